// Drives the page in headless Chromium:
//
//     node examples/web/test/page.mjs <web.wasm> [--picture <file>] [-- <determinism.wasm>…]
//
// Takes `chromium`, or what the variable CHROMIUM says.
import { writeFileSync } from 'node:fs';

import { serve } from '../serve.mjs';
import { Browser } from './browser.mjs';
import { check, outcome } from './check.mjs';
import { withoutMouse } from './keyboard.mjs';
import { banner, numbers, pixels, place, says } from './look.mjs';
import { onPhone } from './phone.mjs';
import { rubbishInAllFields } from './rubbish.mjs';
import { meshInVoxels, pose } from './view.mjs';

const options = process.argv.slice(2);
const split = options.includes('--') ? options.indexOf('--') : options.length;
const [module, picture, file] = options.slice(0, split);
const golden = Object.fromEntries(options.slice(split + 1).map((path, k) => [`golden-${k}.wasm`, path]));

const { server, address } = await serve({ 'web.wasm': module, ...golden }, 0);
const browser = new Browser(process.env.CHROMIUM ?? 'chromium');

async function scenes(page) {
    for (const [id, word, axis] of [
        ['face', 'Disjoint', 'z'], ['normal', 'Disjoint', 'n'],
        ['edge', 'Disjoint', 'x × bc'], ['overlap', 'Overlap', 'none'],
    ]) {
        await page.click(`preset-${id}`);
        check(`scene "${id}": ${word}, axis ${axis}`, await says(page, word, axis));
        check(`scene "${id}": nothing is wrong`, !await banner(page));
        await page.picture();
        // An axis between them, or what both have in common.
        const [wall, meet] = [await pixels(page, 'wall'), await pixels(page, 'meet')];
        check(`scene "${id}": drawn so (${wall} and ${meet} pixels)`, axis === 'none' ? meet > 100 && wall === 0 : wall > 60 && meet < 30);
    }
}

async function drags(page) {
    await page.click('preset-edge');
    const before = await numbers(page);
    const [a, center] = [await place(page, 0), await place(page, 3)];
    await page.drag(a, center);
    const after = await numbers(page);
    check('a vertex dragged into the box: overlap', await says(page, 'Overlap', 'none'));
    check('only that vertex has moved', after.every((x, k) => (x !== before[k]) === (k < 3)));
    await page.drag(await place(page, 0), a);
    check('and dragged out again: disjoint', await says(page, 'Disjoint', 'x × bc'));

    await page.click('preset-edge');
    // On the middle of the triangle, which no vertex is near to.
    const [x, y, z] = await Promise.all([0, 1, 2].map((k) => place(page, k)));
    const middle = x.map((p, i) => (p + y[i] + z[i]) / 3);
    await page.drag(middle, [middle[0], middle[1] + 130]);
    check('the triangle dragged down: overlap', await says(page, 'Overlap', 'none') &&
        (await numbers(page)).every((v, k) => (v !== before[k]) === (k < 9)));

    await page.click('preset-face');
    const still = await numbers(page);
    await page.drag(await place(page, 3), [40, 500]);
    const now = await numbers(page);
    check('the box dragged: its centre moves, and nothing else', now.every((v, k) => (v !== still[k]) === (k >= 9 && k < 12)));
    await page.drag([30, 80], [130, 120]);
    check('beside them the picture turns, and no number changes', (await numbers(page)).every((v, k) => v === now[k]));
}

async function wrong(page) {
    for (const scalar of [0, 1]) {
        await page.evaluate(`document.querySelectorAll('#scalars input')[${scalar}].click()`);
        await page.click('wrong');
        check(`${['f32', 'I8F8'][scalar]}: a banner says that rounding is wrong`, await banner(page));
        console.log(`       ${await page.text('banner')}`);
    }
    await page.evaluate(`document.querySelectorAll('#scalars input')[0].click()`);
    await page.click('wrong');
    const start = await numbers(page);
    // Far enough from the flip all methods agree again.
    for (let k = 0; k < 24; k += 1) await page.click('up');
    const up = await numbers(page);
    check('24 units of the last place on, all agree', !await banner(page) && up.filter((x, k) => x !== start[k]).length === 1);
    for (let k = 0; k < 24; k += 1) await page.click('down');
    check('and back again they do not', await banner(page) && (await numbers(page)).every((x, k) => x === start[k]));
    await page.click('preset-edge');
    await page.click('touch');
    check('"bring to touch" leaves a gap of less than a millionth, or none', /⁻|touch/.test(await page.text('why')));
    await page.click('closer');
    await page.picture();
    check('it can be seen from as near as it is wide', await pixels(page, 'box') > 500);
    await page.click('bits');
    check('numbers show their bits', /^0x[0-9a-f]{8}$/.test(await page.evaluate(`document.querySelector('#numbers small').textContent`)));
    await page.click('bits');
    const write = (k, text) => page.evaluate(`(() => {
        const input = document.querySelectorAll('#numbers input')[${k}];
        input.value = '${text}';
        input.dispatchEvent(new Event('change'));
    })()`);
    await page.click('preset-face');
    await write(11, '1.5');
    check('a number can be written', await says(page, 'Overlap', 'none') && (await numbers(page))[11] === 1.5);
    await write(14, '-1');
    check('what is no box is refused, and the last good one kept', (await page.text('remark-14')).includes('Kept: 0.75') &&
        await says(page, 'Overlap', 'none'));
    await page.click('preset-face');
    await write(14, 'abc');
    await page.click('preset-edge');
    check('a scene ends all errors', await page.evaluate(`document.querySelector('[aria-invalid=true]') === null`));
}

async function far(page) {
    await page.click('preset-edge');
    for (const k of [0, 3, 6, 9]) {
        await page.evaluate(`document.querySelectorAll('#numbers input')[${k}].focus()`);
        await page.evaluate('document.activeElement.select()');
        await page.write(String(1000 + k));
        await page.press('Enter');
    }
    const [gone, goneToo] = [await pixels(page, 'triangle'), await pixels(page, 'box')];
    await page.click('whole');
    check('"whole view" finds shapes that are far away', gone + goneToo === 0 &&
        await pixels(page, 'triangle') > 300 && await pixels(page, 'box') > 300);
    await page.click('preset-edge');
}

async function hashes(page) {
    for (const name of Object.keys(golden)) {
        const lines = await page.evaluate(`(async () => {
            const { hashes, areGolden } = await import('./test/golden.mjs');
            const all = await hashes(await (await fetch('${name}')).arrayBuffer());
            return [areGolden(all), ...all];
        })()`);
        console.log(`\n${golden[name]}\n${lines.slice(1).join('\n')}`);
        check('the golden hashes, in Chromium', lines[0]);
    }
}

/** Each view loads what is its own. */
async function apart() {
    for (const [view, own, others] of [['', '/web.wasm', /mesh/], ['mesh/', '/bindings/npm/dist/simd.js', /^\/(web\.wasm|app\.mjs|module\.mjs)$|plain|pairs/]]) {
        const page = await browser.open(`${address}${view}`);
        await page.until('document.body.dataset.ready');
        const loaded = await page.evaluate(`performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname)`);
        check(`/${view} loads ${own}, and nothing of the other view`, loaded.includes(own) && !loaded.some((path) => others.test(path)));
    }
}

/** What the page says of a module that is missing, or is not the one that it needs. */
async function withoutModules() {
    const { server: empty, address: elsewhere } = await serve({}, 0);
    const lone = await browser.open(elsewhere);
    await lone.until(`document.getElementById('missing').open`);
    check('without a module the page asks for one', await lone.evaluate(`!document.body.dataset.ready`));
    for (let k = 0; k < 3; k += 1) await lone.press('Escape');
    await lone.evaluate(`new Promise((later) => setTimeout(later, 200))`);
    const asks = lone.until(`document.getElementById('missing').open`);
    check('and goes on asking', await asks.then(() => true, () => false));
    empty.closeAllConnections();
    empty.close();
    const { server: swapped, address: there } = await serve({ 'web.wasm': Object.values(golden)[0], 'bindings/npm/dist/simd.js': '/' }, 0);
    for (const [view, id, says, name] of [['', 'refused', 'not web.wasm', 'web.wasm'], ['mesh/', 'problem', 'dist/simd.js', 'the package']]) {
        const page = await browser.open(`${there}${view}`);
        await page.until(`document.getElementById('missing').open`);
        check(`/${view} with another module, or none, says so, and that cargo web builds ${name}`,
            (await page.text(id)).includes(says) && (await page.text('missing')).includes(`cargo web builds ${name}`));
    }
    swapped.closeAllConnections();
    swapped.close();
}

try {
    const page = await browser.open(address);
    await page.size(1080, 760);
    await page.until('document.body.dataset.ready');
    await page.theme('light');
    console.log(`\n${await page.evaluate('navigator.userAgent')}\n${await page.text('size')}`);
    await scenes(page);
    await drags(page);
    await wrong(page);
    await far(page);
    await hashes(page);
    await page.click('wrong');
    await page.evaluate(`document.activeElement.blur()`);
    if (picture === '--picture') {
        await page.size(1180, 900, 1.5);
        await page.evaluate(`document.querySelector('aside').scrollTo(0, 0)`);
        writeFileSync(file, await page.picture());
    }
    const shot = await page.picture();
    await page.theme('dark');
    const dark = await page.picture();
    check('it has a dark theme', !shot.equals(dark));
    for (const test of [withoutMouse, onPhone, rubbishInAllFields]) {
        console.log();
        await test(await browser.open(address)).catch((error) => check(error.stack, false));
    }
    console.log();
    const open = (script) => browser.open(`${address}mesh/`, script);
    await meshInVoxels(open).catch((error) => check(error.stack, false));
    if (picture === '--picture') {
        const posed = await open();
        await pose(posed);
        writeFileSync(file.replace('.png', '-mesh.png'), await posed.picture());
    }
    await apart();
    server.closeAllConnections();
    await withoutModules();
    const local = await browser.open(new URL('../index.html', import.meta.url).href);
    await local.until(`getComputedStyle(document.getElementById('verdict')).visibility === 'visible'`);
    check('opened as a file it says that it needs a server', /server: *cargo web/.test((await local.text('why')).replace(/\s+/g, ' ')));
    check('no error in the page', browser.errors.length === 0);
    browser.errors.forEach((error) => console.log(`       ${error}`));
} catch (error) {
    check(error.stack, false);
} finally {
    await browser.close();
    server.close();
}
process.exit(outcome());
