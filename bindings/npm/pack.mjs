// pack.mjs <module.wasm> <file.js>: writes a module of JavaScript that holds the WebAssembly,
// deflated, and unpacks it.
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';

const [, , from, to] = process.argv;
const bytes = readFileSync(from);
const packed = deflateRawSync(bytes, { level: 9 }).toString('base64');
writeFileSync(to, `export default [${bytes.length}, '${packed}'];\n`);
console.log(`${to}: ${bytes.length} bytes, ${(packed.length * 0.75).toFixed(0)} packed`);
