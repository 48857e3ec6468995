// The stream of golden.txt in headless Chromium, with and without simd128, and in a worker; and,
// if three.js is installed in bench/, the example: node test/chromium.mjs
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Browser } from '../../../examples/web/test/browser.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };
const obj = readFileSync(join(root, '../../examples/assets/teapot.obj'), 'utf8');
const golden = readFileSync(join(root, 'test/golden.txt'), 'utf8').trimEnd().split('\n');
const server = createServer(async ({ url }, response) => {
    const path = normalize(new URL(url, 'http://localhost').pathname);
    const bytes = path === '/' ? '<!doctype html>' : await readFile(join(root, path)).catch(() => null);
    response.writeHead(bytes === null ? 404 : 200, { 'content-type': types[extname(path) || '.html'] ?? 'text/plain' }).end(bytes ?? '');
});
await new Promise((ready) => { server.listen(0, 'localhost', ready); });
const address = `http://localhost:${server.address().port}/`;

/** A script that asks the stream. */
const program = (simd) => `
    const [{ init, Mesh }, pairs, { golden }] = await Promise.all(['js/index.js', 'js/pairs.js', 'test/stream.mjs'].map((path) => import('${address}' + path)));
    await Promise.all([init({ simd: ${simd} }), pairs.init()]);
    return golden({ Mesh, ...pairs }, ${JSON.stringify(obj)});`;

const browser = new Browser(process.env.CHROMIUM ?? 'chromium');
try {
    for (const simd of [true, false]) {
        const page = await browser.open(address);
        assert.deepEqual(await page.evaluate(`(async () => {${program(simd)}})()`), golden);
        console.log(`Chromium, ${simd ? 'with' : 'without'} simd128: the same`);
    }
    const page = await browser.open(address);
    const inWorker = await page.evaluate(`new Promise((told, failed) => {
        const text = ${JSON.stringify(`(async () => {${program(true)}})().then(postMessage, (error) => postMessage(String(error)));`)};
        const worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), { type: 'module' });
        worker.onmessage = ({ data }) => told(data);
        worker.onerror = ({ message }) => failed(message);
    })`);
    assert.deepEqual(inWorker, golden);
    console.log('Chromium, in a worker: the same');
    if (existsSync(join(root, 'bench/node_modules/three'))) {
        const example = await browser.open(`${address}examples/three.html`);
        await example.until(`document.body.dataset.ready === 'yes'`);
        const said = await example.evaluate(`(async () => {
            const told = new Set();
            for (let x = 0; x < innerWidth; x += 7) {
                dispatchEvent(new PointerEvent('pointermove', { clientX: x, clientY: innerHeight / 2 }));
                told.add(document.querySelector('output').value);
            }
            return [...told];
        })()`);
        assert.ok(said.includes('nothing') && said.filter((text) => / of 80000, t = \d/.test(text)).length > 20, said.join('\n'));
        console.log(`Chromium, with three.js: ${said.length} triangles under the pointer`);
    }
    assert.deepEqual(browser.errors, []);
} finally {
    await browser.close();
    server.close();
}
