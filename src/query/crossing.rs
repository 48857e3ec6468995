//! The faces through which a ray enters a box and leaves it.

use super::axis::negated;
use super::{Axis, HasAxes};
use crate::arithmetic::Each;
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// Where a ray enters a box or leaves it: see [`Ray::crossings`](crate::Ray::crossings).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Crossing<S> {
    /// The t of [`Ray::t_range`](crate::Ray::t_range).
    pub t: S,
    /// The face that the ray crosses: 2·i on the lower side of axis i, 2·i + 1 on the upper, as for
    /// [`Part::Face`](crate::contact::Part::Face). `None` if the range of the ray begins, or ends,
    /// inside the box.
    ///
    /// A ray through an edge or a corner crosses several faces at once; the face of the first axis
    /// is named. A range that begins or ends on a face crosses it.
    pub face: Option<u8>,
}

impl<S: Scalar> Crossing<S> {
    /// The outward normal of the face; `None` if the range begins, or ends, inside the box. It is
    /// not normalised. `shape` is the box of the query.
    ///
    /// *Numerics*: [`Axis::vector`] of the face: exact for an [`Aabb`](crate::Aabb), and rounded for
    /// an [`Obb`](crate::Obb), as described there. *Panics*: never. *Cost*: for an oriented box an
    /// exact sum.
    #[must_use]
    pub fn normal(&self, shape: &impl HasAxes<S>) -> Option<Vec3<S>> {
        let face = self.face?;
        let normal = Axis::Face(face / 2).vector(shape);
        Some(if face % 2 == 0 { negated(normal) } else { normal })
    }
}

/// Both ends of a range with their faces, given as axis and side.
pub(super) fn crossings<S>(
    (enter, leave): (S, S),
    faces: [Option<(u8, bool)>; 2],
) -> [Crossing<S>; 2] {
    let [first, last] = faces.each(|face| face.map(|(i, is_upper)| 2 * i + u8::from(is_upper)));
    [Crossing { t: enter, face: first }, Crossing { t: leave, face: last }]
}

/// The entries of a line into the three slabs of a box. Each answer is `None` in doubt.
pub(super) trait Entries {
    /// Whether the line is not parallel to slab `i`.
    fn crosses(&self, i: usize) -> Option<bool>;

    /// Whether it enters slab `i` later than slab `j`, if it crosses both.
    fn is_later(&self, i: usize, j: usize) -> Option<bool>;

    /// Whether its range begins after it enters slab `i`, which it crosses.
    fn is_past(&self, i: usize) -> Option<bool>;

    /// The slab that the line enters last, the first one of equals; `Some(None)` if its range begins
    /// later. A line crosses some slab.
    #[inline(always)]
    fn last_entered(&self) -> Option<Option<usize>> {
        let later = |i: usize, j: usize| {
            Some(self.crosses(i)? && (!self.crosses(j)? || self.is_later(i, j)?))
        };
        let first = usize::from(later(1, 0)?);
        let last = if later(2, first)? { 2 } else { first };
        Some(if self.is_past(last)? { None } else { Some(last) })
    }
}
