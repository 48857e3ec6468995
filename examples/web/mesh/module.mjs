// The module web_mesh.wasm: see module.rs for what it exports. Imports nothing, so that other pages
// can take this file and the module alone.

/** The most triangles. */
export const MOST_TRIANGLES = 500_000;
/** The most voxels along a side: a face is drawn by three numbers of a byte. */
export const MOST_VOXELS = 256;

/** How many triangles are handed over at a time, between two looks at the clock. */
const PART = 4096;
/** How long a question is repeated to be timed, in ms: browsers' clocks are coarse. */
const LONG_ENOUGH = 2;

/** Why there is no grid, by what the module returns. */
const NO_GRID = [
    '', 'There is no mesh.', 'All of the mesh is in one point: it has no size.',
    'Voxels would be too small for their distance from zero: neighbouring planes of the grid would round to one number. Take fewer voxels, or move the mesh to zero.',
    'The mesh is too large for a grid in f32.', 'There is no memory for so many voxels.',
];

export class Mesh {
    #exports;
    vertices = 0;
    triangles = 0;

    /** From the module's bytes. */
    static async from(bytes) {
        const { instance } = await WebAssembly.instantiate(bytes);
        if (!instance.exports.room) throw new Error('a module, but not web_mesh.wasm');
        const mesh = new Mesh();
        mesh.#exports = instance.exports;
        return mesh;
    }

    /** The memory as numbers; a view ends where the memory grows. */
    #view(Type, at, count) {
        return new Type(this.#exports.memory.buffer, at, count);
    }

    /** Numbers that a question takes, and an answer leaves. */
    #numbers(Type) {
        return this.#view(Type, this.#exports.numbers(), 15);
    }

    get bytes() {
        return this.#exports.memory.buffer.byteLength;
    }

    /** Takes vertices, three numbers each, and triangles, three indices each. Builds the tree. */
    load({ vertices, triangles }) {
        [this.vertices, this.triangles] = [0, 0];
        const [count, faces] = [vertices.length / 3, triangles.length / 3];
        if (!this.#exports.room(count, faces)) throw new Error('There is no memory for this mesh.');
        this.#view(Float32Array, this.#exports.vertices(), 3 * count).set(vertices);
        this.#view(Uint32Array, this.#exports.triangles(), 3 * faces).set(triangles);
        const start = performance.now();
        if (!this.#exports.build()) throw new Error('The module refuses the mesh.');
        Object.assign(this, { vertices: count, triangles: faces });
        return performance.now() - start;
    }

    /** The three vertices of a triangle. */
    corners(triangle) {
        const indices = this.#view(Uint32Array, this.#exports.triangles() + 12 * triangle, 3);
        return [...indices].map((i) => this.vertex(i));
    }

    vertex(i) {
        return [...this.#view(Float32Array, this.#exports.vertices() + 12 * i, 3)];
    }

    /** All corners of all triangles, in a row. */
    soup() {
        const vertices = this.#view(Float32Array, this.#exports.vertices(), 3 * this.vertices);
        const indices = this.#view(Uint32Array, this.#exports.triangles(), 3 * this.triangles);
        const soup = new Float32Array(3 * indices.length);
        indices.forEach((i, k) => soup.set(vertices.subarray(3 * i, 3 * i + 3), 3 * k));
        return soup;
    }

    /** The ends of an edge that belongs to an odd number of triangles, if one does. */
    openEdge() {
        if (this.#exports.closed()) return null;
        return [...this.#numbers(Uint32Array).subarray(0, 2)].map((i) => this.vertex(i));
    }

    /**
     * Voxelizes it, and tells `pause` between parts how much is done, from 0 to 1; that may
     * throw to end it. Says the grid, which voxels are set and how many, how many rows do not
     * close, and how long the module took.
     */
    async voxelize(resolution, isSolid, pause) {
        let time = 0;
        const timed = (ask) => {
            const start = performance.now();
            const answer = ask();
            time += performance.now() - start;
            return answer;
        };
        const problem = timed(() => this.#exports.grid(resolution));
        if (problem) throw new Error(NO_GRID[problem]);
        const size = [...this.#numbers(Uint32Array).subarray(0, 3)];
        const [x, y, z, cell] = this.#numbers(Float32Array).subarray(3, 7);
        let [count, open] = [0, 0];
        const passes = isSolid ? ['cross', 'fill'] : ['fill'];
        for (const [k, pass] of passes.entries()) {
            for (let from = 0; from < this.triangles; from += PART) {
                const to = Math.min(from + PART, this.triangles);
                timed(() => this.#exports[pass](from, to));
                await pause((k + to / this.triangles) / passes.length);
            }
            if (pass === 'cross') open = timed(() => this.#exports.finish());
        }
        count = timed(() => this.#exports.count());
        // The next question may have another grid.
        const words = this.#words(0, size).slice();
        return { size, origin: [x, y, z], cell, words, count, open, time };
    }

    /** The words of the voxels, 32 to a word along x, rows by y, and then z. */
    #words(which, size) {
        const words = Math.ceil(size[0] / 32) * size[1] * size[2];
        return this.#view(Uint32Array, this.#exports.words() + 4 * words * which, words);
    }

    /** The same of the voxels of one triangle, and how many there are. */
    mark(triangle, size) {
        const count = this.#exports.mark(triangle);
        return { count, words: this.#words(1, size).slice() };
    }

    #ask(question, numbers) {
        this.#numbers(Float32Array).set(numbers);
        return this.#exports[question]();
    }

    /** How long a question takes: it is asked over and over. */
    #time(question, numbers) {
        const start = performance.now();
        let [count, now] = [0, start];
        for (; now < start + LONG_ENOUGH; now = performance.now(), count += 8) {
            for (let k = 0; k < 8; k += 1) this.#ask(question, numbers);
        }
        return (now - start) / count;
    }

    /** The first triangle on a ray, if there is one, and what the question takes. */
    pick(from, along) {
        const numbers = [...from, ...along];
        const time = this.#time('pick', numbers);
        const answer = this.#ask('pick', numbers);
        const [t] = this.#numbers(Float32Array);
        const isBack = this.#numbers(Uint32Array)[3] === 1;
        return answer ? { triangle: answer - 1, t, isBack, time } : { triangle: null, time };
    }

    /** Whether a triangle is between two points, but for one near the second. */
    hides(from, to) {
        const isHit = this.#ask('pick', [...from, ...to.map((x, i) => x - from[i])]);
        return isHit > 0 && this.#numbers(Float32Array)[0] < 0.999;
    }

    /** Whether a point is 'inside', 'outside' or 'on' a triangle, and what the question takes. */
    inside(point) {
        const where = ['outside', 'inside', 'on'][this.#ask('inside', point)];
        return { where, time: this.#time('inside', point) };
    }
}
