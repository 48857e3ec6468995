// What the second view does with the package, in node: voxels against boxes and points, rays and
// points against plain loops over all triangles; files; and that all work is in steps.
//
//     node examples/web/test/mesh.mjs
import { readFileSync } from 'node:fs';

import { Mesh, init } from '../../../bindings/npm/js/index.js';
import { soupOf } from '../mesh/draw.mjs';
import { facesOf } from '../mesh/faces.mjs';
import { readMesh } from '../mesh/file.mjs';
import { MOST_TRIANGLES } from '../mesh/numbers.mjs';
import { sentence } from '../mesh/refusal.mjs';
import { Superseded, Work, run } from '../mesh/work.mjs';
import { random } from './cases.mjs';
import { check, outcome } from './check.mjs';
import { CUBE_OBJ, CUBE_TEXT, RUBBISH, cubeStl, wavesStl } from './files.mjs';
import { golden } from './teapot.mjs';

const still = async () => {};
const read = (name, ...parts) => readMesh(name, new Blob(parts), still);
const load = async (name, ...parts) => {
    const { positions, index } = await read(name, ...parts);
    return new Mesh(positions, index);
};
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

/** Each voxel by a box, its centre by a point: how many touch, and in how many rows a solid differs. */
function oneByOne(mesh, solid) {
    const { origin, cell, size: [nx, ny, nz] } = solid;
    const plane = (i, k) => Math.fround(origin[i] + cell[i] * k);
    let [touched, rows] = [0, 0];
    for (let z = 0; z < nz; z += 1) {
        for (let y = 0; y < ny; y += 1) {
            let isOther = false;
            for (let x = 0; x < nx; x += 1) {
                const [low, high] = [0, 1].map((k) => [x, y, z].map((n, i) => plane(i, n + k)));
                const touches = mesh.overlapsBox(low, high);
                touched += touches;
                isOther ||= solid.has(x, y, z) !== (touches || mesh.contains(low.map((a, i) => Math.fround((a + high[i]) / 2))));
            }
            rows += isOther;
        }
    }
    return { touched, rows };
}

function voxels(mesh) {
    for (const { resolution, size, surface, solid, open } of golden) {
        const [first, second] = [mesh.voxelize(resolution), mesh.voxelize(resolution, { solid: true })];
        check(`the teapot in ${size.join(' × ')}: ${surface} voxels, ${solid} with the inside, ${open} rows open`,
            [first, second].every((grid) => grid.size.join() === size.join()) &&
            first.count === surface && second.count === solid && second.openRows === open);
        const { touched, rows } = oneByOne(mesh, second);
        check(`as each voxel by itself, but for ${rows} rows that do not close`, touched === surface && rows <= open);
    }
}

function rays(mesh) {
    const triangles = Array.from({ length: mesh.triangleCount }, (_, k) => mesh.corners(k));
    const next = random(5);
    const draw = (size) => Array.from({ length: 3 }, () => Math.fround((next() * 2 - 1) * size));
    const count = { hits: 0, misses: 0, inside: 0, wrong: 0 };
    for (let k = 0; k < 300; k += 1) {
        const [from, along] = [draw(25), draw(1)];
        const all = hits(triangles, from, along);
        if (!all) continue;
        const hit = mesh.raycast(from, along);
        count[all.length ? 'hits' : 'misses'] += 1;
        count.wrong += hit?.triangle !== all[0]?.k || (all.length > 0 && Math.abs(hit.t - all[0].t) > 1e-4 * all[0].t);
    }
    for (let k = 0; k < 150; k += 1) {
        const point = draw(9);
        const all = hits(triangles, point, [1, 0, 0]);
        if (!all) continue;
        count.inside += all.length % 2;
        count.wrong += mesh.locate(point) !== ['outside', 'inside'][all.length % 2];
    }
    check(`rays and points agree with a loop over all triangles (${JSON.stringify(count)})`, count.wrong === 0 &&
        count.hits > 30 && count.misses > 30 && count.inside > 20);
}

async function cubes() {
    for (const [name, content] of [['cube.obj', CUBE_OBJ], ['Cube.STL', CUBE_TEXT], ['binary.stl', cubeStl()]]) {
        const mesh = await load(name, content);
        const [surface, solid] = [mesh.voxelize(16), mesh.voxelize(16, { solid: true })];
        check(`${name}: a closed cube of 16³ voxels`, mesh.triangleCount === 12 && mesh.openEdge() === null &&
            surface.count === 16 ** 3 - 14 ** 3 && solid.count === 16 ** 3 && solid.openRows === 0);
        const points = { inside: [0.5, 0.25, 1 - 2 ** -24], on: [0.5, 0.5, 1], outside: [0.5, 0.5, 1 + 2 ** -23] };
        check(`${name}: inside, on it and outside, one unit in the last place apart`,
            Object.entries(points).every(([where, point]) => mesh.locate(point) === where));
    }
}

async function refused() {
    for (const [name, content, says] of RUBBISH) {
        const message = await load(name, content).then((mesh) => mesh.voxelize(64)).then(() => 'taken', sentence);
        check(`${name}: ${message}`, says.test(message));
    }
    const many = new Uint8Array(84 + 50 * (MOST_TRIANGLES + 1));
    new DataView(many.buffer).setUint32(80, MOST_TRIANGLES + 1, true);
    check('a triangle too many is refused', /more than 500,000/.test(await read('many.stl', many).catch(({ message }) => message)));
    const fake = { size: 300 << 20, arrayBuffer: () => { throw new Error('read'); } };
    check('a file too large is refused before it is read', /300 MB/.test(await readMesh('a.obj', fake, still).catch(({ message }) => message)));
}

/** The steps of a piece of work, and its result. */
async function steps(work) {
    let count = 0;
    const { value } = await run(work, async () => { count += 1; });
    return { count, value };
}

/** Work on a large mesh is in steps, between which the page may draw. */
async function inSteps() {
    const sides = 150;
    const triangles = 2 * sides ** 2;
    let pauses = 0;
    const { positions, index } = await readMesh('waves.stl', new Blob([wavesStl(sides)]), async () => { pauses += 1; });
    check(`${triangles} triangles are read with ${pauses} pauses`, positions.length === 9 * triangles && pauses >= triangles / 5000);
    const { count: built, value: mesh } = await steps(Mesh.steps(positions, index));
    const { count: looked, value: edge } = await steps(mesh.openEdgeSteps());
    const { count: filled, value: grid } = await steps(mesh.voxelizeSteps(100, { solid: true }));
    const { count: faced, value: faces } = await steps(facesOf(grid.words, grid.size));
    const { count: copied, value: soup } = await steps(soupOf(mesh, [0, 0, 0]));
    const all = { built, looked, filled, faced, copied };
    check(`and worked on in steps: ${JSON.stringify(all)}`, edge.length === 2 && faces.length > grid.count && soup.every((x, k) => x === positions[k]) &&
        [built, looked, filled / 2, copied].every((count) => count >= triangles / 5000) && faced === grid.size[1] * grid.size[2]);
    const work = new Work();
    const pause = work.begin('');
    const left = run(mesh.openEdgeSteps(), async (share) => {
        if (share > 0.5) work.begin('');
        await pause(share);
    }).catch((error) => error);
    check('newer work ends it', await left instanceof Superseded);
}

await init();
const teapot = await load('teapot.obj', TEAPOT);
voxels(teapot);
rays(teapot);
await cubes();
await refused();
await inSteps();
process.exit(outcome());
