// The page: holds 15 numbers, asks the module about them, shows what it says.
import { Camera } from './camera.mjs';
import { listen } from './drag.mjs';
import { project } from './exact.mjs';
import { Fields, isHalfExtent, make, nameOf } from './fields.mjs';
import { find } from './find.mjs';
import { listenToKeys } from './keys.mjs';
import { Septum } from './module.mjs';
import { report } from './panel.mjs';
import { PRESETS, inScalar, wrongCase } from './presets.mjs';
import { minus, range, read } from './read.mjs';
import { SCALARS } from './scalar.mjs';
import { Scene } from './scene.mjs';
import { moved, stepped, strip, touch } from './touch.mjs';
import { Units } from './units.mjs';

const at = (id) => document.getElementById(id);
const canvas = at('scene');
const camera = new Camera();
const scene = new Scene(canvas, camera);
const HINT = at('hint').textContent;

const state = {
    septum: null,
    scalar: 0,
    /** Always a triangle and a box that the module takes. */
    numbers: inScalar(0, PRESETS.edge.numbers),
    /** The number whose neighbours are shown. */
    chosen: 0,
    /** What a pointer holds, and what the arrow keys move. */
    held: null,
    keyed: null,
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
        const [wide, high] = [width, height].map((length) => Math.round(length * ratio));
        if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
        Object.assign(camera, { width, height });
        canvas.getContext('2d').setTransform(ratio, 0, 0, ratio, 0, 0);
        scene.draw(state.numbers, state.answer, state.axes, state.held ?? state.keyed);
        units.draw(nameOf(state.chosen), state.numbers[state.chosen], strip(state.septum, state.scalar, state.numbers, state.chosen));
    });
}

/** Uses new numbers of a scalar; where they are no shapes, all stays as it was. */
function set(numbers, scalar = state.scalar) {
    if (numbers !== state.numbers) for (const id of ['found', 'converted']) at(id).textContent = '';
    const answer = state.septum.ask(scalar, numbers);
    if (answer) Object.assign(state, { scalar, numbers, answer, axes: project(numbers) });
    fields.fill(state.scalar, state.numbers, state.chosen, at('bits').checked);
    at('which').textContent = nameOf(state.chosen);
    report(state.scalar, state.answer, state.axes);
    draw();
    return answer !== null;
}

function choose(k) {
    state.chosen = k;
    set(state.numbers);
}

/** Uses what was written into field `k`, or says why not. */
function write(k, text) {
    const { number, note, error } = read(state.scalar, text, isHalfExtent(k));
    if (error) {
        fields.refuse(k, text, error);
        return;
    }
    fields.restore(k);
    const numbers = [...state.numbers];
    numbers[k] = number;
    if (set(numbers)) fields.note(k, note);
    else fields.refuse(k, text, 'With it these are not a triangle and a box.');
}

function step(n) {
    const k = state.chosen;
    const numbers = stepped(state.scalar, state.numbers, k, n);
    const isEnd = n !== 0 && numbers[k] === state.numbers[k];
    if (!set(numbers)) fields.note(k, 'A half-extent must not be negative.');
    else if (isEnd) fields.note(k, `The range ends here. ${range(state.scalar)}.`);
}

/** Changes the scalar, and says which numbers it cannot hold. */
function convert(scalar) {
    const [before, old] = [state.numbers, SCALARS[state.scalar]];
    const { name, about, least, most, nearest, show } = SCALARS[scalar];
    set(inScalar(scalar, before), scalar);
    at('about').textContent = `${about}.`;
    const rounded = before.filter((x, k) => x !== state.numbers[k]).length;
    at('converted').textContent = rounded === 0 ? '' : `${rounded} of the 15 numbers had to be rounded to ${name}.`;
    before.forEach((x, k) => {
        if (x >= least && x <= most) return;
        fields.note(k, `${minus(old.show(x))} is out of range. ${range(scalar)}. Now ${minus(show(nearest(x)))}.`);
    });
}

/** On a narrow screen the picture may be out of sight: scrolls to it. */
function showPicture() {
    const { top, bottom } = canvas.getBoundingClientRect();
    if (top >= 0 && bottom <= innerHeight) return;
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
    canvas.scrollIntoView({ block: 'start', behavior: isStill ? 'auto' : 'smooth' });
}

/** All of both shapes. */
function whole() {
    const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => state.numbers.slice(k, k + 3));
    const corners = [-1, 1].map((sign) => center.map((x, i) => x + sign * half[i]));
    camera.fit([a, b, c, ...corners]);
    draw();
}

/** Goes where `touch` found something, if it did. */
function go(found) {
    if (found) {
        state.chosen = found.number;
        set(found.numbers);
        fields.restoreAll();
        showPicture();
    } else {
        at('found').textContent = 'The verdict stays the same as far as the triangle can be moved.';
    }
}

function scalars() {
    at('scalars').append(...SCALARS.map(({ name }, k) => {
        const label = make('label');
        const radio = make('input', '', { type: 'radio', name: 'scalar', id: `scalar-${name}`, checked: k === state.scalar });
        radio.addEventListener('change', () => convert(k));
        label.append(radio, make('span', name));
        return label;
    }));
    at('about').textContent = `${SCALARS[state.scalar].about}.`;
}

function buttons() {
    const on = (id, action) => at(id).addEventListener('click', action);
    at('presets').append(...Object.entries(PRESETS).map(([id, { text, numbers }]) => {
        const button = make('button', text, { id: `preset-${id}`, type: 'button' });
        button.addEventListener('click', () => {
            set(inScalar(state.scalar, numbers));
            fields.restoreAll();
            whole();
            showPicture();
        });
        return button;
    }));
    on('touch', () => go(touch(state.septum, state.scalar, state.numbers)));
    on('wrong', () => {
        go(wrongCase(state.septum, state.scalar));
        whole();
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

const units = new Units(at('units'), step);
const fields = new Fields(at('numbers'), { write, choose });

function begin(septum, size) {
    state.septum = septum;
    at('size').textContent = `The crate as WebAssembly: ${size.toLocaleString('en')} bytes, no imports.`;
    scalars();
    buttons();
    const hands = {
        numbers: () => state.numbers,
        change: (from, way, first, count) => set(moved(state.scalar, from, way, first, count)),
        turned: draw,
    };
    const mark = (name) => (what) => {
        state[name] = what;
        draw();
    };
    listen(canvas, camera, { ...hands, held: mark('held') });
    listenToKeys(canvas, camera, {
        ...hands,
        held: mark('keyed'),
        whole,
        say: (text) => {
            at('hint').textContent = text ?? HINT;
            at('hint').classList.toggle('keys', text !== null);
        },
    });
    set(state.numbers);
    document.body.dataset.ready = 'yes';
}

const { module, size, problem } = await find('web.wasm', Septum.from);
if (module) {
    begin(module, size);
} else {
    const dialog = at('missing');
    at('refused').textContent = problem;
    dialog.showModal();
    // The page has nothing to say without a module.
    dialog.addEventListener('close', () => {
        if (!state.septum) dialog.showModal();
    });
    at('file').addEventListener('change', async ({ target }) => {
        try {
            const bytes = await target.files[0].arrayBuffer();
            begin(await Septum.from(bytes), bytes.byteLength);
            dialog.close();
        } catch (error) {
            at('refused').textContent = `Not this one: ${error.message}.`;
        }
    });
}
