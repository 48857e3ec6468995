// The page: holds 15 numbers, asks the module about them, shows what it says.
import { Camera } from './camera.mjs';
import { listen } from './drag.mjs';
import { project } from './exact.mjs';
import { Septum } from './module.mjs';
import { fill, make, nameOf, report, table } from './panel.mjs';
import { PRESETS, inScalar, wrongCase } from './presets.mjs';
import { SCALARS } from './scalar.mjs';
import { Scene } from './scene.mjs';
import { moved, stepped, strip, touch } from './touch.mjs';
import { Units } from './units.mjs';

const at = (id) => document.getElementById(id);
const canvas = at('scene');
const camera = new Camera();
const scene = new Scene(canvas, camera);

const state = {
    septum: null,
    scalar: 0,
    numbers: inScalar(0, PRESETS.edge.numbers),
    /** The number whose neighbours are shown. */
    chosen: 0,
    held: null,
    answer: null,
    axes: null,
};

let due = false;
function draw() {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
        due = false;
        const ratio = devicePixelRatio;
        const [width, height] = [canvas.clientWidth, canvas.clientHeight];
        if (canvas.width !== width * ratio || canvas.height !== height * ratio) {
            [canvas.width, canvas.height] = [width * ratio, height * ratio];
        }
        Object.assign(camera, { width, height });
        canvas.getContext('2d').setTransform(ratio, 0, 0, ratio, 0, 0);
        scene.draw(state.numbers, state.answer, state.axes, state.held);
        units.draw(strip(state.septum, state.scalar, state.numbers, state.chosen));
    });
}

/** Asks about new numbers; where they are no shapes, all stays as it was. */
function set(numbers) {
    const answer = state.septum.ask(state.scalar, numbers);
    if (answer) Object.assign(state, { numbers, answer, axes: project(numbers) });
    fill(state.scalar, state.numbers, state.chosen, at('bits').checked);
    at('which').textContent = nameOf(state.chosen);
    report(state.scalar, state.answer, state.axes);
    draw();
    return answer !== null;
}

function choose(k) {
    state.chosen = k;
    set(state.numbers);
}

function step(n) {
    set(stepped(state.scalar, state.numbers, state.chosen, n));
}

/** Goes where `touch` found something, if it did. */
function go(found) {
    if (!found) return;
    state.chosen = found.number;
    set(found.numbers);
}

function whole() {
    Object.assign(camera, new Camera());
    draw();
}

const units = new Units(at('units'), step);

function buttons() {
    at('scalars').append(...SCALARS.map(({ name }, k) => {
        const button = make('button', name, { role: 'radio', ariaChecked: String(k === state.scalar) });
        button.addEventListener('click', () => {
            state.scalar = k;
            [...at('scalars').children].forEach((other) => { other.ariaChecked = String(other === button); });
            set(inScalar(k, state.numbers));
        });
        return button;
    }));
    at('presets').append(...Object.entries(PRESETS).map(([id, { text, numbers }]) => {
        const button = make('button', text, { id: `preset-${id}` });
        button.addEventListener('click', () => {
            whole();
            set(inScalar(state.scalar, numbers));
        });
        return button;
    }));
    const on = (id, action) => at(id).addEventListener('click', action);
    on('touch', () => go(touch(state.septum, state.scalar, state.numbers)));
    on('wrong', () => {
        whole();
        go(wrongCase(state.septum, state.scalar));
    });
    on('down', () => step(-1));
    on('up', () => step(1));
    on('bits', () => set(state.numbers));
    on('whole', whole);
    on('closer', () => {
        const { target, gap } = scene.focus(state.numbers, state.axes);
        camera.target = target;
        camera.distance = Math.max(gap * 12, 1e-9);
        draw();
    });
    addEventListener('resize', draw);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);
}

function begin(septum, size) {
    state.septum = septum;
    at('size').textContent = `The module has ${size.toLocaleString('en')} bytes and imports nothing.`;
    table((k, x) => {
        const numbers = [...state.numbers];
        numbers[k] = SCALARS[state.scalar].nearest(x);
        set(numbers);
    }, choose);
    buttons();
    listen(canvas, camera, {
        numbers: () => state.numbers,
        change: (from, way, first, count) => set(moved(state.scalar, from, way, first, count)),
        held: (what) => {
            state.held = what;
            draw();
        },
        turned: draw,
    });
    set(state.numbers);
    document.body.dataset.ready = 'yes';
}

const found = await Septum.find();
if (found) {
    begin(found.septum, found.size);
} else {
    at('missing').showModal();
    at('file').addEventListener('change', async ({ target }) => {
        try {
            const bytes = await target.files[0].arrayBuffer();
            begin(await Septum.from(bytes), bytes.byteLength);
            at('missing').close();
        } catch (error) {
            at('refused').textContent = `Not this one: ${error.message}.`;
        }
    });
}
