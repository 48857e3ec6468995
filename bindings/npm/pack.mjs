// pack.mjs <module.wasm> <file.js> [<other.wasm>]: writes a module of JavaScript that holds the
// WebAssembly, deflated, or a patch that makes it of another module. js/load.js unpacks it.
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import { difference } from './difference.mjs';

const [, , from, to, other] = process.argv;
const module = readFileSync(from);
const bytes = other === undefined ? module : difference(readFileSync(other), module);
const packed = deflateRawSync(bytes, { level: 9, memLevel: 9 }).toString('base64');
writeFileSync(to, `export default [${bytes.length}, '${packed}'];\n`);
console.log(`${to}: ${bytes.length} bytes, ${(packed.length * 0.75).toFixed(0)} packed`);
