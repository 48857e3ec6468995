// What the page says about a mesh.
import { make } from '../fields.mjs';
import { minus } from '../read.mjs';
import { SCALARS } from '../scalar.mjs';

const at = (id) => document.getElementById(id);
const count = (n) => n.toLocaleString('en');

/** A number of `f32`, by as few digits as tell it from its neighbours. */
export const show = SCALARS[0].show;
const shown = (x) => minus(show(x));
const some = (n, what) => `${count(n)} ${what}${n === 1 ? '' : 's'}`;
const place = (vertex) => `(${vertex.map(shown).join(', ')})`;

/** A time in ms, to two digits. */
export function ms(time) {
    if (time >= 100) return `${Math.round(time)} ms`;
    return `${time < 0.0001 ? '< 0.0001' : Number(time.toPrecision(2))} ms`;
}

/** The mesh, and whether it is closed. */
export function reportMesh({ name, triangles, vertices, edge }) {
    at('mesh').textContent = `${name}: ${some(triangles, 'triangle')}, ${count(vertices)} ${vertices === 1 ? 'vertex' : 'vertices'}.`;
    at('closed').textContent = edge
        ? `It is open, for example at the edge from ${place(edge[0])} to ${place(edge[1])}. Inside are points from which the positive x axis crosses it an odd number of times.`
        : 'It is closed.';
}

/** The voxels. */
export function reportVoxels({ size, count: set, open, time, isSolid }) {
    at('word').textContent = some(set, 'voxel');
    const rows = open === 0 ? '' : ` ${count(open)} ${open === 1 ? 'row does' : 'rows do'} not close, and have no inside.`;
    at('why').textContent = `${isSolid ? 'Surface and inside' : 'Surface'} in ${size.map(count).join(' × ')}, in ${ms(time)}.${rows}`;
}

/** That there are none; the banner says why. */
export function reportNoVoxels() {
    at('word').textContent = 'No voxels';
    at('why').textContent = '';
}

/** The triangle that was picked, or `null`. */
export function reportPicked(picked) {
    const table = at('corners');
    table.hidden = picked === null;
    if (picked === null) {
        at('picked').textContent = 'None is picked.';
        return;
    }
    const { triangle, isFront, marked, corners } = picked;
    const voxels = marked ? `: it meets ${count(marked.count)} ${marked.count === 1 ? 'voxel' : 'voxels'}.` : '.';
    at('picked').textContent = `Triangle ${count(triangle + 1)}${isFront ? '' : ', from its back'}${voxels}`;
    table.replaceChildren(...corners.map((vertex, k) => {
        const row = make('tr');
        row.append(make('td', 'abc'[k]), ...vertex.map((x) => make('td', shown(x))));
        return row;
    }));
}

const WHERE = {
    inside: 'Inside the mesh.', outside: 'Outside the mesh.', on: 'On a triangle of the mesh, exactly.',
};

/** Where the point is; the fields show it. */
export function reportPoint(point, where) {
    at('where').textContent = WHERE[where];
    point.forEach((x, i) => {
        const field = at('xyz'[i]);
        field.value = show(x);
        field.ariaInvalid = 'false';
    });
    at('wrong').hidden = true;
}

/** What was refused, and that the number before is kept. */
export function refusePoint(i, error) {
    at('xyz'[i]).ariaInvalid = 'true';
    at('wrong').hidden = false;
    at('wrong').textContent = `${'xyz'[i]}: ${error} Kept: the point as it was.`;
}

/** Times by name, those that there are. */
export function reportTimes(times) {
    at('times').replaceChildren(...Object.entries(times).map(([name, time]) => {
        const row = make('tr');
        row.append(make('td', name), make('td', ms(time)));
        return row;
    }));
}

/** Shows what takes long; `null` when it is done. */
export function reportWork(doing, share) {
    at('busy').hidden = doing === null;
    if (doing === null) return;
    at('doing').textContent = doing;
    if (share === undefined) at('done').removeAttribute('value');
    else at('done').value = share;
}

/** Shows why a file was refused, or hides it. */
export function reportRefused(name, error = '') {
    at('refused').hidden = error === '';
    at('refused').textContent = error && `${name}: ${error} The mesh before stays.`;
}
