use super::overlaps::overlaps_methods;
use super::{ShapeError, Triangle, Vec3};
use crate::scalar::Scalar;

/// A polygon in the caller's memory: the fan of triangles from its first vertex, a closed set.
///
/// The fan is the union of the triangles (0, k, k + 1). A convex polygon in one plane equals its
/// fan, whichever vertex comes first. A concave polygon equals its fan if the first vertex sees all
/// of it; otherwise the fan covers more than the polygon.
///
/// Rounded vertices seldom lie in exactly one plane. Their fan is a surface slightly bent along its
/// diagonals. Its boundary is exactly the polygon's edges, so polygons that share an edge leave no
/// gap. A renderer that splits polygons into fans draws the same surface. Vertices may coincide or
/// lie on one line.
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
#[doc(alias = "convex polygon")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Polygon<'a, S> {
    pub(super) vertices: &'a [Vec3<S>],
}

impl<'a, S: Scalar> Polygon<'a, S> {
    /// A polygon with these vertices, in their order around it.
    ///
    /// The constructor does not check that the polygon is convex or planar: the [fan](Polygon) is
    /// well defined in any case, and rounding makes almost every planar polygon slightly
    /// non-planar.
    ///
    /// # Errors
    /// [`ShapeError::TooFewVertices`] if there are fewer than three, [`ShapeError::NotFinite`] if a
    /// coordinate is NaN or infinite.
    #[inline]
    pub fn new(vertices: &'a [Vec3<S>]) -> Result<Self, ShapeError> {
        if vertices.len() < 3 {
            return Err(ShapeError::TooFewVertices);
        }
        match vertices.iter().position(|v| !v.is_finite()) {
            None => Ok(Self { vertices }),
            index => Err(ShapeError::NotFinite { argument: "vertices", index }),
        }
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

    /// The triangles (0, k, k + 1) of the fan: two fewer than the polygon has vertices.
    ///
    /// Use them for queries that take triangles only.
    #[inline]
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = Triangle<S>> + use<'a, S> {
        // `new` made sure that there is one; `unwrap_or_default` links no panic, as an index
        // would.
        let first = self.vertices.first().copied().unwrap_or_default();
        let edges = self.vertices.windows(2).skip(1);
        edges.map(move |edge| Triangle::unchecked([first, edge[0], edge[1]]))
    }
}
