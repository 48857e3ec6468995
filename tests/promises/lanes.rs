//! Lanes: the same verdicts and the same bits as single shapes.

use fixed::types::{I16F16, I32F32};
use septum::lanes::{Aabbs, CellTriangle, Cells, Triangles};
use septum::published;
use septum::published::stored_normal::NormalTriangle;
use septum::{Aabb, Cull, Ray, Scalar, Triangle, Vec3};
use septum_kit::{Each, Lanes, Rng, Sample, for_every_scalar, for_scalars, three};

// Each scalar, and each number of lanes. Scalars of 64 bits look at four triangles at a time first.
for_every_scalar!(same_bits_four);
for_scalars!([f32: f32] same_bits_one_lane, same_bits_sixteen);
for_scalars!([f32: f32, f64: f64, i32f32: fixed::types::I32F32] same_bits_three, same_bits_eight);
for_scalars!([f64: f64] same_bits_five);

fn same_bits_one_lane<S: Sample>() {
    same_bits::<S, 1>();
}
fn same_bits_three<S: Sample>() {
    same_bits::<S, 3>();
}
fn same_bits_four<S: Sample>() {
    same_bits::<S, 4>();
}
fn same_bits_five<S: Sample>() {
    same_bits::<S, 5>();
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
        // Grids make edges, vertices and flat triangles common.
        let coordinate = |rng: &mut Rng| match round % 6 {
            0 | 1 => S::nearest(rng.real(-1.5, 1.5)),
            2 => S::nearest(rng.whole(-1, 1) as f64),
            // All products of two are rounded to zero.
            3 => S::from_ordinal(rng.whole(-3, 3)),
            // Close together, far from zero.
            4 => S::from_ordinal(S::GREATEST.ordinal() / 2 + rng.whole(-3, 3)),
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
            let ends = |pick: fn(S, S) -> S| three(|i| pick(p[i], q[i]));
            let min = ends(|a, b| if a < b { a } else { b });
            Aabb::from_min_max(min, ends(|a, b| if a > b { a } else { b })).unwrap()
        });
        let (min, max) = boxes[0].min_max().unwrap();
        let (min, max) = (min.to_array(), max.to_array());
        let half = three(|i| {
            let size = max[i].minus(min[i]);
            if size < S::ZERO { S::ZERO.minus(size) } else { size }
        });
        let centered = Aabb::from_center_half_extents(point(), half).ok();
        let cells = [(); N].map(|()| Aabb::from_center_half_extents(point(), half));
        if cells.iter().all(Result::is_ok) {
            let cells = cells.map(Result::unwrap);
            let lanes = Cells::new(&cells).unwrap();
            for triangle in &triangles {
                // Compiled once, not for each lane.
                let mut expected = [false; N];
                for (cell, met) in cells.iter().zip(&mut expected) {
                    *met = triangle.overlaps(cell);
                }
                assert_eq!(lanes.overlaps(triangle), expected, "{triangle:?} {cells:?}");
                met += expected.iter().filter(|&&met| met).count();
            }
        }
        hits += Lanes { triangles, rays, boxes, centered }.check(cull);
    }
    assert!(hits > 100 && met > 100, "{hits} hits, {met} met");
}

/// Compares lanes with single shapes: boxes of one size, by their centres and by their corners,
/// against a triangle, and one of the boxes against that triangle in all lanes. Returns the number
/// of overlaps.
fn met_at_once<S: Sample>(triangle: &Triangle<S>, centers: [[S; 3]; 8], half: [S; 3]) -> usize {
    let cells = centers.map(|c| Aabb::from_center_half_extents(c, half).unwrap());
    let expected = cells.each_ref().map(|cell| triangle.overlaps(cell));
    assert_eq!(Cells::new(&cells).unwrap().overlaps(triangle), expected, "{triangle:?} {cells:?}");
    let lanes = Triangles::new(&[*triangle; 2]);
    for (cell, met) in cells.iter().zip(expected) {
        assert_eq!(lanes.overlaps(cell), [met; 2], "{triangle:?} {cell:?}");
    }
    let corner = |c: [S; 3], sum: fn(S, S) -> S| three(|i| sum(c[i], half[i]));
    let between = |c: [S; 3]| Aabb::from_min_max(corner(c, S::minus), corner(c, S::plus)).unwrap();
    let boxes = centers.map(between);
    let met = boxes.each_ref().map(|aabb| triangle.overlaps(aabb));
    assert_eq!(Aabbs::new(&boxes).unwrap().overlaps(triangle), met, "{triangle:?} {boxes:?}");
    for (aabb, met) in boxes.iter().zip(met) {
        assert_eq!(lanes.overlaps(aabb), [met; 2], "{triangle:?} {aabb:?}");
    }
    expected.iter().filter(|&&met| met).count()
}

/// Far from the origin the sum of a vertex and a half-extent is not a float: faces that seem to
/// touch may be disjoint.
#[test]
fn cells_far_from_the_origin() {
    let rng = &mut Rng::new(11);
    let mut met = 0;
    for _ in 0..40_000 {
        let mut point = || rng.triple(|rng| 4_096.0 + rng.whole(-3, 3) as f32 / 2_048.0);
        let triangle = Triangle::new(point(), point(), point()).unwrap();
        let centers = [(); 8].map(|()| point());
        // In eighths of the last place of the coordinates.
        let half = rng.triple(|rng| rng.whole(0, 24) as f32 / 16_384.0);
        met += met_at_once(&triangle, centers, half);
    }
    assert!((30_000..160_000).contains(&met), "{met} of 320,000");
}

/// If differences of coordinates are rounded, a computed gap of zero may be a true gap: a vertex
/// near the middle of a face.
#[test]
fn differences_that_round() {
    let rng = &mut Rng::new(12);
    let mut met = 0;
    for round in 0..40_000 {
        let turn = |p: [f32; 3]| three(|i| p[(i + round) % 3]);
        let mut near = |at: f32, ulp: i64| at + rng.whole(-3, 3) as f32 / (1_i64 << ulp) as f32;
        let vertex = turn([near(1.0, 23), 0.25, 0.25]);
        let triangle = Triangle::new(vertex, turn([3.0, 2.0, 0.5]), turn([2.5, 0.5, 2.0])).unwrap();
        let half = turn([near(1.0, 23), 1.0, 1.0]);
        let centers = [(); 8].map(|()| turn([near(0.0, 26), 0.0, 0.0]));
        met += met_at_once(&triangle, centers, half);
    }
    assert!((30_000..290_000).contains(&met), "{met} of 320,000");
}

/// Coordinates too long for the floats of the all-at-once stage.
#[test]
fn coordinates_that_round() {
    let rng = &mut Rng::new(13);
    let mut met = 0;
    for round in 0..40_000 {
        let mut point = |from: i64, to: i64| {
            rng.triple(|rng| I16F16::from_bits((1 << 24) + rng.whole(from, to) as i32))
        };
        let end = if round % 2 == 0 { -1 } else { 4 };
        let triangle = Triangle::new(point(-6, end), point(-6, end), point(-6, end)).unwrap();
        let centers = [(); 8].map(|()| point(-2, 4));
        let half = rng.triple(|rng| I16F16::from_bits(rng.whole(0, 3) as i32));
        met += met_at_once(&triangle, centers, half);
    }
    assert!((30_000..290_000).contains(&met), "{met} of 320,000");
}

/// Boxes that touch a triangle's plane at a corner, or an edge with an edge, or miss it by little,
/// which rounded products get wrong.
#[test]
fn planes_and_edges_graze() {
    let mut met = [0; 3];
    for round in 0..20_000 {
        met[0] += met_by_grazing::<f32>(round, 40_000);
        met[1] += met_by_grazing::<f64>(round, 500_000_000);
        met[2] += met_by_grazing::<I16F16>(round, 2_000);
    }
    assert!(met.iter().all(|met| (20_000..280_000).contains(met)), "{met:?} of 320,000");
}

fn met_by_grazing<S: Sample>(round: u64, span: i64) -> usize {
    let rng = &mut Rng::new(round);
    let [a, b, c] = [(); 3].each(|()| rng.triple(|rng| 4 * rng.whole(-span / 4, span / 4)));
    let half = rng.triple(|rng| rng.whole(1, span / 8));
    let from_a = |p: [i64; 3]| three(|i| p[i] - a[i]);
    let (e, f) = (from_a(b), from_a(c));
    let around = |i: usize| ((i + 1) % 3, (i + 2) % 3);
    // The corner of the box nearest to the plane is a point of the triangle.
    let on_plane = three(|i| {
        let (j, l) = around(i);
        (a[i] + b[i] + 2 * c[i]) / 4 + (e[j] * f[l] - e[l] * f[j]).signum() * half[i]
    });
    // The edge of the box nearest to the middle of the triangle's edge passes through it.
    let i = round as usize % 3;
    let (j, l) = around(i);
    let side = (e[j] * f[l] - e[l] * f[j]).signum();
    let mut on_edge = three(|i| (a[i] + b[i]) / 2);
    on_edge[j] += side * e[l].signum() * half[j];
    on_edge[l] -= side * e[j].signum() * half[l];

    let number = |p: [i64; 3]| p.each(|x| S::nearest(x as f64));
    let triangle = Triangle::new(number(a), number(b), number(c)).unwrap();
    let near = |p: [i64; 3], axis: usize| {
        [-4, -3, -2, -1, 0, 1, 2, 3].map(|beside| {
            let mut center = p;
            center[axis] += beside;
            number(center)
        })
    };
    met_at_once(&triangle, near(on_plane, i), number(half))
        + met_at_once(&triangle, near(on_edge, j), number(half))
}

/// Seven triangles are missed and one is hit; at 2^60 lanes cannot hold the coordinates.
#[test]
fn one_of_eight_triangles() {
    one_of_eight_triangles_at(1 << 40);
    one_of_eight_triangles_at(1 << 60);
}

fn one_of_eight_triangles_at(x: i64) {
    let at = |p: [i64; 3]| p.each(I32F32::from_bits);
    let triangle = |y: i64| {
        let [a, b, c] = [[x - 1024, y, 0], [x + 120, y, 0], [x - 1024, y + 2000, 0]].each(at);
        Triangle::new(a, b, c).unwrap()
    };
    let ray = Ray::new(at([x, 30, -1000]), at([0, 0, 1 << 32])).unwrap();
    for k in 0..8 {
        let triangles: [_; 8] = std::array::from_fn(|i| triangle(if i == k { 0 } else { 90_000 }));
        let hits = Triangles::new(&triangles).hit(&ray);
        for (i, triangle) in triangles.iter().enumerate() {
            assert_eq!(hits.get(i), ray.hit(triangle), "{k} {i}");
            assert_eq!(hits.get(i).is_some(), i == k);
        }
    }
}

/// Prepared for one size, queried with another.
#[test]
fn cells_of_another_size() {
    let cells = |size: f32| {
        let cell = |k: f32| Aabb::from_center_half_extents([k, 0.0, 0.0], [size; 3]).unwrap();
        Cells::new(&[cell(0.0), cell(1.0), cell(2.0), cell(3.0)]).unwrap()
    };
    let triangle = Triangle::new([1.5, -1.0, 0.0], [1.5, 1.0, 0.0], [1.5, 0.0, 1.0]).unwrap();
    for prepared in [0.25, 0.5, 1.5].each(|size| CellTriangle::new(&triangle, &cells(size))) {
        assert_eq!(prepared.overlaps(&cells(0.25)), [false; 4]);
        assert_eq!(prepared.overlaps(&cells(0.5)), [false, true, true, false]);
        assert_eq!(prepared.overlaps(&cells(1.5)), [true; 4]);
        assert_eq!(prepared.triangle(), &triangle);
    }
}

/// The stored normal and the normal computed on the fly have the same bits.
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

/// A table in flash whose last lanes repeat the last box.
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

/// Generic code needs only `Scalar`.
#[allow(dead_code)]
fn generic<S: Scalar>(ray: &Ray<S>, triangles: &[Triangles<S, 8>]) -> usize {
    triangles.iter().filter(|t| t.hit_moller_trumbore(ray, Cull::Nothing).any()).count()
}
