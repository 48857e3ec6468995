// The scalars of the module. A number of either is held as a JavaScript number: both are
// subsets of it. `holds` tells whether a JavaScript number is one of them.

const view = new DataView(new ArrayBuffer(4));

function float(bits) {
    view.setUint32(0, bits);
    return view.getFloat32(0);
}

function floatBits(x) {
    view.setFloat32(0, x);
    return view.getUint32(0);
}

const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

// Floats in order as integers: −0 and 0 are one.
const toOrder = (bits) => bits >> 31 ? -(bits & 0x7fffffff) : bits;
const fromOrder = (order) => order < 0 ? (0x80000000 | -order) >>> 0 : order;
const LAST = 0x7f7fffff;
const GREATEST = float(LAST);

/** Nine digits tell any two `f32` apart. */
const DIGITS = 9;

export const SCALARS = [
    {
        name: 'f32',
        about: 'f32: floating point with 24 significant bits',
        /** Whether the module has the answers of all methods. */
        all: true,
        least: -GREATEST,
        most: GREATEST,
        /** The number that rounding gives; beyond the range the last one. */
        nearest: (x) => clamp(Math.fround(x), -GREATEST, GREATEST),
        /** What rounding gives without an end of the range: infinite where it overflows. */
        unbounded: (x) => Math.fround(x),
        /** Whether it is a number of the scalar, so that `bits` loses nothing. */
        holds: (x) => Object.is(Math.fround(x), x),
        bits: (x) => floatBits(x),
        /** The number `n` units in the last place further up; beyond the range the last one. */
        step: (x, n) => float(fromOrder(clamp(toOrder(floatBits(x)) + n, -LAST, LAST))),
        /** As few digits as tell it from its neighbours. */
        show: (x) => {
            if (Object.is(x, -0)) return '-0';
            let digits = 1;
            while (digits < DIGITS && Math.fround(Number(x.toPrecision(digits))) !== x) digits += 1;
            return String(Number(x.toPrecision(digits)));
        },
        hex: (x) => `0x${floatBits(x).toString(16).padStart(8, '0')}`,
    },
    {
        name: 'I8F8',
        about: 'I8F8: 16-bit fixed point, multiples of 1/256 = 0.00390625',
        all: false,
        least: -128,
        most: 32767 / 256,
        // Plus zero: this scalar has no −0.
        nearest: (x) => clamp(Math.round(x * 256), -32768, 32767) / 256 + 0,
        unbounded: (x) => Math.round(x * 256) / 256 + 0,
        holds: (x) => Number.isInteger(x * 256) && x >= -128 && x < 128,
        bits: (x) => x * 256 >>> 0,
        step: (x, n) => clamp(x * 256 + n, -32768, 32767) / 256,
        show: (x) => String(x),
        hex: (x) => `0x${(x * 256 & 0xffff).toString(16).padStart(4, '0')}`,
    },
];
