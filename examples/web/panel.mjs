// What the page says in words: the verdict, the axes, the methods.
import { make } from './fields.mjs';
import { AXES } from './module.mjs';
import { SCALARS } from './scalar.mjs';
import { nearest } from './touch.mjs';

const at = (id) => document.getElementById(id);
const said = (overlaps) => overlaps ? 'overlap' : 'disjoint';

/** A length with three digits. */
export function length(x) {
    const size = Math.abs(x);
    if (size === 0 || (size >= 1e-3 && size < 1e4)) return size.toPrecision(3);
    const [digits, exponent] = size.toExponential(2).split('e');
    const raised = [...String(Number(exponent))].map((c) => c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]).join('');
    return `${digits}\u00a0·\u00a010${raised}`;
}

function verdict(answer, axes) {
    at('verdict').className = answer.overlaps ? 'meet' : '';
    at('word').textContent = answer.overlaps ? 'Overlap' : 'Disjoint';
    const closest = axes[nearest(axes)];
    if (!answer.overlaps) {
        const axis = AXES[answer.axis];
        at('why').textContent = `Separated on ${axis.name}, the ${axis.text}: a gap of ${length(axes[answer.axis].gap)}.`;
    } else if (closest.sign === 0) {
        at('why').textContent = 'They touch and no more, and touching is overlap.';
    } else {
        at('why').textContent = `No axis separates them. They overlap least on ${AXES[nearest(axes)].name}, by ${length(-closest.gap)}.`;
    }
}

function lit(answer) {
    at('axes').replaceChildren(...AXES.map((axis, k) => make('span', axis.name, {
        title: axis.text,
        className: k === answer.axis ? 'on first' : answer.separates[k] ? 'on' : '',
    })));
}

function methods(answer, truth) {
    const rows = [
        ['Exact', 'overlaps', answer.overlaps],
        ['Conservative', 'may_overlap', answer.mayOverlap],
        ['Rounded', 'shared_normal', answer.rounded],
        ['Published', 'akenine_moller', answer.published],
        ['Checked in big integers', '', truth],
    ].filter((row) => row[2] !== null);
    at('methods').replaceChildren(...rows.map(([name, call, overlaps]) => {
        // The conservative one may say overlap where there is none.
        const bad = overlaps !== truth && (call !== 'may_overlap' || !overlaps);
        const row = make('tr', '', { className: bad ? 'bad' : '' });
        const first = make('td', `${name} `);
        if (call) first.append(make('code', call));
        row.append(first, make('td', `${call === 'may_overlap' && overlaps ? 'may ' : ''}${said(overlaps)}${bad ? ', wrong' : ''}`));
        return row;
    }));
}

function banner(scalar, answer, axes) {
    const { name } = SCALARS[scalar];
    const isRounded = answer.rounded !== answer.overlaps;
    const isWrong = isRounded || (answer.published ?? answer.overlaps) !== answer.overlaps;
    at('banner').hidden = !isWrong;
    if (!isWrong) return;
    const { gap, sign } = axes[nearest(axes)];
    const fact = sign > 0 ? `there is a gap of ${length(gap)}` : sign === 0 ? 'they touch' : `they overlap by ${length(-gap)}`;
    const who = isRounded ? `Rounded ${name}` : `${name} as published`;
    at('banner').textContent = `${who} is wrong: it says ${said(!answer.overlaps)}, but ${fact}.`;
}

/** Shows all that was answered. */
export function report(scalar, answer, axes) {
    verdict(answer, axes);
    lit(answer);
    methods(answer, !axes.some(({ sign }) => sign > 0));
    banner(scalar, answer, axes);
}
