//! The crate's answers about a sphere or a capsule and another shape, and the relation that is true.

use core::cmp::Ordering;

use septum::Overlaps;
use septum::relation::{Relate, Relation};

use super::{CapsuleCase, Other, Point, SphereCase};
use crate::case::Case;
use crate::contact;
use crate::flat::{Flat, FlatCase};
use crate::oriented::Oriented;
use crate::sample::Sample;

/// What all queries about a pair say, in both orders: all must agree.
#[derive(Debug, Default)]
pub struct Answers {
    pub meet: Vec<bool>,
    pub relations: Vec<Relation>,
}

impl Answers {
    /// Of a shape, given in one or in two ways.
    pub(super) fn of<A, B>([first, again]: [&A; 2], second: &B) -> Self
    where
        A: Overlaps<B> + Relate<B>,
        B: Overlaps<A> + Relate<A>,
    {
        Self {
            meet: vec![first.overlaps(second), second.overlaps(again), first.may_overlap(second)],
            relations: vec![first.relation(second), second.relation(again)],
        }
    }

    pub(super) fn of_point(meet: Vec<bool>) -> Self {
        Self { meet, relations: vec![] }
    }

    /// Checks all answers. `relation` is `None` without an oracle for it.
    pub fn check(&self, truth: Ordering, relation: Option<Relation>) -> bool {
        let is_disjoint = |&r: &Relation| r == Relation::Disjoint;
        self.meet.iter().all(|&meet| meet == truth.is_le())
            && match relation {
                Some(truth) => self.relations.iter().all(|&r| r == truth),
                None => self.relations.iter().all(|r| is_disjoint(r) == truth.is_gt()),
            }
    }
}

/// The relation, by the distance if a radius is above zero. Without a radius a segment is left, which
/// other oracles know, except with a plane or a ray.
fn relation<S: Sample>(
    truth: Ordering,
    [a, b]: [Point<S>; 2],
    radius: S,
    other: Other<S>,
) -> Option<Relation> {
    let has_radius = radius > S::ZERO || other.radius().is_some_and(|r| r > S::ZERO);
    match truth {
        Ordering::Greater => return Some(Relation::Disjoint),
        Ordering::Equal if has_radius => return Some(Relation::Touching),
        Ordering::Less => return Some(Relation::Overlapping),
        Ordering::Equal => {}
    }
    let flat = match other {
        Other::Triangle(t) => Flat::Triangle(t),
        Other::Ends(ends) | Other::Capsule(ends, _) => Flat::Ends(ends),
        Other::Center(c, h) => Flat::Center(c, h),
        Other::Point(p) | Other::Sphere(p, _) => Flat::Point(p),
        Other::Box(aabb) => {
            return Some(contact::truth(&Case { vertices: [a, b, b], aabb }).relation());
        }
        Other::Obb(center, axes, half) => {
            let case = Oriented { t: [a, b, b], center, axes, half };
            return Some(case.truth().relation());
        }
        Other::Plane(..) | Other::Ray(..) => return None,
    };
    Some(FlatCase { flat, triangle: [a, b, b] }.truth().relation())
}

impl<S: Sample> SphereCase<S> {
    /// The relation of the shapes; `None` for a point that a plane or a ray contains.
    pub fn relation(&self) -> Option<Relation> {
        relation(self.truth(), [self.center; 2], self.radius, self.other)
    }
}

impl<S: Sample> CapsuleCase<S> {
    /// The relation of the shapes; `None` for a segment that meets a plane.
    pub fn relation(&self) -> Option<Relation> {
        relation(self.truth(), self.ends, self.radius, self.other)
    }
}
