// The page without a mouse: the order of the tab key, what shows the focus, and what the
// keys do on the number types, on the picture and on the neighbours of a number.
import { check } from './check.mjs';
import { bits, drawing, says, width } from './look.mjs';

const ORDER = [
    'scene', 'closer', 'whole', 'scalar-f32', 'other', 'preset-face', 'preset-normal', 'preset-edge', 'preset-overlap',
    'touch', 'wrong', 'down', 'units', 'up', 'bits',
    ...['a', 'b', 'c', 'centre', 'half'].flatMap((name) => ['x', 'y', 'z'].map((axis) => `${name}.${axis}`)),
];

/** What has the focus, and how wide the ring is that shows it. */
const focus = (page) => page.evaluate(`(() => {
    const element = document.activeElement;
    const seen = element.type === 'radio' ? element.nextElementSibling : element;
    const { outlineStyle, outlineWidth } = getComputedStyle(seen);
    return { name: element.id || element.ariaLabel, ring: outlineStyle === 'solid' ? parseFloat(outlineWidth) : 0 };
})()`);

const enter = (page, id) => page.evaluate(`document.getElementById('${id}').focus({ focusVisible: true })`);

/** Which of the 15 numbers differ. */
const differing = (before, after) => after.flatMap((x, k) => x === before[k] ? [] : [k]).join();

async function presses(page, key, count, options) {
    for (let k = 0; k < count; k += 1) await page.press(key, options);
}

async function order(page) {
    const [names, rings] = [[], []];
    for (let k = 0; k < ORDER.length; k += 1) {
        await page.press('Tab');
        const { name, ring } = await focus(page);
        names.push(name);
        rings.push(ring);
    }
    check(`the tab key visits ${ORDER.length} places from top to bottom`, names.join() === ORDER.join());
    if (names.join() !== ORDER.join()) console.log(`       ${names.join()}`);
    check('a ring shows the focus at each of them', rings.every((ring) => ring >= 2));
    await page.press('Tab', { shift: true });
    check('and back with shift', (await focus(page)).name === ORDER.at(-2));
}

async function scalars(page) {
    await enter(page, 'scalar-f32');
    const chosen = () => page.evaluate(`document.querySelector('#scalars input:checked').id`);
    const before = await bits(page);
    await page.press('ArrowRight');
    const second = [await chosen(), (await focus(page)).name].join();
    check('an arrow key chooses the next number type', second === 'scalar-I8F8,scalar-I8F8' && (await bits(page))[0].length === 6);
    await page.press('Tab', { shift: true });
    await page.press('Tab');
    check('only the chosen one is a stop of the tab key', (await focus(page)).name === 'scalar-I8F8');
    await page.press('ArrowDown');
    check('after the last one comes the first', await chosen() === 'scalar-f32' && (await bits(page))[0].length === before[0].length);
}

async function picture(page) {
    await page.click('preset-edge');
    await enter(page, 'scene');
    const [before, start] = [await bits(page), await drawing(page)];
    const hint = await page.text('hint');
    check('the page says which keys there are', /Arrow keys turn/.test(hint));
    await page.press('ArrowLeft');
    await page.press('ArrowUp');
    check('arrow keys turn the view, and no number changes', await drawing(page) !== start && differing(before, await bits(page)) === '');
    await page.press('Home');
    check('Home is the whole view', await drawing(page) === start);
    const wide = await width(page, 'triangle');
    await page.press('+');
    const near = await width(page, 'triangle');
    check(`+ zooms in (${wide} to ${near} pixels)`, near > wide * 1.1);
    await page.press('-');
    check('- zooms out again', Math.abs(await width(page, 'triangle') - wide) < 3);

    const moved = { 'vertex a': '0,1,2', 'vertex b': '3,4,5', 'vertex c': '6,7,8', 'the triangle': '0,1,2,3,4,5,6,7,8', 'the box': '9,10,11' };
    for (const [name, numbers] of Object.entries(moved)) {
        await page.press(' ');
        const old = await bits(page);
        await page.press('ArrowLeft');
        await page.press('ArrowUp');
        check(`the space bar chooses ${name}, and arrow keys move it alone`, (await page.text('hint')).includes(name) &&
            differing(old, await bits(page)) === numbers);
        await page.press('ArrowRight');
        await page.press('ArrowDown');
        check(`and back`, differing(old, await bits(page)) === '');
    }
    await page.press('Escape');
    check('Escape returns to the view', await page.text('hint') === hint);
    await page.press(' ', { shift: true });
    check('the space bar with shift goes the other way', (await page.text('hint')).includes('the box'));
    await page.press('Escape');
    // Without a mouse to an overlap: vertex a goes down into the box.
    await page.press(' ');
    await presses(page, 'ArrowDown', 40);
    check('the verdict follows', await says(page, 'Overlap', 'none'));
    await page.press('Tab');
    check('what the keys moved is released with the focus', /Drag/.test(await page.text('hint')));
}

/** Steps below a unit in the last place add up. */
async function fine(page) {
    await page.click('scalar-I8F8');
    await page.click('preset-edge');
    await enter(page, 'scene');
    await presses(page, '+', 12);
    await page.press(' ', { shift: true });
    const before = await bits(page);
    await page.press('ArrowRight', { shift: true });
    const once = differing(before, await bits(page));
    await presses(page, 'ArrowRight', 30, { shift: true });
    check('steps below a unit of I8F8 add up', once === '' && differing(before, await bits(page)) !== '');
    await page.press('Home');
    await page.click('scalar-f32');
}

async function units(page) {
    await page.click('preset-edge');
    await page.evaluate(`document.querySelectorAll('#numbers input')[2].focus()`);
    await enter(page, 'units');
    const before = await bits(page);
    await page.press('ArrowRight');
    const after = await bits(page);
    check('an arrow key goes to the next number', differing(before, after) === '2' && Number(after[2]) - Number(before[2]) === 1);
    check('and the slider says what it is', /^2\.2.*exact: disjoint/.test(
        await page.evaluate(`new Promise((done) => requestAnimationFrame(() => done(document.getElementById('units').ariaValueText)))`)));
    await page.press('ArrowLeft');
    check('and back', differing(before, await bits(page)) === '');
}

/** A field by the keyboard. */
async function field(page) {
    const text = () => page.evaluate('document.activeElement.value');
    await page.click('preset-edge');
    await page.evaluate(`document.querySelectorAll('#numbers input')[4].select()`);
    await page.evaluate(`document.querySelectorAll('#numbers input')[4].focus()`);
    await page.write('abc');
    await page.press('Enter');
    check('Enter has a field read', await page.evaluate('document.activeElement.ariaInvalid') === 'true' && await text() === 'abc');
    await page.press('Escape');
    check('Escape brings the number in use back', await page.evaluate('document.activeElement.ariaInvalid') !== 'true' && await text() === '-0.5');
}

/** All of it, on a page of its own. */
export async function withoutMouse(page) {
    await page.size(1280, 900);
    await page.until('document.body.dataset.ready');
    await page.theme('light');
    await order(page);
    await scalars(page);
    await picture(page);
    await fine(page);
    await units(page);
    await field(page);
}
