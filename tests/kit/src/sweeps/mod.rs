//! Triangles and boxes that move past boxes: a case, and the oracle.

mod oracle;
mod sets;

pub use oracle::{Contact, Quotient};
pub use sets::SweepSet;

use septum::Aabb;
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
        let parts = S::mantissa_exponent;
        let Case { vertices, aabb } = self.case;
        let vertices = vertices.map(|p| p.map(parts));
        oracle::Shapes::new(vertices, aabb.map(parts), self.way.map(|p| p.map(parts))).contact()
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
    /// Checks the crate's answer, and returns it.
    ///
    /// # Panics
    /// If it is wrong.
    pub fn check(&self) -> Option<FirstContact<S>> {
        let [from, to] = self.way;
        let motion = Motion::new(from, to).expect("finite places");
        let [a, b]: [Aabb<S>; 2] = self.boxes.map(|numbers| numbers.shape().expect("a box"));
        let parts = S::mantissa_exponent;
        let truth = oracle::boxes(self.boxes.map(|b| b.map(parts)), self.way.map(|p| p.map(parts)));
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
