// The stream of cases of golden.rs, asked of the package: also in a browser.
const ROUNDS = 500;

class Stream {
    constructor(state) {
        this.state = state;
    }

    next() {
        this.state ^= this.state << 13;
        this.state ^= this.state >>> 17;
        this.state ^= this.state << 5;
        return this.state >>> 0;
    }

    below(n) {
        return (this.next() >>> 8) % n;
    }

    coarse() {
        return three(() => (this.below(129) - 64) / 8);
    }

    fine() {
        const isCoarse = this.below(2) === 0;
        return three(() => {
            const x = (this.next() >>> 14) - 131_072;
            return isCoarse ? (x >> 13) / 8 : x / 3 / 32_768;
        });
    }
}

const three = (make) => [make(), make(), make()];
const bits = new DataView(new ArrayBuffer(8));

class Hash {
    hash = 2_166_136_261;
    yes = 0;

    add(word) {
        for (let k = 0; k < 4; k += 1) this.hash = Math.imul(this.hash ^ (word >>> 8 * k & 255), 16_777_619) >>> 0;
    }

    addF32(x) {
        bits.setFloat32(0, x);
        this.add(bits.getUint32(0));
    }

    addF64(x) {
        bits.setFloat64(0, x + 0);
        this.add(bits.getUint32(4));
        this.add(bits.getUint32(0));
    }

    addHit({ triangle, t, u, v, isFront }) {
        this.add(triangle);
        for (const x of [t, u, v]) this.addF32(x);
        this.add(Number(isFront));
    }

    print(what) {
        return `${what}: ${this.yes} yes, ${this.hash.toString(16).padStart(8, '0')}`;
    }
}

function teapot(text) {
    const [positions, index] = [[], []];
    for (const line of text.split('\n')) {
        const [kind, ...words] = line.trim().split(/\s+/);
        if (kind === 'v') positions.push(...words.map(Number));
        if (kind === 'f') index.push(...words.map((i) => i - 1));
    }
    return [new Float32Array(positions), new Uint16Array(index)];
}

function torus() {
    const stream = new Stream(7);
    const positions = Array.from({ length: 256 }, () => stream.coarse()).flat();
    const at = (i, j) => 16 * (i % 16) + j % 16;
    const index = [];
    for (let i = 0; i < 16; i += 1) {
        for (let j = 0; j < 16; j += 1) {
            const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            index.push(a, b, c, a, c, d);
        }
    }
    return [positions, index];
}

function ray(stream, positions) {
    const origin = stream.coarse();
    let direction = stream.coarse();
    const k = 3 * stream.below(positions.length / 3);
    if (stream.below(3) === 0) direction = origin.map((x, i) => Math.fround(positions[k + i] - x));
    return direction.some((x) => x !== 0) ? [origin, direction] : null;
}

function corners(stream) {
    const [a, b] = [stream.coarse(), stream.coarse()];
    return [a.map((x, i) => Math.min(x, b[i])), a.map((x, i) => Math.max(x, b[i]))];
}

function meshes({ Mesh }, name, [positions, index], lines) {
    const mesh = new Mesh(positions, index);
    const ask = (what, question) => {
        const [stream, hash] = [new Stream(1), new Hash()];
        for (let round = 0; round < ROUNDS; round += 1) {
            const yes = question(stream, hash);
            hash.yes += Number(yes);
            hash.add(Number(yes));
        }
        lines.push(hash.print(`${name} ${what}`));
    };
    ask('raycast', (stream, hash) => {
        const asked = ray(stream, positions);
        const hit = asked && mesh.raycast(...asked);
        if (hit) hash.addHit(hit);
        return hit !== null;
    });
    ask('raycastAny', (stream) => {
        const asked = ray(stream, positions);
        return asked !== null && mesh.raycastAny(...asked, { near: 0.25, far: 0.75 });
    });
    ask('raycastAll', (stream, hash) => {
        const asked = ray(stream, positions);
        const hits = asked ? mesh.raycastAll(...asked) : [];
        hits.forEach((hit) => hash.addHit(hit));
        return hits.length > 0;
    });
    ask('locate', (stream, hash) => {
        const k = 3 * stream.below(positions.length / 3);
        const point = stream.coarse();
        const isVertex = stream.below(8) === 0;
        const where = mesh.locate(isVertex ? positions.slice(k, k + 3) : point);
        hash.add(['outside', 'inside', 'on'].indexOf(where));
        return where !== 'outside';
    });
    ask('trianglesInBox', (stream, hash) => {
        const found = mesh.trianglesInBox(...corners(stream));
        found.forEach((i) => hash.add(i));
        return found.length > 0;
    });
    ask('trianglesInSphere', (stream, hash) => {
        const center = stream.coarse();
        const radius = stream.below(65) / 16;
        const found = mesh.trianglesInSphere(center, radius);
        found.forEach((i) => hash.add(i));
        if (mesh.overlapsSphere(center, radius) !== found.length > 0) hash.add(-1);
        return found.length > 0;
    });
    ask('boxCast', (stream, hash) => {
        const first = mesh.boxCast(...corners(stream), stream.coarse());
        if (first) {
            hash.add(first.triangle);
            hash.addF32(first.t);
        }
        return first !== null;
    });
    ask('closestPoint', (stream, hash) => {
        const point = stream.coarse();
        const within = stream.below(65) / 16 || undefined;
        const found = mesh.closestPoint(point, { within });
        if (found) {
            hash.add(found.triangle);
            for (const x of found.point) hash.addF32(x + 0);
            hash.add(part(found.part));
        }
        return found !== null;
    });
    ask('sphereCast', (stream, hash) => {
        const center = stream.coarse();
        const radius = stream.below(65) / 64;
        const first = mesh.sphereCast(center, radius, stream.coarse());
        if (first) {
            hash.add(first.triangle);
            hash.addF32(first.t + 0);
            hash.add(first.part ? part(first.part) : -1);
        }
        return first !== null;
    });
    const contacts = (hash, found) => {
        for (const { triangle, translation, depth, normal, isSufficient, isHeld, point, part: on } of found) {
            hash.add(triangle);
            for (const x of [...translation, depth, ...normal, ...point]) hash.addF32(x + 0);
            hash.add(2 * Number(isHeld) + Number(isSufficient));
            hash.add(part(on));
        }
        return found.length > 0;
    };
    ask('sphereContacts', (stream, hash) => contacts(hash, mesh.sphereContacts(stream.coarse(), stream.below(65) / 16)));
    ask('capsuleContacts', (stream, hash) => contacts(hash, mesh.capsuleContacts(stream.coarse(), stream.coarse(), stream.below(65) / 64)));
    const voxels = new Hash();
    for (const resolution of [1, 7, 33, 64]) {
        for (const solid of [false, true]) {
            const grid = mesh.voxelize(resolution, { solid, margin: 1 });
            if (solid) voxels.add(grid.openRows);
            voxels.yes += grid.count;
            grid.words.forEach((word) => voxels.add(word));
        }
    }
    lines.push(voxels.print(`${name} voxelize`));
    const moved = Float32Array.from(positions, (x) => x + 0.125);
    const pairs = mesh.overlappingPairs(new Mesh(moved, index));
    const hash = new Hash();
    hash.yes = pairs.length / 2;
    pairs.forEach((i) => hash.add(i));
    lines.push(hash.print(`${name} overlappingPairs`));
    const edge = mesh.openEdge();
    lines.push(`${name} openEdge: ${edge ? `[${edge.join(', ')}]` : 'Ok(())'}`);
}

const TURNS = [[0, 0, 0.6, 0.8], [0.5, 0.5, 0.5, 0.5], [0.1, 0.7, -0.1, 0.7], [0, 0, 0, 1]];

function any(stream, kind) {
    const [a, b, c] = three(() => stream.fine());
    const quaternion = TURNS[stream.below(4)];
    if (kind === 0) return { a, b, c };
    if (kind === 1) return { min: a.map((x, i) => Math.min(x, b[i])), max: a.map((x, i) => Math.max(x, b[i])) };
    if (kind === 2) return { center: a, halfExtents: b.map(Math.abs), quaternion };
    return kind === 3 ? { center: a, radius: Math.abs(b[0]) } : { a, b, radius: Math.abs(c[0]) };
}

const part = ({ kind, number }) => 16 * ['face', 'edge', 'vertex'].indexOf(kind) + number;

/** The features of a contact as numbers. */
function numbered({ first, second, edges, nearest }) {
    if (nearest) return [3, ...nearest.map(part)];
    if (edges) return [2, ...edges];
    return second === undefined ? [0, first, 0] : [1, second, 0];
}

function pairs({ overlaps, contact, rayBox, raySphere }, lines) {
    const names = ['triangle', 'box', 'oriented box', 'sphere', 'capsule'];
    for (let i = 0; i < 5; i += 1) {
        for (let k = 0; k < 5; k += 1) {
            if ((i > 2 && k > 1) || (i > 1 && k > 2)) continue;
            const [stream, hash] = [new Stream(1), new Hash()];
            for (let round = 0; round < ROUNDS; round += 1) {
                const [first, second] = [any(stream, i), any(stream, k)];
                const found = contact(first, second);
                if (found) {
                    for (const x of [...found.translation, found.depth, ...found.normal]) hash.addF64(x);
                    numbered(found.features).forEach((x) => hash.add(x));
                    for (const { onFirst, onSecond, depth, parts } of found.points) {
                        for (const x of [...onFirst, ...onSecond, depth]) hash.addF64(x);
                        parts.forEach((x) => hash.add(part(x)));
                    }
                }
                const yes = overlaps(first, second);
                hash.yes += Number(yes);
                hash.add(Number(yes));
            }
            lines.push(hash.print(`${names[i]}, ${names[k]}`));
        }
    }
    for (const kind of [1, 2, 3]) {
        const [stream, hash] = [new Stream(1), new Hash()];
        for (let round = 0; round < ROUNDS; round += 1) {
            const [origin, direction] = [stream.fine(), stream.fine()];
            const box = any(stream, kind);
            const ask = kind === 3 ? raySphere : rayBox;
            const range = direction.some((x) => x !== 0) ? ask({ origin, direction }, box) : null;
            hash.yes += Number(range !== null);
            if (range) range.forEach((x) => hash.addF64(x));
        }
        lines.push(hash.print(`ray, ${names[kind]}`));
    }
}

/** The lines that golden.rs prints, by the package. */
export function golden(septum, obj) {
    const lines = [];
    meshes(septum, 'teapot', teapot(obj), lines);
    meshes(septum, 'torus', torus(), lines);
    pairs(septum, lines);
    return lines;
}
