// Draws the triangle, the box, and what separates them or where they meet. What lies
// behind is drawn first: the faces of the box cut the triangle into pieces that have an
// order, and a separating plane has the two on either side.
import { nearest } from './touch.mjs';
import { add, clip, cross, dot, faces, mean, minus, nearestOn, unit } from './vector.mjs';

const FLOOR = -2.6;
const ROOM = 5;
const NAMES = ['a', 'b', 'c'];
const edgesOf = (triangle) => triangle.map((v, k) => [v, triangle[(k + 1) % 3]]);

export class Scene {
    #ctx;
    #camera;
    #color;

    constructor(canvas, camera) {
        this.#ctx = canvas.getContext('2d');
        this.#camera = camera;
    }

    /** Draws `numbers` with what was answered about them. */
    draw(numbers, answer, axes, held) {
        const style = getComputedStyle(document.documentElement);
        this.#color = (name) => style.getPropertyValue(`--${name}`);
        const { width, height } = this.#camera;
        this.#ctx.clearRect(0, 0, width, height);
        const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => numbers.slice(k, k + 3));
        const triangle = [a, b, c];
        const sides = faces(center, half);
        this.#floor(triangle, sides);
        const eye = this.#camera.eye;
        const wall = answer.overlaps ? null : this.#wall(triangle, center, half, axes[answer.axis]);
        if (wall) {
            const uncut = { polygons: [triangle], edges: edgesOf(triangle) };
            const drawn = [() => this.#box(sides, eye, []), () => this.#quad(wall), () => this.#parts(uncut)];
            const above = dot(minus(eye, wall.middle), wall.along) > 0;
            (above ? drawn : drawn.reverse()).forEach((draw) => draw());
        } else {
            this.#pieces(triangle, sides, eye);
        }
        this.#mark(triangle, sides, held);
        this.#corners(triangle, held);
        if (wall) this.#axis(wall, center);
        this.#ring(triangle, center, half, axes);
    }

    #fill(points, color, alpha = 1) {
        this.#fillAll([points], color, alpha);
    }

    /** Polygons of one plane, as one: no seam is seen between them. */
    #fillAll(polygons, color, alpha) {
        this.#ctx.beginPath();
        polygons.forEach((points) => this.#path(points));
        this.#ctx.globalAlpha = alpha;
        this.#ctx.fillStyle = color;
        this.#ctx.fill();
        this.#ctx.globalAlpha = 1;
    }

    #line(points, color, width = 1.5, alpha = 1) {
        this.#trace(points);
        Object.assign(this.#ctx, { globalAlpha: alpha, strokeStyle: color, lineWidth: width, lineJoin: 'round', lineCap: 'round' });
        this.#ctx.stroke();
        this.#ctx.globalAlpha = 1;
    }

    #trace(points) {
        this.#ctx.beginPath();
        this.#path(points);
    }

    #path(points) {
        this.#camera.path(points).forEach(([x, y], k) => k ? this.#ctx.lineTo(x, y) : this.#ctx.moveTo(x, y));
        this.#ctx.closePath();
    }

    #text(text, [x, y], color, font = '600 14px') {
        const ctx = this.#ctx;
        ctx.font = `${font} system-ui, sans-serif`;
        Object.assign(ctx, { textAlign: 'center', textBaseline: 'middle', lineWidth: 4, lineJoin: 'round' });
        ctx.strokeStyle = this.#color('page');
        ctx.strokeText(text, x, y);
        ctx.fillStyle = color;
        ctx.fillText(text, x, y);
    }

    /** A grid below it all, with the shadows on it. */
    #floor(triangle, sides) {
        const { eye, distance } = this.#camera;
        if (eye[2] < FLOOR || distance < 1 || distance > 100) return;
        const onFloor = ([x, y]) => [x, y, FLOOR];
        for (let k = -ROOM; k <= ROOM; k += 1) {
            const alpha = k === 0 ? 0.9 : 0.45;
            this.#line([[k, -ROOM, FLOOR], [k, ROOM, FLOOR]], this.#color('grid'), 1, alpha);
            this.#line([[-ROOM, k, FLOOR], [ROOM, k, FLOOR]], this.#color('grid'), 1, alpha);
        }
        this.#fill(sides[5].corners.map(onFloor), this.#color('shadow'), 0.5);
        this.#fill(triangle.map(onFloor), this.#color('shadow'), 0.5);
        ['x', 'y', 'z'].forEach((name, i) => {
            const from = [-ROOM, -ROOM, FLOOR];
            const to = [...from];
            to[i] += 1.6;
            this.#line([from, to], this.#color('faint'), 1.5);
            to[i] += 0.3;
            const end = this.#camera.pixel(to);
            if (end) this.#text(name, end.at, this.#color('faint'));
        });
    }

    #box(sides, eye, inside) {
        const [front, back] = [true, false].map((is) => sides.filter((side) => side.outside(eye) > 0 === is));
        const color = this.#color('box');
        for (const side of back) {
            this.#fill(side.corners, color, 0.14);
            this.#line(side.corners, color, 1, 0.35);
        }
        inside.forEach((piece) => this.#fill(piece, this.#color('meet'), 0.85));
        if (inside.length) this.#line(inside[0], this.#color('meet'), 2.5);
        for (const side of front) {
            this.#fill(side.corners, color, [0.2, 0.3, 0.38][side.i]);
            this.#line(side.corners, color, 1.6);
        }
    }

    /** Polygons of the triangle, and segments of its edges. */
    #parts({ polygons, edges }) {
        this.#fillAll(polygons, this.#color('triangle'), 0.62);
        edges.forEach((edge) => this.#line(edge, this.#color('triangle'), 2));
    }

    /** The triangle cut by the faces, in the order of what hides what. */
    #pieces(triangle, sides, eye) {
        const [before, behind] = [0, 0].map(() => ({ polygons: [], edges: [] }));
        let inside = [];
        for (const whole of [triangle, ...edgesOf(triangle)]) {
            const list = whole.length === 2 ? 'edges' : 'polygons';
            let rest = whole;
            for (const side of sides) {
                const piece = clip(rest, side.outside);
                if (piece.length) (side.outside(eye) > 0 ? before : behind)[list].push(piece);
                rest = clip(rest, (p) => -side.outside(p));
            }
            if (list === 'polygons' && rest.length > 2) inside = [rest];
        }
        this.#parts(behind);
        this.#box(sides, eye, inside);
        this.#parts(before);
    }

    /** Half way between the shapes on an axis, which points from box to triangle. */
    #between(triangle, center, half, { along, triangle: on, box }) {
        const up = on[0] + on[1] > box[0] + box[1] ? along : along.map((x) => -x);
        const height = triangle.map((v) => dot(up, minus(v, center)));
        const least = Math.min(...height);
        // Of both shapes that part which lies nearest to the other along the axis: a
        // vertex, an edge, a face. From one to the other and back, to where they meet.
        const near = (x) => Math.abs(x) < 1e-6;
        const spread = Math.max(...height) - least || 1;
        const part = triangle.filter((_, k) => near((height[k] - least) / spread));
        const onBox = (p) => center.map((x, i) => near(up[i])
            ? Math.min(Math.max(p[i], x - half[i]), x + half[i])
            : x + Math.sign(up[i]) * half[i]);
        const radius = up.reduce((sum, x, i) => sum + Math.abs(x) * half[i], 0);
        let low = mean(part);
        for (let turn = 0; turn < 100; turn += 1) low = nearestOn(part, onBox(low));
        const middle = mean([low, onBox(low)]);
        const off = (least + radius) / 2 - dot(up, minus(middle, center));
        return { along: up, middle: add(middle, up, off), radius, least, greatest: Math.max(...height) };
    }

    #wall(triangle, center, half, axis) {
        const wall = this.#between(triangle, center, half, axis);
        const { right, away } = this.#camera.frame;
        // Across the axis: as far to the right in the picture as can be, and the third.
        const aside = unit(add(right, wall.along, -dot(right, wall.along)));
        const u = Math.hypot(...aside) > 0.1 ? aside : unit(cross(wall.along, away));
        const size = Math.min(Math.max(1.5, wall.radius * 0.9), this.#camera.distance * 0.17);
        return { ...wall, u, v: cross(wall.along, u), size };
    }

    #quad({ middle, u, v, size }) {
        const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([s, t]) => add(add(middle, u, s * size), v, t * size));
        this.#fill(corners, this.#color('wall'), 0.26);
        this.#line(corners, this.#color('wall'), 1.5, 0.9);
    }

    /** The axis beside the plane, with both shapes as they fall on it. */
    #axis({ along, middle, u, size, radius, least, greatest }, center) {
        const foot = add(middle, u, size * 1.06);
        const base = dot(along, minus(foot, center));
        const at = (x) => add(foot, along, x - base);
        const reach = Math.max(greatest - least, radius) * 0.15 + Math.min(0.25, this.#camera.distance * 0.027);
        this.#line([at(-radius - reach), at(greatest + reach)], this.#color('wall'), 1.5);
        this.#line([at(-radius), at(radius)], this.#color('box'), 6);
        // A triangle seen edge-on is a point: a little longer, so that it is seen.
        const little = this.#camera.distance * 2e-3;
        this.#line([at(least - little), at(greatest + little)], this.#color('triangle'), 6);
        const tip = this.#camera.pixel(at(greatest + reach));
        if (tip) this.#text('axis', [tip.at[0], tip.at[1] - 11], this.#color('wall'));
    }

    /** The outline of what is moved, stronger; a vertex has a larger circle instead. */
    #mark(triangle, sides, held) {
        const outlines = { triangle: [triangle], box: sides.map(({ corners }) => corners) }[held] ?? [];
        outlines.forEach((outline) => this.#line(outline, this.#color(held), 3.5));
    }

    #corners(triangle, held) {
        triangle.forEach((v, k) => {
            const seen = this.#camera.pixel(v);
            if (!seen) return;
            const [x, y] = seen.at;
            this.#ctx.beginPath();
            this.#ctx.arc(x, y, held === k ? 9 : 6.5, 0, 2 * Math.PI);
            this.#ctx.fillStyle = this.#color('page');
            this.#ctx.fill();
            this.#ctx.lineWidth = 2.5;
            this.#ctx.strokeStyle = this.#color('triangle');
            this.#ctx.stroke();
            this.#text(NAMES[k], [x, y - 18], this.#color('ink'));
        });
    }

    /** Where they nearly touch. */
    #ring(triangle, center, half, axes) {
        const axis = axes[nearest(axes)];
        if (!(Math.abs(axis.gap) < this.#camera.distance * 0.002)) return;
        const seen = this.#camera.pixel(this.#between(triangle, center, half, axis).middle);
        if (!seen) return;
        this.#ctx.beginPath();
        this.#ctx.arc(...seen.at, 15, 0, 2 * Math.PI);
        this.#ctx.strokeStyle = this.#color('ink');
        this.#ctx.lineWidth = 2;
        this.#ctx.stroke();
    }

    /** Where to look to see the gap. */
    focus(numbers, axes) {
        const [a, b, c, center, half] = [0, 3, 6, 9, 12].map((k) => numbers.slice(k, k + 3));
        const axis = axes[nearest(axes)];
        return { target: this.#between([a, b, c], center, half, axis).middle, gap: Math.abs(axis.gap) };
    }
}
