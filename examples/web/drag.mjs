// The hand: it takes a vertex, the triangle or the box, and moves it in a plane that
// faces the eye; beside them it turns the picture, and the wheel comes closer.
import { cross, dot, faces, minus } from './vector.mjs';

/** How near to a vertex, in pixels, is on it. */
const GRIP = 16;

/** What lies under a pixel: a vertex (0 to 2), 'triangle', 'box' or nothing; how deep. */
export function grip(camera, numbers, pixel) {
    const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => numbers.slice(k, k + 3));
    const triangle = [a, b, c];
    const near = triangle.map((v, k) => ({ what: k, seen: camera.pixel(v) }))
        .filter(({ seen }) => seen && Math.hypot(seen.at[0] - pixel[0], seen.at[1] - pixel[1]) < GRIP)
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

/** Lets the pointer move what `numbers()` says; `change` is told way, first, count. */
export function listen(canvas, camera, { numbers, change, held, turned }) {
    let hand = null;
    const pixel = (event) => {
        const { left, top } = canvas.getBoundingClientRect();
        return [event.clientX - left, event.clientY - top];
    };
    canvas.addEventListener('pointerdown', (event) => {
        canvas.setPointerCapture(event.pointerId);
        const at = pixel(event);
        // The numbers at the start: what a slow drag rounds off is not lost.
        hand = { ...grip(camera, numbers(), at), at, start: at, numbers: numbers() };
        held(hand.what);
    });
    canvas.addEventListener('pointermove', (event) => {
        const at = pixel(event);
        if (!hand) {
            canvas.style.cursor = grip(camera, numbers(), at).what === null ? 'grab' : 'move';
            return;
        }
        if (hand.what === null) {
            camera.orbit(at[0] - hand.at[0], at[1] - hand.at[1]);
            hand.at = at;
            turned();
            return;
        }
        const way = camera.way(at[0] - hand.start[0], at[1] - hand.start[1], hand.depth);
        const [first, count] = hand.what === 'box' ? [9, 3] : hand.what === 'triangle' ? [0, 9] : [3 * hand.what, 3];
        change(hand.numbers, way, first, count);
    });
    const release = () => {
        hand = null;
        held(null);
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('wheel', (event) => {
        event.preventDefault();
        camera.zoom(Math.exp(event.deltaY * 0.001));
        turned();
    }, { passive: false });
}
