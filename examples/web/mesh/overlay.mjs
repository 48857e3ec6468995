// What is drawn over the voxels: the box of the grid, the triangle that was picked, the point.
const AXES = ['x', 'y', 'z'];

export class Overlay {
    #over;
    #under;
    /** That of the two which is drawn on. */
    #ctx;
    #view;
    #color;

    /** One canvas lies over the voxels, one under them. */
    constructor(over, under, view) {
        [this.#over, this.#under] = [over, under].map((canvas) => canvas.getContext('2d'));
        this.#view = view;
    }

    /** `from` and `to` are corners of the grid; a cross marks the middle, where keys pick. */
    draw({ from, to, triangle, open, point, where, isHidden, isHeld, hasCross }, ratio) {
        const style = getComputedStyle(document.documentElement);
        this.#color = (name) => style.getPropertyValue(`--${name}`);
        const { width, height } = this.#view;
        for (this.#ctx of [this.#under, this.#over]) {
            this.#ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
            this.#ctx.clearRect(0, 0, width, height);
            if (this.#ctx === this.#under) this.#box(from, to);
        }
        if (open) this.#line(open, 'bad', 3);
        if (triangle) this.#triangle(triangle);
        if (point) this.#point(point, { where, isHidden, isHeld, from });
        if (hasCross) this.#cross(width / 2, height / 2);
    }

    #path(points) {
        this.#ctx.beginPath();
        this.#view.path(points).forEach(([x, y], k) => (k ? this.#ctx.lineTo(x, y) : this.#ctx.moveTo(x, y)));
    }

    #line(points, color, width = 1, dashes = []) {
        this.#path(points);
        this.#ctx.setLineDash(dashes);
        Object.assign(this.#ctx, { strokeStyle: this.#color(color), lineWidth: width, lineCap: 'round', lineJoin: 'round' });
        this.#ctx.stroke();
        this.#ctx.setLineDash([]);
    }

    /** The three edges at the foot that are farthest from the eye, and their names. */
    #box(from, to) {
        const foot = this.#view.isYUp ? 1 : 2;
        const { away } = this.#view.frame;
        // The corner of the foot that is farthest: there edges are behind the mesh.
        const corner = from.map((x, i) => (i === foot ? x : away[i] > 0 ? to[i] : x));
        for (let i = 0; i < 3; i += 1) {
            const end = corner.map((x, k) => (k === i ? (x === from[k] ? to[k] : from[k]) : x));
            this.#line([corner, end], 'grid', 1);
            const at = this.#view.at(end.map((x, k) => x + (x - corner[k]) * 0.06));
            if (at) this.#text(AXES[i], at);
        }
        // The two others of the foot.
        const others = [0, 1, 2].filter((i) => i !== foot);
        const opposite = corner.map((x, k) => (k === foot ? x : x === from[k] ? to[k] : from[k]));
        for (const i of others) {
            const beside = opposite.map((x, k) => (k === i ? (x === from[k] ? to[k] : from[k]) : x));
            this.#line([opposite, beside], 'grid', 1);
        }
    }

    #text(text, [x, y]) {
        const ctx = this.#ctx;
        ctx.font = '13px system-ui, sans-serif';
        Object.assign(ctx, { textAlign: 'center', textBaseline: 'middle', fillStyle: this.#color('faint') });
        ctx.fillText(text, x, y);
    }

    #triangle(corners) {
        this.#path([...corners, corners[0]]);
        this.#ctx.fillStyle = this.#color('bad');
        this.#ctx.globalAlpha = 0.3;
        this.#ctx.fill();
        this.#ctx.globalAlpha = 1;
        this.#line([...corners, corners[0]], 'page', 5);
        this.#line([...corners, corners[0]], 'bad', 2.5);
    }

    /** Filled where it is inside; dashed where the mesh hides it. */
    #point(point, { where, isHidden, isHeld, from }) {
        const at = this.#view.at(point);
        if (!at) return;
        const foot = this.#view.isYUp ? 1 : 2;
        this.#line([point, point.map((x, i) => (i === foot ? Math.min(from[i], x) : x))], 'ink', 1, [2, 4]);
        const ctx = this.#ctx;
        const circle = (radius) => {
            ctx.beginPath();
            ctx.arc(...at, radius, 0, 2 * Math.PI);
        };
        circle(isHeld ? 12 : 9);
        ctx.fillStyle = this.#color('page');
        ctx.fill();
        Object.assign(ctx, { lineWidth: 2.5, strokeStyle: this.#color('ink') });
        ctx.setLineDash(isHidden ? [3, 4] : []);
        ctx.stroke();
        ctx.setLineDash([]);
        if (where === 'outside') return;
        circle(isHeld ? 7.5 : 5);
        ctx.fillStyle = this.#color(where === 'on' ? 'triangle' : 'wall');
        ctx.fill();
    }

    #cross(x, y) {
        const ctx = this.#ctx;
        for (const [color, width] of [['page', 4], ['ink', 1.5]]) {
            ctx.beginPath();
            for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
                ctx.moveTo(x + 4 * dx, y + 4 * dy);
                ctx.lineTo(x + 13 * dx, y + 13 * dy);
            }
            Object.assign(ctx, { strokeStyle: this.#color(color), lineWidth: width });
            ctx.stroke();
        }
    }
}
