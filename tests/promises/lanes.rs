//! Lanes: the same verdicts and the same bits as one by one.

use fixed::types::I16F16;
use septum::lanes::{Aabbs, Cells, Triangles};
use septum::published;
use septum::published::stored_normal::NormalTriangle;
use septum::{Aabb, Cull, Ray, Scalar, Triangle, Vec3};
use septum_kit::{Lanes, Rng, Sample, for_every_scalar};

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

fn same_bits<S: Sample, const N: usize>() {
    let rng = &mut Rng::new(N as u64);
    let (mut hits, mut met) = (0, 0);
    for round in 0..6_000 / N {
        let cull = [Cull::Nothing, Cull::Back, Cull::Front][round % 3];
        // On a grid edges, vertices and flat triangles are common.
        let coordinate = |rng: &mut Rng| match round % 5 {
            0 | 1 => S::nearest(rng.real(-1.5, 1.5)),
            2 => S::nearest(rng.whole(-1, 1) as f64),
            // All products of two are rounded to zero.
            3 => S::from_ordinal(rng.whole(-3, 3)),
            _ => S::from_ordinal(rng.whole(S::LEAST.ordinal(), S::GREATEST.ordinal())),
        };
        let mut point = || rng.triple(coordinate);
        let triangles: [Triangle<S>; N] =
            std::array::from_fn(|_| Triangle::new(point(), point(), point()).unwrap());
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
        let half = boxes[0].min_max().unwrap().1.to_array().map(S::plain_abs);
        let centered = Aabb::from_center_half_extents(point(), half).ok();
        let cells = [(); N].map(|()| Aabb::from_center_half_extents(point(), half));
        if cells.iter().all(Result::is_ok) {
            let cells = cells.map(Result::unwrap);
            let lanes = Cells::new(&cells).unwrap();
            for triangle in &triangles {
                let expected = cells.each_ref().map(|cell| triangle.overlaps(cell));
                assert_eq!(lanes.overlaps(triangle), expected, "{triangle:?} {cells:?}");
                met += expected.iter().filter(|&&met| met).count();
            }
        }
        hits += Lanes { triangles, rays, boxes, centered }.check(cull);
    }
    assert!(hits > 100 && met > 100, "{hits} hits, {met} met");
}

/// The stored normal and the normal on the way are the same numbers.
#[test]
fn volumes_are_the_stored_normal() {
    let rng = &mut Rng::new(9);
    for _ in 0..100_000 {
        let mut point = || rng.triple(|rng| rng.real(-1.0, 1.0) as f32);
        let triangle = Triangle::new(point(), point(), point()).unwrap();
        let ray = Ray::new(point(), point()).unwrap();
        let (cull, stored) = (Cull::Nothing, NormalTriangle::new(&triangle));
        let hit = published::volumes::hit(&ray, &triangle, cull);
        assert_eq!(hit, published::stored_normal::hit(&ray, &stored, cull));
        let t = published::stored_normal::t(&ray, &stored, cull, f32::INFINITY);
        assert_eq!(t, hit.map_or(f32::INFINITY, |hit| hit.t));
    }
}

/// A table in flash, of which the last lanes repeat the last box.
const TABLE: Option<Aabbs<I16F16, 4>> = {
    let low = Vec3::splat(I16F16::ZERO);
    let high = Vec3::splat(I16F16::ONE);
    match Aabb::<I16F16>::const_new(low, high) {
        Ok(aabb) => Aabbs::from_slice(&[aabb; 3]),
        Err(_) => None,
    }
};

#[test]
fn slices_fill_lanes() {
    let cell = |k: usize| Aabb::from_min_max([k as f32; 3], [k as f32 + 1.0; 3]).unwrap();
    let triangle = |k: usize| Triangle::new([k as f32; 3], [0.0; 3], [1.0; 3]).unwrap();
    for n in 0..7 {
        let (cells, triangles) =
            ((0..n).map(cell).collect::<Vec<_>>(), (0..n).map(triangle).collect::<Vec<_>>());
        let boxes = Aabbs::<f32, 5>::from_slice(&cells);
        let lanes = Triangles::<f32, 5>::from_slice(&triangles);
        assert_eq!(
            (boxes.is_some(), lanes.is_some()),
            ((1..=5).contains(&n), (1..=5).contains(&n))
        );
        if let (Some(boxes), Some(lanes)) = (boxes, lanes) {
            for k in 0..5 {
                assert_eq!(boxes.get(k), Some(cell(k.min(n - 1))));
                assert_eq!(lanes.get(k), Some(triangle(k.min(n - 1))));
            }
            assert!(boxes.get(5).is_none() && lanes.get(5).is_none());
        }
    }
    let centred = Aabb::from_center_half_extents([0.0_f32; 3], [1.0; 3]).unwrap();
    assert_eq!(Aabbs::<f32, 4>::from_slice(&[cell(0), centred, cell(1)]), None);
    assert_eq!(TABLE.unwrap().get(3), TABLE.unwrap().get(0));
}

#[test]
fn cells_are_of_one_size() {
    let cell = |k: usize, size: f32| Aabb::from_center_half_extents([k as f32; 3], [size; 3]);
    let (cell, other) = (|k: usize| cell(k, 0.5).unwrap(), cell(1, 0.25).unwrap());
    for n in 0..7 {
        let cells: Vec<_> = (0..n).map(cell).collect();
        let lanes = Cells::<f32, 5>::from_slice(&cells);
        assert_eq!(lanes.is_some(), (1..=5).contains(&n));
        let in_lane = |k: usize| lanes.and_then(|lanes| lanes.get(k));
        if lanes.is_some() {
            (0..5).for_each(|k| assert_eq!(in_lane(k), Some(cell(k.min(n - 1)))));
            assert_eq!(in_lane(5), None);
        }
    }
    let corners = Aabb::from_min_max([0.0; 3], [1.0; 3]).unwrap();
    assert_eq!(Cells::new(&[cell(0), other]), None);
    assert_eq!(Cells::new(&[cell(0), corners]), None);
    assert_eq!(Cells::new(&[corners, cell(0)]), None);
}

/// Generic code asks for no more than a scalar.
#[allow(dead_code)]
fn generic<S: Scalar>(ray: &Ray<S>, triangles: &[Triangles<S, 8>]) -> usize {
    triangles.iter().filter(|t| t.hit_moller_trumbore(ray, Cull::Nothing).any()).count()
}
