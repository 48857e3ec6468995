//! Triangles and boxes that move past boxes: a case, and the oracle.

mod oracle;
mod sets;

pub use oracle::{Contact, Quotient};
pub use sets::SweepSet;

use crate::Each;
use septum::Aabb;
use septum::relation::Relation;
use septum::sweep::{FirstContact, Motion, Sweep};

use super::case::{BoxNumbers, Case};
use super::sample::Sample;

/// A triangle and a box; one of them moves from one place to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepCase<S> {
    pub case: Case<S>,
    /// The motion of the triangle.
    pub way: [[S; 3]; 2],
}

impl<S: Sample> SweepCase<S> {
    /// The first contact of the triangle as it moves, by rational arithmetic.
    pub fn truth(&self) -> Option<Contact> {
        self.in_integers().contact()
    }

    /// The nearest relation at any time of the motion, likewise.
    pub fn relation(&self) -> Relation {
        self.in_integers().relation().relation()
    }

    fn in_integers(&self) -> oracle::Shapes {
        let parts = S::mantissa_exponent;
        let Case { vertices, aabb } = self.case;
        let vertices = vertices.each(|p| p.each(parts));
        oracle::Shapes::new(vertices, aabb.map(parts), self.way.each(|p| p.each(parts)))
    }

    /// Checks the crate's nearest relation, for the moving triangle and for the box moving the
    /// opposite way, and returns it.
    ///
    /// # Panics
    /// If it is wrong.
    pub fn check_relation(&self) -> Relation {
        let ((triangle, aabb), motion) = (self.case.shapes(), self.motion());
        let there = triangle.relation_along(&motion, &aabb);
        let back = aabb.relation_along(&motion.reversed(), &triangle);
        assert_eq!([there, back], [self.relation(); 2], "{self:?}");
        there
    }

    pub fn motion(&self) -> Motion<S> {
        let [from, to] = self.way;
        Motion::new(from, to).expect("finite places")
    }

    /// Checks the crate's answer, for the moving triangle and for the box moving the opposite way,
    /// and returns it.
    ///
    /// # Panics
    /// If it is wrong.
    pub fn check(&self) -> Option<FirstContact<S>> {
        let (triangle, aabb) = self.case.shapes();
        let (motion, truth) = (self.motion(), self.truth());
        let meets =
            [triangle.meets_along(&motion, &aabb), aabb.meets_along(&motion.reversed(), &triangle)];
        assert_eq!(meets, [truth.is_some(); 2], "{self:?}");
        let first = triangle.first_contact(&motion, &aabb);
        assert_eq!(first, aabb.first_contact(&motion.reversed(), &triangle), "{self:?}");
        assert_eq!(first.is_some(), truth.is_some(), "{self:?}");
        let (first, truth) = (first?, truth?);
        assert!(truth.time.rounds_down_to(first.t), "{first:?}, {truth:?}: {self:?}");
        assert_eq!(first.axis, truth.witness(first.t), "{first:?}, {truth:?}: {self:?}");
        Some(first)
    }
}

/// Two boxes, of which the first moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxSweep<S> {
    pub boxes: [BoxNumbers<S>; 2],
    pub way: [[S; 3]; 2],
}

impl<S: Sample> BoxSweep<S> {
    pub fn motion(&self) -> Motion<S> {
        let [from, to] = self.way;
        Motion::new(from, to).expect("finite places")
    }

    pub fn shapes(&self) -> [Aabb<S>; 2] {
        self.boxes.each(|numbers| numbers.shape().expect("a box"))
    }

    fn in_integers(&self) -> oracle::Boxes {
        let parts = S::mantissa_exponent;
        oracle::Boxes::new(self.boxes.each(|b| b.map(parts)), self.way.each(|p| p.each(parts)))
    }

    /// The nearest relation at any time of the motion, by rational arithmetic.
    pub fn relation(&self) -> Relation {
        self.in_integers().relation().relation()
    }

    /// Checks the crate's nearest relation in both orders, and returns it.
    ///
    /// # Panics
    /// If it is wrong.
    pub fn check_relation(&self) -> Relation {
        let ([a, b], motion) = (self.shapes(), self.motion());
        let found = [a.relation_along(&motion, &b), b.relation_along(&motion.reversed(), &a)];
        assert_eq!(found, [self.relation(); 2], "{self:?}");
        found[0]
    }

    /// Checks the crate's answer, and returns it.
    ///
    /// # Panics
    /// If it is wrong.
    pub fn check(&self) -> Option<FirstContact<S>> {
        let ([a, b], motion, truth) = (self.shapes(), self.motion(), self.in_integers().contact());
        let first = a.first_contact(&motion, &b);
        assert_eq!(first, b.first_contact(&motion.reversed(), &a), "{self:?}");
        let meets = a.meets_along(&motion, &b);
        assert_eq!((meets, first.is_some()), (truth.is_some(), truth.is_some()), "{self:?}");
        let (first, truth) = (first?, truth?);
        assert!(truth.time.rounds_down_to(first.t), "{first:?}, {truth:?}: {self:?}");
        assert_eq!(first.axis, truth.witness(first.t), "{first:?}, {truth:?}: {self:?}");
        Some(first)
    }
}
