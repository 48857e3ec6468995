// pack.mjs <module.wasm> <file.js> [<other.wasm>]: writes a module of JavaScript that holds the
// WebAssembly, or a patch that makes it of another module, in the format of zlib, which node 18 reads.
// js/load.js unpacks it.
import { readFileSync, writeFileSync } from 'node:fs';
// Deflates as any reader understands it, in a twentieth fewer bytes than zlib.
import zopfli from '@gfx/zopfli';
import { difference } from './difference.mjs';

const [, , from, to, other] = process.argv;
const module = readFileSync(from);
const bytes = other === undefined ? module : difference(readFileSync(other), module);
const deflated = await zopfli.zlibAsync(bytes, { numiterations: 15 });
const packed = Buffer.from(deflated).toString('base64');
writeFileSync(to, `export default [${bytes.length}, '${packed}'];\n`);
console.log(`${to}: ${bytes.length} bytes, ${(packed.length * 0.75).toFixed(0)} packed`);
