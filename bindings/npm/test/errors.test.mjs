// Rubbish in every field: the error names the argument and the element, and nothing else happens.
import assert from 'node:assert/strict';
import test from 'node:test';
import { init, inSteps, Mesh } from '../js/index.js';
import * as pairs from '../js/pairs.js';

test('before init', () => {
    assert.throws(() => new Mesh([]), /await init\(\) first/);
    assert.throws(() => pairs.overlaps({}, {}), /await init\(\) first/);
});

const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
const faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
await Promise.all([init(), pairs.init()]);
const mesh = new Mesh(corners, faces);

/** What each value is as an argument: those that are no vector. */
const RUBBISH = [undefined, null, 7, NaN, '', 'xyz', true, 1n, Symbol.iterator.toString, {}, [], [1, 2], [1, 2, 3, 4], [1, 2, NaN],
    [1, 2, '3'], [1, undefined, 3], [Infinity, 0, 1], [1, 2, 1e39], { x: 1, y: 2 }, { x: 1, y: 2, z: null }, new Date(), new DataView(new ArrayBuffer(3)), new Float32Array(2)];

const V = [1, 2, 3];
const fields = {
    origin: (v) => mesh.raycast(v, V),
    direction: (v) => mesh.raycast(V, v),
    'any origin': (v) => mesh.raycastAny(v, V),
    'any direction': (v) => mesh.raycastAny(V, v),
    'all origin': (v) => mesh.raycastAll(v, V),
    'all direction': (v) => mesh.raycastAll(V, v),
    point: (v) => mesh.contains(v),
    'locate point': (v) => mesh.locate(v),
    min: (v) => mesh.overlapsBox(v, V),
    max: (v) => mesh.overlapsBox([-9, -9, -9], v),
    'in min': (v) => mesh.trianglesInBox(v, V),
    center: (v) => mesh.overlapsSphere(v, 1),
    'in center': (v) => mesh.trianglesInSphere(v, 1),
    'closest point': (v) => mesh.closestPoint(v),
    'signed point': (v) => mesh.signedDistance(v),
    'cast min': (v) => mesh.boxCast(v, V, V),
    'cast max': (v) => mesh.boxCast([-9, -9, -9], v, V),
    motion: (v) => mesh.boxCast(V, V, v),
    'sphere center': (v) => mesh.sphereCast(v, 1, V),
    'sphere motion': (v) => mesh.sphereCast(V, 1, v),
    'contacts center': (v) => mesh.sphereContacts(v, 1),
    'capsule a': (v) => mesh.capsuleContacts(v, V, 1),
    'capsule b': (v) => mesh.capsuleContacts(V, v, 1),
    'grid.origin': (v) => mesh.voxelize({ origin: v, cell: 1, size: V }),
    'grid.size': (v) => mesh.voxelize({ origin: V, cell: 1, size: v }),
    'first.a': (v) => pairs.overlaps({ a: v, b: V, c: V }, { min: V, max: V }),
    'second.max': (v) => pairs.overlaps({ a: V, b: V, c: V }, { min: V, max: v }),
    'second.center': (v) => pairs.contact({ a: V, b: V, c: V }, { center: v, halfExtents: V }),
    'second.halfExtents': (v) => pairs.contact({ a: V, b: V, c: V }, { center: V, halfExtents: v }),
    'second.axes[1]': (v) => pairs.contact({ a: V, b: V, c: V }, { center: V, halfExtents: V, axes: [[1, 0, 0], v, [0, 0, 1]] }),
    'first.center': (v) => pairs.contact({ center: v, radius: 1 }, { min: V, max: V }),
    'first.b': (v) => pairs.contact({ a: V, b: v, radius: 1 }, { min: V, max: V }),
    'sphere.center': (v) => pairs.raySphere({ origin: V, direction: V }, { center: v, radius: 1 }),
    'ray.origin': (v) => pairs.rayBox({ origin: v, direction: V }, { min: V, max: V }),
    'ray.direction': (v) => pairs.rayBox({ origin: V, direction: v }, { min: V, max: V }),
};

for (const [field, ask] of Object.entries(fields)) {
    test(`${field}: no vector`, () => {
        const name = field.split(' ').at(-1);
        for (const [k, v] of RUBBISH.entries()) {
            // Of f64 the same is a number.
            const isFine = k === RUBBISH.findIndex((x) => Array.isArray(x) && x[2] === 1e39) && /^(first|second|ray|sphere\.)/.test(field);
            if (isFine) continue;
            assert.throws(() => ask(v), (error) => {
                assert.ok(error instanceof TypeError || error instanceof RangeError, `${error}`);
                assert.ok(error.message.startsWith(name), `${name}: ${error.message}`);
                return true;
            }, `${field} ${String(v)}`);
        }
    });
}

const told = (ask, message) => assert.throws(ask, { message });

test('a mesh says which of its numbers is wrong', () => {
    told(() => new Mesh(), 'positions are undefined, not an array of numbers');
    told(() => new Mesh('123'), 'positions are "123", not an array of numbers');
    told(() => new Mesh([0, 1]), 'positions have 2 numbers, not a multiple of 3: a vertex has 3');
    told(() => new Mesh([0, 1, 2]), 'positions have 1 vertices, not a multiple of 3: without an index each triangle has three');
    told(() => new Mesh([...corners.slice(0, 10), NaN, 0], faces), 'positions[10] is NaN, not a finite number: y of vertex 3');
    told(() => new Mesh(Float32Array.of(0, 0, 0, 0, -Infinity, 0, 1, 1, 1)), 'positions[4] is -Infinity, not a finite number: y of vertex 1');
    told(() => new Mesh([...corners.slice(0, 11), 1e39], faces), 'positions[11] is 1e+39, which is beyond f32: z of vertex 3');
    told(() => new Mesh([...corners.slice(0, 11), '1'], faces), 'positions[11] is "1", not a number');
    told(() => new Mesh([...corners.slice(0, 11), undefined], faces), 'positions[11] is undefined, not a number');
    told(() => new Mesh(new BigInt64Array(3)), 'positions are an object (BigInt64Array) of bigints, not of numbers');
    told(() => new Mesh(corners, [0, 1]), 'index have 2 numbers, not a multiple of 3: a triangle has 3');
    told(() => new Mesh(corners, Uint16Array.of(0, 1, 2, 0, 4, 1)), 'index[4] is 4, and there are 4 vertices: corner 1 of triangle 1');
    told(() => new Mesh(corners, [0, 1, -1]), 'index[2] is -1, not the number of a vertex');
    told(() => new Mesh(corners, [0, 1.5, 2]), 'index[1] is 1.5, not the number of a vertex');
    told(() => new Mesh(corners, Float32Array.of(0, NaN, 2)), 'index[1] is NaN, not the number of a vertex');
    told(() => new Mesh(corners, 'abc'), 'index are "abc", not an array of numbers');
    told(() => Mesh.fromGeometry(null), 'geometry is null, not a BufferGeometry with the attribute position');
    told(() => Mesh.fromGeometry({ attributes: { position: { itemSize: 2, array: [] } } }), 'geometry.attributes.position has 2 numbers to a vertex, not 3');
});

test('options and counts say what is wrong', async () => {
    told(() => mesh.raycast(V, [0, 0, 0]), 'direction is zero');
    told(() => mesh.raycast(V, [0, 1e-60, 0]), 'direction is zero once rounded to f32');
    told(() => mesh.raycast(V, V, { far: NaN }), 'options.far is NaN, not a finite number');
    for (const near of [3.4028236e38, 1e300, Infinity]) {
        told(() => mesh.raycast(V, V, { near }), Number.isFinite(near) ? `options.near is ${near}, which is beyond f32` : 'options.near is Infinity, not a finite number');
    }
    told(() => mesh.raycastAny(V, V, { near: -Infinity, far: -1e39 }), 'options.far is -1e+39, which is beyond f32');
    told(() => mesh.raycastAll(V, V, { far: -Infinity }), 'options.far is -Infinity, not a finite number');
    told(() => mesh.raycast(V, V, { near: '0' }), 'options.near is "0", not a number');
    told(() => mesh.raycast(V, V, { near: 2, far: 1 }), 'options.near is 2, above options.far, which is 1');
    told(() => mesh.raycast(V, V, { cull: 'both' }), "options.cull is \"both\", not 'none', 'back' or 'front'");
    told(() => mesh.raycast(V, V, { culling: 'back' }), 'options.culling is unknown; there are near, far, cull');
    told(() => mesh.raycast(V, V, 3), 'options are 3, not an object');
    told(() => mesh.raycastMany([1, 2, 3, 4, 5]), 'rays have 5 numbers, not a multiple of 6: a ray has 6');
    told(() => mesh.raycastMany([1, 2, 3, 4, 5, 6, 1, 2, NaN, 4, 5, 6]), 'rays[8] is NaN, not a finite number');
    told(() => mesh.raycastAnyMany([1, 2, 3, 0, 0, 0]), 'the direction of ray 0 is zero: rays[3] to rays[5]');
    // Options are looked at without a ray too.
    for (const ask of ['raycastMany', 'raycastAnyMany']) {
        told(() => mesh[ask]([], { bad: 1 }), 'options.bad is unknown; there are near, far, cull');
        told(() => mesh[ask]([], { near: 2, far: 1 }), 'options.near is 2, above options.far, which is 1');
    }
    told(() => mesh.containsMany([1, 2, 3, 4, 5, Infinity]), 'points[5] is Infinity, not a finite number');
    told(() => mesh.overlapsBox([0, 3, 0], [1, 2, 1]), 'min.y is 3, above max.y, which is 2');
    told(() => mesh.overlapsSphere(V, -1), 'radius is -1, which is negative');
    told(() => mesh.overlapsSphere(V), 'radius is undefined, not a number');
    told(() => mesh.trianglesInSphere(V, 1e39), 'radius is 1e+39, which is beyond f32');
    told(() => mesh.closestPoint(V, { within: -1 }), 'options.within is -1, which is negative');
    told(() => mesh.closestPoint(V, 3), 'options are 3, not an object');
    told(() => mesh.closestPoint(V, { far: 3 }), 'options.far is unknown; there are within');
    told(() => mesh.sphereCast(V, -1, V), 'radius is -1, which is negative');
    told(() => mesh.capsuleContacts(V, V), 'radius is undefined, not a number');
    told(() => mesh.overlapsMesh({}), 'other is an object (Object), not a Mesh');
    told(() => mesh.overlappingPairs(mesh, -1), 'limit is -1, not a whole number from 0 to 4294967295');
    told(() => mesh.corners(4), 'triangle is 4, not a whole number from 0 to 3');
    told(() => mesh.voxelize(0), 'grid is 0, not a whole number from 1 to 1073741824');
    told(() => mesh.voxelize('8'), 'grid is "8", not a number of voxels or { origin, cell, size }');
    told(() => mesh.voxelize(8, { solid: 1 }), 'options.solid is 1, not true or false');
    told(() => mesh.voxelize(8, { triangles: [0, 9] }), 'options.triangles[1] is 9, not a whole number from 0 to 4');
    told(() => mesh.voxelize({ origin: V, cell: 0, size: V }), 'grid.cell[0] is 0, not positive');
    told(() => mesh.voxelize({ origin: V, cell: 1, size: [1, 2.5, 1] }), 'grid.size[1] is 2.5, not a whole number from 1 to 1073741824');
    told(() => mesh.voxelize({ origin: [1e9, 0, 0], cell: 1e-3, size: V }), /^the voxels are too small/);
    told(() => mesh.voxelize(1 << 20), 'there is no memory for so many voxels');
    told(() => new Mesh([1, 1, 1, 1, 1, 1, 1, 1, 1]).voxelize(4), 'all of the mesh is in one point: it has no size');
    told(() => new Mesh([]).voxelize(4), 'the mesh has no triangles');
    told(() => pairs.overlaps({ min: V, max: V }, { center: V, halfExtents: [1, -1, 1] }), 'second.halfExtents.y is -1, below zero');
    told(() => pairs.overlaps({ center: V, halfExtents: V, axes: [V, V, V] }, { min: V, max: V }), 'first.axes are not unit vectors at right angles');
    told(() => pairs.overlaps({ min: V, max: V }, { center: V, halfExtents: V, quaternion: [1, 1, 1, 1] }), 'second.quaternion has not the length 1');
    told(() => pairs.overlaps({ min: V, max: V }, {}), 'second has neither a, b and c, nor min and max, nor center and halfExtents, nor a radius');
    const [ball, box] = [{ center: V, radius: 1 }, { min: V, max: V }];
    told(() => pairs.overlaps(box, { center: V, radius: -1 }), 'second.radius is -1, which is negative');
    const none = (one, other) => `there is no such question about ${one} and ${other}: spheres and capsules have it with { a, b, c } and { min, max }`;
    told(() => pairs.contact(ball, ball), none('first', 'second'));
    told(() => pairs.contact({ center: V, halfExtents: V }, ball), none('first', 'second'));
    told(() => pairs.overlaps(ball, { center: V, halfExtents: V }), none('first', 'second'));
    told(() => pairs.rayBox({ origin: V, direction: V }, ball), 'box is another shape');
    told(() => pairs.raySphere({ origin: V, direction: V }, box), 'sphere is another shape');
    told(() => pairs.rayBox({ origin: V, direction: V, near: 1, far: 0 }, { min: V, max: V }), 'ray.near is 1, above ray.far, which is 0');
    told(() => pairs.rayBox({ origin: V, direction: V, near: Infinity }, box), 'ray.near is Infinity, not a finite number');
    told(() => pairs.rayBox({ origin: V, direction: V, nera: 1 }, box), 'ray.nera is unknown; there are origin, direction, near, far');
    told(() => pairs.overlaps(box, { center: V, halfExtents: V, axes: [V, V, V], quaternion: [0, 0, 0, 1] }), 'second has both axes and a quaternion');
    await assert.rejects(init(5), { message: 'options are 5, not an object' });
    await assert.rejects(init({ simd: 'x' }), { message: 'options.simd is "x", not true or false' });
    await assert.rejects(inSteps(7), { message: /^steps are 7/ });
    await assert.rejects(inSteps(Mesh.steps(corners, faces), { slice: 'x' }), { message: 'options.slice is "x", not a number of milliseconds' });
    await assert.rejects(inSteps(Mesh.steps(corners, faces), { signal: 5 }), { message: 'options.signal is 5, not an AbortSignal' });
    await assert.rejects(inSteps(Mesh.steps(corners, faces), { signal: AbortSignal.abort() }), { name: 'AbortError' });
});

test('a mesh that is freed answers nothing', () => {
    const gone = new Mesh(corners, faces);
    gone.free();
    gone.free();
    for (const ask of [() => gone.raycast(V, V), () => gone.contains(V), () => gone.voxelize(4), () => mesh.overlapsMesh(gone),
        () => gone.raycastMany([]), () => gone.openEdge(), () => gone.sphereContacts(V, 1), () => gone.bounds, () => gone.index]) told(ask, 'the mesh is freed');
    assert.equal(mesh.contains([0.1, 0.1, 0.1]), true);
});
