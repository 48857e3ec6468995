// The page on a phone: what is shown is in sight, two fingers zoom the picture and not
// the page, and all that is touched is large enough.
import { check } from './check.mjs';
import { banner, bits, numbers, place, says, width } from './look.mjs';

const SIZE = [390, 844];
/** The least height of what a finger is to hit, in CSS pixels. */
const TALL = 44;

/** Whether all of an element is in sight, after what scrolls has come to rest. */
async function isInSight(page, id) {
    const top = () => page.evaluate(`document.getElementById('${id}').getBoundingClientRect().top`);
    for (let before = await top(), k = 0; k < 40; k += 1) {
        await new Promise((next) => setTimeout(next, 100));
        const now = await top();
        if (now === before) break;
        before = now;
    }
    return page.evaluate(`(() => {
        const { top, bottom } = document.getElementById('${id}').getBoundingClientRect();
        return top >= 0 && bottom <= innerHeight;
    })()`);
}

async function scenes(page) {
    for (const name of ['f32', 'I8F8', 'f32']) {
        await page.tap(`scalar-${name}`);
        await page.middle('#size');
        check(`${name}: the picture has been scrolled away`, !await isInSight(page, 'scene'));
        await page.tap('wrong');
        check(`${name}: "where rounding is wrong" scrolls to the picture`, await isInSight(page, 'scene'));
        check(`${name}: and its banner is in sight`, await banner(page) && await isInSight(page, 'banner'));
    }
    for (const id of ['preset-face', 'touch']) {
        await page.tap(id);
        check(`"${id}" scrolls to the picture`, await isInSight(page, 'scene'));
    }
}

async function fingers(page) {
    await page.tap('preset-edge');
    await isInSight(page, 'scene');
    const before = await bits(page);
    const start = await width(page, 'triangle');
    const [x, y] = await page.middle('#scene');
    const apart = (by) => [[x - by, y], [x + by, y]];
    await page.touch([apart(40), apart(50), apart(60), apart(70)]);
    const near = await width(page, 'triangle');
    check(`two fingers apart zoom in (${start} to ${near} pixels)`, near > start * 1.2);
    await page.touch([apart(110), apart(90), apart(60), apart(44)]);
    const far = await width(page, 'triangle');
    check(`two fingers together zoom out (${far} pixels)`, far < near / 1.3);
    check('no number has changed', (await bits(page)).join() === before.join());
    check('the page itself is not zoomed or scrolled', await page.evaluate('visualViewport.scale === 1 && scrollY === 0'));

    await page.tap('whole');
    const [a, center] = [await place(page, 0), await place(page, 3)];
    const beside = [a[0] + 18, a[1] - 12];
    await page.touch([[beside], ...[0.25, 0.5, 0.75, 1].map((s) => [beside.map((p, i) => p + s * (center[i] - p))])]);
    const after = await bits(page);
    check('a finger beside a vertex takes it, and drags it into the box', after.every((x, k) => (x !== before[k]) === (k < 3)) &&
        await says(page, 'Overlap', 'none'));
}

async function sizes(page) {
    const small = await page.evaluate(`[...document.querySelectorAll('button, label, #numbers input, #units')]
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < ${TALL})
        .map((element) => element.id || element.ariaLabel || element.textContent)`);
    check(`all that is touched is at least ${TALL} px tall${small.map((name) => `, not ${name}`).join('')}`, small.length === 0);
    const letters = await page.evaluate(`parseFloat(getComputedStyle(document.querySelector('#numbers input')).fontSize)`);
    check('letters in fields are 16 px: no phone zooms into them', letters >= 16);
    check('nothing is wider than the screen', await page.evaluate('document.documentElement.scrollWidth') <= SIZE[0]);
}

async function refusal(page) {
    const good = await numbers(page);
    await page.evaluate(`document.querySelectorAll('#numbers input')[14].focus()`);
    await page.evaluate(`document.activeElement.select()`);
    await page.write('abc');
    await page.press('Enter');
    check('a refusal is in sight', await isInSight(page, 'remark-14') && (await page.text('remark-14')).includes(String(good[14])));
}

/** All of it, on a page of its own. */
export async function onPhone(page) {
    await page.phone(...SIZE);
    await page.until('document.body.dataset.ready');
    await page.theme('light');
    await scenes(page);
    await fingers(page);
    await sizes(page);
    await refusal(page);
}
