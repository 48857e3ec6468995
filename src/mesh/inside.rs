//! Whether a closed mesh contains a point.

use super::node::Cell;
use super::walk::Walk;
use super::{Index, Tree};
use crate::query::crossing;
use crate::scalar::Scalar;
use crate::shape::Vec3;

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// Whether a closed mesh contains a point: it lies inside, or on a triangle.
    ///
    /// *Geometry*: inside is where any way out crosses the mesh an odd number of times. The
    /// triangles' orientation does not matter. So where two parts of the mesh overlap is
    /// outside; [`winding`](Self::winding) tells more, if they are oriented alike. Of a mesh
    /// that is not closed ([`Mesh::check_closed`](super::Mesh::check_closed)) the answer is
    /// about the way along the first axis.
    ///
    /// *Contact*: the mesh belongs to its inside. A point with a coordinate that is NaN or
    /// infinite is not contained.
    ///
    /// *Numerics*: exact for every valid input, in every scalar; on faces, edges and vertices
    /// too. *Panics*: never.
    ///
    /// *Cost*: for each box in the row of the point 5 comparisons of integers; for a triangle
    /// there two areas of a plane, and a volume if it reaches from before the point to behind
    /// it.
    ///
    /// *Source*: crossings are counted as by M. Shimrat, "Algorithm 112: Position of Point
    /// Relative to Polygon", *Communications of the ACM* 5(8), 1962, seen along the row.
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        self.winding(point).is_none_or(|winding| winding % 2 != 0)
    }

    /// The winding number of a closed mesh about a point, `None` for a point on a triangle:
    /// how many times the mesh encloses it, turned inside out if negative.
    ///
    /// It is of use where triangles are oriented alike, counterclockwise seen from outside: of
    /// parts that overlap each counts, so that all but zero is inside of one.
    ///
    /// *Numerics*, *Panics*, *Cost*: as [`contains`](Self::contains). A point with a coordinate
    /// that is NaN or infinite has winding number 0.
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
