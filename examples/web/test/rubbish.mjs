// Types what is no number, or none of the scalar, into every field: nothing may freeze,
// an error must be seen, and the last good numbers and their picture stay.
import { SCALARS } from '../scalar.mjs';
import { check } from './check.mjs';
import { bits, drawing } from './look.mjs';

/** Refused in every scalar, and written into every field. */
const RUBBISH = [
    'abc', '-', '', '😀', 'NaN', 'Infinity', '0x10', '1,5', '1e', '1e999', '9'.repeat(400), `${'1'.repeat(5000)}x`,
];

/** Refused in every scalar, and written into one field each. */
const MORE_RUBBISH = [
    '+', '.', '--1', '1-', 'e5', '1e+', '1.5.2', '1 2', '1/2', '1_000', '1n', '0b1', '1.000,5', 'nan', '-Infinity', '∞',
    'inf', ' ', '👩‍👩‍👧', '½', '١٢', '１', 'null', 'true', '[]', '{}', '<b>1</b>', `'; alert(1)`, '-1e999', '1e99999999999',
    `-${'9'.repeat(400)}`, `${'1'.repeat(2500)}.${'1'.repeat(2500)}.`, '%s%n', '\u202e1', '1\u200b',
];

/** Refused in one scalar, or in the fields of the half-extents. */
const OUT_OF_RANGE = {
    f32: ['3.5e38', '-1e39', '340282356779733661637539395458142568448'],
    I8F8: ['128', '127.999', '-128.01', '1e3', '3.4e38'],
};
const NEGATIVE = ['-1', '-0.25', '-1e-60'];

/** What is taken, and rounded, with the number taken. */
const ROUNDED = {
    f32: { '0.123456789': '0.12345679', 16777217: '16777216', '1e-60': '0', '3.14159265358979323846264338327950288': '3.1415927' },
    I8F8: { 0.1: '0.1015625', '1e-3': '0', '3.14159265358979323846264338327950288': '3.140625', 127.997: '127.99609375' },
};

/** What is taken as it stands. */
const TAKEN = { '1.5': '1.5', ' 2 ': '2', '+.25': '0.25', '1.': '1', '5e-1': '0.5', '\u22121': '-1', '007': '7' };

const FIELDS = Array.from({ length: 15 }, (_, k) => k);
const other = (scalar) => (scalar + 1) % SCALARS.length;
const choose = (page, scalar) => page.click(`scalar-${SCALARS[scalar].name}`);

const enter = (page, k) => page.evaluate(`document.querySelectorAll('#numbers input')[${k}].focus()`);

/** Writes a text into field `k` and leaves it by the tab key. */
async function write(page, k, text) {
    await enter(page, k);
    await page.evaluate('document.activeElement.select()');
    await page.write(text);
    await page.press('Tab');
}

/** Field `k`: its text, whether it is marked, and the message that is seen beside it. */
const field = (page, k) => page.evaluate(`(() => {
    const input = document.querySelectorAll('#numbers input')[${k}];
    const message = document.getElementById(input.getAttribute('aria-describedby') ?? 'none');
    const row = input.closest('tr').getBoundingClientRect();
    return {
        text: input.value,
        isInvalid: input.getAttribute('aria-invalid') === 'true',
        message: message?.checkVisibility() ? message.textContent : '',
        isNear: Math.abs((message?.getBoundingClientRect().top ?? Infinity) - row.bottom) < 160,
    };
})()`);

const isRefused = ({ isInvalid, message, isNear }) => isInvalid && message.includes('Kept: ') && isNear;
const short = (text) => JSON.stringify(text.length > 30 ? `${text.slice(0, 12)}… (${text.length})` : text);

/** Numbers that both scalars hold, so that the picture is the same in both. */
async function begin(page, scalar) {
    await choose(page, 0);
    await page.click('preset-edge');
    await choose(page, 1);
    await choose(page, scalar);
    return { bits: (await bits(page)).join(), drawing: await drawing(page), word: await page.text('word') };
}

async function isAsBefore(page, before) {
    return (await bits(page)).join() === before.bits && await drawing(page) === before.drawing &&
        await page.text('word') === before.word;
}

/** Writes a text into fields, and tells whether each of them refuses it. */
async function areRefused(page, text, fields) {
    let refused = 0;
    for (const k of fields) {
        await write(page, k, text);
        const after = await field(page, k);
        refused += isRefused(after) && after.text === text;
    }
    return refused === fields.length;
}

async function rubbish(page, scalar) {
    const { name } = SCALARS[scalar];
    const before = await begin(page, scalar);
    for (const text of RUBBISH) {
        check(`${name}: ${short(text)} is refused in every field`, await areRefused(page, text, FIELDS));
        check(`${name}: ${short(text)}: the last good picture stays`, await isAsBefore(page, before));
        await choose(page, other(scalar));
        const there = await field(page, 0);
        const isSame = await drawing(page) === before.drawing;
        await choose(page, scalar);
        check(`${name}: ${short(text)}: another scalar and back`, isRefused(there) && isSame && await isAsBefore(page, before));
    }
    let [refused, k] = [0, 0];
    for (const text of MORE_RUBBISH) {
        const isHere = await areRefused(page, text, [k]);
        if (!isHere) console.log(`       ${short(text)}`);
        refused += isHere;
        k = (k + 1) % FIELDS.length;
    }
    check(`${name}: ${MORE_RUBBISH.length} more texts are refused`, refused === MORE_RUBBISH.length && await isAsBefore(page, before));
    for (const k of FIELDS) await write(page, k, '1');
    const all = await Promise.all(FIELDS.map((k) => field(page, k)));
    check(`${name}: a number ends the error`, all.every(({ text, isInvalid, message }) => text === '1' && !isInvalid && message === ''));
}

async function ranges(page, scalar) {
    const { name } = SCALARS[scalar];
    const before = await begin(page, scalar);
    for (const text of [...OUT_OF_RANGE[name], ...NEGATIVE]) {
        const fields = NEGATIVE.includes(text) ? FIELDS.slice(12) : FIELDS;
        check(`${name}: ${short(text)} is refused`, await areRefused(page, text, fields) && await isAsBefore(page, before));
    }
}

async function rounded(page, scalar) {
    const { name } = SCALARS[scalar];
    for (const [text, taken] of Object.entries(ROUNDED[name])) {
        let said = 0;
        for (const k of FIELDS) {
            await write(page, k, text);
            const after = await field(page, k);
            said += after.text === taken && !after.isInvalid && after.isNear && after.message.includes('rounded') &&
                after.message.includes(taken);
        }
        check(`${name}: ${short(text)} is rounded, and the message says to ${taken}`, said === 15);
    }
    for (const [text, taken] of Object.entries(TAKEN)) {
        await write(page, 4, text);
        const after = await field(page, 4);
        check(`${name}: ${short(text)} is taken as ${taken}`, after.text === taken && !after.isInvalid && after.message === '');
    }
}

/** A number of one scalar that lies beyond the other. */
async function beyond(page) {
    await begin(page, 0);
    await write(page, 3, '1e30');
    await choose(page, 1);
    const after = await field(page, 3);
    check('I8F8: 1e30 of f32 becomes the greatest number, and a message says so', after.text === '127.99609375' &&
        /out of range.*127\.99609375/.test(after.message));
    await page.click('preset-edge');
    await choose(page, 0);
    await page.click('preset-edge');
    await choose(page, 1);
    check('a message counts the numbers that another scalar rounds', /^1[0-5] of the 15 numbers/.test(await page.text('converted')));
}

/** The ends of a scalar: no button throws there. */
async function ends(page, scalar) {
    const { name, most, show } = SCALARS[scalar];
    await begin(page, scalar);
    for (const k of FIELDS) await write(page, k, show(k % 2 || k > 11 ? most : -most));
    for (const id of ['touch', 'closer', 'whole', 'up', 'down', 'units', 'touch', 'bits', 'bits']) await page.click(id);
    await choose(page, other(scalar));
    for (const id of ['touch', 'closer', 'whole', 'up', 'down']) await page.click(id);
    await choose(page, scalar);
    await begin(page, scalar);
    await write(page, 0, show(most));
    await enter(page, 0);
    await page.click('up');
    check(`${name}: one unit beyond the end stays, and a message says so`, (await field(page, 0)).message.includes('range ends') &&
        (await field(page, 0)).text === show(most));
    await page.click('preset-edge');
    await write(page, 12, '0');
    await enter(page, 12);
    await page.click('down');
    check(`${name}: one unit below a half-extent of zero is refused`, (await field(page, 12)).message.includes('negative') &&
        (await field(page, 12)).text === '0');
}

/** All of it, on a page of its own. */
export async function rubbishInAllFields(page) {
    await page.size(1280, 900);
    await page.until('document.body.dataset.ready');
    for (const scalar of SCALARS.keys()) {
        await rubbish(page, scalar);
        await ranges(page, scalar);
        await rounded(page, scalar);
        await ends(page, scalar);
    }
    await beyond(page);
}
