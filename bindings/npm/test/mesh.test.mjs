// What the stream of golden.test.mjs does not ask: steps, geometries, many at once, memory.
import assert from 'node:assert/strict';
import test from 'node:test';
import { init, inSteps, Mesh } from '../js/index.js';
import { forget, module } from '../js/memory.js';

await init();
const corners = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
const faces = Uint16Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);

/** A wavy sheet of 2·n·n triangles. */
function sheet(n) {
    const positions = new Float32Array(3 * (n + 1) ** 2);
    for (let i = 0; i <= n; i += 1) {
        for (let k = 0; k <= n; k += 1) positions.set([i, k, Math.sin(i / 9) * Math.cos(k / 7)], 3 * (i * (n + 1) + k));
    }
    const index = new Uint32Array(6 * n * n);
    for (let i = 0; i < n; i += 1) {
        for (let k = 0; k < n; k += 1) {
            const a = i * (n + 1) + k;
            index.set([a, a + n + 1, a + n + 2, a, a + n + 2, a + 1], 6 * (i * n + k));
        }
    }
    return { positions, index };
}

test('a hit has its point and normal', () => {
    const mesh = new Mesh(corners, faces);
    assert.deepEqual(mesh.raycast([0.25, 0.25, 2], [0, 0, -1]), {
        triangle: 3, t: 1.5, u: 0.25, v: 0.5, isFront: true, point: [0.25, 0.25, 0.5], normal: [1, 1, 1].map((x) => x / Math.sqrt(3)),
    });
    assert.equal(mesh.raycast({ x: 0.25, y: 0.25, z: 2 }, [0, 0, -1], { cull: 'front' }).triangle, 0);
    assert.equal(mesh.raycast([0.25, 0.25, 2], [0, 0, -1], { far: 1 }), null);
    assert.deepEqual(mesh.bounds, { min: [0, 0, 0], max: [1, 1, 1] });
    assert.equal(mesh.openEdge(), null);
    assert.deepEqual([mesh.contains([0.1, 0.1, 0.1]), mesh.locate([0, 0, 0]), mesh.locate([1, 1, 1])], [true, 'on', 'outside']);
    assert.deepEqual(mesh.boxCast([0, 0, 2], [0.25, 0.25, 3], [0, 0, -4]).t, 0.25);
    assert.deepEqual([...mesh.voxelize(2)], [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]].filter(([x, y, z]) => mesh.voxelize(2).has(x, y, z)));
    assert.equal(mesh.voxelize(2).has(2, 0, 0), false);
});

test('the closest point of a mesh', () => {
    const mesh = new Mesh(corners, faces);
    assert.deepEqual(mesh.closestPoint([0.25, 0.25, -2]), { triangle: 0, point: [0.25, 0.25, 0], distance: 2, part: { kind: 'face', number: 0 } });
    const { point, distance, part } = mesh.closestPoint([-3, -4, 0]);
    assert.deepEqual([point, distance, part.kind], [[0, 0, 0], 5, 'vertex']);
    assert.notEqual(mesh.closestPoint([-3, -4, 0], { within: 5 }), null);
    assert.equal(mesh.closestPoint([-3, -4, 0], { within: 4.999 }), null);
    // A limit is rounded to the nearest f32: up, or down.
    for (const [within, isWithin] of [[0.1, true], [0.7, false]]) {
        assert.equal(Math.fround(within) > within, isWithin);
        const next = Math.fround(within) + (isWithin ? 0 : 2 ** -24);
        assert.equal(mesh.closestPoint([0.125, 0.125, -next], { within }) !== null, isWithin);
    }
    assert.equal(new Mesh([], []).closestPoint([0, 0, 0]), null);
    assert.equal(new Mesh([], []).signedDistance([0, 0, 0]), null);
    assert.deepEqual([[0.25, 0.25, 0.125], [0.25, 0.25, -2], [0.25, 0.25, 0]].map((p) => mesh.signedDistance(p)), [-0.125, 2, 0]);
});

test('spheres and capsules have casts and contacts', () => {
    const mesh = new Mesh(corners, faces);
    assert.deepEqual(mesh.sphereCast([0.25, 0.25, -2], 0.25, [0, 0, 2]), { triangle: 0, t: 0.875, part: { kind: 'face', number: 0 } });
    assert.equal(mesh.sphereCast([0.25, 0.25, 0], 0.25, [0, 0, 1]).part, null);
    assert.equal(mesh.sphereCast([9, 9, 9], 0.25, [0, 0, 1]), null);
    const below = mesh.sphereContacts([0.25, 0.25, -0.125], 0.1875);
    assert.deepEqual(below, [{
        triangle: 0, translation: [0, 0, -0.0625], depth: 0.0625, normal: [0, 0, -1], isSufficient: true, isHeld: false,
        point: [0.25, 0.25, 0], part: { kind: 'face', number: 0 },
    }]);
    assert.deepEqual(mesh.capsuleContacts([0.25, 0.25, -1], [0.25, 0.25, -0.125], 0.1875), below);
    // Over the diagonal of a square nothing catches on it.
    const square = new Mesh([0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0], [0, 1, 2, 3, 2, 1]);
    const found = square.sphereContacts([1.875, 2, 0.25], 0.5);
    assert.deepEqual(found.map(({ triangle, normal }) => [triangle, normal]), [[0, [0, 0, 1]]]);
});

test('in steps it is the same mesh, and the page is let in', async () => {
    const { positions, index } = sheet(300);
    const once = new Mesh(positions, index);
    let last = 0;
    let turns = 0;
    const slow = await inSteps(Mesh.steps(positions, index), {
        slice: 0, progress: (share) => {
            assert.ok(share >= last && share <= 1);
            last = share;
            turns += 1;
        },
    });
    assert.ok(turns > 10);
    const rays = Float32Array.from({ length: 6000 }, (_, k) => [(k * 7919) % 100, (k * 104_729) % 100, 5, 0.1, 0.05, -1][k % 6]);
    assert.deepEqual(slow.raycastMany(rays), once.raycastMany(rays));
    assert.deepEqual(await inSteps(slow.voxelizeSteps(50, { solid: true }), { slice: 0 }), once.voxelize(50, { solid: true }));
    // Between the steps the page may ask what has other numbers for an answer.
    assert.deepEqual(await inSteps(slow.openEdgeSteps(), { slice: 0, progress: () => slow.bounds }), [0, 1]);
    assert.deepEqual(once.openEdge(), [0, 1]);
    assert.deepEqual(slow.index, index);
    assert.deepEqual(slow.positions, positions);
});

test('many rays and points are the same as one by one', () => {
    const { positions, index } = sheet(30);
    const mesh = new Mesh(positions, index);
    const rays = Array.from({ length: 600 }, (_, k) => [(k * 7919) % 37, (k * 104_729) % 31, 5, 0.1, 0.05, -1][k % 6]);
    const { triangle, t } = mesh.raycastMany(rays);
    const any = mesh.raycastAnyMany(rays);
    const inside = mesh.containsMany(rays);
    for (let k = 0; k < 100; k += 1) {
        const [o, d] = [rays.slice(6 * k, 6 * k + 3), rays.slice(6 * k + 3, 6 * k + 6)];
        const hit = mesh.raycast(o, d);
        assert.deepEqual([triangle[k], t[k]], hit ? [hit.triangle, hit.t] : [-1, 0]);
        assert.equal(any[k] === 1, mesh.raycastAny(o, d));
        assert.deepEqual([inside[2 * k] === 1, inside[2 * k + 1] === 1], [mesh.contains(o), mesh.contains(d)]);
    }
    for (const numbers of Object.values(mesh.raycastMany([], { cull: 'back' }))) assert.equal(numbers.length, 0);
    assert.deepEqual(mesh.raycastAnyMany([], { far: 2 }), new Uint8Array(0));
    assert.deepEqual(mesh.containsMany([]), new Uint8Array(0));
});

test('a geometry of three.js, indexed, not indexed, interleaved, or of half floats', () => {
    const soup = Float32Array.from([...faces].flatMap((i) => [...corners.subarray(3 * i, 3 * i + 3)]));
    const position = (array) => ({ array, itemSize: 3, count: array.length / 3, normalized: false });
    const mixed = {
        isInterleavedBufferAttribute: true, count: 12,
        getX: (i) => soup[3 * i], getY: (i) => soup[3 * i + 1], getZ: (i) => soup[3 * i + 2],
    };
    for (const geometry of [
        { attributes: { position: position(corners) }, index: { array: faces } },
        { attributes: { position: position(soup) }, index: null },
        { attributes: { position: mixed }, index: null },
        { attributes: { position: { ...mixed, isInterleavedBufferAttribute: false, isFloat16BufferAttribute: true } }, index: null },
    ]) {
        const mesh = Mesh.fromGeometry(geometry);
        assert.equal(mesh.triangleCount, 4);
        assert.equal(mesh.openEdge(), null);
        assert.equal(mesh.raycast([0.25, 0.25, 2], [0, 0, -1]).t, 1.5);
    }
});

test('memory that is given back is used again', () => {
    const { positions, index } = sheet(100);
    for (let k = 0; k < 40; k += 1) new Mesh(positions, index).free();
    // Steps that are not ended give theirs back too.
    for (let k = 0; k < 40; k += 1) {
        const steps = Mesh.steps(positions, index);
        for (let i = 0; i < 5; i += 1) steps.next();
        steps.return();
    }
    const many = Array.from({ length: 10 }, () => new Mesh(positions, index));
    assert.equal(many[9].overlappingPairs(many[0], 5).length, 10);
    assert.equal(many[9].overlapsMesh(many[0]), true);
    many.forEach((mesh) => mesh.free());
});

test('a long list is given back', () => {
    // All of its triangles are one.
    const count = 70_000;
    const mesh = new Mesh(corners.subarray(0, 9), Uint32Array.from({ length: 3 * count }, (_, k) => k % 3));
    forget();
    const none = module().found();
    const at = [0.25, 0.25, 0.125];
    for (const [name, length, ask] of [
        ['raycastAll', count, () => mesh.raycastAll(at, [0, 0, -1])],
        ['trianglesInBox', count, () => mesh.trianglesInBox([0, 0, 0], at)],
        ['trianglesInSphere', count, () => mesh.trianglesInSphere(at, 1)],
        ['sphereContacts', count, () => mesh.sphereContacts(at, 1)],
        ['capsuleContacts', count, () => mesh.capsuleContacts(at, at, 1)],
        ['overlappingPairs', 2 * count, () => mesh.overlappingPairs(mesh, count)],
        ['containsMany', count, () => mesh.containsMany(new Float32Array(3 * count))],
    ]) {
        assert.equal(ask().length, length, name);
        assert.equal(module().found(), none, name);
    }
    assert.equal(mesh.raycast(at, [0, 0, -1]).triangle, 0);
});
