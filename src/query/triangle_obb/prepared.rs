//! One oriented box against many triangles, with the numbers of the box that the first stage of fixed
//! point needs for every triangle: see `short`.

use super::Disjoint;
use super::known::{Crossed, Known};
use super::short::{EXACT, are_disjoint};
use crate::arithmetic::{Each, Embeds};
use crate::robust::{Predicate, Profile, noted};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Obb, Triangle, Vec3};

/// A box for many triangles, and what the first stage of fixed point asks of it; in floats the box
/// alone.
#[derive(Clone, Copy, Debug)]
pub struct PreparedObb<S: Scalar> {
    obb: Obb<S>,
    crossed: Crossed,
}

impl<S: Scalar> PreparedObb<S> {
    /// Prepares a box for triangles that meet its bounding box. The first face to be tested belongs
    /// to an axis that is not along a coordinate axis, because such a face has been tested already.
    #[inline(always)]
    pub(crate) fn new(obb: &Obb<S>) -> Self {
        let is_skew = |u: &Vec3<S>| {
            let [x, y, z] = u.to_array().each(|x| u8::from(x != S::ZERO));
            x + y + z > 1
        };
        let [first, second, _] = obb.axes();
        let obb = if is_skew(first) {
            *obb
        } else if is_skew(second) {
            obb.turned()
        } else {
            obb.turned().turned()
        };
        Self { obb, crossed: S::evaluate_bounded(&Crossing(&obb)).unwrap_or_default() }
    }

    /// Whether the box overlaps the triangle.
    #[inline(always)]
    pub(crate) fn overlaps(&self, triangle: &Triangle<S>) -> bool {
        let question = Disjoint::new(triangle, &self.obb);
        !question.in_cut_floats().unwrap_or_else(|| S::evaluate(&Prepared(question, &self.crossed)))
    }
}

/// Are the triangle and the prepared box disjoint?
struct Prepared<'a, S>(Disjoint<'a, S>, &'a Crossed);

impl<S: Scalar> Predicate<S> for Prepared<'_, S> {
    type Answer = bool;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.0.filter::<N>()
    }

    const PROFILE: Profile = Profile::CUT;

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<bool>
    where
        S: FixedBackend,
    {
        let &Self(ref question, crossed) = self;
        let vertices = move || question.vertices_from_center();
        noted(are_disjoint(question.obb, move || Known::All(crossed), EXACT, vertices))
            .or_else(|| S::in_machine_words(question))
    }

    fn exact(&self) -> bool {
        self.0.exact()
    }
}

/// What are the axes, crossed?
struct Crossing<'a, S>(&'a Obb<S>);

impl<S: Scalar> Predicate<S> for Crossing<'_, S> {
    type Answer = Crossed;

    fn filter<N: Embeds<S>>(&self) -> Option<Crossed> {
        None
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Crossed>
    where
        S: FixedBackend,
    {
        Some(Crossed::of(self.0))
    }
}
