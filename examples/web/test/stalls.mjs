// A mesh of 300,000 triangles: no call of the module has all of them, and the page works in between.
// Prints the longest stalls; these depend on the machine.
import { check } from './check.mjs';

const SIDES = 388;
const TRIANGLES = 2 * SIDES ** 2;
/** The most triangles of a call, and the least number of calls for all of them. */
const [MOST, LEAST] = [4096, Math.ceil(TRIANGLES / 4096)];

/** Notes the triangles of each call, the longest tasks, and the turns of the page. */
const NOTE = `
window.noted = { begun: 0, calls: {}, turns: 0, gap: 0, tasks: [] };
const triangles = { advance: ([, n]) => n, count_edges: ([, , from, to]) => to - from, fill: ([, , from, to]) => to - from, cross: ([, , from, to]) => to - from };
WebAssembly.instantiate = ((instantiate) => async (...given) => {
    const { instance } = await instantiate.call(WebAssembly, ...given);
    const exports = { ...instance.exports };
    for (const [name, count] of Object.entries(triangles)) {
        exports[name] = (...numbers) => {
            (noted.calls[name] ??= []).push(count(numbers));
            return instance.exports[name](...numbers);
        };
    }
    return { instance: { exports } };
})(WebAssembly.instantiate);
new PerformanceObserver((list) => noted.tasks.push(...list.getEntries().filter(({ startTime }) => startTime >= noted.begun).map(({ duration }) => Math.round(duration)))).observe({ entryTypes: ['longtask'] });
const channel = new MessageChannel();
let last = performance.now();
channel.port1.onmessage = () => {
    const now = performance.now();
    noted.gap = Math.max(noted.gap, Math.round(now - last));
    noted.turns += 1;
    last = now;
    setTimeout(() => channel.port2.postMessage(null));
};
channel.port2.postMessage(null);
`;

/** Drawing is left out where it shows what the page itself takes: here a program draws, not a card. */
const BLIND = `WebGL2RenderingContext.prototype.drawArrays = WebGL2RenderingContext.prototype.clear = () => {};`;

async function longest(page, idle, what) {
    await page.evaluate(`last = performance.now(); Object.assign(noted, { begun: last, calls: {}, turns: 0, gap: 0, tasks: [] });`);
    await what();
    await idle(page);
    await page.evaluate('new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)))');
    const { calls, turns, gap, tasks } = await page.evaluate('({ ...noted })');
    return { calls, turns, text: `longest tasks ${tasks.sort((a, b) => b - a).slice(0, 3).join(', ') || 'below 50'} ms, longest wait for a turn ${gap} ms` };
}

export async function stalls(open, idle) {
    for (const [script, how] of [[NOTE + BLIND, 'not drawn'], [NOTE, 'drawn without a graphics card']]) {
        const page = await open(script);
        await page.size(1080, 760);
        await idle(page);
        await page.evaluate(`(async () => {
            const { wavesStl } = await import('../test/files.mjs');
            window.file = new File([wavesStl(${SIDES})], 'waves.stl');
        })()`);
        const { calls, turns, text } = await longest(page, idle, async () => {
            await page.evaluate(`(() => {
                const dataTransfer = new DataTransfer();
                dataTransfer.items.add(file);
                document.getElementById('scene').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
            })()`);
            await page.until(`document.getElementById('mesh').textContent.startsWith('waves.stl')`);
        });
        console.log(`       ${TRIANGLES} triangles loaded, ${how}: ${text}`);
        const wrong = ['advance', 'count_edges', 'fill'].filter((name) => !(calls[name]?.length >= LEAST && Math.max(...calls[name]) <= MOST));
        check(`no call of the module has more than ${MOST} of them${wrong.map((name) => `, but ${name}`).join('')}`, wrong.length === 0);
        check(`and the page works in between (${turns} turns)`, turns > 5);
        const solid = await longest(page, idle, () => page.evaluate(`document.getElementById('solid').click()`));
        console.log(`       a solid of them: ${solid.text}`);
    }
}
