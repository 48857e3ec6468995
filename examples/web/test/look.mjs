// What the tests look at in the page.

/** The numbers in use, as their bits: not what stands in the fields. */
export const bits = (page) => page.evaluate(
    `[...document.querySelectorAll('#numbers small')].map(({ textContent }) => textContent)`);

/** The fields' numbers. */
export const numbers = (page) => page.evaluate(
    `[...document.querySelectorAll('#numbers input')].map(({ value }) => Number(value))`);

const lit = (page) => page.evaluate(`document.querySelector('#axes .first')?.textContent ?? 'none'`);
export const says = async (page, word, axis) => await page.text('word') === word && await lit(page) === axis;
export const banner = (page) => page.evaluate(`document.getElementById('banner').checkVisibility()`);

/** The scene as it is drawn: a text that is another for every other picture. */
export async function drawing(page) {
    await page.drawn();
    return page.evaluate(`document.getElementById('scene').toDataURL()`);
}

/** How many pixels of the picture are nearly of a colour of the page, and how wide they reach. */
const search = async (page, color) => {
    await page.drawn();
    return page.evaluate(`(() => {
        const canvas = document.getElementById('scene');
        const probe = document.createElement('canvas').getContext('2d');
        probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--${color}');
        probe.fillRect(0, 0, 1, 1);
        const wanted = probe.getImageData(0, 0, 1, 1).data;
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let [count, left, right] = [0, Infinity, -Infinity];
        for (let i = 0; i < data.length; i += 4) {
            if (data[i + 3] <= 250 || [0, 1, 2].some((k) => Math.abs(data[i + k] - wanted[k]) >= 40)) continue;
            const x = i / 4 % canvas.width;
            [count, left, right] = [count + 1, Math.min(left, x), Math.max(right, x)];
        }
        return { count, width: count && right - left };
    })()`);
};
export const pixels = async (page, color) => (await search(page, color)).count;
export const width = async (page, color) => (await search(page, color)).width;

/** Where vertex k is on the page (3: the box's centre), by the page's own camera from the start. */
export const place = (page, k) => page.evaluate(`(async () => {
    const { Camera } = await import('./camera.mjs');
    const canvas = document.getElementById('scene');
    const camera = Object.assign(new Camera(), { width: canvas.clientWidth, height: canvas.clientHeight });
    const values = [...document.querySelectorAll('#numbers input')].map(({ value }) => Number(value));
    return camera.pixel(values.slice(3 * ${k}, 3 * ${k} + 3)).at;
})()`);
