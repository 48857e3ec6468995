//! Segments and rays against an axis-aligned box as published: separating axes, in the scalar's own
//! arithmetic.
//!
//! T. Akenine-Möller, E. Haines, N. Hoffman et al., *Real-Time Rendering*, section 16.7. It takes
//! the centre c, the half-vector w and the half-extents h, and tests three face normals and three
//! cross products with the absolute value of w. Against zeros in w, the book adds a small number.
//! The comparisons here are right without it.

use super::{Triple, line, rounded};
use crate::arithmetic::{Number, Rounded, minus3};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Ray, Segment, SegmentForm};

/// Does the segment overlap the box, by the test of *Real-Time Rendering*? In the scalar's own
/// arithmetic, and sometimes wrong.
///
/// *Numerics*: within rounding of contact it errs in both directions. In fixed point, products lose
/// their last bits and wrap around outside the range. A segment given by its ends and a box given
/// by its corners are first converted to their centres, rounded.
///
/// *Panics*: never. *Cost*: up to 12 multiplications, 6 early exits. It is here for comparison;
/// [`Segment::overlaps`] is exact.
///
/// *Source*: *Real-Time Rendering* 16.7, without its epsilon.
#[inline]
pub fn segment_overlaps<S: Scalar>(segment: &Segment<S>, aabb: &Aabb<S>) -> bool {
    let (c, w) = match segment.form() {
        SegmentForm::Center { center, half } => {
            (rounded(center.to_array()), rounded(half.to_array()))
        }
        SegmentForm::Ends(a, b) => between(rounded(a.to_array()), rounded(b.to_array())),
    };
    centered_overlaps(c, w, aabb)
}

/// Does the half-infinite ray overlap the box, by the test of *Real-Time Rendering*? In the
/// scalar's own arithmetic, and sometimes wrong.
///
/// *Geometry*: a range with one end moves the origin there; a range with two ends makes the ray a
/// segment.
///
/// *Numerics*: see [`segment_overlaps`].
///
/// *Panics*: never. *Cost*: up to 12 multiplications, 6 early exits. It is here for comparison;
/// [`Ray::overlaps`] is exact.
///
/// *Source*: *Real-Time Rendering* 16.7, without its epsilon.
#[inline]
pub fn ray_overlaps<S: Scalar>(ray: &Ray<S>, aabb: &Aabb<S>) -> bool {
    let (o, d) = line(ray);
    let at = |t: S| {
        let t = Rounded(t);
        [o[0] + d[0] * t, o[1] + d[1] * t, o[2] + d[2] * t]
    };
    let (start, d) = match (ray.t_min(), ray.t_max()) {
        (Some(from), Some(to)) => {
            let (c, w) = between(at(from), at(to));
            return centered_overlaps(c, w, aabb);
        }
        (Some(from), None) => (Some(at(from)), d),
        (None, Some(to)) => (Some(at(to)), [-d[0], -d[1], -d[2]]),
        (None, None) => (None, d),
    };
    let (center, h) = center_half(aabb);
    let zero = Rounded::ZERO;
    let c = minus3(&start.unwrap_or(o), &center);
    // It starts beside the box and does not come nearer.
    let leaves = |i: usize| (c[i] > h[i] && d[i] >= zero) || (c[i] < -h[i] && d[i] <= zero);
    let leaves = start.is_some() && (leaves(0) || leaves(1) || leaves(2));
    !leaves && !line_misses(c, d, absolute(d), h)
}

#[inline(always)]
fn centered_overlaps<S: Scalar>(c: Triple<S>, w: Triple<S>, aabb: &Aabb<S>) -> bool {
    let (center, h) = center_half(aabb);
    !misses_about_origin(minus3(&c, &center), w, h)
}

/// Whether a segment misses a box around the origin.
#[inline(always)]
pub(super) fn segment_misses<S: Scalar>(a: Triple<S>, b: Triple<S>, h: Triple<S>) -> bool {
    let (c, w) = between(a, b);
    misses_about_origin(c, w, h)
}

#[inline(always)]
fn misses_about_origin<S: Scalar>(c: Triple<S>, w: Triple<S>, h: Triple<S>) -> bool {
    let v = absolute(w);
    let beside = |i: usize| c[i].magnitude() > v[i] + h[i];
    beside(0) || beside(1) || beside(2) || line_misses(c, w, v, h)
}

/// The three cross products.
#[inline(always)]
fn line_misses<S: Scalar>(c: Triple<S>, w: Triple<S>, v: Triple<S>, h: Triple<S>) -> bool {
    let separates =
        |j: usize, k: usize| (c[j] * w[k] - c[k] * w[j]).magnitude() > h[j] * v[k] + h[k] * v[j];
    separates(1, 2) || separates(2, 0) || separates(0, 1)
}

/// Centre and half-vector of a segment.
#[inline(always)]
fn between<S: Scalar>(a: Triple<S>, b: Triple<S>) -> (Triple<S>, Triple<S>) {
    let half = |x: Rounded<S>| Rounded(x.0.plain_half());
    let c = [half(a[0] + b[0]), half(a[1] + b[1]), half(a[2] + b[2])];
    (c, minus3(&b, &c))
}

#[inline(always)]
pub(super) fn center_half<S: Scalar>(aabb: &Aabb<S>) -> (Triple<S>, Triple<S>) {
    match aabb.form() {
        AabbForm::Center { center, half } => (rounded(center.to_array()), rounded(half.to_array())),
        AabbForm::Corners { min, max } => between(rounded(min.to_array()), rounded(max.to_array())),
    }
}

#[inline(always)]
fn absolute<S: Scalar>(v: Triple<S>) -> Triple<S> {
    [v[0].magnitude(), v[1].magnitude(), v[2].magnitude()]
}
