// Looks at a point from a distance, and turns around it. All is taken relative to that
// point first, so that the view can come as close as two neighbouring floats are.
import { add, clip, cross, dot, mean, minus } from './vector.mjs';

const NEAR = 0.02;
/** What lies as near to the target as this is in sight at the start. */
const START = 3.4;
/** From how far, in radii, all of a ball is in sight. */
const FIT = 3;
/** The limits of the distance: any two `f32` can be seen apart, and all be in sight. */
const [NEAREST, FARTHEST] = [1e-44, 1e40];
/** Half the height of what is seen, at a distance of one. */
const SPREAD = 0.36;

export class Camera {
    target = [0.2, 0.1, -0.1];
    distance = 9.2;
    yaw = -0.95;
    pitch = 0.42;
    width = 1;
    height = 1;
    /** Where the middle of the picture is, as a share of the width. */
    middle = 0.5;

    /** Right, up, and away from the eye. */
    get frame() {
        const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
        const away = [-cy * cp, -sy * cp, -sp];
        const right = [-sy, cy, 0];
        return { right, up: cross(right, away), away };
    }

    get eye() {
        return add(this.target, this.frame.away, -this.distance);
    }

    /** Pixels per unit at a distance of one. */
    get #scale() {
        return Math.min(this.height, this.width * 0.9) / 2 / SPREAD;
    }

    /** In the frame of the eye: right, up, depth. */
    #turned(p) {
        const { right, up, away } = this.frame;
        const from = minus(p, this.target);
        return [dot(from, right), dot(from, up), dot(from, away) + this.distance];
    }

    #flat([x, y, depth]) {
        const by = this.#scale / depth;
        return [this.width * this.middle + x * by, this.height / 2 - y * by];
    }

    /** The pixels of a polygon or a segment, without what cannot be seen. */
    path(points) {
        const wide = 2 * SPREAD * Math.max(this.width / this.height, 1) + 1;
        let seen = clip(points.map((p) => this.#turned(p)), (p) => p[2] - NEAR * this.distance);
        for (const [i, sign] of [[0, 1], [0, -1], [1, 1], [1, -1]]) {
            seen = clip(seen, (p) => wide * p[2] - sign * p[i]);
        }
        return seen.map((p) => this.#flat(p));
    }

    /** The pixel of a point, and how deep it lies; nothing if that is behind the eye. */
    pixel(p) {
        const turned = this.#turned(p);
        return turned[2] < NEAR * this.distance ? null : { at: this.#flat(turned), depth: turned[2] };
    }

    /** The way that a move by so many pixels is at some depth. */
    way(dx, dy, depth) {
        const { right, up } = this.frame;
        const by = depth / this.#scale;
        return add(right.map((x) => x * dx * by), up, -dy * by);
    }

    /** How long a pixel is at some depth. */
    pixelAt(depth) {
        return depth / this.#scale;
    }

    /** Where the ray through a pixel runs. */
    ray([x, y]) {
        const way = this.way(x - this.width * this.middle, y - this.height / 2, 1);
        return { from: this.eye, along: add(way, this.frame.away) };
    }

    orbit(dx, dy) {
        this.yaw -= dx * 0.008;
        this.pitch = Math.min(Math.max(this.pitch + dy * 0.008, -1.5), 1.5);
    }

    /** Moves what is seen by so many pixels. */
    pan(dx, dy) {
        this.target = add(this.target, this.way(dx, dy, this.distance), -1);
    }

    zoom(by) {
        this.distance = Math.min(Math.max(this.distance * by, NEAREST), FARTHEST);
    }

    /** As at the start, if all points are in sight then; else so far away that they are. */
    fit(points) {
        const { target, distance, yaw, pitch } = new Camera();
        Object.assign(this, { target, distance, yaw, pitch });
        const ends = [Math.min, Math.max].map((end) => [0, 1, 2].map((i) => end(...points.map((p) => p[i]))));
        const middle = mean(ends);
        const radius = Math.hypot(...minus(ends[1], middle));
        const fromStart = Math.max(...points.map((p) => Math.hypot(...minus(p, target))));
        if (fromStart <= START && radius > START / 50) return;
        this.target = middle;
        this.distance = Math.min(Math.max(radius * FIT, NEAREST), FARTHEST);
    }
}
