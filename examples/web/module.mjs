// The crate, as a WebAssembly module: see module.rs for what it exports.
import { SCALARS } from './scalar.mjs';

/** The 13 axes in the order of `Axis::ALL`, by the names of the page. */
export const AXES = [
    ...['x', 'y', 'z'].map((name, i) => ({ kind: 'face', i, name, text: 'face normal of the box' })),
    { kind: 'normal', name: 'n', text: 'normal of the triangle' },
    ...['x', 'y', 'z'].flatMap((name, i) =>
        ['ab', 'bc', 'ca'].map((edge, k) => ({
            kind: 'edge', i, k, name: `${name} × ${edge}`, text: `cross product of ${name} and edge ${edge}`,
        }))),
];

/** Where the module may lie: beside this file, or where cargo puts it. */
export const PLACES = ['web.wasm', '../../target/wasm32-unknown-unknown/web/examples/web.wasm'];

/** The exports of a module's bytes. */
export async function exportsOf(bytes) {
    const { instance } = await WebAssembly.instantiate(bytes);
    if (!instance.exports.answers) throw new Error('a module, but not the one of this page');
    return instance.exports;
}

/**
 * The bytes from the first of the places where there are any. Else `problem` says what is wrong
 * with what lies there, if anything is.
 */
export async function find(places = PLACES) {
    let problem = '';
    for (const place of places) {
        try {
            const response = await fetch(new URL(place, import.meta.url));
            if (!response.ok) continue;
            const bytes = await response.arrayBuffer();
            await WebAssembly.compile(bytes);
            return { bytes };
        } catch (error) {
            problem = `${place}: ${error.message}`;
        }
    }
    return { bytes: null, problem };
}

export class Septum {
    #exports;

    constructor(exports) {
        this.#exports = exports;
    }

    /** From the module's bytes. */
    static async from(bytes) {
        return new Septum(await exportsOf(bytes));
    }

    /** From where the module is, and its size; else `problem` says what is wrong. */
    static async find() {
        const { bytes, problem } = await find();
        if (!bytes) return { septum: null, problem };
        return { septum: await Septum.from(bytes), size: bytes.byteLength };
    }

    /**
     * All answers about 15 numbers of a scalar: a, b, c, centre, half-extents. Nothing
     * where they are no triangle and box, or not numbers of the scalar: the module gets
     * their bits, and the bits of I8F8 cannot say NaN.
     */
    ask(scalar, numbers) {
        if (!numbers.every(SCALARS[scalar].holds)) return null;
        const words = new Uint32Array(this.#exports.memory.buffer, this.#exports.numbers(), 15);
        words.set(numbers.map(SCALARS[scalar].bits));
        const bits = this.#exports.answers(scalar);
        const is = (k) => (bits >> k & 1) === 1;
        if (!is(0)) return null;
        return {
            overlaps: is(1),
            rounded: is(2),
            mayOverlap: SCALARS[scalar].all ? is(3) : null,
            published: SCALARS[scalar].all ? is(4) : null,
            axis: (bits >> 5 & 15) - 1, // of AXES; −1 where there is none
            separates: AXES.map((_, k) => is(16 + k)),
        };
    }
}
