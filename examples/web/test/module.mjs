// Checks modules in node, against whole numbers of any size and against each other:
//
//     node examples/web/test/module.mjs <most bytes> <web.wasm>… [-- <determinism.wasm>…]
import { readFileSync } from 'node:fs';

import { project } from '../exact.mjs';
import { AXES, Septum } from '../module.mjs';
import { PRESETS, inScalar, wrongCase } from '../presets.mjs';
import { SCALARS } from '../scalar.mjs';
import { nearest, stepped, touch } from '../touch.mjs';
import { cases } from './cases.mjs';
import { check, outcome } from './check.mjs';
import { areGolden, hashes } from './golden.mjs';

const [most, ...paths] = process.argv.slice(2);
const split = paths.includes('--') ? paths.indexOf('--') : paths.length;
const modules = paths.slice(0, split).map((path) => ({ path, bytes: readFileSync(path) }));

const name = (answer) => answer.axis < 0 ? 'none' : AXES[answer.axis].name;
const BOX = [0.5, 0.5, 0.5, 0.5, 0.5, 0.5];
/** In the corner (1, 1, 1) of that box. */
const IN_CORNER = [0, 3, 0, 3, 0, 0, 0, 0, 3, ...BOX];

/** The same with another number `k`. */
const other = (k, x) => IN_CORNER.map((old, i) => i === k ? x : old);

/** Whether a module was built for vectors of 128 bits. */
function isSimd(bytes) {
    const sections = WebAssembly.Module.customSections(new WebAssembly.Module(bytes), 'target_features');
    return sections.some((section) => new TextDecoder().decode(section).includes('simd128'));
}

function known(septum, scalar) {
    const { name: of } = SCALARS[scalar];
    const expected = { face: 'z', normal: 'n', edge: 'x × bc', overlap: 'none' };
    for (const [id, axis] of Object.entries(expected)) {
        const answer = septum.ask(scalar, inScalar(scalar, PRESETS[id].numbers));
        check(`${of}: scene "${id}" is separated by ${axis}`, name(answer) === axis && answer.overlaps === (axis === 'none'));
        check(`${of}: scene "${id}", rounded`, answer.rounded === answer.overlaps);
    }
    check(`${of}: touching is overlap`, septum.ask(scalar, IN_CORNER).overlaps);
    const off = septum.ask(scalar, stepped(scalar, IN_CORNER, 1, 1));
    check(`${of}: one unit of the last place farther off is not`, name(off) === 'n' && !off.overlaps);

    const found = wrongCase(septum, scalar);
    const answer = septum.ask(scalar, found.numbers);
    const truth = !project(found.numbers).some(({ sign }) => sign > 0);
    check(`${of}: the page has a case that rounding gets wrong`, found.wrong && answer.rounded !== truth && answer.overlaps === truth);
    for (const { text, numbers } of Object.values(PRESETS)) {
        const there = touch(septum, scalar, inScalar(scalar, numbers));
        const axes = project(there.numbers);
        check(`${of}: "${text}" is brought to touch`, Math.abs(axes[nearest(axes)].gap) < (scalar ? 0.02 : 2e-6));
    }
    check(`${of}: a negative half-extent is refused`, septum.ask(scalar, other(14, -1)) === null);
}

/** All answers about the stream, against `project`: how many, and what is wrong. */
function stream(septum, scalar) {
    const [wrong, raw] = [[], []];
    const count = { cases: 0, overlaps: 0, touch: 0, rounded: 0 };
    for (const { kind, numbers } of cases(scalar, 7 + scalar, 600)) {
        const answer = septum.ask(scalar, numbers);
        const signs = project(numbers).map(({ sign }) => sign);
        const first = signs.indexOf(1);
        const right = answer && answer.overlaps === (first < 0) && answer.axis === first &&
            signs.every((sign, k) => answer.separates[k] === sign > 0) &&
            (answer.mayOverlap ?? true) >= answer.overlaps;
        if (!right) wrong.push(`${kind}: ${numbers}`);
        count.cases += 1;
        count.overlaps += first < 0;
        count.touch += Math.max(...signs) === 0;
        count.rounded += answer?.rounded !== first < 0;
        raw.push(JSON.stringify(answer));
    }
    return { wrong, raw, count };
}

const said = new Map();
for (const { path, bytes } of modules) {
    console.log(`\n${path}: ${bytes.length} bytes`);
    check(`it has at most ${most} bytes`, bytes.length <= Number(most));
    check('it imports nothing', WebAssembly.Module.imports(new WebAssembly.Module(bytes)).length === 0);
    const septum = await Septum.from(bytes);
    SCALARS.forEach(({ name: of }, scalar) => {
        known(septum, scalar);
        const { wrong, raw, count } = stream(septum, scalar);
        const { cases: all, overlaps, touch: contacts, rounded } = count;
        check(`${of}: verdicts and axes of ${all} cases agree with whole numbers (${overlaps} overlap, ${contacts} just touch; rounding is wrong in ${rounded})`, wrong.length === 0);
        wrong.slice(0, 3).forEach((line) => console.log(`       ${line}`));
        check(`${of}: the cases have something of everything`, overlaps > all / 20 && overlaps < all * 0.95 && contacts > 20 && rounded > 20);
        if (said.has(of)) check(`${of}: the same bits as the first module`, said.get(of) === raw.join());
        else said.set(of, raw.join());
    });
    // Bits of I8F8 cannot say these: it is the page that must not send them.
    for (const x of [NaN, Infinity, 0.1, 128]) check(`I8F8: ${x} is refused`, septum.ask(1, other(4, x)) === null);
    check('f32: what is no f32 is refused', septum.ask(0, other(4, 0.1)) === null);
    check('f32: NaN is refused', septum.ask(0, other(4, NaN)) === null);
    check('f32: an infinity is refused', septum.ask(0, other(4, Infinity)) === null);
}

const golden = paths.slice(split + 1).map((path) => ({ path, bytes: readFileSync(path) }));
for (const { path, bytes } of golden) {
    const lines = await hashes(bytes);
    console.log(`\n${path}\n${lines.join('\n')}`);
    check(`the golden hashes, in node, ${isSimd(bytes) ? 'with' : 'without'} simd128`, areGolden(lines));
}
process.exit(outcome());
