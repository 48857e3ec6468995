// How a module of WebAssembly is loaded from the module of JavaScript that holds it.

/** The bytes of a text in base 64. */
function bytesOf(text) {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < bytes.length; i += 1) bytes[i] = binary.charCodeAt(i);
    return bytes;
}

/** The bytes that a module of JavaScript holds. */
async function unpacked([length, packed]) {
    const stream = new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream('deflate'));
    const bytes = await new Response(stream).arrayBuffer();
    if (bytes.byteLength !== length) throw new Error('septum: the WebAssembly is damaged');
    return new Uint8Array(bytes);
}

/** The module that a patch makes of another one; difference.mjs makes patches. */
function patched(old, patch) {
    const count = new Int32Array(patch.buffer, 0, 1)[0];
    const steps = new Int32Array(patch.buffer, 4, 3 * count);
    const sum = (which) => steps.reduce((sum, x, k) => (k % 3 === which ? sum + x : sum), 0);
    const bytes = new Uint8Array(sum(0) + sum(1));
    let [to, from, difference] = [0, 0, 4 + steps.byteLength];
    let added = difference + sum(0);
    for (let k = 0; k < steps.length; k += 3) {
        for (const end = to + steps[k]; to < end; to += 1, from += 1, difference += 1) bytes[to] = old[from] + patch[difference];
        bytes.set(patch.subarray(added, added + steps[k + 1]), to);
        to += steps[k + 1];
        added += steps[k + 1];
        from += steps[k + 2];
    }
    return bytes;
}

/** The exports of the module that `packed` holds; with a patch, of the patched module. */
export async function load(packed, patch) {
    const bytes = await unpacked(packed);
    const { instance } = await WebAssembly.instantiate(patch ? patched(bytes, await unpacked(patch)) : bytes);
    return instance.exports;
}

/** Whether the machine has vectors: a module of one function with `i8x16.splat`. */
export const hasVectors = () => WebAssembly.validate(Uint8Array.of(
    0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
));
