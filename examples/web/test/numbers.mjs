// Checks in node how numbers are read, shown and stepped:
//
//     node examples/web/test/numbers.mjs
import { spawnSync } from 'node:child_process';

import { read } from '../read.mjs';
import { SCALARS } from '../scalar.mjs';
import { cases, random } from './cases.mjs';
import { check, outcome } from './check.mjs';

const SCALAR = new URL('../scalar.mjs', import.meta.url);
const NOT_HELD = { f32: [0.1, 2 ** 128, 1e-60], I8F8: [NaN, Infinity, -Infinity, 0.1, 128, -128.5, 1 / 512] };

/** What an expression of `SCALARS` prints; nothing if it takes more than 5 s. */
function within5s(expression) {
    const program = `import { SCALARS } from '${SCALAR}'; console.log(${expression})`;
    const { status, stdout } = spawnSync(process.execPath, ['--input-type=module', '-e', program], { timeout: 5000 });
    return status === 0 ? String(stdout).trim() : null;
}

/** The time in ms that reading a text takes. */
function time(text) {
    const start = performance.now();
    SCALARS.forEach((_, scalar) => read(scalar, text));
    return performance.now() - start;
}

SCALARS.forEach(({ name, least, most, holds, show, step, nearest, hex }, scalar) => {
    check(`${name}: showing what is no number ends`, within5s(`[NaN, Infinity, -Infinity, 0.1, 1e-60].map(SCALARS[${scalar}].show).length`) === '5');
    check(`${name}: it holds none of ${NOT_HELD[name].join(', ')}`, !NOT_HELD[name].some(holds));

    const all = [...cases(scalar, 1, 300)].flatMap(({ numbers }) => numbers).concat(0, least, most);
    check(`${name}: it holds ${all.length} numbers of its own`, all.every(holds));
    const isReadBack = (x) => {
        const { number, note, error } = read(scalar, show(x));
        return Object.is(number, x) && !note && !error;
    };
    check(`${name}: what is shown is read back to the bit, unrounded`, all.every(isReadBack));

    const next = random(3);
    const apart = (x) => {
        const n = Math.round((next() * 2 - 1) * 1000);
        const there = step(x, n);
        return holds(there) && (there === least || there === most || (step(there, -n) === x && Math.sign(there - x) === Math.sign(n)));
    };
    check(`${name}: so many steps up and down are none`, all.every(apart));
    check(`${name}: steps end with the range`, step(most, 1) === most && step(least, -7) === least && step(most, -1) < most);
    check(`${name}: the nearest number is within the range`, nearest(1e300) === most && nearest(-1e300) === least && nearest(Infinity) === most);
    check(`${name}: no number below the range is read, and none above`, ['', '1'].every((digits) =>
        [`${digits}1e40`, `-${digits}1e40`].every((text) => read(scalar, text).error?.includes('out of range'))));
    check(`${name}: bits are those of a word`, hex(0) === `0x${'0'.repeat(name === 'f32' ? 8 : 4)}`);
});
check('f32: −0 is shown and read as such', SCALARS[0].show(-0) === '-0' && Object.is(read(0, '-0').number, -0));
check('I8F8: −0 is read as zero', Object.is(read(1, '-0').number, 0) && Object.is(read(1, '-0.001').number, 0));
check('a half-extent may be zero, and not negative', [0, 1].every((scalar) =>
    read(scalar, '0', true).number === 0 && read(scalar, '-1e-60', true).error && !read(scalar, '-1').error));
check('a comma is answered with a point', read(0, '1,5').error.includes('“1.5”'));

const digits = '1'.repeat(20_000);
const slowest = Math.max(...[`${digits}x`, `.${digits}e`, `${digits}.${digits},`, `${digits},${digits}`, digits].map(time));
check(`20,000 digits are read in ${slowest.toFixed(0)} ms`, slowest < 500);
check('and a message repeats but some of them', read(0, `${digits}x`).error.length < 100);
process.exit(outcome());
