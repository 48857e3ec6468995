// How a module of WebAssembly is loaded from the module of JavaScript that holds it.

/** The bytes of a text in base 64. */
function bytesOf(text) {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < bytes.length; i += 1) bytes[i] = binary.charCodeAt(i);
    return bytes;
}

/** The exports of the module that `packed` holds. */
export async function load([length, packed]) {
    const stream = new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    const bytes = await new Response(stream).arrayBuffer();
    if (bytes.byteLength !== length) throw new Error('septum: the WebAssembly is damaged');
    const { instance } = await WebAssembly.instantiate(bytes);
    return instance.exports;
}

/** Whether the machine has vectors: a module of one function with `i8x16.splat`. */
export const hasVectors = () => WebAssembly.validate(Uint8Array.of(
    0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
));
