// Runs a module without imports; cargo calls it. One that exports `lines() -> count`
// and `line(k) -> length`, its text in the exported `buffer()`, is printed; that of the
// page in ../web is served with the page.
import { readFileSync } from 'node:fs';

const path = process.argv[2];
const module = await WebAssembly.instantiate(readFileSync(path));
const { memory, buffer, lines, line } = module.instance.exports;
if (lines) {
    for (let k = 0; k < lines(); k++) {
        const length = line(k);
        console.log(new TextDecoder().decode(new Uint8Array(memory.buffer, buffer(), length)));
    }
} else {
    const { serve } = await import('../web/serve.mjs');
    const at = (port) => serve({ 'web.wasm': path }, port);
    // Another port where that one is taken.
    const { address } = await at(Number(process.env.PORT ?? 8017)).catch(() => at(0));
    console.log(`The page is at ${address} until you press Ctrl-C.`);
}
