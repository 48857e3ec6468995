// The keyboard on the picture. Arrow keys turn the view; the space bar chooses a vertex,
// the triangle or the box for them to move.
import { PARTS } from './drag.mjs';
import { mean } from './vector.mjs';

/** What the arrow keys can move, in the order of the space bar. */
const CHOICES = [null, 0, 1, 2, 'triangle', 'box'];
const NAMES = { 0: 'vertex a', 1: 'vertex b', 2: 'vertex c', triangle: 'the triangle', box: 'the box' };
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Pixels for one key press; with shift; and for a turn of the view. */
const [STEP, FINE, TURN] = [8, 1, 24];
const ZOOM = { '+': 0.8, '=': 0.8, '-': 1.25, '_': 1.25 };

function help(what) {
    return what === null
        ? 'Arrow keys turn the view, + and − zoom. The space bar chooses what the arrow keys move.'
        : `Arrow keys move ${NAMES[what]}, finer with Shift. Space bar: the next one. Escape: back to the view.`;
}

/** The middle of what is held. */
function middle(numbers, what) {
    const [first, count] = PARTS[what];
    return mean(Array.from({ length: count / 3 }, (_, k) => numbers.slice(first + 3 * k, first + 3 * k + 3)));
}

/**
 * Lets keys move what `numbers()` says; `change` is told from which numbers, way, first,
 * count. `say` shows what the keys do, `null` where they do nothing any more.
 */
export function listenToKeys(canvas, camera, { numbers, change, held, turned, whole, say }) {
    let what = null;
    /** Where the moves began, and their sum: steps below a unit in the last place add up. */
    let path = null;

    function choose(next) {
        what = next;
        path = null;
        held(what);
        say(help(what));
    }

    function move([x, y], isFine) {
        if (what === null) {
            camera.orbit(x * TURN, y * TURN);
            turned();
            return;
        }
        if (path?.last !== numbers()) path = { from: numbers(), x: 0, y: 0 };
        const by = isFine ? FINE : STEP;
        path.x += x * by;
        path.y += y * by;
        const depth = camera.pixel(middle(path.from, what))?.depth ?? camera.distance;
        change(path.from, camera.way(path.x, path.y, depth), ...PARTS[what]);
        path.last = numbers();
    }

    canvas.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const { key } = event;
        if (ARROWS[key]) move(ARROWS[key], event.shiftKey);
        else if (key === ' ') choose(CHOICES[(CHOICES.indexOf(what) + (event.shiftKey ? CHOICES.length - 1 : 1)) % CHOICES.length]);
        else if (key === 'Escape') choose(null);
        else if (key === 'Home') whole();
        else if (ZOOM[key]) {
            camera.zoom(ZOOM[key]);
            turned();
        } else return;
        event.preventDefault();
    });
    canvas.addEventListener('focus', () => {
        if (canvas.matches(':focus-visible')) say(help(what));
    });
    canvas.addEventListener('blur', () => {
        choose(null);
        say(null);
    });
}
