// Times and wrong answers beside three-mesh-bvh and rapier, in one process:
// npm install && npm run race. A bumpy torus; its coordinates are whole numbers of 512ths, so that
// rays lead exactly to its vertices and to the middles of its edges.
import RAPIER from '@dimforge/rapier3d-compat';
import { Box3, BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Ray, Sphere, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { init, Mesh } from '../js/index.js';

const QUERIES = 4000;
const REPEATS = 25;

let state = 1;
const random = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
};

const coarse = (x) => Math.round(512 * x) / 512;

function torus(n, m) {
    const positions = new Float32Array(3 * n * m);
    const index = new Uint32Array(6 * n * m);
    const at = (i, j) => m * (i % n) + j % m;
    for (let i = 0; i < n; i += 1) {
        for (let j = 0; j < m; j += 1) {
            const [a, b] = [2 * Math.PI * i / n, 2 * Math.PI * j / m];
            const radius = 10 + 0.5 * Math.sin(9 * a) * Math.sin(7 * b);
            const out = 30 + radius * Math.cos(b);
            positions.set([out * Math.cos(a), out * Math.sin(a), radius * Math.sin(b)].map(coarse), 3 * at(i, j));
            const [p, q, r, s] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            index.set([p, q, r, p, r, s], 6 * at(i, j));
        }
    }
    return { positions, index };
}

const CAMERA = [0, -60, 70];
const vertex = ({ positions }, i) => [0, 1, 2].map((k) => positions[3 * i + k]);
const anywhere = () => [0, 1, 2].map((k) => coarse((k < 2 ? 90 : 30) * (random() - 0.5)));

/** Rays at random, rays from a camera, and segments that end in a vertex or in the middle of an edge. */
function questions(mesh) {
    const count = mesh.positions.length / 3;
    const to = (target) => {
        const origin = anywhere();
        return [origin, target.map((x, k) => x - origin[k])];
    };
    const pick = ([x, y]) => [CAMERA, [x, y, 0].map((at, k) => at - CAMERA[k])];
    const one = () => vertex(mesh, Math.floor(random() * count));
    const middle = () => {
        const i = 3 * Math.floor(random() * mesh.index.length / 3);
        const [a, b] = [vertex(mesh, mesh.index[i]), vertex(mesh, mesh.index[i + 1])];
        return a.map((x, k) => (x + b[k]) / 2);
    };
    const many = (make) => Array.from({ length: QUERIES }, make);
    return {
        rays: many(() => to(anywhere())), picks: many(() => pick(anywhere())), vertices: many(() => to(one())), edges: many(() => to(middle())),
        boxes: many(() => {
            const [low, size] = [anywhere(), 1 + random()];
            return [low, low.map((x) => x + size)];
        }),
        points: many(anywhere),
        balls: many(() => [anywhere(), 1 + random()]),
    };
}

/** Each: how to build, and questions; those of rays say whether a segment is hit. */
const CONTENDERS = {
    septum: {
        build: ({ positions, index }) => new Mesh(positions, index),
        first: (mesh, [o, d]) => mesh.raycast(o, d),
        any: (mesh, [o, d]) => mesh.raycastAny(o, d, FAR),
        box: (mesh, [min, max]) => mesh.overlapsBox(min, max),
        closest: (mesh, point) => mesh.closestPoint(point).distance,
        ball: (mesh, [center, radius]) => mesh.overlapsSphere(center, radius),
        free: (mesh) => mesh.free(),
    },
    'three-mesh-bvh': {
        build: ({ positions, index }) => {
            const geometry = new BufferGeometry();
            geometry.setAttribute('position', new BufferAttribute(positions, 3));
            geometry.setIndex(new BufferAttribute(index.slice(), 1));
            return new MeshBVH(geometry);
        },
        first: (bvh, [o, d]) => bvh.raycastFirst(aim(o, d), DoubleSide),
        // It has no question of its own for any hit.
        any: (bvh, [o, d]) => bvh.raycastFirst(aim(o, d), DoubleSide, 0, 1.000001 * Math.hypot(...d)) !== null,
        box: (bvh, [min, max]) => {
            box3.min.fromArray(min);
            box3.max.fromArray(max);
            return bvh.intersectsBox(box3, identity);
        },
        closest: (bvh, point) => bvh.closestPointToPoint(point3.fromArray(point), found).distance,
        ball: (bvh, [center, radius]) => {
            sphere3.center.fromArray(center);
            sphere3.radius = radius;
            return bvh.intersectsSphere(sphere3);
        },
        free: () => {},
    },
    rapier: {
        build: ({ positions, index }) => {
            const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
            return { world, collider: world.createCollider(RAPIER.ColliderDesc.trimesh(positions, index)) };
        },
        first: ({ collider }, [o, d]) => collider.castRayAndGetNormal(rapierRay(o, d), 1e9, false),
        any: ({ collider }, [o, d]) => collider.castRay(rapierRay(o, d), 1.000001, false) >= 0,
        box: ({ collider }, [min, max]) => {
            const [x, y, z] = min.map((low, k) => (low + max[k]) / 2);
            const half = (max[0] - min[0]) / 2;
            return collider.intersectsShape(new RAPIER.Cuboid(half, half, half), { x, y, z }, { x: 0, y: 0, z: 0, w: 1 });
        },
        closest: ({ collider }, [x, y, z]) => {
            const { point } = collider.projectPoint({ x, y, z }, false);
            return Math.hypot(point.x - x, point.y - y, point.z - z);
        },
        ball: ({ collider }, [[x, y, z], radius]) => collider.intersectsShape(new RAPIER.Ball(radius), { x, y, z }, { x: 0, y: 0, z: 0, w: 1 }),
        free: ({ world }) => world.free(),
    },
};
const FAR = { far: 1 };
const [ray3, box3, identity] = [new Ray(new Vector3(), new Vector3()), new Box3(), new Matrix4()];
const [point3, sphere3, found] = [new Vector3(), new Sphere(), {}];
const aim = (o, d) => {
    ray3.origin.fromArray(o);
    ray3.direction.fromArray(d).normalize();
    return ray3;
};
const rapierRay = ([x, y, z], [dx, dy, dz]) => new RAPIER.Ray({ x, y, z }, { x: dx, y: dy, z: dz });

/** The least time of several, in turn, in ms. */
function race(works, repeats = REPEATS) {
    const least = works.map(() => Infinity);
    for (let k = 0; k <= repeats; k += 1) {
        works.forEach((work, i) => {
            const start = performance.now();
            work();
            // The first warms up.
            if (k > 0) least[i] = Math.min(least[i], performance.now() - start);
        });
    }
    return least;
}

const { simd } = await init({ simd: !process.argv.includes('plain') });
await RAPIER.init();
console.log(`septum ${simd ? 'with' : 'without'} simd128; node ${process.version}`);
const names = Object.keys(CONTENDERS);
for (const [n, m] of [[200, 200], [300, 500]]) {
    const mesh = torus(n, m);
    const asked = questions(mesh);
    const rows = [];
    const row = (what, times, digits) => rows.push({ what, ...Object.fromEntries(names.map((name, i) => [name, times[i].toFixed(digits)])), 'of three-mesh-bvh': (times[0] / times[1]).toFixed(2) });
    const all = names.map((name) => CONTENDERS[name]);
    row('build, ms', race(all.map(({ build, free }) => () => free(build(mesh))), 5), 1);
    const built = all.map(({ build }) => build(mesh));
    const each = (question, list) => race(all.map((one, i) => () => { for (const x of list) one[question](built[i], x); })).map((ms) => 1e3 * ms / list.length);
    row('pick, µs', each('first', asked.picks), 2);
    row('first hit, µs', each('first', asked.rays), 2);
    row('any hit, µs', each('any', asked.rays), 2);
    row('box, µs', each('box', asked.boxes), 2);
    const wrong = (list) => all.map((one, i) => list.filter((x) => !one.any(built[i], x)).length);
    row('missed vertices', wrong(asked.vertices), 0);
    row('missed edges', wrong(asked.edges), 0);
    row('closest point, µs', each('closest', asked.points), 2);
    const distances = all.map((one, i) => asked.points.map((x) => one.closest(built[i], x)));
    const least = asked.points.map((_, k) => Math.min(...distances.map((d) => d[k])));
    row('farther than the closest', distances.map((d) => d.filter((x, k) => !(x <= least[k] + 1e-5)).length), 0);
    row('ball, µs', each('ball', asked.balls), 2);
    console.log(`${mesh.index.length / 3} triangles`);
    console.table(Object.fromEntries(rows.map(({ what, ...rest }) => [what, rest])));
    built.forEach((one, i) => all[i].free(one));
    if (n === 200) {
        const rays = new Float32Array(asked.rays.flat(2));
        const own = new Mesh(mesh.positions, mesh.index);
        const [ms] = race([() => own.raycastMany(rays)]);
        console.log(`first hit, ${QUERIES} in one call: ${(1e3 * ms / QUERIES).toFixed(2)} µs each`);
    }
}
