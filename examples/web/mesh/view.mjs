// The camera on a mesh. What is up in the file is up in the picture.
import { Camera } from '../camera.mjs';
import { add, dot, minus } from '../vector.mjs';

/** From how far, in radii, all of a ball is in sight. */
const FIT = 2.3;

export class View extends Camera {
    isYUp = true;
    /** The radius of what there is to see. */
    radius = 1;

    get frame() {
        const frame = super.frame;
        if (!this.isYUp) return frame;
        const turn = ([x, y, z]) => [x, z, -y];
        return { right: turn(frame.right), up: turn(frame.up), away: turn(frame.away) };
    }

    /** All between two corners in sight, as at the start. */
    around(low, high) {
        const { yaw, pitch } = new Camera();
        Object.assign(this, { yaw, pitch: pitch * 0.8, target: low.map((x, i) => (x + high[i]) / 2) });
        this.radius = Math.hypot(...minus(high, low)) / 2 || 1;
        this.distance = this.radius * FIT;
    }

    /** As far as there is something to see. */
    zoom(by) {
        this.distance = Math.min(Math.max(this.distance * by, this.radius * 0.05), this.radius * 40);
    }

    /**
     * What brings points of a grid, or others of that origin and size of a step, into the
     * picture: sixteen numbers, column by column.
     */
    matrix(origin, cell) {
        const { right, up, away } = this.frame;
        const from = minus(origin, this.target);
        const scale = 2 / this.pixelAt(1);
        const far = this.distance + 3 * this.radius;
        const near = Math.max(this.distance - 3 * this.radius, this.distance * 0.02);
        const [a, b] = [(far + near) / (far - near), 2 * far * near / (far - near)];
        const rows = [
            [right, scale / this.width, 0], [up, scale / this.height, 0],
            [away, a, a * this.distance - b], [away, 1, this.distance],
        ].map(([axis, by, more]) => [...axis.map((x) => x * by * cell), dot(axis, from) * by + more]);
        return [0, 1, 2, 3].flatMap((k) => rows.map((row) => row[k]));
    }

    /** Whether a point is before the eye, and where; nothing if not. */
    at(point) {
        return this.pixel(point)?.at ?? null;
    }

    /** A point moved by pixels, as deep in the picture as it is. */
    moved(point, [dx, dy]) {
        const depth = this.pixel(point)?.depth ?? this.distance;
        return add(point, this.way(dx, dy, depth));
    }
}
