//! Every triangle on a small grid, in every scalar. The check is in this package rather than in the
//! test, so that the crate's part of it is compiled with full optimization.

use crate::Each;
use std::ops::Range;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::prepared::PreparedTriangle;
use septum::{Aabb, Triangle};

use super::case::{BoxNumbers, Case};
use super::oracle::meets;
use super::orders::VERTEX_ORDERS;
use super::sample::Sample;

type Point = [f64; 3];

/// All triples of grid points regardless of order, repetitions included.
fn triples() -> impl Iterator<Item = [Point; 3]> {
    let point = |n: usize| [n / 25, n / 5 % 5, n % 5].each(|x| x as f64 - 2.0);
    (0..125).flat_map(move |a| {
        (a..125).flat_map(move |b| (b..125).map(move |c| [point(a), point(b), point(c)]))
    })
}

/// Checks the crate, in some orders of the vertices.
fn check<S: Sample>(vertices: &[Point; 3], aabb: &Aabb<S>, expected: bool, orders: Range<usize>) {
    let vertices = vertices.each(|v| v.each(S::nearest));
    for order in &VERTEX_ORDERS[orders] {
        let [a, b, c] = order.each(|k| vertices[k]);
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        let is_right = triangle.overlaps(aabb) == expected
            && PreparedTriangle::new(&triangle).overlaps(aabb) == expected
            && triangle.may_overlap(aabb) >= expected;
        assert!(is_right, "{triangle:?}, {aabb:?}");
    }
}

fn in_scalar<S: Sample>(numbers: BoxNumbers<f64>) -> Aabb<S> {
    let to = |v: Point| v.each(S::nearest);
    match numbers {
        BoxNumbers::Center(c, h) => Aabb::from_center_half_extents(to(c), to(h)),
        BoxNumbers::Corners(min, max) => Aabb::from_min_max(to(min), to(max)),
    }
    .expect("a box")
}

/// Checks the box against every triangle on the grid {−2, …, 2}³, degenerate ones included: 333,375
/// triples of vertices in six scalars, in six orders in `f32` and in the other scalars in one of
/// them in turn. The oracle runs once for three vertices. Panics at the first wrong answer; returns
/// the number of triples that meet the box.
pub fn every_triangle_on_the_grid(aabb: BoxNumbers<f64>) -> u32 {
    let single: Aabb<f32> = in_scalar(aabb);
    let double: Aabb<f64> = in_scalar(aabb);
    let i4f4: Aabb<I4F4> = in_scalar(aabb);
    let i8f8: Aabb<I8F8> = in_scalar(aabb);
    let i16f16: Aabb<I16F16> = in_scalar(aabb);
    let i32f32: Aabb<I32F32> = in_scalar(aabb);
    let mut met = 0;
    for (turn, vertices) in triples().enumerate() {
        let expected = meets(&Case { vertices, aabb });
        met += u32::from(expected);
        check(&vertices, &single, expected, 0..6);
        let (order, next) = (turn % 6, turn % 6 + 1);
        check(&vertices, &double, expected, order..next);
        check(&vertices, &i4f4, expected, order..next);
        check(&vertices, &i8f8, expected, order..next);
        check(&vertices, &i16f16, expected, order..next);
        check(&vertices, &i32f32, expected, order..next);
    }
    met
}
