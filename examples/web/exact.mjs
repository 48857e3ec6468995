// The 13 axes once more, in whole numbers of any size: how wide the gaps are, and a
// check of the module by other arithmetic.
import { AXES } from './module.mjs';

const words = new DataView(new ArrayBuffer(8));

/** A finite number as m·2^e. */
function parts(x) {
    words.setFloat64(0, x);
    const bits = words.getBigUint64(0);
    const exponent = Number(bits >> 52n & 0x7ffn);
    const fraction = bits & 0xfffffffffffffn;
    const m = exponent ? fraction | 1n << 52n : fraction;
    return { m: bits >> 63n ? -m : m, e: Math.max(exponent, 1) - 1075 };
}

/** The numbers as multiples of one power of two, and its exponent. */
function whole(numbers) {
    const all = numbers.map(parts);
    const used = all.filter(({ m }) => m !== 0n).map(({ m, e }) => {
        let zeros = 0;
        while (!(m >> BigInt(zeros) & 1n)) zeros += 1;
        return e + zeros;
    });
    const least = Math.min(...used, 0);
    return { exponent: least, values: all.map(({ m, e }) => e < least ? m >> BigInt(least - e) : m << BigInt(e - least)) };
}

const abs = (x) => x < 0n ? -x : x;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [0, 1, 2].map((i) => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3];
    return a[j] * b[k] - a[k] * b[j];
});
const UNITS = [[1n, 0n, 0n], [0n, 1n, 0n], [0n, 0n, 1n]];

/** The axis as a vector, given the edges ab, bc, ca: of BigInts. */
function vector({ kind, i, k }, edges) {
    if (kind === 'face') return UNITS[i];
    return kind === 'normal' ? cross(edges[0], edges[1]) : cross(UNITS[i], edges[k]);
}

/**
 * For each axis its direction, the intervals of both shapes on it in units of the scene,
 * and the gap between them: negative where they overlap, with `sign` exact.
 */
export function project(numbers) {
    const { values, exponent } = whole(numbers);
    const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => values.slice(k, k + 3));
    const edges = [minus(b, a), minus(c, b), minus(a, c)];
    return AXES.map((axis) => {
        const along = vector(axis, edges);
        const length = Math.hypot(...along.map(Number));
        if (length === 0) return { along: [0, 0, 0], gap: -Infinity, sign: -1 };
        // From the centre of the box, which loses nothing in whole numbers.
        const at = [a, b, c].map((v) => dot(along, minus(v, center)));
        const low = at.reduce((x, y) => x < y ? x : y);
        const high = at.reduce((x, y) => x > y ? x : y);
        const radius = along.reduce((sum, x, i) => sum + abs(x) * half[i], 0n);
        const gap = [low - radius, -radius - high].reduce((x, y) => x > y ? x : y);
        const scene = (x) => Number(x) / length * 2 ** exponent;
        return {
            along: along.map((x) => Number(x) / length),
            triangle: [scene(low), scene(high)],
            box: [-scene(radius), scene(radius)],
            gap: scene(gap),
            sign: gap > 0n ? 1 : gap < 0n ? -1 : 0,
        };
    });
}
