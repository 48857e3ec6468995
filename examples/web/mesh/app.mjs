// The page: holds a mesh, its voxels and a point, asks the package about them, and shows what it
// says.
import { Mesh, init } from '../../../bindings/npm/js/index.js';
import { atOnce } from '../../../bindings/npm/js/steps.js';
import { read } from '../read.mjs';
import { SCALARS } from '../scalar.mjs';
import { Clock } from './clock.mjs';
import { Picture, soupOf } from './draw.mjs';
import { facesOf } from './faces.mjs';
import { isYUp, readMesh } from './file.mjs';
import { listen, listenToKeys } from './hands.mjs';
import { Broken } from './numbers.mjs';
import { Overlay } from './overlay.mjs';
import * as panel from './panel.mjs';
import { orNull, sentence } from './refusal.mjs';
import { View } from './view.mjs';
import { Superseded, Work, busily, run } from './work.mjs';

const at = (id) => document.getElementById(id);
const canvas = at('scene');
const view = new View();
const picture = new Picture(at('picture'));
const overlay = new Overlay(canvas, at('floor'), view);
// No file is dropped on a phone.
if (matchMedia('(hover: none)').matches) at('hint').textContent = at('hint').textContent.replace(/ Drop an OBJ.*/, '');
const HINT = at('hint').textContent;
const [reading, filling, showing, copying] = Array.from({ length: 4 }, () => new Work());
const clock = new Clock();
const { nearest } = SCALARS[0];

/** Where the teapot may lie: beside the page, or in its repository. */
const TEAPOTS = ['../teapot.obj', '../../assets/teapot.obj'];

const state = {
    mesh: null,
    grid: null,
    picked: null,
    point: null,
    where: 'outside',
    edge: null,
    held: false,
    hasCross: false,
    times: {},
};

const greatest = ({ origin, size, cell }) => origin.map((x, i) => x + size[i] * cell);

let due = false;
function draw() {
    if (due || !state.grid) return;
    due = true;
    requestAnimationFrame(() => {
        due = false;
        // Another file may have come in between.
        if (!state.grid) return;
        const ratio = Math.min(devicePixelRatio, 2);
        const [width, height] = [canvas.clientWidth, canvas.clientHeight];
        for (const each of [canvas, at('picture'), at('floor')]) {
            const [wide, high] = [width, height].map((length) => Math.round(length * ratio));
            if (each.width !== wide || each.height !== high) Object.assign(each, { width: wide, height: high });
        }
        Object.assign(view, { width, height });
        const { grid, picked, point } = state;
        picture.draw(view, grid, at('triangles').checked, [0.92, 0.2, 0.16]);
        overlay.draw({
            from: grid.origin, to: greatest(grid), triangle: picked?.corners, open: state.edge, point, where: state.where,
            isHidden: hides(view.eye, point), isHeld: state.held, hasCross: state.hasCross,
        }, ratio);
    });
}

/** For y and z from which voxel to which there are any: the cut comes from the eye's side. */
function cut({ size }) {
    const axis = view.isYUp ? 2 : 1;
    const away = Math.round(size[axis] * Number(at('cut').value) / 100);
    at('depth').textContent = away === 0 ? 'none' : `${away} of ${size[axis]} layers`;
    const kept = [[0, size[1]], [0, size[2]]];
    if (axis === 2) kept[1] = [0, size[2] - away];
    else kept[0] = [away, size[1]];
    return kept;
}

/** Whether a triangle is between two points, but for one near the second. */
function hides(from, to) {
    return to && orNull(() => state.mesh.raycastAny(from, to.map((x, i) => x - from[i]), { far: 0.999 }));
}

/** What is drawn of the voxels. */
const show = () => busily(async () => {
    const { grid } = state;
    const { value } = await run(facesOf(grid.words, grid.size, cut(grid)), showing.begin('Drawing voxels…'));
    picture.faces = value;
    mark();
});

/** What is drawn of the triangle that was picked. */
function mark() {
    const { mesh, grid, picked } = state;
    if (picked && picked.marked?.grid !== grid) {
        const { triangle } = picked;
        const { words, count } = mesh.voxelize(grid, { triangles: [triangle, triangle + 1] });
        picked.marked = { grid, words, count };
    }
    picture.marked = picked ? atOnce(facesOf(picked.marked.words, grid.size, cut(grid))) : new Uint32Array(0);
    panel.reportPicked(picked);
    report();
    draw();
}

const report = (times = {}) => panel.reportTimes(Object.assign(state.times, times));

const time = (name, ask) => clock.time(name, ask, (taken) => report({ [name]: taken }));

/** Asks for voxels, as the page is set. */
const voxelize = () => busily(async () => {
    if (!state.mesh) return;
    const [resolution, solid] = [Number(at('resolution').value), at('solid').checked];
    at('fineness').textContent = resolution;
    try {
        const pause = filling.begin('Filling voxels…');
        const { value, time: taken } = await run(state.mesh.voxelizeSteps(resolution, { solid }), pause);
        const { origin, size, cell: [cell], words, count, openRows } = value;
        const middle = origin.map((x, i) => x + size[i] * cell / 2);
        state.grid = { origin, size, cell, words, middle };
        state.times[solid ? 'Surface and inside' : 'Surface'] = taken;
        delete state.times[solid ? 'Surface' : 'Surface and inside'];
        panel.reportVoxels({ size, count, open: openRows, time: taken, isSolid: solid });
        at('banner').hidden = true;
    } catch (error) {
        if (error instanceof Superseded) throw error;
        at('banner').hidden = false;
        at('banner').textContent = sentence(error);
        blank();
        return;
    }
    await (state.point ? show() : first());
});

/** Shows no voxels: that is better than those of another grid, or of another mesh. */
function blank() {
    showing.begin('');
    picture.faces = picture.marked = new Uint32Array(0);
    panel.reportNoVoxels();
    draw();
    if (state.grid) return;
    panel.reportPicked(null);
    // A canvas whose size is set is empty.
    for (const each of [canvas, at('picture'), at('floor')]) each.width = each.width;
}

/** Takes a file, if there is a mesh in it. */
const open = (name, file) => busily(async () => {
    panel.reportRefused(name);
    const start = performance.now();
    let mesh = null;
    try {
        let pause = reading.begin(`Reading ${name}…`);
        const { positions, index } = await readMesh(name, file, pause);
        await pause(1);
        const read = performance.now() - start;
        pause = reading.begin('Building the tree…', start);
        const built = await run(Mesh.steps(positions, index), pause);
        mesh = built.value;
        await pause(1);
        pause = reading.begin('Looking for an open edge…', start);
        const { value: ends, time: looked } = await run(mesh.openEdgeSteps(), pause);
        await pause(1);
        const edge = ends?.map((i) => [...positions.subarray(3 * i, 3 * i + 3)]);
        // From here on voxels of the mesh before would be wrong.
        for (const work of [filling, showing, copying]) work.begin('');
        clock.stop();
        state.mesh?.free();
        const times = { 'Reading the file (not the module)': read, 'Building the tree': built.time, 'Looking for an open edge': looked };
        Object.assign(state, { mesh, edge, times, picked: null, grid: null, point: null });
        panel.reportMesh({ name, edge, triangles: mesh.triangleCount, vertices: mesh.vertexCount });
        view.isYUp = isYUp(name);
    } catch (error) {
        mesh?.free();
        if (error instanceof Superseded) throw error;
        if (!(error instanceof Broken || error instanceof RangeError)) console.warn(error);
        panel.reportRefused(name, sentence(error));
        return;
    }
    await voxelize();
});

/** The first voxels of a mesh, all of it in sight, and the point in its middle. */
async function first() {
    const { mesh, grid } = state;
    view.around(grid.origin, greatest(grid));
    moveTo(grid.middle);
    await show();
    if (mesh !== state.mesh) return;
    const pause = copying.begin('Copying triangles…');
    const { value } = await run(soupOf(mesh, grid.middle), pause);
    await pause(1);
    picture.soup = value;
    draw();
}

/** Asks about another point. */
function moveTo(point) {
    if (!state.grid) return;
    const rounded = point.map(nearest);
    const where = orNull(() => state.mesh.locate(rounded));
    if (!where) return;
    Object.assign(state, { point: rounded, where });
    time('Inside or not', () => state.mesh.locate(rounded));
    panel.reportPoint(rounded, where);
    report();
    draw();
}

/** Picks the first triangle under a pixel that is drawn. */
function pick(pixel) {
    if (!state.grid) return;
    let { from, along } = view.ray(pixel);
    const [ys, zs] = cut(state.grid);
    const [axis, layer] = view.isYUp ? [2, zs[1]] : [1, ys[0]];
    const plane = state.grid.origin[axis] + layer * state.grid.cell;
    const t = (plane - from[axis]) / along[axis];
    const isCut = !at('triangles').checked && Number(at('cut').value) > 0;
    // What was cut away is not in the way.
    if (isCut && t > 0) from = from.map((x, i) => x + t * along[i]);
    const ask = () => orNull(() => state.mesh.raycast(from, along));
    const hit = ask();
    state.picked = hit && { ...hit, corners: state.mesh.corners(hit.triangle) };
    time('First triangle on a ray', ask);
    mark();
}

function whole() {
    if (state.grid) view.around(state.grid.origin, greatest(state.grid));
    draw();
}

async function teapot() {
    for (const place of TEAPOTS) {
        const response = await fetch(new URL(place, import.meta.url)).catch(() => null);
        if (response?.ok) return open('teapot.obj', await response.blob());
    }
    at('mesh').textContent = 'The teapot is not here. Drop an OBJ or STL.';
    return null;
}

function controls() {
    at('fineness').textContent = at('resolution').value;
    for (const id of ['resolution', 'surface', 'solid']) at(id).addEventListener('input', voxelize);
    at('cut').addEventListener('input', () => state.grid && show());
    for (const id of ['voxels', 'triangles']) at(id).addEventListener('input', draw);
    at('teapot').addEventListener('click', teapot);
    at('whole').addEventListener('click', whole);
    at('file').addEventListener('change', ({ target }) => {
        const [file] = target.files;
        // So that the same file can be chosen again.
        if (file) open(file.name, file).finally(() => { target.value = ''; });
    });
    [...'xyz'].forEach((id, i) => at(id).addEventListener('change', ({ target }) => {
        const { number, error } = read(0, target.value);
        if (error) panel.refusePoint(i, error);
        else if (state.point) moveTo(state.point.map((x, k) => (k === i ? number : x)));
    }));
    const drop = at('drop');
    for (const type of ['dragenter', 'dragover', 'dragleave', 'drop']) {
        addEventListener(type, (event) => {
            event.preventDefault();
            drop.classList.toggle('over', type === 'dragenter' || type === 'dragover');
            const file = type === 'drop' && event.dataTransfer?.files[0];
            if (file) open(file.name, file);
        });
    }
    addEventListener('resize', draw);
    at('picture').addEventListener('again', () => state.grid && busily(first));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
    const held = (isHeld) => {
        state.held = isHeld;
        draw();
    };
    const hands = { point: () => state.point, move: moveTo, pick, held, turned: draw, whole };
    listen(canvas, view, hands);
    listenToKeys(canvas, view, {
        ...hands,
        say: (text) => {
            at('hint').textContent = text ?? HINT;
            at('hint').classList.toggle('keys', text !== null);
            state.hasCross = text !== null;
            draw();
        },
    });
}

try {
    const { simd } = await init();
    at('size').textContent = `The crate as WebAssembly, ${simd ? 'with' : 'without'} simd128.`;
    at('without').hidden = picture.works;
    controls();
    await teapot();
    document.body.dataset.ready = 'yes';
} catch (error) {
    at('problem').textContent = error.message;
    at('missing').showModal();
}
