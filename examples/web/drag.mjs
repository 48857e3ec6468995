// The mouse and the fingers. They drag a vertex, the triangle or the box in a plane that
// faces the eye. Beside them they turn the view. The wheel and two fingers zoom.
import { cross, dot, faces, minus } from './vector.mjs';

/** How near to a vertex, in pixels, the mouse or a finger is on it. */
const [GRIP, FINGER] = [16, 28];

/** The first and the count of the numbers of what can be moved. */
export const PARTS = { 0: [0, 3], 1: [3, 3], 2: [6, 3], triangle: [0, 9], box: [9, 3] };

/** What lies under a pixel: a vertex (0 to 2), 'triangle', 'box' or nothing; how deep. */
export function grip(camera, numbers, pixel, reach = GRIP) {
    const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => numbers.slice(k, k + 3));
    const triangle = [a, b, c];
    const near = triangle.map((v, k) => ({ what: k, seen: camera.pixel(v) }))
        .filter(({ seen }) => seen && Math.hypot(seen.at[0] - pixel[0], seen.at[1] - pixel[1]) < reach)
        .sort((x, y) => x.seen.depth - y.seen.depth);
    if (near.length) return { what: near[0].what, depth: near[0].seen.depth };

    const { from, along } = camera.ray(pixel);
    const { away } = camera.frame;
    const hits = [];
    const cut = (corners, what) => {
        const normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
        const t = dot(normal, minus(corners[0], from)) / dot(normal, along);
        const p = from.map((x, i) => x + t * along[i]);
        const inside = corners.every((v, k) => {
            const edge = minus(corners[(k + 1) % corners.length], v);
            return dot(cross(edge, minus(p, v)), normal) >= 0;
        });
        if (t > 0 && inside) hits.push({ what, depth: dot(minus(p, camera.eye), away) });
    };
    cut(triangle, 'triangle');
    faces(center, half).forEach(({ corners }) => cut(corners, 'box'));
    return hits.sort((x, y) => x.depth - y.depth)[0] ?? { what: null, depth: 0 };
}

/** The middle of two pixels, and how far apart they are. */
const spread = ([p, q]) => ({
    middle: p.map((x, i) => (x + q[i]) / 2),
    apart: Math.max(Math.hypot(p[0] - q[0], p[1] - q[1]), 1),
});

/** Lets pointers move what `numbers()` says; `change` is told way, first, count. */
export function listen(canvas, camera, { numbers, change, held, turned }) {
    /** Where each pointer is that is down, by its id. */
    const down = new Map();
    let hand = null;
    const pixel = (event) => {
        const { left, top } = canvas.getBoundingClientRect();
        return [event.clientX - left, event.clientY - top];
    };
    const take = (next) => {
        hand = next;
        held(hand?.what ?? null);
    };

    function pinch(before, now) {
        camera.zoom(before.apart / now.apart);
        camera.pan(now.middle[0] - before.middle[0], now.middle[1] - before.middle[1]);
        turned();
    }

    function drag(at) {
        if (hand.what === null) {
            camera.orbit(at[0] - hand.at[0], at[1] - hand.at[1]);
            hand.at = at;
            turned();
            return;
        }
        const way = camera.way(at[0] - hand.start[0], at[1] - hand.start[1], hand.depth);
        change(hand.numbers, way, ...PARTS[hand.what]);
    }

    canvas.addEventListener('pointerdown', (event) => {
        if (event.button !== 0 || down.size === 2) return;
        canvas.setPointerCapture(event.pointerId);
        const at = pixel(event);
        down.set(event.pointerId, at);
        // A second finger ends what the first one did: two of them zoom.
        if (down.size === 2) {
            take(null);
            return;
        }
        // The numbers at the start: what a slow drag rounds off is not lost.
        const reach = event.pointerType === 'mouse' ? GRIP : FINGER;
        take({ ...grip(camera, numbers(), at, reach), at, start: at, numbers: numbers() });
    });
    canvas.addEventListener('pointermove', (event) => {
        const at = pixel(event);
        if (!down.has(event.pointerId)) {
            canvas.style.cursor = grip(camera, numbers(), at).what === null ? 'grab' : 'move';
            return;
        }
        const before = [...down.values()];
        down.set(event.pointerId, at);
        if (down.size === 2) pinch(spread(before), spread([...down.values()]));
        else if (hand) drag(at);
    });
    const release = (event) => {
        if (down.delete(event.pointerId)) take(null);
    };
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) canvas.addEventListener(type, release);
    canvas.addEventListener('wheel', (event) => {
        event.preventDefault();
        // With `ctrlKey` it is two fingers on a touchpad, which send small numbers.
        camera.zoom(Math.exp(event.deltaY * (event.ctrlKey ? 0.01 : 0.001)));
        turned();
    }, { passive: false });
}
