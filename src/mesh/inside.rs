//! Whether a closed mesh contains a point.

use super::node::Cell;
use super::walk::Walk;
use super::{Index, Tree};
use crate::query::crossing;
use crate::scalar::Scalar;
use crate::shape::Vec3;

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// Does the closed mesh contain a point, inside it or on a triangle?
    ///
    /// *Geometry*: a point is inside if a ray from it crosses the mesh an odd number of times
    /// (even-odd rule). The orientation of triangles does not matter. By this rule the overlap of
    /// two parts of the mesh is outside; use [`winding`](Self::winding) there, if the triangles are
    /// oriented consistently. For a mesh that is not closed
    /// ([`Mesh::check_closed`](super::Mesh::check_closed)) the answer counts the crossings of the
    /// ray along the positive x axis.
    ///
    /// *Contact*: the surface belongs to the inside. A point with a NaN or infinite coordinate is
    /// not contained.
    ///
    /// *Numerics*: exact for every valid input, in every scalar, also for points or rays on faces,
    /// edges and vertices. *Panics*: never.
    ///
    /// *Cost*: 5 integer comparisons for each box along the ray; for each triangle there two planar
    /// areas, and a volume if the triangle extends from before the point to behind it.
    ///
    /// *Source*: crossings are counted as in M. Shimrat, "Algorithm 112: Position of Point Relative
    /// to Polygon", *Communications of the ACM* 5(8), 1962, in the projection along the ray.
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        self.winding(point).is_none_or(|winding| winding % 2 != 0)
    }

    /// The winding number of a closed mesh about a point: how many times the mesh encloses it.
    /// `None` for a point on a triangle.
    ///
    /// Use it for meshes whose triangles are oriented consistently, counterclockwise seen from
    /// outside. Overlapping parts each add 1, so every point with a number other than 0 is inside
    /// some part. A part that is turned inside out adds −1.
    ///
    /// *Numerics*, *Panics*, *Cost*: as [`contains`](Self::contains). A point with a NaN or
    /// infinite coordinate has winding number 0.
    #[must_use]
    pub fn winding(&self, point: impl Into<Vec3<S>>) -> Option<i32> {
        let p: Vec3<S> = point.into();
        if !p.is_finite() {
            return Some(0);
        }
        let p = p.to_array();
        let Cell { low, high } = self.grid.cell([p, p]);
        let row = Cell { low, high: [u16::MAX, high[1], high[2]] };
        let mut winding = 0;
        let mut walk = Walk::new(self.nodes, |root| root.meeting(&row));
        while let Some(leaf) = walk.next(self.nodes, &self.layout, |node| node.meeting(&row)) {
            for place in leaf {
                let triangle = self.mesh.known(self.index(place));
                if triangle.contains(p) {
                    return None;
                }
                winding += crossing(p, &triangle);
            }
        }
        Some(winding)
    }
}
