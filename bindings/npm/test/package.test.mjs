// What `npm pack` makes, installed into an empty folder: a program in TypeScript is checked and
// runs. Needs `npm install` here, for the compiler, and is skipped without it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const compiler = join(root, 'node_modules/typescript/bin/tsc');
/** The most bytes of the package. */
const MOST = 251_000;

const PROGRAM = `
import { init, inSteps, Mesh, type Hit, type Voxels } from 'septum';
import * as pairs from 'septum/pairs';

const { simd }: { simd: boolean } = await init();
await pairs.init();
const mesh: Mesh = new Mesh(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
const hit: Hit | null = mesh.raycast([0.25, 0.25, 2], { x: 0, y: 0, z: -1 }, { cull: 'back' });
const voxels: Voxels = await inSteps(mesh.voxelizeSteps(4, { solid: true }), { slice: 4 });
const [x, y, z]: [number, number, number] = [...voxels][0]!;
const contact = pairs.contact({ a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0] }, { min: [-1, -1, -0.5], max: [1, 1, 1] });
const out = pairs.contact({ center: [0, 0, 0.5], radius: 1 }, { min: [-1, -1, -1], max: [1, 1, 0] });
if (out && 'nearest' in out.features) console.log(out.features.nearest[0].kind);
const [first] = mesh.sphereContacts([0.25, 0.25, -0.25], 0.5);
const kind: string | undefined = mesh.sphereCast([0, 0, 9], 1, [0, 0, -9])?.part?.kind ?? first?.part.kind;
// @ts-expect-error: spheres have no contacts with spheres
try { pairs.contact({ center: [0, 0, 0], radius: 1 }, { center: [0, 0, 0], radius: 1 }); } catch { /* as it says */ }
// @ts-expect-error: a ray has a direction
try { mesh.raycast([0, 0, 0]); } catch (error) { console.log(String(error)); }
// @ts-expect-error: there is no such side
try { mesh.raycast([0, 0, 0], [1, 0, 0], { cull: 'left' }); } catch { /* as it says */ }
console.log(typeof simd, hit?.t, x + y + z, mesh.contains([0.1, 0.1, 0.1]), contact?.depth, out?.depth, kind);
mesh.free();
`;

test('the program of docs/getting-started.md says what its comments say', async () => {
    const page = readFileSync(join(root, '../../docs/getting-started.md'), 'utf8');
    const [, program] = page.match(/```js\n(.*?)```/s);
    const index = new URL('../js/index.js', import.meta.url);
    const text = `${program.replace("'septum'", `'${index}'`)}export { triangle, t, where, size, count };`;
    const { triangle, t, where, size, count } = await import(`data:text/javascript,${encodeURIComponent(text)}`);
    assert.deepEqual([triangle, t, where, size[0]], [0, 1, 'on', 64]);
    assert.ok(count > 64);
});

test('the package, installed, is checked by TypeScript and runs', { skip: !existsSync(compiler) && 'no TypeScript: npm install' }, () => {
    const place = mkdtempSync(join(tmpdir(), 'septum-'));
    try {
        const run = (program, ...options) => execFileSync(program, options, { cwd: place, encoding: 'utf8' });
        const name = execFileSync('npm', ['pack', '--silent', '--ignore-scripts', '--pack-destination', place], { cwd: root, encoding: 'utf8' }).trim();
        const bytes = statSync(join(place, name)).size;
        assert.ok(bytes <= MOST, `${bytes} bytes`);
        writeFileSync(join(place, 'package.json'), '{ "type": "module", "private": true }');
        writeFileSync(join(place, 'program.ts'), PROGRAM);
        run('npm', 'install', '--silent', '--offline', '--no-audit', '--no-fund', `./${name}`);
        run(process.execPath, compiler, '--strict', '--noUncheckedIndexedAccess', '--target', 'es2022', '--module', 'nodenext', '--lib', 'es2022,dom', 'program.ts');
        assert.equal(run(process.execPath, 'program.js'), 'TypeError: direction is undefined, not three numbers: [x, y, z] or { x, y, z }\nboolean 1.5 0 true 0.5 0.5 vertex\n');
    } finally {
        rmSync(place, { recursive: true });
    }
});
