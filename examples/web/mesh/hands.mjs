// Pointers and keys on the picture. A click picks a triangle, the point is dragged; beside it a
// drag turns the view. The wheel and two fingers zoom.

/** How near to the point, in pixels, the mouse or a finger is on it. */
const [GRIP, FINGER] = [14, 28];
/** How far a pointer may move and still have clicked. */
const STILL = 5;

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const ZOOM = { '+': 0.8, '=': 0.8, '-': 1.25, '_': 1.25 };
/** Pixels for a key; with shift; and for a turn of the view. */
const [STEP, FINE, TURN] = [8, 1, 24];

/** The middle of two pixels, and how far apart they are. */
const spread = ([p, q]) => ({
    middle: p.map((x, i) => (x + q[i]) / 2),
    apart: Math.max(Math.hypot(p[0] - q[0], p[1] - q[1]), 1),
});

/**
 * `point()` is the point, if there is one; `move(point)` and `pick(pixel)` are told what hands
 * do, `held` whether the point is held, `turned` that the view has changed.
 */
export function listen(canvas, view, { point, move, pick, held, turned }) {
    /** Where each pointer is that is down, by its id. */
    const down = new Map();
    let hand = null;
    const pixel = ({ clientX, clientY }) => {
        const { left, top } = canvas.getBoundingClientRect();
        return [clientX - left, clientY - top];
    };
    const isOnPoint = (at, reach) => {
        const there = point() && view.at(point());
        return Boolean(there) && Math.hypot(there[0] - at[0], there[1] - at[1]) < reach;
    };

    canvas.addEventListener('pointerdown', (event) => {
        if (event.button !== 0 || down.size === 2) return;
        canvas.setPointerCapture(event.pointerId);
        const at = pixel(event);
        down.set(event.pointerId, at);
        // A second finger ends what the first one did: two of them zoom.
        const isPoint = down.size === 1 && isOnPoint(at, event.pointerType === 'mouse' ? GRIP : FINGER);
        hand = down.size === 1 ? { at, start: at, from: isPoint ? point() : null, isStill: true } : null;
        held(isPoint);
    });
    canvas.addEventListener('pointermove', (event) => {
        const at = pixel(event);
        if (!down.has(event.pointerId)) {
            canvas.style.cursor = isOnPoint(at, GRIP) ? 'move' : 'crosshair';
            return;
        }
        const before = [...down.values()];
        down.set(event.pointerId, at);
        if (down.size === 2) {
            const [old, now] = [spread(before), spread([...down.values()])];
            view.zoom(old.apart / now.apart);
            view.pan(now.middle[0] - old.middle[0], now.middle[1] - old.middle[1]);
            turned();
        } else if (hand) {
            if (Math.hypot(at[0] - hand.start[0], at[1] - hand.start[1]) > STILL) hand.isStill = false;
            if (hand.isStill) return;
            if (hand.from) {
                move(view.moved(hand.from, [at[0] - hand.start[0], at[1] - hand.start[1]]));
            } else {
                view.orbit(at[0] - hand.at[0], at[1] - hand.at[1]);
                turned();
            }
            hand.at = at;
        }
    });
    const release = (event) => {
        if (!down.delete(event.pointerId)) return;
        if (hand?.isStill && !hand.from && event.type === 'pointerup') pick(hand.start);
        hand = null;
        held(false);
    };
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) canvas.addEventListener(type, release);
    canvas.addEventListener('wheel', (event) => {
        event.preventDefault();
        // With `ctrlKey` it is two fingers on a touchpad, which send small numbers.
        view.zoom(Math.exp(event.deltaY * (event.ctrlKey ? 0.01 : 0.001)));
        turned();
    }, { passive: false });
}

const HELP = {
    view: 'Arrow keys turn the view, + and − zoom. Enter picks the triangle in the middle. Space bar: move the point.',
    point: 'Arrow keys move the point, finer with Shift. Space bar or Escape: back to the view.',
};

/** The same by keys; `say` shows what they do, `null` where they do nothing any more. */
export function listenToKeys(canvas, view, { point, move, pick, held, turned, whole, say }) {
    let what = 'view';
    const choose = (next) => {
        what = next;
        held(what === 'point');
        say(HELP[what]);
    };
    canvas.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const { key } = event;
        if (ARROWS[key]) {
            const [x, y] = ARROWS[key].map((step) => step * (event.shiftKey ? FINE : STEP));
            if (what === 'point' && point()) move(view.moved(point(), [x, y]));
            else {
                view.orbit(x / STEP * TURN, y / STEP * TURN);
                turned();
            }
        } else if (key === ' ') choose(what === 'view' ? 'point' : 'view');
        else if (key === 'Escape') choose('view');
        else if (key === 'Enter') pick([view.width / 2, view.height / 2]);
        else if (key === 'Home') whole();
        else if (ZOOM[key]) {
            view.zoom(ZOOM[key]);
            turned();
        } else return;
        event.preventDefault();
    });
    canvas.addEventListener('focus', () => {
        if (canvas.matches(':focus-visible')) choose('view');
    });
    canvas.addEventListener('blur', () => {
        what = 'view';
        held(false);
        say(null);
    });
}
