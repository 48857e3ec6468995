//! Whether two shapes are disjoint, touch or overlap, from separating axes.

use core::cmp::Ordering;

use crate::arithmetic::Number;
use crate::robust::Uncertain;

/// Whether two closed convex sets are disjoint, touch or overlap.
///
/// The *interior* here is the relative interior: the interior of a shape within its own line, plane
/// or space. A triangle loses its edges, a segment its ends, a box its faces, a flat box its edges;
/// a point is its own interior.
///
/// Two shapes touch if they have a point in common and their interiors have none. Equivalently,
/// some plane supports both from opposite sides, touches both, and does not contain both (R. T.
/// Rockafellar, *Convex Analysis*, 1970, theorem 11.3). A triangle on a face of a box touches it.
/// Two triangles of a mesh that share an edge touch, whether or not they lie in one plane; two
/// triangles of one plane with a common area overlap. A sphere or a capsule without radius is a
/// point or a segment.
///
/// The variants are ordered by nearness, disjoint shapes first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Relation {
    /// They have no point in common.
    #[default]
    Disjoint,
    /// They have points in common, but their interiors are disjoint.
    Touching,
    /// Their interiors have a point in common.
    Overlapping,
}

/// Distinguishes disjoint, touching and overlapping shapes.
///
/// It is implemented for each supported pair, in both orders.
#[diagnostic::on_unimplemented(
    message = "septum has no relation for `{Self}` and `{Other}`",
    label = "no such pair",
    note = "both shapes need the same scalar; `septum::relation` lists the pairs"
)]
pub trait Relate<Other> {
    /// Are the two shapes disjoint, touching or overlapping?
    ///
    /// *Numerics*: exact for every valid input, in every scalar: it is
    /// [`Disjoint`](Relation::Disjoint) if and only if `overlaps` is `false`.
    ///
    /// *Range*: as for `overlaps`. *Panics*: never.
    ///
    /// *Cost*: as for `overlaps`; for a triangle or an axis-aligned box with an axis-aligned box,
    /// up to twice as much. In floats, contact takes wider integers unless the numbers are
    /// short. A sphere or a capsule asks `overlaps`, and if that is `true`, once more without its
    /// surface.
    ///
    /// ```
    /// use septum::relation::{Relate, Relation};
    /// use septum::{Aabb, Capsule, Plane, Sphere};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let ball = Sphere::new([4.0, 5.0, 0.5], 5.0)?; // 3² + 4² = 5²
    /// assert_eq!(ball.relation(&cell), Relation::Touching);
    /// let walker = Capsule::new([0.0, 0.0, 0.5], [0.0, 0.0, 1.5], 0.5)?;
    /// let ground = Plane::from_point_normal([0.0; 3], [0.0, 0.0, 1.0])?;
    /// assert_eq!(walker.relation(&ground), Relation::Touching);
    /// assert_eq!(walker.relation(&cell), Relation::Overlapping);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    fn relation(&self, other: &Other) -> Relation;
}

/// The questions that one predicate answers about two shapes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Asked {
    /// Whether they may have a point in common, using only stages that every machine has.
    MayOverlap,
    /// Whether they have a point in common; touching and overlapping need not be distinguished.
    Overlaps,
    /// Which of the three relations holds.
    Relation,
}

/// The nearest relation that one axis allows, from the signs of the gaps in front of one shape and
/// behind it.
pub(super) fn of_gaps(gaps: [Ordering; 2]) -> Relation {
    match gaps {
        [Ordering::Greater, _] | [_, Ordering::Greater] => Relation::Disjoint,
        // Both shapes project to a single point.
        [Ordering::Equal, Ordering::Equal] => Relation::Overlapping,
        [Ordering::Equal, _] | [_, Ordering::Equal] => Relation::Touching,
        [Ordering::Less, Ordering::Less] => Relation::Overlapping,
    }
}

/// The axes tried so far, with their errors.
pub(super) struct Nearness {
    pub(super) is_disjoint: bool,
    /// Whether an axis may separate or touch.
    is_near: bool,
}

impl Nearness {
    /// Adds an axis, given whether it separates and whether it may touch.
    #[inline(always)]
    pub(super) fn add_known(&mut self, is_disjoint: bool, is_near: bool) {
        self.is_disjoint |= is_disjoint;
        self.is_near |= is_near;
    }
}

/// What to collect from the axes: whether one separates, or the relation.
pub(super) trait Reading {
    type Answer: Default;
    const NONE: Self;
    /// Whether the answer distinguishes touching from overlapping.
    const TELLS_CONTACT: bool;

    /// Adds an axis. `gap` is the distance between the two projections (negative if they overlap),
    /// and `extent` their length together.
    fn add<T: Number>(&mut self, gap: T, extent: T, error: T);

    /// Adds an axis. Unless `is_own`, a later axis has the same direction, and this one counts only
    /// if it separates for certain.
    fn add_if<T: Number>(&mut self, is_own: bool, gap: T, extent: T, error: T);

    /// Whether an axis separates for certain.
    fn is_disjoint(&self) -> bool;

    /// The answer; `None` in doubt.
    fn answer(&self, is_certain: bool) -> Option<Self::Answer>;

    /// The answer, given the relation.
    fn of(relation: Relation) -> Self::Answer;

    /// The answer, given whether the shapes are disjoint, if they do not only touch.
    #[inline(always)]
    fn clear(is_disjoint: bool) -> Self::Answer {
        Self::of(if is_disjoint { Relation::Disjoint } else { Relation::Overlapping })
    }
}

impl Reading for Uncertain {
    /// Whether the shapes are disjoint.
    type Answer = bool;
    const NONE: Self = Self::NONE;
    const TELLS_CONTACT: bool = false;

    #[inline(always)]
    fn add<T: Number>(&mut self, gap: T, _: T, error: T) {
        *self = self.or(Self::above(gap, error));
    }
    #[inline(always)]
    fn add_if<T: Number>(&mut self, is_own: bool, gap: T, _: T, error: T) {
        let found = Self::above(gap, error);
        *self = self.or(Self { possible: found.possible & (found.certain | is_own), ..found });
    }
    #[inline(always)]
    fn is_disjoint(&self) -> bool {
        self.certain
    }
    #[inline(always)]
    fn answer(&self, _: bool) -> Option<bool> {
        self.verdict()
    }
    #[inline(always)]
    fn of(relation: Relation) -> bool {
        relation == Relation::Disjoint
    }
}

impl Reading for Nearness {
    type Answer = Relation;
    const NONE: Self = Self { is_disjoint: false, is_near: false };
    const TELLS_CONTACT: bool = true;

    #[inline(always)]
    fn add<T: Number>(&mut self, gap: T, extent: T, error: T) {
        self.is_disjoint |= Uncertain::above(gap, error).certain;
        // Two projections to one point do not touch. That is certain only without rounding.
        self.is_near |=
            Uncertain::not_below(gap, error).possible & Uncertain::above(extent, error).possible;
    }
    #[inline(always)]
    fn add_if<T: Number>(&mut self, is_own: bool, gap: T, extent: T, error: T) {
        let mut found = Self::NONE;
        found.add(gap, extent, error);
        self.add_known(found.is_disjoint, found.is_near & is_own);
    }
    #[inline(always)]
    fn is_disjoint(&self) -> bool {
        self.is_disjoint
    }
    #[inline(always)]
    fn answer(&self, is_certain: bool) -> Option<Relation> {
        if self.is_disjoint {
            Some(Relation::Disjoint)
        } else if !self.is_near {
            Some(Relation::Overlapping)
        } else {
            is_certain.then_some(Relation::Touching)
        }
    }
    #[inline(always)]
    fn of(relation: Relation) -> Relation {
        relation
    }
}

#[cfg(test)]
mod tests {
    use crate::{Aabb, Obb, Segment, Triangle};

    /// The shapes nearly touch. Their numbers are short, and some machines have a stage for those.
    #[test]
    fn whether_shapes_may_overlap_is_the_same_on_every_machine() {
        let low = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]).unwrap();
        let high = Triangle::new([4.0, 4.0, 0.0], [4.0, 1.0, 0.0], [1.0, 4.0, 0.0]).unwrap();
        let side = Segment::new([4.0, 1.0, 0.0], [1.0, 4.0, 0.0]).unwrap();
        assert!(!high.overlaps(&low) && high.may_overlap(&low));
        assert!(!side.overlaps(&low) && side.may_overlap(&low));

        let skewed = [[1.0_f32, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let obb = |center| Obb::from_skewed_axes(center, skewed, [65_535.0, 1.0, 1.0]).unwrap();
        let (a, b) = (obb([0.0; 3]), obb([131_071.0, 131_070.0, 0.0]));
        assert!(!a.overlaps(&b) && a.may_overlap(&b));
        let cube = Aabb::from_center_half_extents([0.0; 3], [65_535.0, 1.0, 1.0]).unwrap();
        let b = obb([65_540.0, 1.0, 0.0]);
        assert!(!cube.overlaps(&b) && cube.may_overlap(&b));
    }
}
