// septum/pairs: exact questions about two shapes, in f64, JavaScript's own numbers.
import { corners, direction, length, number, part, range as reach, shown, vector } from './check.js';
import { load } from './load.js';

let exports = null;
let loading = null;

/** Loads the WebAssembly, once. */
export function init() {
    loading ??= (async () => {
        const packed = await import('../dist/pairs.js');
        exports = await load(packed.default);
    })().catch((error) => {
        loading = null;
        throw error;
    });
    return loading;
}

function module() {
    if (exports === null) throw new Error('septum/pairs is not loaded yet: await init() first');
    return exports;
}

/** The numbers of a question and of an answer. */
const numbers = () => new Float64Array(module().memory.buffer, module().shapes(), 96);

const exact = Number;
const point = (name, v) => vector(name, v, exact);

/** The kind of a shape and its numbers. */
function shape(name, s) {
    if (typeof s !== 'object' || s === null) {
        throw new TypeError(`${name} is ${shown(s)}, not a shape: { a, b, c }, { min, max }, { center, halfExtents, axes or quaternion }, { center, radius } or { a, b, radius }`);
    }
    if ('radius' in s) {
        const ends = 'a' in s ? [...point(`${name}.a`, s.a), ...point(`${name}.b`, s.b)] : point(`${name}.center`, s.center);
        return [ends.length > 3 ? 5 : 4, [...ends, length(`${name}.radius`, s.radius, exact)]];
    }
    if ('a' in s) return [0, [...point(`${name}.a`, s.a), ...point(`${name}.b`, s.b), ...point(`${name}.c`, s.c)]];
    if ('min' in s) return [1, corners(`${name}.`, s.min, s.max, exact).flat()];
    if ('center' in s) {
        const half = point(`${name}.halfExtents`, s.halfExtents);
        half.forEach((x, i) => { if (x < 0) throw new RangeError(`${name}.halfExtents.${'xyz'[i]} is ${x}, below zero`); });
        const head = [...point(`${name}.center`, s.center), ...half];
        if (s.quaternion !== undefined && s.axes !== undefined) throw new TypeError(`${name} has both axes and a quaternion`);
        if (s.quaternion !== undefined) return [3, [...head, ...quaternion(`${name}.quaternion`, s.quaternion)]];
        const axes = s.axes ?? [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        if (!Array.isArray(axes) || axes.length !== 3) throw new TypeError(`${name}.axes are ${shown(axes)}, not three vectors`);
        return [2, [...head, ...axes.flatMap((axis, i) => point(`${name}.axes[${i}]`, axis))]];
    }
    throw new TypeError(`${name} has neither a, b and c, nor min and max, nor center and halfExtents, nor a radius`);
}

function quaternion(name, q) {
    const given = Array.isArray(q) || ArrayBuffer.isView(q) ? [...q] : [q?.x, q?.y, q?.z, q?.w];
    if (given.length !== 4) throw new RangeError(`${name} has ${given.length} numbers, not 4`);
    return given.map((x, i) => number(`${name}.${'xyzw'[i]}`, x, exact));
}

const NO_PAIR = -8;

/** What the module refuses, of the first shape or of the second. */
function refused(code, first, second) {
    if (code === NO_PAIR) return new TypeError(`there is no such question about ${first} and ${second}: spheres and capsules have it with { a, b, c } and { min, max }`);
    const [name, problem] = code < -16 ? [second, -code - 16] : [first, -code];
    return new RangeError({
        4: `${name}.axes are not unit vectors at right angles`,
        5: `${name}.quaternion has not the length 1`,
    }[problem] ?? `${name} is refused`);
}

function ask(question, a, b) {
    const exports = module();
    const [[first, ofFirst], [second, ofSecond]] = [shape('first', a), shape('second', b)];
    const all = numbers();
    all.set(ofFirst, 0);
    all.set(ofSecond, 16);
    const code = exports[question](first, second);
    if (code < 0) throw refused(code, 'first', 'second');
    return code;
}

/** Whether two shapes have a point in common: touching is overlap. */
export function overlaps(first, second) {
    return ask('overlaps', first, second) === 1;
}

/** The least translation that moves the first shape out of the second, and where they meet; null if they are apart or touch. */
export function contact(first, second) {
    const count = ask('contact', first, second) - 1;
    if (count < 0) return null;
    const all = numbers();
    const three = (k) => [all[k], all[k + 1], all[k + 2]];
    const points = Array.from({ length: count }, (_, i) => {
        const k = 11 + 9 * i;
        return { onFirst: three(k), onSecond: three(k + 3), depth: all[k + 6], parts: [part(all[k + 7]), part(all[k + 8])] };
    });
    const [from, one, other] = three(8);
    const features = [{ first: one }, { second: one }, { edges: [one, other] }, { nearest: [part(one), part(other)] }][from];
    return { translation: three(0), depth: all[3], normal: three(4), isSufficient: all[7] === 1, features, points };
}

/** The question of a ray's range in a shape. */
function range(ray, name, given) {
    if (typeof ray !== 'object' || ray === null) throw new TypeError(`ray is ${shown(ray)}, not { origin, direction }`);
    const unknown = Object.keys(ray).find((name) => !['origin', 'direction', 'near', 'far'].includes(name));
    if (unknown !== undefined) throw new TypeError(`ray.${unknown} is unknown; there are origin, direction, near, far`);
    const { near = 0, far = Infinity } = ray;
    const along = [...point('ray.origin', ray.origin), ...direction('ray.direction', ray.direction, exact)];
    reach('ray.', near, far, exact);
    const [kind, numbersOf] = shape(name, given);
    if ((name === 'sphere') !== (kind === 4) || kind === 0 || kind === 5) throw new TypeError(`${name} is another shape`);
    const all = numbers();
    all.set([...along, near, far], 0);
    all.set(numbersOf, 16);
    const code = module().ray_range(kind);
    if (code < 0) throw refused(code, 'ray', name);
    return code === 1 ? [all[0], all[1]] : null;
}

/** Where a ray enters and leaves a box, as parts of its direction: [t, t]; null if it misses. */
export function rayBox(ray, box) {
    return range(ray, 'box', box);
}

/** Where a ray enters and leaves a sphere, likewise; both rounded outward. */
export function raySphere(ray, sphere) {
    return range(ray, 'sphere', sphere);
}
