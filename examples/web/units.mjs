// A number and its neighbours, unit by unit in the last place: what the exact method says
// of each, and what the rounded ones say.
import { AROUND } from './touch.mjs';

const COUNT = 2 * AROUND + 1;
const LABELS = 62;
const STEPS = {
    ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 8, PageDown: -8,
};

const said = (overlaps) => overlaps ? 'overlap' : 'disjoint';

export class Units {
    #canvas;

    /** `choose(n)` when someone picks the n-th neighbour: by a click, or by arrow keys. */
    constructor(canvas, choose) {
        this.#canvas = canvas;
        canvas.addEventListener('keydown', (event) => {
            const n = STEPS[event.key];
            if (!n || event.ctrlKey || event.metaKey || event.altKey) return;
            event.preventDefault();
            choose(n);
        });
        canvas.addEventListener('click', ({ offsetX }) => {
            const n = Math.floor((offsetX - LABELS) / this.#cell) - AROUND;
            if (Math.abs(n) <= AROUND) choose(n);
        });
    }

    get #cell() {
        return (this.#canvas.clientWidth - LABELS) / COUNT;
    }

    /** Draws the answers about a number and its neighbours, `null` where they are no shapes. */
    draw(name, number, answers) {
        const canvas = this.#canvas;
        const here = answers[AROUND];
        canvas.ariaLabel = `${name}, by units in the last place`;
        canvas.ariaValueNow = String(number);
        canvas.ariaValueText = `${number}, exact: ${said(here.overlaps)}; rounded: ${said(here.rounded)}`;
        const ratio = devicePixelRatio;
        canvas.width = canvas.clientWidth * ratio;
        canvas.height = canvas.clientHeight * ratio;
        const ctx = canvas.getContext('2d');
        ctx.scale(ratio, ratio);
        const style = getComputedStyle(document.documentElement);
        const color = (name) => style.getPropertyValue(`--${name}`);
        const rows = [['exact', 'overlaps'], ['rounded', 'rounded'], ['published', 'published']]
            .filter(([, key]) => answers.some((answer) => (answer?.[key] ?? null) !== null));
        const [cell, height] = [this.#cell, (canvas.clientHeight - 2) / rows.length];
        rows.forEach(([label, key], r) => {
            const y = 1 + r * height;
            ctx.fillStyle = color('faint');
            ctx.font = '11.5px system-ui, sans-serif';
            ctx.textBaseline = 'middle';
            ctx.fillText(label, 0, y + height / 2);
            answers.forEach((answer, n) => {
                if (!answer) return;
                const x = LABELS + n * cell;
                const isWrong = answer[key] !== answer.overlaps;
                ctx.fillStyle = color(isWrong ? 'bad' : answer[key] ? 'meet' : 'wall');
                ctx.globalAlpha = isWrong ? 1 : 0.5;
                ctx.fillRect(x + 0.5, y + 1, cell - 1, height - 3);
                ctx.globalAlpha = 1;
            });
        });
        ctx.strokeStyle = color('ink');
        ctx.lineWidth = 1.5;
        ctx.strokeRect(LABELS + AROUND * cell - 0.5, 0.75, cell + 1, canvas.clientHeight - 2);
    }
}
