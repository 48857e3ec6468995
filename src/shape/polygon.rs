use super::overlaps::overlaps_methods;
use super::{ShapeError, Triangle, Vec3};
use crate::scalar::Scalar;

/// A polygon in the caller's memory: the fan of triangles from its first vertex, a closed set.
///
/// The fan is the union of the triangles of vertices 0, k and k + 1. A convex polygon in one plane
/// is its fan, whichever vertex comes first. So is a concave one whose first vertex sees all of it;
/// of others the fan is more than the polygon.
///
/// Points of a plane, rounded, seldom lie in one plane again. Their fan is a surface that is bent a
/// little along its diagonals. It has the edges of the polygon exactly, so that nothing is lost
/// between polygons that share an edge. It is what a renderer draws that splits polygons likewise.
/// Vertices may coincide or lie on one line.
///
/// ```
/// use septum::Aabb;
/// use septum::polygon::Polygon;
///
/// let corners = [[0.0, -9.0, 3.0], [9.0, 0.0, 3.0], [0.0, 9.0, 3.0], [-9.0, 0.0, 3.0]];
/// let corners = corners.map(septum::Vec3::from);
/// let floor = Polygon::new(&corners)?;
/// let cell = Aabb::from_min_max([4.0, 4.0, 2.0], [5.0, 5.0, 3.0])?;
/// assert!(floor.overlaps(&cell)); // its top face touches the floor
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Polygon<'a, S> {
    pub(super) vertices: &'a [Vec3<S>],
}

impl<'a, S: Scalar> Polygon<'a, S> {
    /// The polygon with these vertices, in the order in which they go round.
    ///
    /// Whether it is convex and lies in one plane is not asked: the [fan](Polygon) is a set anyway,
    /// and rounding would make a refusal of the best of polygons.
    ///
    /// # Errors
    /// [`ShapeError::TooFewVertices`] where there are fewer than three,
    /// [`ShapeError::NotFinite`] where a coordinate is NaN or infinite.
    #[inline]
    pub fn new(vertices: &'a [Vec3<S>]) -> Result<Self, ShapeError> {
        if vertices.len() < 3 {
            return Err(ShapeError::TooFewVertices);
        }
        let are_finite = vertices.iter().all(|v| v.is_finite());
        are_finite.then_some(Self { vertices }).ok_or(ShapeError::NotFinite)
    }
}

overlaps_methods!(Polygon<'_>, "an [`Aabb`](crate::Aabb)");

impl<'a, S: Scalar> Polygon<'a, S> {
    /// The vertices, in the order given.
    #[inline]
    #[must_use]
    pub const fn vertices(&self) -> &'a [Vec3<S>] {
        self.vertices
    }

    /// The triangles that make up the polygon, of vertices 0, k and k + 1: two fewer than it has
    /// vertices.
    ///
    /// What can be asked about triangles alone is asked about these.
    #[inline]
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = Triangle<S>> + use<'a, S> {
        // There is one; without an index there is no panic to link.
        let first = self.vertices.first().copied().unwrap_or_default();
        let edges = self.vertices.windows(2).skip(1);
        edges.map(move |edge| Triangle::unchecked([first, edge[0], edge[1]]))
    }
}
