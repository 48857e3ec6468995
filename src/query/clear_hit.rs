//! Ray against triangle where the answer is clear at once: the first rung of the
//! exact query, without a branch, for many at once.

use super::crossing::{Crossing, Setting};
use super::rounded::Found;
use crate::scalar::{Holds, Number, Scalar};
use crate::shape::Ray;

/// What [`Ray::hit`] says of a triangle, bit by bit, and whether that is certain: a
/// hit clear of edges and of the ray's ends, or a clear miss.
///
/// `is_plain`: the ray has the range t ≥ 0. It is for the caller to tell apart, as a
/// constant.
#[inline(always)]
pub(crate) fn clear_hit<S: Scalar, N: Holds<S>>(
    ray: &Ray<S>,
    is_plain: bool,
    [a, b, c]: [[S; 3]; 3],
) -> (bool, Found<S>) {
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let placed = N::place(&[a, b, c, o], &[d]);
    let setting = Setting::new(&placed.points, placed.extents[0]);
    let (crossing, is_known) = setting.crossing_if_known::<N>();
    let is_known = is_known & N::fits(&[a, b, c, o, d]);
    if !is_plain {
        return (is_known & (crossing.meets(false) == Some(false)), Found::none());
    }
    let Crossing { det, t, sides: [_, u, v], slack } = crossing;
    let (certain, hit) = match crossing.strictly_ahead() {
        Some(hit) => (true, hit),
        None => (false, false),
    };
    let (quotients, are_good) = N::quotients([t, u, v], det, [slack.t, slack.side]);
    let found = Found::new(hit & are_good, quotients, det > N::Volume::ZERO, [false; 3]);
    (is_known & certain & (are_good | !hit), found)
}
