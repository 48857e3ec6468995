//! Compares the computation by offsets with 128-bit integers.

use fixed::types::I32F32;

use super::*;
use crate::query::triangle_aabb::PreparedTriangle;
use crate::random::Random;

/// Three vertices, centre and half-extents, in units.
type Pair = [[i64; 3]; 5];

/// Shapes of `bits` bits, as far from the origin as permitted, or near it. All coordinates are
/// even, so that a box given by its corners has an integer centre.
fn pair(state: &mut Random, bits: u32, is_far: bool) -> Pair {
    let far = if is_far { (1_i64 << 48) + 2 * (state.bits() % 1_000) as i64 } else { 0 };
    let mut number = || 2 * ((state.bits() >> (65 - bits)) as i64 - (1 << (bits - 2)));
    let [a, b, c, center, half] = [(); 5].map(|()| [(); 3].map(|()| number()));
    let placed = |p: [i64; 3]| p.map(|x| x + far);
    [placed(a), placed(b), placed(c), placed(center), half.map(i64::abs)]
}

/// The doubled gaps: nine edge axes in the kernel's order, and the plane.
fn truth([a, b, c, center, half]: Pair) -> ([[i128; 3]; 3], i128) {
    let minus = |p: [i64; 3], q: [i64; 3]| [0, 1, 2].map(|i| i128::from(p[i] - q[i]));
    let (v, h) = ([a, b, c].map(|p| minus(p, center)), half.map(i128::from));
    let e = [minus(b, a), minus(c, b), minus(a, c)];
    let cross = |p: [i128; 3], q: [i128; 3]| {
        [0, 1, 2].map(|i| p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3])
    };
    let dot = |p: [i128; 3], q: [i128; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let n = cross(e[0], e[1]);
    let edges = [0, 1, 2].map(|k| {
        let p = cross(e[k], v[k]);
        // A row of the kernel has (z, x, y).
        [2, 0, 1].map(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            let r = h[j] * e[k][l].abs() + h[l] * e[k][j].abs();
            (2 * p[i] + n[i]).abs() - n[i].abs() - 2 * r
        })
    });
    (edges, 2 * (dot(n, v[0]).abs() - dot(n.map(i128::abs), h)))
}

/// The kernel's result, doubled and in units: rows, frame, and the factor by which all lengths are
/// greater.
fn check(pair: Pair, (rows, frame): &InRows, scale: f64, reached: &mut [f64; 2]) {
    let bound = offset_bound(size_in_range(frame).unwrap());
    let (edges, plane) = truth(pair);
    let found = rows.edges(frame).map(Quad::three);
    for (found, truth) in found.as_flattened().iter().zip(edges.as_flattened()) {
        let error = f64::from(*found) - *truth as f64 / 2.0 * scale * scale;
        reached[0] = reached[0].max(error.abs() / f64::from(bound.edge));
    }
    let error = f64::from(rows.plane(frame)) - plane as f64 / 2.0 * scale * scale * scale;
    reached[1] = reached[1].max(error.abs() / f64::from(bound.plane));
}

fn shapes<S: Scalar>(pair: Pair, scalar: impl Fn(i64) -> S) -> (Triangle<S>, [Aabb<S>; 2]) {
    let [a, b, c, center, half] = pair;
    let point = |p: [i64; 3]| p.map(&scalar);
    let corner = |sign: i64| point([0, 1, 2].map(|i| center[i] + sign * half[i]));
    let by_center = Aabb::from_center_half_extents(point(center), point(half)).unwrap();
    let by_corners = Aabb::from_min_max(corner(-1), corner(1)).unwrap();
    (Triangle::new(point(a), point(b), point(c)).unwrap(), [by_center, by_corners])
}

/// The greatest errors on an edge axis and on the plane, relative to their bounds. `scale` is the
/// size of a unit.
fn errors<S: Scalar>(bits: u32, is_far: bool, scale: f64, scalar: fn(i64) -> S) -> [f64; 2] {
    let (state, mut reached) = (&mut Random(u64::from(bits)), [0.0; 2]);
    for _ in 0..4_000 {
        let pair = pair(state, bits, is_far);
        let (triangle, [by_center, by_corners]) = shapes(pair, scalar);
        let (AabbForm::Center { center, half }, AabbForm::Corners { min, max }) =
            (by_center.form(), by_corners.form())
        else {
            unreachable!()
        };
        let of_center = of_center(&triangle, center.to_array(), half.to_array());
        let of_corners = of_corners(&triangle, min.to_array(), max.to_array());
        // The bounds assume that no face separates.
        if of_center.1.apart != 0 {
            continue;
        }
        check(pair, &of_center, scale, &mut reached);
        check(pair, &of_corners, 2.0 * scale, &mut reached);
        let prepared = PreparedTriangle::new(&triangle);
        let rows = prepared.rows.unwrap();
        for aabb in [by_center, by_corners] {
            let frame = prepared.in_frame(&rows, &aabb).unwrap();
            check(pair, &(rows, frame), scale, &mut reached);
        }
    }
    reached
}

#[test]
fn no_error_exceeds_its_bound() {
    if !<f64 as crate::scalar::Backend>::IN_QUADS {
        return;
    }
    for bits in [4, 8, 12, 20, 25, 30, 40] {
        for is_far in [false, true] {
            let in_doubles = errors(bits, is_far, 1.0 / 16_777_216.0, |x| x as f64 / 16_777_216.0);
            let in_fixed_point = errors(bits, is_far, 1.0 / 16_777_216.0, I32F32::from_bits);
            // `f32` cannot hold longer or more distant coordinates.
            let is_short = bits <= 25 && !is_far;
            let in_floats = is_short.then(|| errors(bits, false, 1.0, |x| x as f32));
            for [edge, plane] in [in_doubles, in_fixed_point].into_iter().chain(in_floats) {
                assert!(edge <= 1.0 && plane <= 1.0, "{bits} {is_far} {edge} {plane}");
                // The worst cases of all roundings never coincide, but something was rounded.
                assert!(bits < 20 || edge > 0.02 && plane > 0.005, "{bits} {edge} {plane}");
            }
        }
    }
}

/// On a grid that is coarse enough, nothing is rounded.
#[test]
fn what_is_exact_is_exact() {
    let (state, mut exact) = (&mut Random(1), 0);
    for case in 0..40_000 {
        let mut pair = pair(state, 7, false);
        // Some of the units are too small.
        let unit = 1 << (case % 5);
        pair.as_flattened_mut().iter_mut().for_each(|x| *x = *x / unit * unit);
        let scale = [1.0, 1.0 / 1024.0][case % 2];
        let (triangle, boxes) = shapes(pair, |x| x as f64 * scale);
        let found = boxes.map(|aabb| are_exact(&triangle, &aabb));
        for (found, aabb) in found.iter().zip(&boxes) {
            let (rows, frame, scale) = match aabb.form() {
                AabbForm::Center { center, half } => {
                    let (rows, frame) = of_center(&triangle, center.to_array(), half.to_array());
                    (rows, frame, scale)
                }
                AabbForm::Corners { min, max } => {
                    let (rows, frame) = of_corners(&triangle, min.to_array(), max.to_array());
                    (rows, frame, 2.0 * scale)
                }
            };
            if *found && largest(frame.size) > 0.0 {
                exact += 1;
                let (edges, plane) = truth(pair);
                let found = rows.edges(&frame).map(Quad::three);
                for (found, truth) in found.as_flattened().iter().zip(edges.as_flattened()) {
                    assert!(f64::from(*found) == *truth as f64 / 2.0 * scale * scale);
                }
                let plane = plane as f64 / 2.0 * scale * scale * scale;
                assert!(f64::from(rows.plane(&frame)) == plane);
            }
        }
    }
    assert!((10_000..70_000).contains(&exact), "{exact}");
}

/// Sizes for which `f32` has no unit, or none in range.
#[test]
fn what_is_out_of_range_is_not_exact() {
    let shapes = |scale: [f64; 3], last: i64| {
        let at = |p: [i64; 3]| [0, 1, 2].map(|i| p[i] as f64 * scale[i]);
        let triangle = Triangle::new(at([-9, -1, 4]), at([-5, -4, -2]), at([1, -6, last])).unwrap();
        let aabb = Aabb::from_center_half_extents([0.0; 3], at([3, 9, 6])).unwrap();
        (triangle, aabb)
    };
    let is_exact = |scale, last| {
        let (triangle, aabb) = shapes(scale, last);
        are_exact(&triangle, &aabb)
    };
    assert!(is_exact([1.0; 3], 16) && !is_exact([1.0; 3], 999));
    let power = |e: i32| 2_f64.powi(e);
    for e in [-200, -150, -40, 200] {
        assert!(!is_exact([power(e); 3], 999), "{e}");
    }
    // An axis with infinite offsets, and other axes that reveal a unit.
    for far in 0..3 {
        let mut scale = [1.0; 3];
        scale[far] = power(140);
        assert!(!is_exact(scale, 16), "{far}");
    }
    let (triangle, aabb) = shapes([power(-149); 3], 999);
    let floats = |p: [f64; 3]| p.map(|x| x as f32);
    let [a, b, c] = triangle.points().map(floats);
    let AabbForm::Center { center, half } = aabb.form() else { unreachable!() };
    let aabb =
        Aabb::from_center_half_extents(floats(center.to_array()), floats(half.to_array())).unwrap();
    assert!(!are_exact(&Triangle::new(a, b, c).unwrap(), &aabb));
}
