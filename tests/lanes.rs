//! Lanes: the same verdicts and the same bits as one by one.

mod support;

use septum::{
    Aabb, Aabbs, Cull, Hit, Hits, NormalTriangle, NormalTriangles, Ranges, Ray, Rays, Scalar,
    SlabRay, SlabRays, Triangle, Triangles,
};
use support::{Rng, Sample, for_every_scalar};

for_every_scalar!(
    same_bits_one_lane,
    same_bits_three,
    same_bits_four,
    same_bits_eight,
    same_bits_sixteen
);

fn same_bits_one_lane<S: Sample>() {
    same_bits::<S, 1>();
}
fn same_bits_three<S: Sample>() {
    same_bits::<S, 3>();
}
fn same_bits_four<S: Sample>() {
    same_bits::<S, 4>();
}
fn same_bits_eight<S: Sample>() {
    same_bits::<S, 8>();
}
fn same_bits_sixteen<S: Sample>() {
    same_bits::<S, 16>();
}

/// The signs of noughts are bits too: written out they differ.
fn check<S: Sample, const N: usize>(
    method: &str,
    hits: &Hits<S, N>,
    one: impl Fn(usize) -> Option<Hit<S>>,
) {
    for k in 0..N {
        let one = one(k);
        assert_eq!(hits.get(k), one, "{method}, lane {k}");
        assert_eq!(hits.mask[k], one.is_some(), "{method}, lane {k}");
        let lanes = (hits.t[k], hits.u[k], hits.v[k]);
        let scalar = one.map_or((S::ZERO, S::ZERO, S::ZERO), |hit| (hit.t, hit.u, hit.v));
        if lanes.0 == S::ZERO || lanes.1 == S::ZERO || lanes.2 == S::ZERO {
            assert_eq!(format!("{lanes:?}"), format!("{scalar:?}"), "{method}, lane {k}");
        }
    }
    assert_eq!(hits.any(), (0..N).any(|k| one(k).is_some()), "{method}");
    assert_eq!(hits.get(N), None);
    let nearest = (0..N)
        .filter_map(|k| Some((k, one(k)?)))
        .reduce(|best, next| if next.1.t < best.1.t { next } else { best });
    assert_eq!(hits.nearest(), nearest, "{method}");
}

fn check_ranges<S: Sample, const N: usize>(
    method: &str,
    ranges: &Ranges<S, N>,
    one: impl Fn(usize) -> Option<(S, S)>,
) {
    for k in 0..N {
        let one = one(k);
        assert_eq!(ranges.mask[k], one.is_some(), "{method}, lane {k}");
        assert_eq!(format!("{:?}", ranges.get(k)), format!("{one:?}"), "{method}, lane {k}");
    }
    assert_eq!(ranges.get(N), None);
}

fn same_bits<S: Sample, const N: usize>() {
    let rng = &mut Rng::new(N as u64);
    let mut hits = 0;
    for round in 0..6_000 / N {
        let cull = [Cull::Nothing, Cull::Back, Cull::Front][round % 3];
        // On a grid edges, vertices and flat triangles are common.
        let coordinate = |rng: &mut Rng| match round % 5 {
            0 | 1 => S::nearest(rng.real(-1.5, 1.5)),
            2 => S::nearest(rng.whole(-1, 1) as f64),
            // All products of two are rounded to nought.
            3 => S::from_ordinal(rng.whole(-3, 3)),
            _ => S::from_ordinal(rng.whole(S::LEAST.ordinal(), S::GREATEST.ordinal())),
        };
        let mut point = || rng.triple(coordinate);
        let triangles: [Triangle<S>; N] =
            std::array::from_fn(|_| Triangle::new(point(), point(), point()).unwrap());
        let normals: [NormalTriangle<S>; N] = triangles.map(|t| t.with_normal());
        let rays: [Ray<S>; N] = std::array::from_fn(|k| {
            let mut ray = Ray::new(point(), point());
            while ray.is_err() {
                ray = Ray::new(point(), point());
            }
            let (low, high) = (S::nearest(-0.5), S::nearest(0.75));
            match (round + k) % 7 {
                0 => ray.unwrap().with_range(None, None),
                1 => ray.unwrap().with_range(low, high),
                2 => ray.unwrap().with_range(None, high),
                _ => ray,
            }
            .unwrap()
        });

        let boxes: [Aabb<S>; N] = std::array::from_fn(|_| {
            let (p, q) = (point(), point());
            let ends = |pick: fn(S, S) -> S| [0, 1, 2].map(|i| pick(p[i], q[i]));
            let min = ends(|a, b| if a < b { a } else { b });
            Aabb::from_min_max(min, ends(|a, b| if a > b { a } else { b })).unwrap()
        });
        let (slabs, many_boxes) = (rays[0].for_slabs(), Aabbs::new(&boxes).unwrap());
        let ranges = slabs.t_range_each_rounded(&many_boxes);
        check_ranges("boxes", &ranges, |k| slabs.t_range_rounded(&boxes[k]));
        for k in 0..N {
            assert_eq!(many_boxes.get(k), Some(boxes[k]));
            assert_eq!(ranges.mask[k], slabs.overlaps_rounded(&boxes[k]));
        }
        // Directions without a nought too, lest one lane send all the slow way.
        let steep = |k: usize| {
            let plain = round % 2 == 0 && rays[k].direction().to_array().contains(&S::ZERO);
            let one = S::nearest(1.0);
            let ray = if plain { Ray::new(rays[k].origin(), [one; 3]).unwrap() } else { rays[k] };
            ray.for_slabs()
        };
        let slab_rays: [SlabRay<S>; N] = std::array::from_fn(steep);
        let half = boxes[0].min_max().unwrap().1.to_array().map(S::plain_abs);
        let centered = Aabb::from_center_half_extents(point(), half).ok();
        for aabb in [Some(boxes[0]), centered].into_iter().flatten() {
            let ranges = SlabRays::new(&slab_rays).t_range_rounded(&aabb);
            check_ranges("rays, slabs", &ranges, |k| slab_rays[k].t_range_rounded(&aabb));
        }

        let (many, many_normals) = (Triangles::new(&triangles), NormalTriangles::new(&normals));
        let many_rays = Rays::new(&rays);
        for k in 0..N {
            assert_eq!(many.get(k), Some(triangles[k]));
            // Written out: an overflow may have left a NaN in a normal.
            let (laned, normal) = (many_normals.get(k), Some(normals[k]));
            assert!(laned == normal || format!("{laned:?}") == format!("{normal:?}"));
            assert_eq!(many_rays.get(k), Some(rays[k]));
        }
        let (ray, triangle, normal) = (rays[0], triangles[0], normals[0]);
        let found = ray.hit_each_moller_trumbore(&many, cull);
        check("triangles, moller_trumbore", &found, |k| {
            ray.hit_moller_trumbore(&triangles[k], cull)
        });
        hits += found.mask.iter().filter(|&&hit| hit).count();
        check("triangles, stored_normal", &ray.hit_each_stored_normal(&many_normals, cull), |k| {
            ray.hit_stored_normal(&normals[k], cull)
        });
        check("triangles, volumes", &ray.hit_each_volumes(&many, cull), |k| {
            ray.hit_volumes(&triangles[k], cull)
        });
        check("triangles, sheared", &ray.sheared().hit_each(&many, cull), |k| {
            ray.sheared().hit(&triangles[k], cull)
        });
        check("rays, moller_trumbore", &many_rays.hit_moller_trumbore(&triangle, cull), |k| {
            rays[k].hit_moller_trumbore(&triangle, cull)
        });
        check("rays, stored_normal", &many_rays.hit_stored_normal(&normal, cull), |k| {
            rays[k].hit_stored_normal(&normal, cull)
        });
        check("rays, volumes", &many_rays.hit_volumes(&triangle, cull), |k| {
            rays[k].hit_volumes(&triangle, cull)
        });
        check("triangles, exact", &ray.hit_each(&many), |k| ray.hit(&triangles[k]));
    }
    assert!(hits > 100, "{hits} hits");
}

/// The stored normal and the normal on the way are the same numbers.
#[test]
fn volumes_are_the_stored_normal() {
    let rng = &mut Rng::new(9);
    for _ in 0..100_000 {
        let mut point = || rng.triple(|rng| rng.real(-1.0, 1.0) as f32);
        let triangle = Triangle::new(point(), point(), point()).unwrap();
        let ray = Ray::new(point(), point()).unwrap();
        let (cull, stored) = (Cull::Nothing, triangle.with_normal());
        let hit = ray.hit_volumes(&triangle, cull);
        assert_eq!(hit, ray.hit_stored_normal(&stored, cull));
        let t = ray.t_stored_normal(&stored, cull, f32::INFINITY);
        assert_eq!(t, hit.map_or(f32::INFINITY, |hit| hit.t));
    }
}

/// Generic code asks for no more than a scalar.
#[allow(dead_code)]
fn generic<S: Scalar>(ray: &Ray<S>, triangles: &[Triangles<S, 8>]) -> usize {
    triangles.iter().filter(|t| ray.hit_each_moller_trumbore(t, Cull::Nothing).any()).count()
}
