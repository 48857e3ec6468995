// The golden hashes of the example `determinism`, wherever JavaScript runs.

/** The lines that the module prints: a table, and a verdict. */
export async function hashes(bytes) {
    const { instance } = await WebAssembly.instantiate(bytes);
    const { memory, buffer, lines, line } = instance.exports;
    return Array.from({ length: lines() }, (_, k) => {
        const length = line(k);
        return new TextDecoder().decode(new Uint8Array(memory.buffer, buffer(), length));
    });
}

/** Whether all are what they are on every other machine. */
export const areGolden = (all) => all.at(-1)?.endsWith(' scalars: as everywhere') ?? false;
