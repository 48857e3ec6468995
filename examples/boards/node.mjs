// Runs a module without imports that exports `lines() -> count` and
// `line(k) -> length`, its text in the exported `buffer()`. Cargo calls it.
import { readFileSync } from 'node:fs';

const module = await WebAssembly.instantiate(readFileSync(process.argv[2]));
const { memory, buffer, lines, line } = module.instance.exports;
for (let k = 0; k < lines(); k++) {
    const length = line(k);
    console.log(new TextDecoder().decode(new Uint8Array(memory.buffer, buffer(), length)));
}
