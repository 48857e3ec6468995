//! Triangles, segments and points against triangles: a case, and the oracle.

mod axes;
mod crossing;
mod grid;
mod oracle;
mod sets;

pub use grid::every_pair_on_the_grid;
pub use oracle::{Truth, truth_of_whole};
pub use sets::FlatSet;

use crate::Each;
use septum::relation::{Relate, Relation};
use septum::{Segment, Triangle};

use super::exact::Parts;
use super::rays::Fraction;
use super::sample::Sample;

pub type Point<S> = [S; 3];

/// The shape that is tested against a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flat<S> {
    Triangle([Point<S>; 3]),
    /// A segment by its ends.
    Ends([Point<S>; 2]),
    /// A segment by its centre and half-vector.
    Center(Point<S>, Point<S>),
    Point(Point<S>),
}

impl<S: Copy> Flat<S> {
    fn map<T>(self, f: impl Fn(S) -> T + Copy) -> Flat<T> {
        match self {
            Self::Triangle(t) => Flat::Triangle(t.each(|p| p.each(f))),
            Self::Ends(ends) => Flat::Ends(ends.each(|p| p.each(f))),
            Self::Center(c, h) => Flat::Center(c.each(f), h.each(f)),
            Self::Point(p) => Flat::Point(p.each(f)),
        }
    }
}

/// A shape and a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatCase<S> {
    pub flat: Flat<S>,
    pub triangle: [Point<S>; 3],
}

impl<S: Sample> FlatCase<S> {
    /// The relation of the two shapes.
    pub fn truth(&self) -> Truth {
        let parts = S::mantissa_exponent;
        let flat: Flat<Parts> = self.flat.map(parts);
        oracle::truth(flat, self.triangle.each(|p| p.each(parts)))
    }

    /// The crate's answers to every query about the pair, in either order, which must all agree;
    /// and the answer of `may_overlap`.
    pub fn answers(&self) -> (Vec<bool>, bool) {
        let [a, b, c] = self.triangle;
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        match self.flat {
            Flat::Triangle([a, b, c]) => {
                let t = Triangle::new(a, b, c).expect("finite vertices");
                (vec![t.overlaps(&triangle), triangle.overlaps(&t)], t.may_overlap(&triangle))
            }
            Flat::Ends([a, b]) => {
                Self::of_segment(&Segment::new(a, b).expect("finite ends"), &triangle)
            }
            Flat::Center(c, h) => {
                let segment = Segment::from_center_half_vector(c, h).expect("finite vectors");
                Self::of_segment(&segment, &triangle)
            }
            Flat::Point(p) => {
                let answer = triangle.contains(p);
                (vec![answer], answer)
            }
        }
    }

    /// The relation according to the crate; `None` for points, which have none.
    pub fn relation(&self) -> Option<Relation> {
        let [a, b, c] = self.triangle;
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        match self.flat {
            Flat::Triangle([a, b, c]) => {
                Some(Triangle::new(a, b, c).expect("finite vertices").relation(&triangle))
            }
            Flat::Ends([a, b]) => {
                Some(Segment::new(a, b).expect("finite ends").relation(&triangle))
            }
            Flat::Center(c, h) => {
                let segment = Segment::from_center_half_vector(c, h).expect("finite vectors");
                Some(triangle.relation(&segment))
            }
            Flat::Point(_) => None,
        }
    }

    fn of_segment(segment: &Segment<S>, triangle: &Triangle<S>) -> (Vec<bool>, bool) {
        let answers = vec![segment.overlaps(triangle), triangle.overlaps(segment)];
        (answers, segment.may_overlap(triangle))
    }

    /// Checks whether two triangles cross in a segment, and where it lies. Returns the coordinates
    /// of its ends, each beside the true one; `None` if they do not cross, or if the shape is no
    /// triangle.
    ///
    /// # Panics
    /// If the verdict is wrong, if another order of the triangles or of their vertices gives another
    /// segment, or if an end is outside of a bounding box.
    pub fn check_crossing(&self) -> Option<[[(S, Fraction); 3]; 2]> {
        let Flat::Triangle(first) = self.flat else { return None };
        let triangles = [first, self.triangle];
        let truth =
            crossing::crossing(triangles.each(|t| t.each(|p| p.each(S::mantissa_exponent))));
        let [first, second] =
            triangles.each(|[a, b, c]| Triangle::new(a, b, c).expect("finite vertices"));
        let ends = |a: &Triangle<S>, b: &Triangle<S>| a.crossing(b).and_then(|s| s.ends());
        let found = ends(&first, &second);
        assert_eq!(found.is_some(), truth.is_some(), "{self:?}");
        let back = found.map(|(p, q)| (q, p));
        assert_eq!(ends(&second, &first), back, "{self:?}");
        let [[a, b, c], [d, e, f]] = triangles;
        let turned = |a, b, c| Triangle::new(a, b, c).expect("finite vertices");
        assert_eq!(ends(&turned(b, c, a), &turned(f, d, e)), found, "{self:?}");
        assert_eq!(ends(&turned(b, a, c), &second), back, "{self:?}");
        let (from, to) = found?;
        let boxes = [first.aabb(), second.aabb()];
        assert!([from, to].iter().all(|&p| boxes.iter().all(|b| b.contains(p))), "{self:?}");
        let mut truth = truth?.into_iter();
        let beside = [from, to].each(|end| {
            let mut truth = truth.next().expect("two ends").into_iter();
            end.to_array().each(|x| (x, truth.next().expect("three coordinates")))
        });
        Some(beside)
    }

    /// Checks all answers against the oracle, and returns its relation.
    ///
    /// # Panics
    /// If an answer is wrong.
    pub fn check(&self) -> Truth {
        let truth = self.truth();
        let (answers, may) = self.answers();
        let meets = truth != Truth::Apart;
        assert!(answers.iter().all(|&answer| answer == meets), "{truth:?}, {answers:?}: {self:?}");
        assert!(may || !meets, "may_overlap: {self:?}");
        if let Some(relation) = self.relation() {
            assert_eq!(relation, truth.relation(), "{self:?}");
        }
        truth
    }
}
