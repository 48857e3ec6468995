//! The first stage of ray against triangle without a branch, for many pairs at once.

use super::crossing::{Crossing, Setting};
use super::residual::Numbers;
use super::rows::{First, first};
use super::{Facing, Feature, Hit};
use crate::arithmetic::{Embeds, Filtered, Number, greatest, largest, least};
use crate::scalar::Scalar;
use crate::shape::Ray;

/// A possible hit. The other fields are valid only if `hit` is true.
#[derive(Clone, Copy)]
pub(crate) struct Candidate<S> {
    pub hit: bool,
    pub t: S,
    pub u: S,
    pub v: S,
    pub marks: u8,
}

impl<S: Scalar> Candidate<S> {
    /// `zeros` says which of w, u and v are zero.
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

/// The bits of [`Ray::hit`] for a triangle, and whether they are certain: a hit clear of edges and
/// of the ray's ends, or a clear miss.
///
/// `is_plain` says that the ray has the range t ≥ 0. The caller passes it as a constant.
#[inline(always)]
pub(crate) fn clear_hit<S: Scalar, N: Embeds<S>>(
    ray: &Ray<S>,
    is_plain: bool,
    [a, b, c]: [[S; 3]; 3],
) -> (bool, Candidate<S>) {
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let Some([a, b, c, o, d]) = N::embed(&[a, b, c, o, d]) else {
        return (false, Candidate::none());
    };
    let setting = Setting::new(&[a, b, c, o], d);
    let (crossing, is_known) = setting.crossing_if_known::<N>();
    if !is_plain {
        return (is_known & (crossing.meets(false) == Some(false)), Candidate::none());
    }
    let Crossing { det, t, sides: [_, u, v], error_bound } = crossing;
    let (certain, hit) = match crossing.strictly_ahead() {
        Some(hit) => (true, hit),
        None => (false, false),
    };
    let (quotients, are_good) = N::quotients([t, u, v], det, [error_bound.t, error_bound.side]);
    let found = Candidate::new(hit & are_good, quotients, det > N::Volume::ZERO, [false; 3]);
    (is_known & certain & (are_good | !hit), found)
}

/// The same with numbers from the residual, for a ray with the range t ≥ 0.
#[inline(always)]
pub(crate) fn clear_refined_hit<S: Scalar>(
    ray: &Ray<S>,
    [a, b, c]: [[S; 3]; 3],
) -> (bool, Candidate<S>)
where
    Filtered<f64>: Embeds<S>,
{
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let [a, b, c, o, d] = Filtered::<f64>::embed_held(&[a, b, c, o, d]);
    let points = [a, b, c, o];
    let setting = Setting::new(&points, d);
    let (crossing, is_known) = setting.crossing_if_known::<Filtered<f64>>();
    let (certain, hit) = match crossing.strictly_ahead() {
        Some(hit) => (true, hit),
        None => (false, false),
    };
    let Crossing { det, t, sides: [_, u, v], .. } = crossing;
    let numbers = Numbers::new(false, &points, d, [det, t, u, v], setting.sizes());
    let (rounded, are_good) = numbers.rounded::<S>();
    let found = Candidate::new(hit & are_good, rounded, det > 0.0, [false; 3]);
    (is_known & certain & (are_good | !hit), found)
}

/// Whether the ray certainly misses a triangle, in the scalar's first float.
#[inline(always)]
pub(crate) fn clearly_misses<S: Scalar>(ray: &Ray<S>, [a, b, c]: [[S; 3]; 3]) -> bool {
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let [a, b, c, o, d] = [first(a), first(b), first(c), first(o), first(d)];
    let is_held = S::FIRST_LIMIT.is_none_or(|limit| {
        let is_held = |p: &[First<S>; 3]| largest(p) < limit;
        is_held(&a) & is_held(&b) & is_held(&c) & is_held(&o) & is_held(&d)
    });
    let (crossing, is_known) =
        Setting::new(&[a, b, c, o], d).crossing_if_known::<Filtered<First<S>>>();
    let Crossing { t, sides: [w, u, v], error_bound, .. } = crossing;
    let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
    let is_ahead = ray.t_min().is_some_and(|t| t >= S::ZERO);
    let (ahead, behind) = ((t > error_bound.t) & is_ahead, (t < -error_bound.t) & is_ahead);
    let miss = ((low < -error_bound.sides) | behind) & ((high > error_bound.sides) | ahead);
    is_held & is_known & miss
}
