//! The closest point of a triangle in `f64`, for hosts.
//!
//! The same signs as in [`feature`](super::foot::feature), without loops: each part has an answer of
//! its own, from numbers in registers, and the first that is certain is the answer. Numbers for the
//! parts after it would take longer than a branch.

use super::foot::{Around, on_edge, on_face, side};
use super::kernel::product;
use crate::arithmetic::{Embeds, Filtered, dot, least};
use crate::query::Feature;
use crate::scalar::Scalar;

type N = Filtered<f64>;

/// The part of a triangle closest to a point, and the closest point; `None` in doubt.
#[inline(always)]
pub(super) fn in_double<S: Scalar>(
    vertices: &[[S; 3]; 3],
    point: [S; 3],
) -> Option<(Feature, [S; 3])>
where
    N: Embeds<S>,
{
    let [a, b, c, p] = N::embed(&[vertices[0], vertices[1], vertices[2], point])?;
    let around = Around::<N>::new(&p, &[a, b, c])?;
    let Around { d, e, errors, side: error } = &around;
    // One branch for both.
    let is_past = |end: f64, start: f64| least(end, -start) > errors.dot;
    let vertex = |k: usize| Some((Feature::Vertex(k as u8), vertices[k]));
    let (end2, start0) = (product::<N>(&d[0], &e[2]), product::<N>(&d[0], &e[0]));
    if is_past(end2, start0) {
        return vertex(0);
    }
    let (end0, start1) = (product::<N>(&d[1], &e[0]), product::<N>(&d[1], &e[1]));
    if is_past(end0, start1) {
        return vertex(1);
    }
    let (end1, start2) = (product::<N>(&d[2], &e[1]), product::<N>(&d[2], &e[2]));
    if is_past(end1, start2) {
        return vertex(2);
    }
    let is_beside =
        |side: f64, start: f64, end: f64| (side < -*error) & (least(start, -end) > errors.dot);
    let side0 = side::<N>([start0, end0], start1, end2);
    if is_beside(side0, start0, end0) {
        return Some((Feature::Edge(0), on_edge::<S, N>([&a, &d[0], &e[0]], 1.0, errors)?));
    }
    let side1 = side::<N>([start1, end1], start2, end0);
    if is_beside(side1, start1, end1) {
        return Some((Feature::Edge(1), on_edge::<S, N>([&b, &d[1], &e[1]], 1.0, errors)?));
    }
    let side2 = side::<N>([start2, end2], start0, end1);
    if is_beside(side2, start2, end2) {
        return Some((Feature::Edge(2), on_edge::<S, N>([&c, &d[2], &e[2]], 1.0, errors)?));
    }
    let is_inside = least(least(side0, side1), side2) > *error;
    let n = around.normal();
    let foot = || on_face::<S, N>(&p, &n, dot::<N>(&n, &d[0]), 1.0, errors);
    if is_inside { Some((Feature::Interior, foot()?)) } else { None }
}
