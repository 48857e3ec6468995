// The module of this view, web.wasm: see module.rs for what it exports.
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

export class Septum {
    #exports;

    /** From the module's bytes. */
    static async from(bytes) {
        const { instance } = await WebAssembly.instantiate(bytes);
        if (!instance.exports.answers) throw new Error('a module, but not web.wasm');
        const septum = new Septum();
        septum.#exports = instance.exports;
        return septum;
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
