// The module's answers about meshes, in node: voxels against the golden table that a test in Rust
// makes by asking each voxel, rays and points against plain loops over all triangles; and files.
//
//     node examples/web/test/mesh.mjs <most bytes> <web_mesh.wasm>…
import { readFileSync } from 'node:fs';

import { readMesh } from '../mesh/file.mjs';
import { MOST_TRIANGLES, Mesh } from '../mesh/module.mjs';
import { random } from './cases.mjs';
import { check, outcome } from './check.mjs';
import { CUBE_OBJ, CUBE_TEXT, RUBBISH, cubeStl } from './files.mjs';
import { golden } from './teapot.mjs';

const still = async () => {};
const read = (name, ...parts) => readMesh(name, new Blob(parts), still);
const TEAPOT = readFileSync(new URL('../../assets/teapot.obj', import.meta.url));

const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Where a ray hits each triangle, by volumes; `null` if one is in doubt. */
function hits(triangles, from, along) {
    const found = [];
    for (const [k, corners] of triangles.entries()) {
        const [a, b, c] = corners.map((v) => minus(v, from));
        const sides = [dot(along, cross(b, c)), dot(along, cross(c, a)), dot(along, cross(a, b))];
        const sum = sides[0] + sides[1] + sides[2];
        const least = 1e-9 * Math.hypot(...along) * Math.max(...corners.flat().map(Math.abs), 1) ** 2;
        if (sides.some((s) => Math.abs(s) < least)) {
            if (Math.max(...sides) > -least && Math.min(...sides) < least && Math.abs(sum) > least) return null;
            continue;
        }
        if (!(sides.every((s) => s > 0) || sides.every((s) => s < 0))) continue;
        found.push({ k, t: dot(a, cross(b, c)) / sum });
    }
    return found.filter(({ t }) => t > 1e-9).sort((p, q) => p.t - q.t);
}

async function voxels(mesh) {
    mesh.load(await read('teapot.obj', TEAPOT));
    for (const { resolution, size, surface, solid, open } of golden) {
        const first = await mesh.voxelize(resolution, false, still);
        const second = await mesh.voxelize(resolution, true, still);
        check(`the teapot in ${size.join(' × ')}: ${surface} voxels, ${solid} with the inside, ${open} rows open`,
            [first, second].every((grid) => grid.size.join() === size.join()) &&
            first.count === surface && second.count === solid && second.open === open);
    }
    const grid = await mesh.voxelize(64, true, still);
    const ones = grid.words.reduce((sum, word) => {
        let count = 0;
        for (let rest = word; rest; rest &= rest - 1) count += 1;
        return sum + count;
    }, 0);
    check('as many bits are set as it says', ones === grid.count);
    let marks = 0;
    for (let k = 0; k < mesh.triangles; k += 50) {
        const marked = mesh.mark(k, grid.size);
        marks += marked.count;
        if (marked.words.some((word, i) => word & ~grid.words[i])) marks = NaN;
    }
    check('the voxels of a triangle are among them', marks > 0);
}

async function rays(mesh) {
    const triangles = Array.from({ length: mesh.triangles }, (_, k) => mesh.corners(k));
    const next = random(5);
    const draw = (size) => Array.from({ length: 3 }, () => Math.fround((next() * 2 - 1) * size));
    const count = { hits: 0, misses: 0, inside: 0, wrong: 0 };
    for (let k = 0; k < 300; k += 1) {
        const [from, along] = [draw(25), draw(1)];
        const all = hits(triangles, from, along);
        if (!all) continue;
        const { triangle, t } = mesh.pick(from, along);
        count[all.length ? 'hits' : 'misses'] += 1;
        count.wrong += triangle !== (all[0]?.k ?? null) || (all.length > 0 && Math.abs(t - all[0].t) > 1e-4 * all[0].t);
    }
    for (let k = 0; k < 150; k += 1) {
        const point = draw(9);
        const all = hits(triangles, point, [1, 0, 0]);
        if (!all) continue;
        count.inside += all.length % 2;
        count.wrong += mesh.inside(point).where !== ['outside', 'inside'][all.length % 2];
    }
    check(`rays and points agree with a loop over all triangles (${JSON.stringify(count)})`, count.wrong === 0 &&
        count.hits > 30 && count.misses > 30 && count.inside > 20);
}

async function cubes(mesh) {
    for (const [name, content] of [['cube.obj', CUBE_OBJ], ['Cube.STL', CUBE_TEXT], ['binary.stl', cubeStl()]]) {
        mesh.load(await read(name, content));
        const [surface, solid] = [await mesh.voxelize(16, false, still), await mesh.voxelize(16, true, still)];
        check(`${name}: a closed cube of 16³ voxels`, mesh.triangles === 12 && mesh.openEdge() === null &&
            surface.count === 16 ** 3 - 14 ** 3 && solid.count === 16 ** 3 && solid.open === 0);
        const points = { inside: [0.5, 0.25, 1 - 2 ** -24], on: [0.5, 0.5, 1], outside: [0.5, 0.5, 1 + 2 ** -23] };
        check(`${name}: inside, on it and outside, one unit in the last place apart`,
            Object.entries(points).every(([where, point]) => mesh.inside(point).where === where));
    }
    mesh.load(await read('open.obj', CUBE_OBJ.split('\r\n').filter((line) => !line.startsWith('f -')).join('\r\n')));
    check('a cube without sides is open at an edge of it', mesh.openEdge()?.flat().every((x) => x === 0 || x === 1));
}

async function refused(mesh) {
    for (const [name, content, says] of RUBBISH) {
        const message = await read(name, content).then(async (numbers) => {
            mesh.load(numbers);
            return mesh.voxelize(64, false, still);
        }).then(() => 'taken', (error) => error.message);
        check(`${name}: ${message}`, says.test(message));
    }
    const many = new Uint8Array(84 + 50 * (MOST_TRIANGLES + 1));
    new DataView(many.buffer).setUint32(80, MOST_TRIANGLES + 1, true);
    check('a triangle too many is refused', /more than 500,000/.test(await read('many.stl', many).catch(({ message }) => message)));
    const fake = { size: 300 << 20, arrayBuffer: () => { throw new Error('read'); } };
    check('a file too large is refused before it is read', /300 MB/.test(await readMesh('a.obj', fake, still).catch(({ message }) => message)));
    // The largest mesh that there is, of small triangles, and a small one after it.
    const place = (k) => [k % 80, Math.floor(k / 80) % 80, Math.floor(k / 6400)];
    const vertices = new Float32Array(9 * MOST_TRIANGLES);
    for (let k = 0; k < vertices.length; k += 1) {
        vertices[k] = place(Math.floor(k / 9))[k % 3] + (k % 9 === 3 || k % 9 === 7 ? 0.5 : 0);
    }
    mesh.load({ vertices, triangles: Uint32Array.from({ length: 3 * MOST_TRIANGLES }, (_, k) => k) });
    await mesh.voxelize(256, false, still);
    check(`${MOST_TRIANGLES} triangles, each with its own vertices, fit (${mesh.bytes / (1 << 20)} MB)`, mesh.bytes <= 96 << 20);
    const most = mesh.bytes;
    let message = '';
    try {
        mesh.load({ vertices: { length: 9e9 }, triangles: { length: 9e9 } });
    } catch (error) {
        message = error.message;
    }
    check('what does not fit is refused', /no memory/.test(message));
    mesh.load(await read('cube.obj', CUBE_OBJ));
    check('and memory does not grow for a small mesh', mesh.bytes === most && mesh.inside([0.5, 0.5, 0.5]).where === 'inside');
}

const [most, ...paths] = process.argv.slice(2);
for (const path of paths) {
    const bytes = readFileSync(path);
    console.log(`\n${path}: ${bytes.length} bytes`);
    check(`it has at most ${most} bytes`, bytes.length <= Number(most));
    check('it imports nothing', WebAssembly.Module.imports(new WebAssembly.Module(bytes)).length === 0);
    const mesh = await Mesh.from(bytes);
    await voxels(mesh);
    await rays(mesh);
    await cubes(mesh);
    await refused(mesh);
}
process.exit(outcome());
