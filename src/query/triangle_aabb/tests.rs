//! Compares the first look by offsets with 128-bit integers, and with the truncated test.

use fixed::types::I32F32;

use super::PreparedTriangle;
use super::conservative::disjoint_when_cut_down;
use super::error_bound::offset_bound;
use super::offsets::{self, InRows, are_exact, in_rows, size_in_range};
use crate::arithmetic::{Each, Quad, cross3, dot3, minus3, three, turn};
use crate::random::Random;
use crate::scalar::{Backend, Scalar};
use crate::shape::{Aabb, Triangle};

/// Three vertices, centre and half-extents, in units.
type Pair = [[i64; 3]; 5];

/// Shapes of `bits` bits, as far from the origin as permitted, or near it. All coordinates are
/// even, so that a box given by its corners has an integer centre.
fn pair(state: &mut Random, bits: u32, is_far: bool) -> Pair {
    let far = if is_far { (1_i64 << 48) + 2 * (state.bits() % 1_000) as i64 } else { 0 };
    let mut number = || 2 * ((state.bits() >> (65 - bits)) as i64 - (1 << (bits - 2)));
    let [a, b, c, center, half] = [(); 5].map(|()| [(); 3].each(|()| number()));
    let placed = |p: [i64; 3]| p.each(|x| x + far);
    [placed(a), placed(b), placed(c), placed(center), half.each(i64::abs)]
}

/// The triangle, and the box in both forms.
fn shapes<S: Scalar>(pair: Pair, scalar: impl Fn(i64) -> S) -> (Triangle<S>, [Aabb<S>; 2]) {
    let [a, b, c, center, half] = pair;
    let point = |p: [i64; 3]| p.each(&scalar);
    let corner = |sign: i64| point(three(|i| center[i] + sign * half[i]));
    let by_center = Aabb::from_center_half_extents(point(center), point(half)).unwrap();
    let by_corners = Aabb::from_min_max(corner(-1), corner(1)).unwrap();
    (Triangle::new(point(a), point(b), point(c)).unwrap(), [by_center, by_corners])
}

/// The doubled gaps: nine edge axes in the kernel's order, and the plane.
fn truth([a, b, c, center, half]: Pair) -> [i128; 10] {
    let minus = |p: [i64; 3], q: [i64; 3]| three(|i| i128::from(p[i] - q[i]));
    let (v, h) = ([a, b, c].each(|p| minus(p, center)), half.each(i128::from));
    let e = [minus(b, a), minus(c, b), minus(a, c)];
    let n = cross3(&e[0], &e[1]);
    let mut gaps = [2 * (dot3(&n, &v[0]).abs() - dot3(&n.each(i128::abs), &h)); 10];
    for k in 0..3 {
        let p = cross3(&e[k], &v[k]);
        // A row of the kernel has (z, x, y).
        for (to, i) in [2, 0, 1].into_iter().enumerate() {
            let (_, j, l) = turn(i);
            let r = h[j] * e[k][l].abs() + h[l] * e[k][j].abs();
            gaps[3 * k + to] = (2 * p[i] + n[i]).abs() - n[i].abs() - 2 * r;
        }
    }
    gaps
}

/// The kernel's gaps and the true ones, for coordinates in units of `scale`.
fn gaps(pair: Pair, (rows, frame): &InRows, scale: f64) -> impl Iterator<Item = (f64, f64)> {
    let [a, b, c] = rows.edges(frame).each(Quad::three);
    let found = [a, b, c, [rows.plane(frame), 0.0, 0.0]];
    let truth = truth(pair).map(|x| x as f64 / 2.0 * scale * scale);
    (0..10).map(move |k| {
        (f64::from(found[k / 3][k % 3]), if k < 9 { truth[k] } else { truth[k] * scale })
    })
}

/// The shapes in the frame of the box, and by how much all lengths are greater there.
fn in_frame<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> (InRows, f64) {
    (in_rows(triangle, aabb), if aabb.numbers().2 { 1.0 } else { 2.0 })
}

/// The greatest errors on an edge axis and on the plane, relative to their bounds. `scale` is the
/// size of a unit.
fn errors<S: Scalar>(bits: u32, is_far: bool, scale: f64, scalar: fn(i64) -> S) -> [f64; 2] {
    let (state, mut reached) = (&mut Random(u64::from(bits)), [0.0_f64; 2]);
    for _ in 0..4_000 {
        let pair = pair(state, bits, is_far);
        let (triangle, boxes) = shapes(pair, scalar);
        // The bounds assume that no face separates.
        if in_frame(&triangle, &boxes[0]).0.1.apart != 0 {
            continue;
        }
        let prepared = PreparedTriangle::new(&triangle);
        let rows = prepared.rows.unwrap();
        for aabb in &boxes {
            let by_preparing = ((rows, prepared.in_frame(&rows, aabb).unwrap()), 1.0);
            for (found, doubled) in [in_frame(&triangle, aabb), by_preparing] {
                let bound = offset_bound(size_in_range(&found.1).unwrap());
                for (k, (gap, truth)) in gaps(pair, &found, scale * doubled).enumerate() {
                    let bound = f64::from(if k < 9 { bound.edge } else { bound.plane });
                    reached[k / 9] = reached[k / 9].max((gap - truth).abs() / bound);
                }
            }
        }
    }
    reached
}

#[test]
fn no_error_exceeds_its_bound() {
    if !<f64 as Backend>::IN_QUADS {
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
        // Some of the units are too small.
        let unit = 1 << (case % 5);
        let pair = pair(state, 7, false).map(|p| p.each(|x| x / unit * unit));
        let scale = [1.0, 1.0 / 1024.0][case % 2];
        let (triangle, boxes) = shapes(pair, |x| x as f64 * scale);
        for aabb in &boxes {
            let (found, doubled) = in_frame(&triangle, aabb);
            if are_exact(&triangle, aabb) && found.1.size.most() > 0.0 {
                exact += 1;
                assert!(gaps(pair, &found, scale * doubled).all(|(gap, truth)| gap == truth));
            }
        }
    }
    assert!((10_000..70_000).contains(&exact), "{exact}");
}

/// Sizes for which `f32` has no unit, or none in range.
#[test]
fn what_is_out_of_range_is_not_exact() {
    let is_exact = |scale: [f64; 3], last: i64| {
        let at = |p: [i64; 3]| three(|i| p[i] as f64 * scale[i]);
        let triangle = Triangle::new(at([-9, -1, 4]), at([-5, -4, -2]), at([1, -6, last])).unwrap();
        let half = at([3, 9, 6]);
        let found = are_exact(&triangle, &Aabb::from_center_half_extents([0.0; 3], half).unwrap());
        // `f32` agrees, where it holds the shapes.
        let floats = |p: [f64; 3]| p.each(|x| x as f32);
        let [a, b, c] = triangle.points().each(floats);
        if let (Ok(t), Ok(aabb)) =
            (Triangle::new(a, b, c), Aabb::from_center_half_extents([0.0; 3], floats(half)))
        {
            assert_eq!(are_exact(&t, &aabb), found, "{scale:?} {last}");
        }
        found
    };
    assert!(is_exact([1.0; 3], 16) && !is_exact([1.0; 3], 999));
    let power = |e: i32| 2_f64.powi(e);
    for e in [-200, -150, -149, -40, 200] {
        assert!(!is_exact([power(e); 3], 999), "{e}");
    }
    // An axis with infinite offsets, and other axes that reveal a unit.
    for far in 0..3 {
        let mut scale = [1.0; 3];
        scale[far] = power(140);
        assert!(!is_exact(scale, 16), "{far}");
    }
}

/// How often the first look of the conservative test decides, of both forms of the box. Then the
/// truncated test has the same answer.
fn clear_looks(pair: Pair) -> u32 {
    let (triangle, boxes) = shapes(pair, I32F32::from_bits);
    let is_clear = |aabb: &Aabb<I32F32>| {
        let clear = offsets::pair(&triangle, aabb, offsets::coarsely_apart);
        if let Ok(apart) = clear {
            assert_eq!(apart, disjoint_when_cut_down(&triangle, aabb), "{pair:?}");
        }
        u32::from(clear.is_ok())
    };
    boxes.iter().map(is_clear).sum()
}

/// Shapes of any size, with half-extents down to a quarter of the triangle's size, just apart from
/// the triangle along one axis, or not.
fn near_a_face(state: &mut Random, case: usize) -> Pair {
    let bits = 3 + state.bits() % 44;
    let mut number = || (state.bits() & ((1 << bits) - 1)) as i64 - (1 << (bits - 1));
    let [a, b, c, mut p, q] = [(); 5].map(|()| [(); 3].each(|()| number()));
    let q = q.each(|half| half.abs() >> (case % 3));
    let (nudge, axis) = (number() >> (7 + case % 8), case % 3);
    if case % 2 == 0 {
        p[axis] = a[axis].max(b[axis]).max(c[axis]) + q[axis] + nudge;
    } else {
        // From the triangle's centroid, along one axis by all half-extents and a nudge.
        p = three(|i| (a[i] + b[i] + c[i]) / 3);
        p[axis] += q[0] + q[1] + q[2] + nudge;
    }
    [a, b, c, p, q]
}

/// Boxes at a small distance from the plane, or from an edge: 2^-9 to 2^-17 of the size. Vertices
/// at the corners of a cube have the longest normal for their size.
fn near_a_plane_or_an_edge(state: &mut Random, case: usize) -> Option<Pair> {
    let side = 1_i64 << (20 + state.bits() % 26);
    let vertices = [(); 3].each(|()| {
        let signs = state.bits();
        three(|i| (if signs >> i & 1 == 0 { side } else { -side }) - (signs >> 44) as i64)
    });
    let half = [(); 3].each(|()| (state.bits() as i64 & (side - 1)) >> (case % 5 + 2));
    let [[a, b, c], [q, ..]] = [vertices, [half; 3]].each(|x| x.each(|row| row.each(|x| x as f64)));
    let along = [minus3(&b, &a), minus3(&c, &a)];
    let (axis, from) = if case % 2 == 0 {
        (cross3(&along[0], &along[1]), three(|i| (a[i] + b[i] + c[i]) / 3.0))
    } else {
        let unit = three(|i| f64::from(i == case % 3));
        (cross3(&along[0], &unit), three(|i| (a[i] + b[i]) / 2.0))
    };
    // Away from the third vertex.
    let length = dot3(&axis, &axis).sqrt().copysign(-dot3(&axis, &along[1]));
    if length == 0.0 {
        return None;
    }
    let axis = axis.each(|x| x / length);
    let gap = side as f64 / (256 + state.bits() % (1 << (9 + case % 8))) as f64;
    let off = dot3(&axis.each(f64::abs), &q) + gap;
    let [a, b, c] = vertices;
    Some([a, b, c, three(|i| (from[i] + axis[i] * off) as i64), half])
}

#[test]
fn what_is_clear_is_so_when_all_is_cut_down() {
    if !<I32F32 as Backend>::IN_QUADS {
        return;
    }
    let (faces, others) = (&mut Random(1), &mut Random(2));
    let clear: u32 = (0..200_000).map(|case| clear_looks(near_a_face(faces, case))).sum();
    // The first look decides nearly always, but not always.
    assert!((200_000..398_000).contains(&clear), "{clear}");
    let pairs = (0..200_000).filter_map(|case| near_a_plane_or_an_edge(others, case));
    let clear: u32 = pairs.map(clear_looks).sum();
    assert!((40_000..360_000).contains(&clear), "{clear}");
}
