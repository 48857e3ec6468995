//! From a determinant and three numerators to a hit.

use crate::arithmetic::{Number, Rounded, least};
use crate::query::{Candidate, Cull, Facing};
use crate::scalar::Scalar;
use crate::shape::Ray;

/// Which hits count: the range of t, and the sides.
#[derive(Clone, Copy)]
pub(crate) struct Limits<S> {
    /// The ends of the range, and whether each is open.
    pub t_min: S,
    pub t_max: S,
    pub open: [bool; 2],
    pub front: bool,
    pub back: bool,
}

impl<S: Scalar> Limits<S> {
    #[inline(always)]
    pub(crate) fn new(ray: &Ray<S>, cull: Cull) -> Self {
        Self {
            t_min: ray.t_min().unwrap_or(S::ZERO),
            t_max: ray.t_max().unwrap_or(S::ZERO),
            open: [ray.t_min().is_none(), ray.t_max().is_none()],
            front: cull.keeps(Facing::Front),
            back: cull.keeps(Facing::Back),
        }
    }

    /// Whether t counts. An infinity or a NaN, from an overflow, does not.
    #[inline(always)]
    pub(super) fn hold(&self, t: S) -> bool {
        let is_finite = t.plain_sub(t) == S::ZERO;
        (self.open[0] | (t >= self.t_min)) & (self.open[1] | (t <= self.t_max)) & is_finite
    }

    #[inline(always)]
    pub(super) fn keep(&self, front: bool) -> bool {
        (self.front & front) | (self.back & !front)
    }
}

/// A determinant, above zero if the ray comes from the front, and the products of t, u and v with
/// it.
#[derive(Clone, Copy)]
pub(crate) struct Fractions<S> {
    pub det: Rounded<S>,
    pub t: Rounded<S>,
    pub u: Rounded<S>,
    pub v: Rounded<S>,
}

/// The verdict from the signs, and the three quotients.
///
/// A miss divides by zero, which costs no division in fixed point; its quotients are not read.
#[inline(always)]
pub(crate) fn resolve<S: Scalar>(f: Fractions<S>, limits: &Limits<S>) -> Candidate<S> {
    let zero = Rounded::ZERO;
    let front = f.det > zero;
    let upright = |x: Rounded<S>| Rounded(x.0.flip_sign_by(f.det.0));
    let (det, u, v) = (upright(f.det), upright(f.u), upright(f.v));
    let w = det - u - v;
    let inside = (det > zero) & none_below_zero(u, v, w) & limits.keep(front);
    let divisor = if inside { det.0 } else { S::ZERO };
    let t = upright(f.t).0.plain_div(divisor);
    Candidate::new(
        inside & limits.hold(t),
        [t, u.0.plain_div(divisor), v.0.plain_div(divisor)],
        front,
        [w == zero, u == zero, v == zero],
    )
}

/// Whether none of three numbers is below zero. A NaN in `w` gives no; a NaN in u or v must make w
/// a NaN too.
#[inline(always)]
pub(super) fn none_below_zero<S: Scalar>(u: Rounded<S>, v: Rounded<S>, w: Rounded<S>) -> bool {
    least(least(u, v), w) >= Rounded::ZERO
}
