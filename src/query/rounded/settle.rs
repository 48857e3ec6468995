//! From a determinant and three numerators to a hit.

use crate::query::{Cull, Facing, Feature, Hit};
use crate::scalar::{Number, Rounded, Scalar, least};
use crate::shape::Ray;

/// Which hits count: the range of t, and the culling.
#[derive(Clone, Copy)]
pub(crate) struct Limits<S> {
    /// The ends of the range, and whether each is open for ever.
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

/// A hit before it is one: nothing here is read where `hit` is false.
#[derive(Clone, Copy)]
pub(crate) struct Found<S> {
    pub hit: bool,
    pub t: S,
    pub u: S,
    pub v: S,
    pub marks: u8,
}

impl<S: Scalar> Found<S> {
    /// `zeros` are those of w, u and v.
    #[inline(always)]
    pub(crate) fn new(hit: bool, [t, u, v]: [S; 3], front: bool, zeros: [bool; 3]) -> Self {
        let [w_is_zero, u_is_zero, v_is_zero] = zeros.map(u8::from);
        let marks = u8::from(front) | w_is_zero << 1 | u_is_zero << 2 | v_is_zero << 3;
        Self { hit, t, u, v, marks }
    }

    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self { hit: false, t: S::ZERO, u: S::ZERO, v: S::ZERO, marks: 0 }
    }

    #[inline(always)]
    pub(crate) fn from_hit(hit: Hit<S>) -> Self {
        let zeros = match hit.feature {
            Feature::Interior => [false; 3],
            Feature::Edge(k) => [k == 1, k == 2, k == 0],
            Feature::Vertex(k) => [k != 0, k != 1, k != 2],
        };
        Self::new(true, [hit.t, hit.u, hit.v], hit.facing == Facing::Front, zeros)
    }

    #[inline(always)]
    pub(crate) fn into_hit(self) -> Option<Hit<S>> {
        let Self { hit, t, u, v, marks } = self;
        let is = |bit: u8| marks & bit != 0;
        let facing = if is(1) { Facing::Front } else { Facing::Back };
        let feature = Feature::from_zeros(is(2), is(4), is(8));
        if hit { Some(Hit { t, u, v, facing, feature }) } else { None }
    }
}

/// A determinant, above nought where the ray comes from before, and t, u and v
/// times it.
#[derive(Clone, Copy)]
pub(crate) struct Fractions<S> {
    pub det: Rounded<S>,
    pub t: Rounded<S>,
    pub u: Rounded<S>,
    pub v: Rounded<S>,
}

/// The verdict from the signs, and the three quotients.
///
/// A miss divides by nought, which in fixed point is no division at all; what
/// comes of it is not read.
#[inline(always)]
pub(crate) fn settle<S: Scalar>(f: Fractions<S>, limits: &Limits<S>) -> Found<S> {
    let zero = Rounded::ZERO;
    let front = f.det > zero;
    let upright = |x: Rounded<S>| Rounded(x.0.plain_turned_by(f.det.0));
    let (det, u, v) = (upright(f.det), upright(f.u), upright(f.v));
    let w = det - u - v;
    let inside = (det > zero) & none_below_zero(u, v, w) & limits.keep(front);
    let divisor = if inside { det.0 } else { S::ZERO };
    let t = upright(f.t).0.plain_div(divisor);
    Found::new(
        inside & limits.hold(t),
        [t, u.0.plain_div(divisor), v.0.plain_div(divisor)],
        front,
        [w == zero, u == zero, v == zero],
    )
}

/// Whether none of three is below nought. A NaN in `w` is no; one in u or v must
/// show there.
#[inline(always)]
pub(super) fn none_below_zero<S: Scalar>(u: Rounded<S>, v: Rounded<S>, w: Rounded<S>) -> bool {
    least(least(u, v), w) >= Rounded::ZERO
}
