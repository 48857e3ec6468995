// A mesh and questions about it.
import { corners, direction, length, number, options, part, reach, row, shown, vector, whole } from './check.js';
import { answer, asFloats, asWords, forget, found, list, module } from './memory.js';
import { atOnce } from './steps.js';
import { voxelSteps } from './voxels.js';

/** How many triangles are looked at in a step. */
const PART = 4096;
/** How many numbers are copied, or entries of a table looked at, in a step. */
const COPIED = 1 << 18;
/** The longest list that stays in the module's memory, in words. */
const SHORT = 1 << 16;

/** Meshes that are collected give their memory back. */
const registry = new FinalizationRegistry((handle) => module().drop_mesh(handle));
const BUILT = Symbol('what steps have built');

/** Why the module refuses a mesh that JavaScript let through. */
function refused(problem, positions, index, count) {
    const which = asWords()[answer()];
    if (problem === 1) {
        const k = 3 * which + [0, 1, 2].find((i) => !Number.isFinite(Math.fround(positions[3 * which + i])));
        const x = positions[k];
        return new RangeError(`positions[${k}] is ${shown(x)}, ${Number.isFinite(x) ? 'which is beyond f32' : 'not a finite number'}: ${'xyz'[k % 3]} of vertex ${which}`);
    }
    if (problem === 2 && index) {
        const k = 3 * which + [0, 1, 2].find((i) => !(index[3 * which + i] < count));
        return new RangeError(`index[${k}] is ${index[k]}, and there are ${count} vertices: corner ${k % 3} of triangle ${which}`);
    }
    return new RangeError('the mesh has too many triangles');
}

const slice = (numbers, from, to) => (Array.isArray(numbers) ? numbers.slice(from, to) : numbers.subarray(from, to));

/** Copies so many numbers, not too many in a step; the share that is done begins at `share`. */
function* copy(count, part, share) {
    for (let from = 0; from < count; from += COPIED) {
        part(from, Math.min(from + COPIED, count));
        yield share + 0.04 * from / count;
    }
}

/** Builds a mesh, and returns its handle and its counts of vertices and triangles. */
function* build(positions, index) {
    const exports = module();
    row('positions', positions, 3, 'a vertex');
    const vertices = positions.length / 3;
    if (index !== null && index !== undefined) {
        row('index', index, 3, 'a triangle');
        if (![Uint8Array, Uint16Array, Uint32Array].some((Type) => index instanceof Type)) {
            const bad = index.findIndex((i) => !Number.isInteger(i) || i < 0 || i > 0xffff_ffff);
            if (bad >= 0) throw new RangeError(`index[${bad}] is ${shown(index[bad])}, not the number of a vertex`);
        }
    } else if (vertices % 3 !== 0) {
        throw new RangeError(`positions have ${vertices} vertices, not a multiple of 3: without an index each triangle has three`);
    }
    const triangles = (index?.length ?? vertices) / 3;
    const handle = exports.mesh(vertices, triangles);
    if (handle < 0) throw new RangeError(`there is no memory for ${vertices} vertices and ${triangles} triangles`);
    let isBuilt = false;
    try {
        yield 0.02;
        yield* copy(positions.length, (from, to) => asFloats().set(slice(positions, from, to), (exports.vertices(handle) >>> 2) + from), 0.02);
        yield* copy(3 * triangles, (from, to) => {
            const [words, at] = [asWords(), exports.triangles(handle) >>> 2];
            if (index) words.set(slice(index, from, to), at + from);
            else for (let i = from; i < to; i += 1) words[at + i] = i;
        }, 0.06);
        const problem = exports.begin(handle);
        if (problem) throw refused(problem, positions, index, vertices);
        for (let done = 0; done < 1;) {
            done = exports.advance(handle, PART);
            yield 0.1 + 0.9 * done;
        }
        isBuilt = true;
        return [handle, vertices, triangles];
    } finally {
        if (!isBuilt) exports.drop_mesh(handle);
    }
}

export class Mesh {
    #handle;
    #isFreed = false;
    #vertices;
    #triangles;
    /** Where positions and index are, in words: a tree that is built keeps its place. */
    #positionsAt;
    #indexAt;

    /**
     * From positions, three numbers to a vertex, and an index, three to a triangle; without an
     * index each three vertices are a triangle.
     */
    constructor(positions, index = null) {
        const built = positions === BUILT ? index : atOnce(build(positions, index));
        [this.#handle, this.#vertices, this.#triangles] = built;
        this.#positionsAt = module().vertices(this.#handle) >>> 2;
        this.#indexAt = module().triangles(this.#handle) >>> 2;
        registry.register(this, this.#handle, this);
    }

    /** The same in steps: see `inSteps`. */
    static *steps(positions, index = null) {
        return new Mesh(BUILT, yield* build(positions, index));
    }

    /** From three.js's `BufferGeometry`. */
    static fromGeometry(geometry) {
        return atOnce(Mesh.geometrySteps(geometry));
    }

    /** The same in steps. */
    static geometrySteps(geometry) {
        const position = geometry?.attributes?.position;
        if (position === undefined) throw new TypeError(`geometry is ${shown(geometry)}, not a BufferGeometry with the attribute position`);
        let { array } = position;
        if (position.isInterleavedBufferAttribute || position.normalized || position.isFloat16BufferAttribute) {
            array = new Float32Array(3 * position.count);
            for (let i = 0; i < position.count; i += 1) array.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i);
        } else if (position.itemSize !== 3) {
            throw new RangeError(`geometry.attributes.position has ${position.itemSize} numbers to a vertex, not 3`);
        }
        return Mesh.steps(array, geometry.index?.array ?? null);
    }

    /** The handle, while there is one. */
    get #here() {
        if (this.#isFreed) throw new Error('the mesh is freed');
        return this.#handle;
    }

    get vertexCount() {
        return this.#vertices;
    }

    get triangleCount() {
        return this.#triangles;
    }

    /** The positions as the mesh has them, copied. */
    get positions() {
        this.#here;
        return asFloats().slice(this.#positionsAt, this.#positionsAt + 3 * this.#vertices);
    }

    /** The triangles as indices of vertices, copied. */
    get index() {
        this.#here;
        return asWords().slice(this.#indexAt, this.#indexAt + 3 * this.#triangles);
    }

    /** The bounding box, or null without a triangle. */
    get bounds() {
        if (!module().bounds(this.#here)) return null;
        const [ax, ay, az, bx, by, bz] = asFloats().subarray(answer(), answer() + 6);
        return { min: [ax, ay, az], max: [bx, by, bz] };
    }

    /** The three corners of a triangle. */
    corners(triangle) {
        whole('triangle', triangle, 0, this.#triangles - 1);
        this.#here;
        const at = this.#indexAt + 3 * triangle;
        return [...asWords().subarray(at, at + 3)].map((i) => this.#vertex(i));
    }

    #vertex(i) {
        const at = this.#positionsAt + 3 * i;
        const all = asFloats();
        return [all[at], all[at + 1], all[at + 2]];
    }

    /** The first hit of a ray, or null. */
    raycast(origin, along, given) {
        const o = vector('origin', origin);
        const d = direction('direction', along);
        const ends = reach(given);
        const triangle = sane(module().first_hit(this.#here, o[0], o[1], o[2], d[0], d[1], d[2], ends[0], ends[1], ends[2]));
        return triangle < 0 ? null : this.#hit(o, d, triangle, answer());
    }

    /** Whether a ray hits any triangle. */
    raycastAny(origin, along, given) {
        const [o, d, [near, far, cull]] = [vector('origin', origin), direction('direction', along), reach(given)];
        return sane(module().any_hit(this.#here, o[0], o[1], o[2], d[0], d[1], d[2], near, far, cull)) === 1;
    }

    /** All hits of a ray, by t; where it is the same, by triangle. */
    raycastAll(origin, along, given) {
        const [o, d, [near, far, cull]] = [vector('origin', origin), direction('direction', along), reach(given)];
        const exports = module();
        const count = sane(exports.all_hits(this.#here, o[0], o[1], o[2], d[0], d[1], d[2], near, far, cull));
        const at = exports.found() >>> 2;
        const hits = Array.from({ length: count }, (_, k) => this.#hit(o, d, asWords()[at + 5 * k], at + 5 * k + 1));
        giveBack(5 * count);
        return hits.sort((a, b) => a.t - b.t || a.triangle - b.triangle);
    }

    /** A hit whose numbers are at a place. */
    #hit(o, d, triangle, at) {
        const floats = asFloats();
        const words = asWords();
        const t = floats[at];
        const { fround } = Math;
        const k = this.#indexAt + 3 * triangle;
        const from = this.#positionsAt;
        const a = from + 3 * words[k];
        const b = from + 3 * words[k + 1];
        const c = from + 3 * words[k + 2];
        const x = floats[a];
        const y = floats[a + 1];
        const z = floats[a + 2];
        const bx = floats[b] - x;
        const by = floats[b + 1] - y;
        const bz = floats[b + 2] - z;
        const cx = floats[c] - x;
        const cy = floats[c + 1] - y;
        const cz = floats[c + 2] - z;
        return {
            triangle, t, u: floats[at + 1], v: floats[at + 2], isFront: words[at + 3] === 0,
            point: [fround(o[0]) + t * fround(d[0]), fround(o[1]) + t * fround(d[1]), fround(o[2]) + t * fround(d[2])],
            normal: unit(by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx),
        };
    }

    /**
     * The first hits of many rays, six numbers each: origin and direction. A ray without a hit has
     * the triangle -1.
     */
    raycastMany(rays, given) {
        return this.#many('rays', rays, 6, 'a ray', (exports, at, count) => {
            exports.first_hits(this.#handle, ...reach(given));
            const [floats, words] = [asFloats(), asWords()];
            const [triangle, t, u, v] = [new Int32Array(count), new Float32Array(count), new Float32Array(count), new Float32Array(count)];
            for (let k = 0, p = at; k < count; k += 1, p += 6) {
                triangle[k] = words[p];
                if (triangle[k] < -1) throw brokenRay(rays, k);
                t[k] = floats[p + 1];
                u[k] = floats[p + 2];
                v[k] = floats[p + 3];
            }
            return { triangle, t, u, v };
        });
    }

    /** Whether each of many rays hits any triangle: 1 or 0. */
    raycastAnyMany(rays, given) {
        return this.#many('rays', rays, 6, 'a ray', (exports, at, count) => {
            exports.any_hits(this.#handle, ...reach(given));
            const words = asWords();
            return Uint8Array.from({ length: count }, (_, k) => {
                if (words[at + 6 * k] > 1) throw brokenRay(rays, k);
                return words[at + 6 * k];
            });
        });
    }

    /** Writes the numbers of many questions, and hands over where they are. */
    #many(name, numbers, each, element, ask) {
        row(name, numbers, each, element);
        this.#here;
        const [exports, at] = [module(), list(numbers.length || each)];
        try {
            asFloats().set(numbers, at);
            return ask(exports, at, numbers.length / each);
        } finally {
            giveBack(numbers.length);
        }
    }

    /** Whether the mesh contains a point: inside, or on a triangle. */
    contains(point) {
        return this.#locate(point) > 0;
    }

    /** Whether a point is 'outside', 'inside' or 'on' a triangle. */
    locate(point) {
        return ['outside', 'inside', 'on'][this.#locate(point)];
    }

    #locate(point) {
        const [x, y, z] = vector('point', point);
        return module().locate(this.#here, x, y, z);
    }

    /** Whether the mesh contains each of many points, three numbers each: 1 or 0. */
    containsMany(points) {
        return this.#many('points', points, 3, 'a point', (exports, at, count) => {
            exports.locate_all(this.#handle);
            const words = asWords();
            return Uint8Array.from({ length: count }, (_, k) => {
                const where = words[at + 3 * k];
                if (where > 2) throw notFinite('points', points, 3 * k, 3);
                return where > 0;
            });
        });
    }

    /** Whether a box overlaps a triangle. */
    overlapsBox(min, max) {
        const [a, b] = corners('', min, max);
        return sane(module().meets_box(this.#here, ...a, ...b)) === 1;
    }

    /** The triangles that overlap a box, in the order of their numbers. */
    trianglesInBox(min, max) {
        const [a, b] = corners('', min, max);
        return triangles(module().in_box(this.#here, ...a, ...b));
    }

    /** Whether a ball overlaps a triangle: whether one is no farther from the centre than the radius. */
    overlapsSphere(center, radius) {
        return sane(module().meets_sphere(this.#here, ...vector('center', center), length('radius', radius))) === 1;
    }

    /** The triangles that overlap a ball, in the order of their numbers. */
    trianglesInSphere(center, radius) {
        return triangles(module().in_sphere(this.#here, ...vector('center', center), length('radius', radius)));
    }

    /**
     * The point of a triangle that is closest to another, or null. None is farther than `within`, rounded
     * to the nearest f32: that of 0.1 is a little more, and that of 0.7 a little less.
     */
    closestPoint(point, given) {
        const p = vector('point', point);
        const { within = Infinity } = given === undefined ? {} : options(given, ['within']);
        const limit = within === Infinity ? within : length('options.within', within);
        const triangle = module().closest(this.#here, ...p, limit);
        if (triangle < 0) return null;
        const [floats, at] = [asFloats(), answer()];
        const found = [floats[at], floats[at + 1], floats[at + 2]];
        const distance = Math.hypot(...found.map((x, i) => x - Math.fround(p[i])));
        return { triangle, point: found, distance, part: part(asWords()[at + 3]) };
    }

    /** The distance of a point from the closed mesh, negative inside, or null without a triangle. */
    signedDistance(point) {
        const closest = this.closestPoint(point);
        return closest && (this.contains(point) ? 0 - closest.distance : closest.distance);
    }

    /** Whether a triangle overlaps one of another mesh. Meshes are surfaces here. */
    overlapsMesh(other) {
        return this.#pairs(other, 1) > 0;
    }

    /** At most `limit` pairs of triangles that overlap, of this mesh and another: [a, b, a, b, …]. */
    overlappingPairs(other, limit = 0xffff_ffff) {
        whole('limit', limit, 0, 0xffff_ffff);
        const pairs = found(2 * this.#pairs(other, limit));
        giveBack(pairs.length);
        return pairs;
    }

    #pairs(other, limit) {
        if (!(other instanceof Mesh)) throw new TypeError(`other is ${shown(other)}, not a Mesh`);
        const count = module().pairs(this.#here, other.#here, limit) >>> 0;
        if (count === 0xffff_ffff) throw new RangeError('there is no memory for so many pairs');
        return count;
    }

    /** The first triangle that a box meets on its way by `motion`, or null. */
    boxCast(min, max, motion) {
        const [[a, b], d] = [corners('', min, max), vector('motion', motion)];
        const triangle = sane(module().box_cast(this.#here, ...a, ...b, ...d));
        if (triangle < 0) return null;
        const [all, at] = [asFloats(), answer()];
        const normal = asWords()[at + 1] ? unit(all[at + 2], all[at + 3], all[at + 4]) : null;
        return { triangle, t: all[at], normal };
    }

    /** The first triangle that a sphere meets on its way by `motion`, or null. */
    sphereCast(center, radius, motion) {
        const [c, r, d] = [vector('center', center), length('radius', radius), vector('motion', motion)];
        const triangle = sane(module().sphere_cast(this.#here, ...c, r, ...d));
        if (triangle < 0) return null;
        const touched = asWords()[answer() + 1] | 0;
        return { triangle, t: asFloats()[answer()], part: touched < 0 ? null : part(touched) };
    }

    /** The contacts with all triangles that a sphere penetrates, in the order of their numbers. */
    sphereContacts(center, radius) {
        const [c, r] = [vector('center', center), length('radius', radius)];
        return contacts(module().sphere_contacts(this.#here, ...c, r));
    }

    /** The same of a capsule, by the ends of its segment. */
    capsuleContacts(a, b, radius) {
        const [from, to, r] = [vector('a', a), vector('b', b), length('radius', radius)];
        return contacts(module().capsule_contacts(this.#here, ...from, ...to, r));
    }

    /** An edge that belongs to an odd number of triangles, as two vertices; null if the mesh is closed. */
    openEdge() {
        return atOnce(this.openEdgeSteps());
    }

    /** The same in steps. */
    *openEdgeSteps() {
        const exports = module();
        const count = exports.edges(this.#here);
        if (count < 0) throw new RangeError('there is no memory to count the edges');
        try {
            let room = 0;
            for (let missing = 1; missing > 0; room += COPIED) {
                missing = exports.more_edges(count, COPIED);
                yield 0;
            }
            for (let from = 0; from < this.#triangles; from += PART) {
                exports.count_edges(count, this.#here, from, from + PART);
                yield 0.99 * from / this.#triangles;
            }
            for (let from = 0; from < room; from += COPIED) {
                exports.open_edge(count, this.#here, from, from + COPIED);
                yield 0.99;
            }
            // Once more: the page may have asked something else since.
            return exports.open_edge(count, this.#here, 0, 0) ? [...asWords().subarray(answer(), answer() + 2)] : null;
        } finally {
            exports.drop_edges(count);
        }
    }

    /** The voxels that the mesh meets; with `solid` those whose centre is inside too. */
    voxelize(grid, given) {
        return atOnce(this.voxelizeSteps(grid, given));
    }

    /** The same in steps. */
    voxelizeSteps(grid, given) {
        return voxelSteps(() => this.#here, this.#triangles, grid, given);
    }

    /** Gives the memory back; the mesh answers nothing after that. */
    free() {
        if (this.#isFreed) return;
        this.#isFreed = true;
        registry.unregister(this);
        module().drop_mesh(this.#handle);
    }

    [Symbol.dispose ?? Symbol.for('dispose')]() {
        this.free();
    }
}

/** An answer of the module, which refuses nothing that was checked here. */
function sane(answer) {
    if (answer < -1) throw new Error('septum refuses what it took for a good question: a fault of the package');
    return answer;
}

/** Gives the memory of a list of so many words back, if it is long. */
function giveBack(words) {
    if (words > SHORT) forget();
}

/** The list as triangles, in the order of their numbers. */
function triangles(count) {
    const all = found(sane(count));
    giveBack(count);
    return all.sort();
}

/** The list as contacts. In the module the triangle moves; here the other shape does. */
function contacts(count) {
    if (count === -1) throw new RangeError('there is no memory to find the interior edges');
    const [floats, words, from] = [asFloats(), asWords(), module().found() >>> 2];
    sane(count);
    const all = Array.from({ length: count }, (_, k) => {
        const at = from + 13 * k;
        const away = (i) => [0 - floats[i], 0 - floats[i + 1], 0 - floats[i + 2]];
        const flags = words[at + 8];
        return {
            triangle: words[at], translation: away(at + 1), depth: floats[at + 4], normal: away(at + 5),
            isSufficient: (flags & 1) === 1, isHeld: (flags & 2) === 2,
            point: [floats[at + 9], floats[at + 10], floats[at + 11]], part: part(words[at + 12]),
        };
    });
    giveBack(13 * count);
    return all.sort((a, b) => a.triangle - b.triangle);
}

/** The unit vector, or zero. */
function unit(x, y, z) {
    const most = Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) || 1;
    const a = x / most;
    const b = y / most;
    const c = z / most;
    const length = Math.sqrt(a * a + b * b + c * c) || 1;
    return [a / length, b / length, c / length];
}

/** Which of an element's numbers is not finite. */
function notFinite(name, numbers, from, count) {
    for (let k = from; k < from + count; k += 1) {
        const x = numbers[k];
        if (!Number.isFinite(Math.fround(x))) {
            return new RangeError(`${name}[${k}] is ${shown(x)}, ${Number.isFinite(x) ? 'which is beyond f32' : 'not a finite number'}`);
        }
    }
    return null;
}

const brokenRay = (rays, k) => notFinite('rays', rays, 6 * k, 6) ?? new RangeError(`the direction of ray ${k} is zero: rays[${6 * k + 3}] to rays[${6 * k + 5}]`);
