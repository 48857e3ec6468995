// What is wrong with an argument: errors that name the argument and its element.

/** A value as an error shows it. */
export function shown(x) {
    if (typeof x === 'string') return JSON.stringify(x.length > 20 ? `${x.slice(0, 20)}…` : x);
    if (typeof x === 'object' && x !== null) return Array.isArray(x) ? 'an array' : `an object (${x.constructor?.name ?? 'without a prototype'})`;
    if (typeof x === 'function') return 'a function';
    return typeof x === 'bigint' ? `${x}n` : String(x);
}

/** A finite number, for f32 if `round` is `Math.fround`. */
export function number(name, x, round = Math.fround) {
    if (typeof x !== 'number') throw new TypeError(`${name} is ${shown(x)}, not a number`);
    if (Number.isFinite(round(x))) return x;
    throw new RangeError(Number.isFinite(x) ? `${name} is ${x}, which is beyond f32` : `${name} is ${x}, not a finite number`);
}

const isList = (x) => Array.isArray(x) || (ArrayBuffer.isView(x) && !(x instanceof DataView));

const isFine = (x, round) => typeof x === 'number' && Number.isFinite(round(x));

/** Three finite numbers: an array of three, or an object with x, y and z. */
export function vector(name, v, round = Math.fround) {
    const isRow = isList(v);
    if (isRow && v.length !== 3) throw new RangeError(`${name} has ${v.length} numbers, not 3`);
    if (!isRow && (typeof v !== 'object' || v === null || !('x' in v))) {
        throw new TypeError(`${name} is ${shown(v)}, not three numbers: [x, y, z] or { x, y, z }`);
    }
    const three = isRow ? [v[0], v[1], v[2]] : [v.x, v.y, v.z];
    if (!(isFine(three[0], round) && isFine(three[1], round) && isFine(three[2], round))) {
        // Names of elements take longer to make than a ray to cast.
        three.forEach((x, i) => number(isRow ? `${name}[${i}]` : `${name}.${'xyz'[i]}`, x, round));
    }
    return three;
}

/** The same, but not all zero. */
export function direction(name, v, round = Math.fround) {
    const d = vector(name, v, round);
    if (round(d[0]) === 0 && round(d[1]) === 0 && round(d[2]) === 0) {
        throw new RangeError(`${name} is zero${d.some((x) => x !== 0) ? ' once rounded to f32' : ''}`);
    }
    return d;
}

/** A finite number that is not negative. */
export function length(name, x, round = Math.fround) {
    if (number(name, x, round) < 0) throw new RangeError(`${name} is ${x}, which is negative`);
    return x;
}

/** A whole number from `least` to `most`. */
export function whole(name, x, least, most) {
    if (typeof x !== 'number') throw new TypeError(`${name} is ${shown(x)}, not a number`);
    if (Number.isInteger(x) && x >= least && x <= most) return x;
    throw new RangeError(`${name} is ${x}, not a whole number from ${least} to ${most}`);
}

/** An object of options, of which each has a name in `known`. */
export function options(given, known) {
    if (given === undefined) return {};
    if (typeof given !== 'object' || given === null) throw new TypeError(`options are ${shown(given)}, not an object`);
    for (const name of Object.keys(given)) {
        if (!known.includes(name)) throw new TypeError(`options.${name} is unknown; there are ${known.join(', ')}`);
    }
    return given;
}

/** The ends of a ray; for f32 if `round` is `Math.fround`. An infinite one on its own side is none. */
export function range(name, near, far, round = Math.fround) {
    for (const [end, x, none] of [['near', near, -Infinity], ['far', far, Infinity]]) {
        if (x !== none) number(`${name}${end}`, x, round);
    }
    if (round(near) > round(far)) throw new RangeError(`${name}near is ${near}, above ${name}far, which is ${far}`);
    return [near, far];
}

const WHOLE = [0, Infinity, 0];

/** The ends of a ray and which of its hits are culled. */
export function reach(given) {
    if (given === undefined) return WHOLE;
    const { near = 0, far = Infinity, cull = 'none' } = options(given, ['near', 'far', 'cull']);
    const [from, to] = range('options.', near, far);
    const rule = ['none', 'back', 'front'].indexOf(cull);
    if (rule < 0) throw new RangeError(`options.cull is ${shown(cull)}, not 'none', 'back' or 'front'`);
    return [from, to, rule];
}

/** A box by its corners, for f32 if `round` is `Math.fround`. */
export function corners(name, min, max, round = Math.fround) {
    const [low, high] = [vector(`${name}min`, min, round), vector(`${name}max`, max, round)];
    for (let i = 0; i < 3; i += 1) {
        if (low[i] > high[i]) throw new RangeError(`${name}min.${'xyz'[i]} is ${low[i]}, above ${name}max.${'xyz'[i]}, which is ${high[i]}`);
    }
    return [low, high];
}

/** Numbers in a row, so many to an element, as f32: an array's elements are looked at. */
export function row(name, numbers, each, element) {
    if (!isList(numbers)) throw new TypeError(`${name} are ${shown(numbers)}, not an array of numbers`);
    if (numbers.length % each !== 0) {
        throw new RangeError(`${name} have ${numbers.length} numbers, not a multiple of ${each}: ${element} has ${each}`);
    }
    if (typeof numbers[0] === 'bigint') throw new TypeError(`${name} are ${shown(numbers)} of bigints, not of numbers`);
    if (Array.isArray(numbers)) {
        const bad = numbers.findIndex((x) => typeof x !== 'number');
        const hole = bad < 0 ? numbers.length : bad;
        if (hole < numbers.length) throw new TypeError(`${name}[${hole}] is ${shown(numbers[hole])}, not a number`);
    }
    return numbers;
}

const PARTS = ['face', 'edge', 'vertex'];

/** A part of a shape, by the module's number. */
export const part = (k) => ({ kind: PARTS[k >> 4], number: k & 15 });
