// Runs a module without imports; cargo calls it. One that exports `lines() -> count`
// and `line(k) -> length`, its text in the exported `buffer()`, is printed; those of the
// page in ../web are served with the page.
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
    const { start } = await import('../web/start.mjs');
    await start(path);
}
