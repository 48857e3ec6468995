// The scalars of the module. A number of either is held as a JavaScript number: both
// are subsets of it.

const view = new DataView(new ArrayBuffer(4));

function float(bits) {
    view.setUint32(0, bits);
    return view.getFloat32(0);
}

function floatBits(x) {
    view.setFloat32(0, x);
    return view.getUint32(0);
}

// As many steps above the least float as there are floats between: −0 and 0 are one.
const toOrder = (bits) => bits >> 31 ? -(bits & 0x7fffffff) : bits;
const fromOrder = (order) => order < 0 ? (0x80000000 | -order) >>> 0 : order;

export const SCALARS = [
    {
        name: 'f32',
        /** Whether the module has the answers of all methods. */
        all: true,
        nearest: (x) => Math.fround(x),
        bits: (x) => floatBits(x),
        /** The number `n` units of the last place further up. */
        step: (x, n) => float(fromOrder(toOrder(floatBits(x)) + n)),
        /** As few digits as tell it from its neighbours. */
        show: (x) => {
            let digits = 1;
            while (Math.fround(Number(x.toPrecision(digits))) !== x) digits += 1;
            return String(Number(x.toPrecision(digits)));
        },
        hex: (x) => `0x${floatBits(x).toString(16).padStart(8, '0')}`,
    },
    {
        name: 'I8F8',
        all: false,
        nearest: (x) => Math.min(Math.max(Math.round(x * 256), -32768), 32767) / 256,
        bits: (x) => x * 256 >>> 0,
        step: (x, n) => Math.min(Math.max(x * 256 + n, -32768), 32767) / 256,
        show: (x) => String(x),
        hex: (x) => `0x${(x * 256 & 0xffff).toString(16).padStart(4, '0')}`,
    },
];
