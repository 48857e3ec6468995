//! How two shapes lie to each other, and how axes tell.

use core::cmp::Ordering;

use crate::arithmetic::Number;
use crate::robust::Uncertain;

/// How two closed convex sets lie to each other.
///
/// The *interior* of a shape is what is inside it seen from its own line, plane or space: of a
/// triangle all but its edges, of a segment all but its ends, of a box all but its faces, of a
/// flat box all but its edges; a point is its own interior. (In the literature: the relative
/// interior.)
///
/// Two shapes touch if they have a point in common and their interiors have none. That is so
/// exactly if some plane has one on its one side and the other on its other, both of them meet
/// it, and not all of both lies in it (R. T. Rockafellar, *Convex Analysis*, 1970, theorem
/// 11.3). So a triangle on a face of a box touches it, and two triangles of a mesh that share an
/// edge touch, in one plane or not; two that lie on each other in one plane overlap.
///
/// The order is that of nearness: disjoint shapes come first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Relation {
    /// They have no point in common.
    #[default]
    Disjoint,
    /// They have points in common, but their interiors have none.
    Touching,
    /// Their interiors have a point in common.
    Overlapping,
}

/// How a shape lies to another: touching told apart from overlapping.
///
/// There is an implementation for each pair that can be asked about, in both orders of the
/// arguments.
pub trait Relate<Other> {
    /// How the two shapes lie to each other.
    ///
    /// *Numerics*: exact for every valid input, in every scalar: it is
    /// [`Disjoint`](Relation::Disjoint) if and only if `overlaps` is `false`.
    ///
    /// *Range*: as of `overlaps`. *Panics*: never.
    ///
    /// *Cost*: that of `overlaps`, but of a triangle or an axis-aligned box with an
    /// axis-aligned box up to twice. In floats contact takes integers or exact sums, but where the
    /// numbers are short.
    #[must_use]
    fn relation(&self, other: &Other) -> Relation;
}

/// What is asked about two shapes, of questions that one predicate answers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Asked {
    /// Whether they may have a point in common: by no stage that only some machines have.
    MayOverlap,
    /// Whether they have one: touching and overlapping are the same then.
    Overlaps,
    /// Which of the three it is.
    Relation,
}

/// What an axis says at most, given how the two gaps on it compare with zero: that before the one
/// shape and that after it.
pub(super) fn of_gaps(gaps: [Ordering; 2]) -> Relation {
    match gaps {
        [Ordering::Greater, _] | [_, Ordering::Greater] => Relation::Disjoint,
        // All of both at one place.
        [Ordering::Equal, Ordering::Equal] => Relation::Overlapping,
        [Ordering::Equal, _] | [_, Ordering::Equal] => Relation::Touching,
        [Ordering::Less, Ordering::Less] => Relation::Overlapping,
    }
}

/// What the axes tried so far say, errors allowed for.
pub(super) struct Nearness {
    pub(super) is_disjoint: bool,
    /// Whether an axis may separate, or touch.
    is_near: bool,
}

impl Nearness {
    pub(super) const NONE: Self = Self { is_disjoint: false, is_near: false };

    /// An axis on which the shapes are so far apart (below zero: so far in each other), and
    /// extend so far together.
    #[inline(always)]
    pub(super) fn add<T: Number>(&mut self, gap: T, extent: T, error: T) {
        self.is_disjoint |= gap > error;
        // All of both at one place is no touch. It is certain only if nothing is rounded.
        self.is_near |= (gap >= -error) & (extent > -error);
    }

    /// An axis on which it is not known.
    #[inline(always)]
    pub(super) fn add_doubt(&mut self, is_near: bool) {
        self.is_near |= is_near;
    }

    /// How the shapes lie to each other; `None` in doubt.
    #[inline(always)]
    pub(super) fn relation(&self, is_certain: bool) -> Option<Relation> {
        if self.is_disjoint {
            Some(Relation::Disjoint)
        } else if !self.is_near {
            Some(Relation::Overlapping)
        } else {
            is_certain.then_some(Relation::Touching)
        }
    }
}

/// What axes are read for: whether one separates, or how the shapes lie.
pub(super) trait Reading {
    type Answer;
    const NONE: Self;

    /// An axis, as of [`Nearness::add`].
    fn add<T: Number>(&mut self, gap: T, extent: T, error: T);

    /// The answer; `None` in doubt.
    fn answer(&self, is_certain: bool) -> Option<Self::Answer>;
}

impl Reading for Uncertain {
    /// Whether the shapes are disjoint.
    type Answer = bool;
    const NONE: Self = Self::NONE;

    #[inline(always)]
    fn add<T: Number>(&mut self, gap: T, _: T, error: T) {
        *self = self.or(Self { certain: gap > error, possible: gap > -error });
    }
    #[inline(always)]
    fn answer(&self, _: bool) -> Option<bool> {
        self.verdict()
    }
}

impl Reading for Nearness {
    type Answer = Relation;
    const NONE: Self = Self::NONE;

    #[inline(always)]
    fn add<T: Number>(&mut self, gap: T, extent: T, error: T) {
        self.add(gap, extent, error);
    }
    #[inline(always)]
    fn answer(&self, is_certain: bool) -> Option<Relation> {
        self.relation(is_certain)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Aabb, Obb, Segment, Triangle};

    /// Where they do not meet, nearly, numbers are short, and some machines have a stage for that.
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
