// The page: holds a mesh, its voxels and a point, asks the module about them, and shows what it
// says.
import { find } from '../find.mjs';
import { read } from '../read.mjs';
import { SCALARS } from '../scalar.mjs';
import { Picture } from './draw.mjs';
import { facesOf } from './faces.mjs';
import { isYUp, readMesh } from './file.mjs';
import { listen, listenToKeys } from './hands.mjs';
import { Mesh } from './module.mjs';
import { Broken } from './numbers.mjs';
import { Overlay } from './overlay.mjs';
import * as panel from './panel.mjs';
import { View } from './view.mjs';
import { Superseded, Work } from './work.mjs';

const at = (id) => document.getElementById(id);
const canvas = at('scene');
const view = new View();
const picture = new Picture(at('picture'));
const overlay = new Overlay(canvas, at('floor'), view);
// No file is dropped on a phone.
if (matchMedia('(hover: none)').matches) at('hint').textContent = at('hint').textContent.replace(/ Drop an OBJ.*/, '');
const HINT = at('hint').textContent;
const [reading, filling] = [new Work(), new Work()];
const { nearest } = SCALARS[0];

/** How many indices a mesh has whose tree takes longer than a moment. */
const LARGE = 60_000;

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
    isFilling: false,
};

const greatest = ({ origin, size, cell }) => origin.map((x, i) => x + size[i] * cell);

let due = false;
function draw() {
    if (due || !state.grid) return;
    due = true;
    requestAnimationFrame(() => {
        due = false;
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
            isHidden: state.mesh.hides(view.eye, point), isHeld: state.held, hasCross: state.hasCross,
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

/** What is drawn of the voxels. */
function show() {
    const { mesh, grid, picked } = state;
    const kept = cut(grid);
    picture.faces = facesOf(grid.words, grid.size, kept);
    // While the next voxels come the module has another grid.
    if (picked && !state.isFilling) picked.marked = { grid, ...mesh.mark(picked.triangle, grid.size) };
    const marked = picked?.marked;
    picture.marked = marked?.grid === grid ? facesOf(marked.words, grid.size, kept) : new Uint32Array(0);
    panel.reportPicked(picked);
    report();
    draw();
}

const report = () => panel.reportTimes(state.times, state.mesh.bytes);

/** Asks for voxels, as the page is set. */
async function voxelize() {
    if (!state.mesh.triangles) return;
    const [resolution, isSolid] = [Number(at('resolution').value), at('solid').checked];
    at('fineness').textContent = resolution;
    document.body.dataset.busy = 'yes';
    state.isFilling = true;
    const pause = filling.begin('Filling voxels…');
    try {
        const grid = await state.mesh.voxelize(resolution, isSolid, pause);
        state.grid = { ...grid, isSolid, middle: grid.origin.map((x, i) => x + grid.size[i] * grid.cell / 2) };
        state.isFilling = false;
        state.times[isSolid ? 'Surface and inside' : 'Surface'] = grid.time;
        delete state.times[isSolid ? 'Surface' : 'Surface and inside'];
        panel.reportVoxels(state.grid);
        at('banner').hidden = true;
        show();
    } catch (error) {
        if (error instanceof Superseded) return;
        at('banner').hidden = false;
        at('banner').textContent = error.message;
        blank();
    }
    panel.reportWork(null);
    document.body.dataset.busy = '';
}

/** Shows no voxels: that is better than those of another grid, or of another mesh. */
function blank() {
    picture.faces = picture.marked = new Uint32Array(0);
    panel.reportNoVoxels();
    draw();
    if (state.grid) return;
    panel.reportPicked(null);
    // A canvas whose size is set is empty.
    for (const each of [canvas, at('picture'), at('floor')]) each.width = each.width;
}

/** Takes a file, if there is a mesh in it. */
async function open(name, file) {
    panel.reportRefused(name);
    document.body.dataset.busy = 'yes';
    const pause = reading.begin(`Reading ${name}…`);
    const start = performance.now();
    try {
        const numbers = await readMesh(name, file, pause);
        await pause(1);
        const time = performance.now() - start;
        // From here on voxels of the mesh before would be wrong.
        filling.begin('');
        if (numbers.triangles.length > LARGE) {
            panel.reportWork('Building the tree…', undefined);
            await new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)));
            await pause(1);
        }
        const tree = state.mesh.load(numbers);
        const begun = performance.now();
        const edge = state.mesh.openEdge();
        state.times = { 'Reading the file (not the module)': time, 'Building the tree': tree, 'Looking for an open edge': performance.now() - begun };
        Object.assign(state, { edge, picked: null, grid: null, point: null });
        panel.reportMesh({ name, edge, triangles: state.mesh.triangles, vertices: state.mesh.vertices });
        await first(name);
    } catch (error) {
        if (error instanceof Superseded) return;
        if (!(error instanceof Broken)) console.warn(error);
        panel.reportRefused(name, error.message);
        panel.reportWork(null);
        document.body.dataset.busy = '';
    }
}

/** The first voxels of a mesh, all of it in sight, and the point in its middle. */
async function first(name) {
    view.isYUp = isYUp(name);
    await voxelize();
    if (!state.grid) return;
    view.around(state.grid.origin, greatest(state.grid));
    const { middle } = state.grid;
    picture.soup = state.mesh.soup().map((x, k) => x - middle[k % 3]);
    moveTo(middle);
}

/** Asks about another point. */
function moveTo(point) {
    if (!state.grid) return;
    state.point = point.map(nearest);
    const { where, time } = state.mesh.inside(state.point);
    state.where = where;
    state.times['Inside or not'] = time;
    panel.reportPoint(state.point, where);
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
    const found = state.mesh.pick(from, along);
    state.picked = found.triangle === null ? null : { ...found, corners: state.mesh.corners(found.triangle) };
    state.times['First triangle on a ray'] = found.time;
    show();
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
    at('picture').addEventListener('again', () => state.grid && first(at('mesh').textContent.split(':')[0]));
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

const { module, size, problem } = await find('web_mesh.wasm', Mesh.from);
if (module) {
    state.mesh = module;
    at('size').textContent = `The crate as WebAssembly: ${size.toLocaleString('en')} bytes, no imports.`;
    at('without').hidden = picture.works;
    controls();
    await teapot();
    document.body.dataset.ready = 'yes';
} else {
    at('problem').textContent = problem;
    at('missing').showModal();
}
