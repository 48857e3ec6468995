// The module for meshes, once it is loaded, and its memory.
import { options, shown } from './check.js';
import { hasVectors, load } from './load.js';

let exports = null;
let loading = null;
let vectors = false;
let floats = new Float32Array(0);
let words = new Uint32Array(0);
let numbers = 0;

/** Loads the WebAssembly, once: with vectors where the machine has them, or as the options say. */
export async function init(given) {
    const { simd = true } = options(given, ['simd']);
    if (typeof simd !== 'boolean') throw new TypeError(`options.simd is ${shown(simd)}, not true or false`);
    loading ??= (async () => {
        vectors = simd && hasVectors();
        // Without vectors it is the same module and a patch.
        const parts = await Promise.all([import('../dist/simd.js'), ...vectors ? [] : [import('../dist/plain.js')]]);
        const loaded = await load(...parts.map((part) => part.default));
        numbers = loaded.numbers() >>> 2;
        exports = loaded;
        return { simd: vectors };
    })().catch((error) => {
        loading = null;
        throw error;
    });
    return loading;
}

/** The module's exports. */
export function module() {
    if (exports === null) throw new Error('septum is not loaded yet: await init() first');
    return exports;
}

/** All of the memory as numbers. When the memory grows, a view loses all of its length. */
export function asFloats() {
    if (floats.length === 0) floats = new Float32Array(exports.memory.buffer);
    return floats;
}

export function asWords() {
    if (words.length === 0) words = new Uint32Array(exports.memory.buffer);
    return words;
}

/** Where the numbers of an answer begin, in words. */
export const answer = () => numbers;

/** The list of so many words: its place, in words. */
export function list(length) {
    const at = module().list(length) >>> 2;
    if (at === 0) throw new RangeError(`there is no memory for ${length} numbers`);
    return at;
}

/** What was found: so many words, copied. */
export function found(count) {
    const at = exports.found() >>> 2;
    return asWords().slice(at, at + count);
}

/** Gives the memory of a long list back. */
export const forget = () => { exports.list(0); };
