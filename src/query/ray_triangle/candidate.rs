use super::{Facing, Feature, Hit};
use crate::scalar::Scalar;

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
