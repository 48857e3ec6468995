//! How to get two shapes out of each other: the least translation, and where they touch then.
//!
//! ```
//! use septum::contact::{Axis, Part, contact};
//! use septum::{Aabb, Triangle};
//!
//! // A crate that sank a sixteenth into the floor.
//! let floor = Triangle::new([-8.0_f32, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 8.0, 0.0])?;
//! let crate_ = Aabb::from_min_max([0.0, 0.0, -0.0625], [1.0, 1.0, 0.9375])?;
//!
//! let found = contact(&crate_, &floor).unwrap();
//! let out = found.translation;
//! assert_eq!(out.vector.to_array(), [0.0, 0.0, 0.0625]); // the crate goes up
//! assert_eq!((out.depth, out.axis), (0.0625, Axis::Second(0))); // by the floor's face
//! assert_eq!(found.points().len(), 4); // it rests on the corners of its bottom
//! assert_eq!(found.points()[0].parts, [Part::Vertex(0), Part::Face(0)]);
//!
//! let lifted = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
//! assert!(contact(&lifted, &floor).is_none()); // it touches, and is in nothing
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! # Which pairs
//!
//! A [`Triangle`], an [`Aabb`] and an [`Obb`], each with each, in every scalar. An oriented box is
//! the parallelepiped that its numbers describe.
//!
//! # What is exact
//!
//! Whether there is a translation at all is exact: there is one if and only if no plane has one of
//! the shapes on its one side and the other on its other. Shapes that touch have none, nor have two
//! that lie in one plane, which any step off the plane takes apart.
//!
//! The first shape moved by the vector as returned has no interior point in common with the second,
//! for certain: each coordinate is rounded away from zero. Moved means p + t without rounding. Who
//! rounds p + t moves each coordinate by up to half a unit in the last place of p + t beside, and
//! the shapes may be as far in each other still. Fixed point does not round a sum.
//!
//! Where a coordinate of the vector lies beyond the range of the scalar no vector is enough, and
//! [`Translation::is_sufficient`] is `false`.
//!
//! The direction is that of the least depth, but for differences of less than 2^-55 of it. Of equal
//! ones it is the first in this order: the faces of triangles, faces of the first shape, of the
//! second, and edges across edges, those of the first shape in turn; against the direction of the
//! cross product before along it. With d the true depth, `depth` is at least d and less than
//! (1 + 2^-55)·d plus one unit in the last place. Each coordinate of the vector is rounded likewise,
//! away from zero. In up to 53 bits that is the next number, or the one after. In fixed point of 64
//! bits 2^-55 of a large number is up to 256 units. A coordinate of the normal is off by up to 2^-55 of
//! itself and half a unit. All three are exact where the direction is along a coordinate axis and
//! numbers are not long.
//!
//! # Points
//!
//! Points are computed in `f64` from the second shape's centre or first vertex, and rounded to the
//! scalar. Let R be the greatest difference in a coordinate between any two corners of the shapes, and
//! let a unit be one unit in the last place of the number in question.
//!
//! * Each coordinate of `on_first` and of `on_second` is within 2^-47·R and one unit of a point of the
//!   part named in `parts`.
//! * `on_second` − `on_first` is `depth` times the normal, within 2^-42·R and a unit of each number.
//! * The points span what touches. Draw one of the shapes in by 2^-42·R and four units, and translate
//!   the first: what touches then is within as much of the convex hull of the deepest points.
//!
//! In `f32` and in fixed point of up to 32 bits 2^-47·R is below a unit, unless R is thousands of times
//! as great as the coordinate. A coordinate beyond the range of the scalar is infinite, or the end of
//! the range. In `f64` a coordinate may be NaN where an axis of an oriented box is longer than 2^600 or
//! shorter than 2^-600.
//!
//! All of it is the same on every machine.
//!
//! # On meshes
//!
//! A box that slides over a floor of triangles is now and then caught by an edge between two: seen
//! alone, a triangle that it has just entered is left soonest sideways. [`contact_in_mesh`] takes
//! three bits for a triangle that say which of its edges are interior; [`interior_edges`] computes
//! them.

mod body;
mod directions;
mod exact;
mod faces;
mod feature;
mod interior;
mod least;
mod points;
mod sums;
#[cfg(test)]
mod tests;
mod whole;

use core::fmt;

use self::body::{Body, Place, Rough};
use self::exact::Size;
pub use self::feature::{Axis, Part};
pub use self::interior::{InteriorEdges, interior_edges};
use self::least::{Way, least_way};
pub use self::points::Point;
use self::points::{Points, axis, points};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Triangle, Vec3};

/// A shape that has contacts: a [`Triangle`], an [`Aabb`] or an [`Obb`].
///
/// The trait is sealed.
pub trait Shape<S>: sealed::Sealed<S> {}

mod sealed {
    pub trait Sealed<S> {
        fn body(&self) -> super::Body<'_, S>;
    }
}

macro_rules! shapes {
    ($($shape:ident)*) => {$(
        impl<S: Scalar> Shape<S> for $shape<S> {}

        impl<S: Scalar> sealed::Sealed<S> for $shape<S> {
            fn body(&self) -> Body<'_, S> {
                Body::$shape(self)
            }
        }
    )*};
}
shapes! { Triangle Aabb Obb }

/// The least translation of the first shape that takes it out of the second.
#[doc(alias = "MTV")]
#[doc(alias = "penetration")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Translation<S> {
    /// The translation. Each coordinate is rounded away from zero. A coordinate beyond the range of
    /// the scalar is infinite, in fixed point the end of the range.
    pub vector: Vec3<S>,
    /// The length of the translation, rounded up; beyond the range infinite or the end of the range.
    pub depth: S,
    /// The unit vector along it, each coordinate to the nearest or next to it; a fixed-point type
    /// that cannot hold one has the greatest number for it.
    pub normal: Vec3<S>,
    /// What of the shapes the direction comes from.
    pub axis: Axis,
    /// Whether moving the first shape by `vector` takes it out of the second: `false` if and only
    /// if a coordinate lies beyond the range of the scalar.
    pub is_sufficient: bool,
}

/// The least translation, and the points where the shapes are in each other.
#[doc(alias = "manifold")]
#[derive(Clone, Copy)]
pub struct Contact<S> {
    /// The least translation.
    pub translation: Translation<S>,
    /// Whether the least translation of all leads across an interior edge, so that this is the one
    /// along the triangle's normal. Always `false` without a mesh.
    pub is_held: bool,
    points: Points<S>,
}

impl<S: Scalar> Contact<S> {
    /// Between one and eight points, in no order.
    ///
    /// If the axis is a face, they are corners of the overlap of that face and a face of the other
    /// shape, both seen along the normal, as far as the latter lies below the former. The other face is
    /// one that has the part of its shape which lies deepest, and of those the one that is turned most
    /// against the normal. If the axis is two edges, the point is where they cross.
    ///
    /// [The module](self#points) tells how far a point may be off.
    #[must_use]
    pub fn points(&self) -> &[Point<S>] {
        self.points.as_slice()
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

/// The least translation of the first shape that takes it out of the second; `None` if they are
/// disjoint or touch.
///
/// *Geometry*: interiors have no point in common after it. See [the module](self) for shapes that
/// lie in one plane.
///
/// *Numerics*: see [the module](self): whether there is one is exact, and it suffices for certain.
///
/// *Range*: all of the scalar's. A coordinate of the result beyond it is infinite in floats, and in
/// fixed point the end of the range; then [`Translation::is_sufficient`] is `false`.
///
/// *Panics*: never. *Cost*: in `f64` at most 15 cross products, each with two intervals; where
/// floats leave one direction, as they nearly always do, three exact numbers for its coordinates,
/// six signs at most and one for the depth: by whole numbers of up to 256 bits, or where 60 bits do
/// not hold what is given by exact sums; a root and seven quotients of 64 bits.
///
/// *Source*: separating axes, as for [`Obb::overlaps`]; a vector that suffices as it is rounded,
/// ours.
#[doc(alias = "MTV")]
#[doc(alias = "minimum translation vector")]
#[doc(alias = "penetration")]
#[must_use]
pub fn least_translation<S: Scalar>(
    first: &impl Shape<S>,
    second: &impl Shape<S>,
) -> Option<Translation<S>> {
    let bodies = [first.body(), second.body()];
    let (_, rough) = in_floats(&bodies);
    let way = least_way(&bodies, &rough, InteriorEdges::NONE)?;
    Some(translation(&bodies, &way, way.ratios()))
}

/// The least translation of the first shape that takes it out of the second, and the points where
/// they are in each other; `None` if they are disjoint or touch.
///
/// *Geometry*, *numerics*, *range*, *cost*: as of [`least_translation`]; points are rounded.
/// *Panics*: never.
///
/// *Source* of the points: I. E. Sutherland, G. W. Hodgman, *Communications of the ACM* 17, 1974.
#[doc(alias = "penetration")]
#[doc(alias = "manifold")]
#[must_use]
pub fn contact<S: Scalar>(first: &impl Shape<S>, second: &impl Shape<S>) -> Option<Contact<S>> {
    of_bodies(&[first.body(), second.body()], InteriorEdges::NONE)
}

/// The same for a triangle of a mesh: where the least translation leads across an interior edge,
/// that along the triangle's normal.
///
/// A translation leads across an edge if what of the triangle lies farthest toward the other shape,
/// against the translation, is the edge, or a vertex at its end and that direction does not point
/// back from the edge. Then `is_held` is `true`, and the depth is that along the normal, on the side where it is less.
///
/// `None` also where the triangle is a segment or a point, which has no normal to hold it to.
///
/// Points lie on the triangle, as for [`contact`]: if `is_held`, where that face of the other shape
/// lies over the triangle which is deepest there. The deepest part of the other shape may lie beyond
/// the triangle's edges, and then no point is as deep as the translation.
///
/// *Numerics*: as of [`contact`]; whether a direction points back is computed in `f64`.
///
/// ```
/// use septum::contact::{InteriorEdges, contact, contact_in_mesh};
/// use septum::{Aabb, Triangle};
///
/// // A crate on the floor, that has come over an edge by less than it sank.
/// let next = Triangle::new([0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0])?;
/// let sunk = Aabb::from_min_max([1.0, -0.75, -0.5], [2.0, 0.25, 0.5])?;
/// let alone = contact(&next, &sunk).unwrap();
/// assert_eq!(alone.translation.vector.to_array(), [0.0, 0.25, 0.0]); // caught by the edge
/// let inside = InteriorEdges::new([true, false, false]);
/// let in_mesh = contact_in_mesh(&next, inside, &sunk).unwrap();
/// assert_eq!(in_mesh.translation.vector.to_array(), [0.0, 0.0, -0.5]);
/// assert!(in_mesh.is_held && !alone.is_held);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[must_use]
pub fn contact_in_mesh<S: Scalar>(
    triangle: &Triangle<S>,
    interior: InteriorEdges,
    other: &impl Shape<S>,
) -> Option<Contact<S>> {
    of_bodies(&[Body::Triangle(triangle), other.body()], interior)
}

fn of_bodies<S: Scalar>(bodies: &[Body<'_, S>; 2], interior: InteriorEdges) -> Option<Contact<S>> {
    let (origin, rough) = in_floats(bodies);
    let way = least_way(bodies, &rough, interior)?;
    let ratios = way.ratios();
    let translation = translation(bodies, &way, ratios);
    let points = points(bodies, &origin, &rough, &way, way.unit(&ratios), translation.axis);
    Some(Contact { translation, is_held: way.is_held, points })
}

/// The shapes in floats, and from which place.
fn in_floats<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> (Place<S>, [Rough; 2]) {
    let origin = bodies[1].origin();
    (origin, [bodies[0].rough(&origin, 1.0), bodies[1].rough(&origin, 1.0)])
}

fn translation<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    way: &Way,
    ratios: [Size; 3],
) -> Translation<S> {
    let (vector, is_sufficient) = way.translation();
    let (depth, normal, axis) = (way.depth(), way.normal(ratios), axis(bodies, way));
    Translation { vector, depth, normal, axis, is_sufficient }
}
