//! Segments and rays against an axis-aligned box as published: separating axes, in
//! the scalar's own arithmetic.
//!
//! T. Akenine-Möller, E. Haines, N. Hoffman et al., *Real-Time Rendering*, section
//! 16.7: centre c, half-vector w and half-extents h, three face normals and three
//! cross products, the absolute value of w taken once. The book adds a small number to
//! it against noughts in w; the comparisons here are right without, and there is no
//! such number.

use crate::scalar::{Number, Numbers, Rounded, Scalar};
use crate::shape::{Aabb, AabbForm, Ray, Segment, SegmentForm};

/// A vector.
type Row<S> = [Rounded<S>; 3];

impl<S: Scalar> Segment<S> {
    /// The overlap test of *Real-Time Rendering*, in the scalar's own arithmetic:
    /// sometimes wrong.
    ///
    /// *Numerics*: within rounding of contact it errs either way. In fixed point
    /// products lose their last bits and wrap beyond the range. A segment given by its
    /// ends and a box given by its corners are first brought to their centres, rounded.
    ///
    /// *Panics*: never. *Cost*: up to 12 multiplications, 6 early exits. Here for
    /// comparison; [`overlaps`](Self::overlaps) is exact.
    ///
    /// *Source*: *Real-Time Rendering* 16.7, without its epsilon.
    #[inline]
    pub fn overlaps_as_published(&self, aabb: &Aabb<S>) -> bool {
        let (c, w) = match self.form() {
            SegmentForm::Center { center, half } => (row(center), row(half)),
            SegmentForm::Ends(a, b) => between(row(a), row(b)),
        };
        segment_overlaps(c, w, aabb)
    }
}

impl<S: Scalar> Ray<S> {
    /// The overlap test of *Real-Time Rendering* for a half-infinite ray, in the
    /// scalar's own arithmetic: sometimes wrong.
    ///
    /// *Geometry*: a range with one end moves the origin there; one with two makes the
    /// ray a segment.
    ///
    /// *Numerics*: see [`Segment::overlaps_as_published`].
    ///
    /// *Panics*: never. *Cost*: up to 12 multiplications, 6 early exits. Here for
    /// comparison; [`overlaps`](Self::overlaps) is exact.
    ///
    /// *Source*: *Real-Time Rendering* 16.7, without its epsilon.
    #[inline]
    pub fn overlaps_as_published(&self, aabb: &Aabb<S>) -> bool {
        let (o, d) = (row(&self.origin()), row(&self.direction()));
        let at = |t: S| {
            let t = Rounded(t);
            [o[0] + d[0] * t, o[1] + d[1] * t, o[2] + d[2] * t]
        };
        let (start, d) = match (self.t_min(), self.t_max()) {
            (Some(from), Some(to)) => {
                let (c, w) = between(at(from), at(to));
                return segment_overlaps(c, w, aabb);
            }
            (Some(from), None) => (Some(at(from)), d),
            (None, Some(to)) => (Some(at(to)), [-d[0], -d[1], -d[2]]),
            (None, None) => (None, d),
        };
        let (center, h) = center_half(aabb);
        let zero = Rounded::ZERO;
        let c = minus(start.unwrap_or(o), center);
        // It starts beside the box and does not come nearer.
        let leaves = |i: usize| (c[i] > h[i] && d[i] >= zero) || (c[i] < -h[i] && d[i] <= zero);
        let leaves = start.is_some() && (leaves(0) || leaves(1) || leaves(2));
        !leaves && !line_misses(c, d, absolute(d), h)
    }
}

#[inline(always)]
fn segment_overlaps<S: Scalar>(c: Row<S>, w: Row<S>, aabb: &Aabb<S>) -> bool {
    let (center, h) = center_half(aabb);
    let (c, v) = (minus(c, center), absolute(w));
    let beside = |i: usize| c[i].magnitude() > v[i] + h[i];
    !(beside(0) || beside(1) || beside(2) || line_misses(c, w, v, h))
}

/// The three cross products.
#[inline(always)]
fn line_misses<S: Scalar>(c: Row<S>, w: Row<S>, v: Row<S>, h: Row<S>) -> bool {
    let mul = Rounded::<S>::area;
    let separates = |j: usize, k: usize| {
        (mul(c[j], w[k]) - mul(c[k], w[j])).magnitude() > mul(h[j], v[k]) + mul(h[k], v[j])
    };
    separates(1, 2) || separates(2, 0) || separates(0, 1)
}

/// Centre and half-vector of a segment.
#[inline(always)]
fn between<S: Scalar>(a: Row<S>, b: Row<S>) -> (Row<S>, Row<S>) {
    let half = |x: Rounded<S>| Rounded(x.0.plain_half());
    let c = [half(a[0] + b[0]), half(a[1] + b[1]), half(a[2] + b[2])];
    (c, minus(b, c))
}

#[inline(always)]
fn center_half<S: Scalar>(aabb: &Aabb<S>) -> (Row<S>, Row<S>) {
    match aabb.form() {
        AabbForm::Center { center, half } => (row(center), row(half)),
        AabbForm::Corners { min, max } => between(row(min), row(max)),
    }
}

#[inline(always)]
fn row<S: Scalar>(v: &crate::linear::Vec3<S>) -> Row<S> {
    [Rounded(v.x), Rounded(v.y), Rounded(v.z)]
}

#[inline(always)]
fn minus<S: Scalar>(a: Row<S>, b: Row<S>) -> Row<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn absolute<S: Scalar>(v: Row<S>) -> Row<S> {
    [v[0].magnitude(), v[1].magnitude(), v[2].magnitude()]
}
