//! The results: parts of shapes by number, a translation, and contact points.

use core::fmt;

use crate::scalar::Scalar;
use crate::shape::Vec3;

/// A part of a triangle, of a box, or of a sphere or a capsule.
///
/// A part's number depends only on the order in which the shape's numbers were given. It is
/// therefore the same in each frame of a simulation, and a solver recognises a point by the two
/// parts that meet there.
///
/// | | triangle | box |
/// | --- | --- | --- |
/// | face | 0 | 2·i on the lower side of axis i, 2·i + 1 on the upper |
/// | edge | k, from vertex k to the next | 4·i + a + 2·b: along axis i, on the upper side of the next axis if a is 1, of the one after that if b is |
/// | vertex | k | a + 2·b + 4·c: on the upper side of the first axis if a is 1, of the second if b is, of the third if c is |
///
/// A sphere is vertex 0. A capsule has edge 0, and vertices 0 and 1 at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Part {
    /// A face.
    Face(u8),
    /// An edge.
    Edge(u8),
    /// A vertex.
    Vertex(u8),
}

/// The parts of the shapes that determine the direction of a translation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Features {
    /// The normal of this face of the first shape.
    First(u8),
    /// The normal of this face of the second shape.
    Second(u8),
    /// The cross product of an edge of the first shape and one of the second.
    Edges(u8, u8),
    /// The way between the nearest points of these parts, of a shape and of a sphere or a capsule.
    Nearest(Part, Part),
}

/// The minimum translation that moves the first shape out of the second.
#[doc(alias = "MTV")]
#[doc(alias = "penetration")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Translation<S> {
    /// The translation. Each coordinate is rounded away from zero. A coordinate beyond the range of
    /// the scalar is infinite in floats, and the end of the range in fixed point.
    pub vector: Vec3<S>,
    /// The length of the translation, rounded up. Beyond the range it is infinite, or the end of
    /// the range.
    pub depth: S,
    /// The unit vector along the translation. A fixed-point type that does not hold 1 has its
    /// greatest number instead.
    pub normal: Vec3<S>,
    /// The face or the edges that the direction comes from.
    pub features: Features,
    /// Whether `vector` moves the first shape out of the second. It is `false` if and only if a
    /// coordinate, or its bound in [the module](super#exactness), lies beyond the range of the scalar.
    pub is_sufficient: bool,
}

/// A contact point: a point of the first shape and a point of the second, which coincide after the
/// least translation or overlap before it.
///
/// The error is stated in [the module](super#points).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Point<S> {
    /// On the first shape.
    pub on_first: Vec3<S>,
    /// On the second shape.
    pub on_second: Vec3<S>,
    /// The distance of the two points along the normal; never negative.
    pub depth: S,
    /// The part of the first shape and the part of the second that meet here.
    pub parts: [Part; 2],
}

/// The intersection of two convex quadrilaterals has at most this many corners.
pub(super) const MOST: usize = 8;

/// Up to eight points.
#[derive(Clone, Copy)]
pub(super) struct Points<S> {
    pub(super) points: [Point<S>; MOST],
    pub(super) count: usize,
}

impl<S: Scalar> Points<S> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = Vec3::splat(S::ZERO);
        let parts = [Part::Face(0); 2];
        Self {
            points: [Point { on_first: zero, on_second: zero, depth: S::ZERO, parts }; MOST],
            count: 0,
        }
    }

    pub(super) fn one(point: Point<S>) -> Self {
        Self { points: [point; MOST], count: 1 }
    }
}

/// The minimum translation, and the points where the shapes overlap.
#[doc(alias = "manifold")]
#[derive(Clone, Copy)]
pub struct Contact<S> {
    /// The minimum translation.
    pub translation: Translation<S>,
    /// Whether the translation is held to the triangle's normal because the minimum translation
    /// leads across an interior edge. Always `false` without a mesh.
    pub is_held: bool,
    pub(super) points: Points<S>,
}

impl<S: Scalar> Contact<S> {
    /// The contact points: between one and eight, in no particular order.
    ///
    /// If the direction comes from a face, this face and a face of the opposite shape are projected
    /// along the normal, and the points are the corners of the overlap that lie at or below the first
    /// face. The second face contains the deepest vertex or edge of its shape; among several such faces,
    /// the most nearly antiparallel to the normal is used. If it comes from two edges, the point is
    /// their crossing.
    ///
    /// The error is stated in [the module](super#points).
    #[must_use]
    pub fn points(&self) -> &[Point<S>] {
        self.points.points.get(..self.points.count).unwrap_or(&[])
    }
}

impl<S: Scalar> fmt::Debug for Contact<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contact")
            .field("translation", &self.translation)
            .field("is_held", &self.is_held)
            .field("points", &self.points())
            .finish()
    }
}
