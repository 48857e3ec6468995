//! Polygon against axis-aligned box: the fan of its triangles, and what saves asking all of them.
//!
//! D. Green, D. Hatch, "Fast Polygon-Cube Intersection Testing", *Graphics Gems V*, 1995: outcodes,
//! edges, and a diagonal of the box against the inside. Here the outcodes of the faces, and the
//! plane, are asked of all vertices at once (`rows`); then triangles, each exactly, beginning with
//! the one that the centre of the box lies over.
//!
//! There is no relation: touching would have to be told from overlapping where a flat box lies
//! along a side that two triangles of the fan share, and what is bent has no interior to speak of.

mod error_bound;
mod rows;

use self::rows::{Survey, survey};
use super::Overlaps;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Polygon};

impl<S: Scalar> Overlaps<Aabb<S>> for Polygon<'_, S> {
    /// Whether a polygon and an axis-aligned box have a point in common.
    ///
    /// *Geometry*: closed sets in one frame and unit. The polygon is the fan of its
    /// [`triangles`](Polygon::triangles), which is the polygon itself if it is convex and lies in
    /// one plane; its vertices may coincide or lie on one line. The box may be flat or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar; of three vertices it is the answer
    /// for the triangle.
    ///
    /// *Range*: as of
    /// [triangle and box](crate::Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: with vectors, 6 comparisons a vertex say whether one of them is in the box, or a
    /// face separates; 9 multiplications and 3 a vertex, whether the plane does; 3 a vertex, which
    /// triangle to ask first. Of those that meet the box it is nearly always the only one. Without
    /// vectors, and of polygons that a slanted axis separates, all are asked.
    ///
    /// *Source*: outcodes by Voorhies 1992, before the rest, by Green and Hatch 1995; the fan and
    /// its order are ours. As published it is
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
        // A triangle knows best itself.
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
