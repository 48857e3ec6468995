//! Polygon against axis-aligned box: the triangles of the fan, and tests that avoid most triangles.
//!
//! D. Green, D. Hatch, "Fast Polygon-Cube Intersection Testing", *Graphics Gems V*, 1995, test
//! outcodes, then edges, then a diagonal of the box against the polygon. Here the outcodes of the
//! faces and the plane are tested for all vertices at once (`rows`). The triangles follow, each
//! exactly, beginning with the triangle onto which the centre of the box projects.
//!
//! There is no `Relate` for this pair. A flat box may lie along a diagonal that two triangles of
//! the fan share, and a bent fan has no clear interior.

mod rows;

use self::rows::{Survey, survey};
use super::Overlaps;
use crate::arithmetic::{Arithmetic, Number};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Polygon};

impl<S: Scalar> Overlaps<Aabb<S>> for Polygon<'_, S> {
    /// Do a polygon and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit. The polygon is the fan of its
    /// [`triangles`](Polygon::triangles), which equals the polygon if it is convex and planar. Its
    /// vertices may coincide or lie on one line. The box may be flat or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. A polygon of three vertices gets
    /// the answer of the triangle.
    ///
    /// *Range*: as for [triangle and box](crate::Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: on machines with vectors, 6 comparisons a vertex find a vertex in the box or a
    /// separating face; 9 multiplications and 3 a vertex test the plane; 3 a vertex choose the
    /// triangle to test first. If the polygon meets the box, usually no further triangle is tested.
    /// Without vectors, and for polygons that only a slanted axis separates, every triangle is
    /// tested.
    ///
    /// *Source*: outcodes are by Voorhies 1992; Green and Hatch 1995 test them first. The fan and
    /// its order are ours. The method as published is
    /// [`green_hatch`](crate::published::green_hatch::overlaps).
    ///
    /// ```
    /// use septum::polygon::Polygon;
    /// use septum::{Aabb, Vec3};
    ///
    /// let roof = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [4.0, 2.0, 4.0], [0.0, 2.0, 4.0]];
    /// let roof = roof.map(Vec3::from);
    /// let cell = Aabb::from_min_max([1.0, 1.0, 1.0], [2.0, 2.0, 3.0])?;
    /// assert!(Polygon::new(&roof)?.overlaps(&cell)); // along an edge of the cell
    ///
    /// let higher = roof.map(|v| Vec3::new(v.x, v.y, v.z + 4.0 * f64::EPSILON));
    /// assert!(!Polygon::new(&higher)?.overlaps(&cell));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        let mut first = 1;
        // A triangle has a faster test of its own.
        if S::IN_QUADS && self.vertices().len() > 3 {
            match survey(self.vertices(), aabb) {
                Survey::Meets => return true,
                Survey::Apart => return false,
                Survey::AskFirst(k) => first = k,
            }
        }
        let mut in_turn = self.triangles().skip(first - 1).chain(self.triangles().take(first - 1));
        in_turn.any(|triangle| triangle.overlaps(aabb))
    }
}

// The error of the computed distance between the plane of three vertices of a polygon and a corner
// of the box, seen from any vertex of the polygon, in units of u·R³.
//
// R is the greatest sum, over the axes, of the half-extent of the box and the extent of the
// polygon. If no face separates, every vertex is within R of the centre of the box, and no edge is
// longer than the extent. The steps and their operands are those of `triangle_aabb::error_bound`.
// `error_bound.g` proves [`PLANE`].

/// Roundoffs in the distance.
const PLANE: u16 = 64;

/// The bound for shapes of this size; `None` if the size is out of range.
#[inline(always)]
fn error_bound<N: Arithmetic>(size: N::Length) -> Option<N::Volume> {
    size.in_range().then(|| N::volume(N::area(size, size), size).error(PLANE))
}
