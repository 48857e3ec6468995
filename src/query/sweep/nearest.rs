//! How near a moving triangle comes to a box.
//!
//! The triangle sweeps a convex set, and the relative interior of that set is all that the relative
//! interior of the triangle sweeps strictly between start and end. The relation of the swept set
//! and the box is therefore the nearest relation strictly between start and end. At the ends the
//! relation may be nearer only if triangle, box and motion do not span space together: the shapes
//! of a box with volume have interior points in common at all times close to such an end, too.

use super::{Misses, Passing};
use crate::arithmetic::Embeds;
use crate::query::relation::{Relate, Relation};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm};

/// How near does the triangle come to the box strictly between start and end, or at the end?
struct Nearest<'a, 'b, S> {
    passing: &'b Passing<'a, S>,
    is_at_end: bool,
}

impl<S: Scalar> Predicate<S> for Nearest<'_, '_, S> {
    type Answer = Relation;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        if !self.is_at_end {
            return self.passing.course::<N>()?.relation();
        }
        // Short integers have no room for a triangle that has moved.
        if !N::LARGE {
            return None;
        }
        let mut given = self.passing.given::<N>()?;
        let [from, to] = given.way;
        for vertex in &mut given.triangle {
            for i in 0..3 {
                vertex[i] = vertex[i] + to[i] - from[i];
            }
        }
        given.way = [from; 2];
        given.course().relation()
    }
}

impl<S: Scalar> Passing<'_, S> {
    /// The nearest relation on the way.
    pub(super) fn relation(self) -> Relation {
        let question = Misses(self);
        if S::evaluate(&question) {
            return Relation::Disjoint;
        }
        let passing = &question.0;
        let between = S::evaluate(&Nearest { passing, is_at_end: false });
        if between != Relation::Touching || has_volume(passing.aabb) {
            return between;
        }
        let at_start = passing.triangle.relation(passing.aabb);
        // Only the last stages answer this question.
        let at_end = Nearest { passing, is_at_end: true }.exact();
        between.max(at_start).max(at_end)
    }
}

fn has_volume<S: Scalar>(aabb: &Aabb<S>) -> bool {
    let (low, high) = match *aabb.form() {
        AabbForm::Center { half, .. } => ([S::ZERO; 3], half.to_array()),
        AabbForm::Corners { min, max } => (min.to_array(), max.to_array()),
    };
    low.iter().zip(&high).all(|(low, high)| low < high)
}
