//! Contact between two shapes: the minimum translation that separates them (MTV), and the points
//! where they then touch.
//!
//! ```
//! use septum::contact::{Features, Part, contact};
//! use septum::{Aabb, Triangle};
//!
//! // A crate that sank a sixteenth into the floor.
//! let floor = Triangle::new([-8.0_f32, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 8.0, 0.0])?;
//! let chest = Aabb::from_min_max([0.0, 0.0, -0.0625], [1.0, 1.0, 0.9375])?;
//!
//! let found = contact(&chest, &floor).unwrap();
//! let out = found.translation;
//! assert_eq!(out.vector.to_array(), [0.0, 0.0, 0.0625]); // the crate goes up
//! assert_eq!((out.depth, out.features), (0.0625, Features::Second(0))); // by the floor's face
//! assert_eq!(found.points().len(), 4); // it rests on the corners of its bottom
//! assert_eq!(found.points()[0].parts, [Part::Vertex(0), Part::Face(0)]);
//!
//! let lifted = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
//! assert!(contact(&lifted, &floor).is_none()); // it touches, and is in nothing
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! # Pairs
//!
//! [`Triangle`], [`Aabb`] and [`Obb`] in every combination; [`Sphere`] and [`Capsule`] with
//! [`Triangle`] and [`Aabb`], in either order. All in every scalar, and with a mesh. An oriented box
//! is the parallelepiped that its numbers describe. Other pairs do not compile:
//!
//! ```compile_fail
//! use septum::{Obb, Sphere, contact::contact};
//!
//! let ball = Sphere::new([0.0_f32; 3], 1.0).unwrap();
//! let turned = Obb::from_quaternion([0.0; 3], [0.0, 0.0, 0.0, 1.0], [1.0; 3]).unwrap();
//! contact(&ball, &turned);
//! ```
//!
//! # Exactness
//!
//! The verdict is exact: there is no translation if and only if a plane separates the interiors of
//! the shapes. Shapes that only touch have none. Two shapes in one plane have none either, because
//! any step off the plane separates them. A sphere or a capsule has a translation if and only if a
//! point of the other shape is nearer than the radius; without a radius it is a point or a segment,
//! and the first rule holds.
//!
//! Moving the first shape by the returned vector is guaranteed to separate the interiors, because
//! each coordinate is rounded away from zero. The guarantee is for p + t without rounding. If the
//! sum is rounded, each coordinate moves by up to half a unit in the last place of p + t, and the
//! shapes may overlap by that much. Fixed point does not round a sum. If a coordinate of the vector
//! lies beyond the range of the scalar, no vector is enough, and [`Translation::is_sufficient`] is
//! `false`.
//!
//! The direction has minimum depth, except for differences below 2⁻⁵⁵ of the depth. Ties go to the
//! first candidate in this order: faces of triangles, faces of the first shape, faces of the second
//! shape, then pairs of edges, sorted by the edge of the first shape. Each candidate is a cross
//! product n of two edges; −n comes before n. Where a third depth differs from the tied ones by less
//! than 2⁻⁵⁵, a later candidate of the tie may be taken. All machines take the same candidate.
//!
//! Let d be the true depth. Then `depth` is at least d and less than (1 + 2⁻⁵⁵)·d plus one unit in
//! the last place. The coordinates of the vector are rounded in the same way. In 64-bit fixed point
//! 2⁻⁵⁵ of a large number is up to 256 units. A coordinate of the normal is off by up to 2⁻⁵⁵ of
//! itself and half a unit in the last place. All three are exact if the direction is a coordinate
//! axis and the coordinates have few bits.
//!
//! # Spheres and capsules
//!
//! A sphere is a point with a radius, a capsule a segment with one. Outside of the other shape, the
//! direction is that between the nearest points, which is exact, and d is the radius less their
//! distance. If the point or the segment meets the shape, d is the radius plus the least overlap. The
//! bounds above hold for both. Of equal depths a face that an end of the segment lies over comes before an
//! edge, the lower number first, and the front of a triangle, where its vertices go counterclockwise, before
//! its back: a sphere around a point of a triangle leaves to the front. If no end lies over a face, the way out
//! is named by an edge that the segment crosses, also where it is a face's normal, on either side. The order
//! of the two shapes changes only signs.
//!
//! There is one contact point, also where a capsule lies along a face. It is on the part that the
//! direction comes from: on the other shape each coordinate is rounded once, and `on_second` −
//! `on_first` is `depth` times the normal, within 2⁻⁵⁰ of the depth and two units. If a coordinate
//! on the other shape lies beyond the range of the scalar, that on the sphere or the capsule is measured from the
//! end of the range, and in floats may be NaN. In a mesh, if `is_held`, the point is less deep than the
//! translation.
//!
//! # Points
//!
//! Of shapes with flat faces:
//!
//! Points are computed in `f64` from the second shape's centre or first vertex, and rounded to the
//! scalar. Let R be the greatest difference in a coordinate between any two corners of the shapes,
//! and let a unit be one unit in the last place of the number in question.
//!
//! * Each coordinate of `on_first` and of `on_second` is within 2⁻⁴⁷·R and one unit of a point of
//!   the part named in `parts`.
//! * `on_second` − `on_first` is `depth` times the normal, within 2⁻⁴²·R and a unit of each
//!   number.
//! * The points span the contact, within ε = 2⁻⁴²·R plus four units. Shrink one of the shapes by ε
//!   and translate the first shape by `vector`. Every point where the shapes then touch is at most
//!   ε from the convex hull of the deepest points.
//!
//! In `f32` and in fixed point of up to 32 bits, 2⁻⁴⁷·R is less than a unit unless the coordinate
//! is thousands of times smaller than R. A coordinate beyond the range of the scalar is infinite,
//! in fixed point the end of the range. In `f64` a coordinate may be NaN if an axis of an oriented
//! box is longer than 2⁶⁰⁰ or shorter than 2⁻⁶⁰⁰.
//!
//! All results are the same on every machine.
//!
//! # Meshes
//!
//! A box that slides over a floor of triangles sometimes catches on an edge between two triangles:
//! for a single triangle that the box has just entered, the minimum translation points sideways.
//! [`contact_in_mesh`] prevents this. It takes three bits for each triangle, one for each edge: set
//! if the edge is interior. [`interior_edges`] computes them, and
//! [`Tree::contacts`](crate::mesh::Tree::contacts) returns the contacts of a shape with a whole mesh.
//!
//! A sphere or a capsule that is outside of a triangle, and nearest to it across an interior edge, is
//! nearer to the triangle beyond that edge, whose contact is deeper. There it has no contact with the
//! first triangle.

mod against;
mod answer;
mod apart;
mod body;
mod clip;
mod cut;
mod depth;
mod directions;
mod exact;
mod faces;
mod filter;
mod integers;
mod lanes;
mod least;
mod line;
mod measures;
mod mesh;
mod nearest;
mod on_axis;
mod pairs;
mod points;
mod quads;
mod round;
mod rows;
mod scene;
mod settled;
mod sides;
mod signs;
mod solid;
#[cfg(test)]
mod tests;
mod unit;
mod view;
mod wanted;
mod whole;

use self::pairs::sealed::Pair;
use crate::scalar::Scalar;
use crate::shape::Triangle;
#[cfg(doc)]
use crate::shape::{Aabb, Capsule, Obb, Sphere};

pub use self::answer::{Contact, Features, Part, Point, Translation};
pub use self::mesh::{Contacts, InteriorEdges, interior_edges};
pub use self::pairs::{ContactWith, Shape};

/// Returns the minimum translation that moves the first shape out of the second, or `None` if they
/// are disjoint or touch.
///
/// *Geometry*: the translated interiors have no common point. See [the module](self) for shapes in
/// one plane.
///
/// *Numerics*: the verdict is exact, and the vector is guaranteed to separate the shapes; see
/// [the module](self).
///
/// *Range*: all of the scalar. A coordinate of the result beyond it is infinite in floats, and the
/// end of the range in fixed point; then [`Translation::is_sufficient`] is `false`.
///
/// *Panics*: never. *Cost*: in `f64` at most 15 cross products, each with two intervals. These
/// nearly always leave one direction. In scalars of up to 32 bits the intervals nearly always round
/// to one number each. Along a coordinate axis the depth is a sum that `f64` seldom rounds. If there is still a
/// doubt, it takes three exact coordinates, at most six signs and one exact depth
/// for each direction that is left, in integers of up to 256 bits, or in exact sums if 60 bits do
/// not hold the coordinates; and a root and seven quotients of 64 bits. On 32-bit cores half words begin,
/// and integers of up to 128 bits follow: in fixed point of up to 32 bits, and in `f32` where 31 bits hold the
/// axes, the half-extents and what places differ by, each in a unit of its own.
///
/// A sphere or a capsule first asks whether it overlaps. On hosts, in scalars of up to 32 bits, `f64`
/// with bounds, or double words where a depth nearly cancels, then have the numbers of a centre or
/// an end outside, and of a centre in a box. If they leave a doubt, and elsewhere, integers of the
/// length that exactness takes compare the distances of the ends and the parts of the other shape.
///
/// *Source*: separating axes, as for [`Obb::overlaps`]. The rounding that guarantees separation is
/// ours.
///
/// ```
/// use septum::contact::{Features, least_translation};
/// use septum::{Aabb, Capsule, Sphere};
///
/// let cell = Aabb::from_min_max([0.0_f32; 3], [4.0; 3])?;
/// let ball = Sphere::new([4.375, 2.0, 2.0], 0.5)?;
/// let out = least_translation(&ball, &cell).unwrap();
/// assert_eq!((out.depth, out.features), (0.125, Features::Second(1)));
/// assert_eq!(out.vector.to_array(), [0.125, 0.0, 0.0]);
/// let post = Capsule::new([3.0, 1.0, -2.0], [3.0, 1.0, 9.0], 0.5)?;
/// assert_eq!(least_translation(&post, &cell).unwrap().depth, 1.5); // from inside
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[doc(alias = "MTV")]
#[doc(alias = "minimum translation vector")]
#[doc(alias = "penetration")]
#[must_use]
pub fn least_translation<S: Scalar, Other>(
    first: &impl ContactWith<S, Other>,
    second: &Other,
) -> Option<Translation<S>> {
    first.least_translation_from(second)
}

/// Returns the minimum translation that moves the first shape out of the second, and the contact
/// points, or `None` if the shapes are disjoint or touch.
///
/// *Geometry*, *Numerics*, *Range*, *Cost*: as for [`least_translation`]. The points are rounded;
/// [the module](self#points) states their error. *Panics*: never.
#[doc(alias = "penetration")]
#[doc(alias = "manifold")]
#[must_use]
pub fn contact<S: Scalar, Other>(
    first: &impl ContactWith<S, Other>,
    second: &Other,
) -> Option<Contact<S>> {
    first.contact_with(second, InteriorEdges::NONE)
}

/// Returns the [`contact`] of a triangle of a mesh. If the minimum translation leads across an
/// interior edge, a translation along the triangle's normal replaces it.
///
/// Take the part of the triangle that is farthest in the direction opposite to the translation. The
/// translation leads across an edge if this part is the edge, or if it is an end of the edge and
/// the direction does not point back over the edge. Then `is_held` is `true`, and the
/// translation goes to the side of the triangle where the depth is less.
///
/// `None` also if the triangle is a segment or a point, which has no normal, and if the other shape
/// is a sphere or a capsule outside of the triangle: then the triangle beyond the edge is nearer.
///
/// The points lie on the triangle, as for [`contact`]. If `is_held`, they come from the face of
/// `other` that is deepest over the triangle. The deepest part of `other` may lie beyond the
/// triangle's edges; then all points are less deep than the translation.
///
/// *Numerics*: as for [`contact`]; whether a direction points back is computed in `f64`.
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
pub fn contact_in_mesh<S: Scalar, Other>(
    triangle: &Triangle<S>,
    interior: InteriorEdges,
    other: &Other,
) -> Option<Contact<S>>
where
    Triangle<S>: ContactWith<S, Other>,
{
    Pair::contact_with(triangle, other, interior)
}
