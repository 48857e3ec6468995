//! Polygons and boxes: an oracle that clips the polygon's triangles; and for convex planar polygons
//! one that clips the polygon itself.

mod plane;
mod sets;

pub use plane::PlanePolygon;
pub use sets::PolygonSet;

use septum::Vec3;
use septum::polygon::Polygon;

use super::case::{BoxNumbers, Case};
use super::oracle::meets;
use super::sample::Sample;

/// A polygon and a box.
#[derive(Clone, Debug, PartialEq)]
pub struct PolygonCase<S> {
    pub vertices: Vec<[S; 3]>,
    pub aabb: BoxNumbers<S>,
}

impl<S: Sample> PolygonCase<S> {
    /// Whether one of the triangles of vertices 0, k and k + 1 meets the box.
    pub fn meets(&self) -> bool {
        let [first, rest @ ..] = self.vertices.as_slice() else { return false };
        let triangle = |edge: &[[S; 3]]| [*first, edge[0], edge[1]];
        rest.windows(2).any(|edge| meets(&Case { vertices: triangle(edge), aabb: self.aabb }))
    }

    /// The crate's answers, in either order and in both modes.
    pub fn answers(&self) -> [bool; 4] {
        let vertices: Vec<_> = self.vertices.iter().map(|v| Vec3::from(*v)).collect();
        let polygon = Polygon::new(&vertices).expect("three finite vertices or more");
        let aabb = self.aabb.shape().expect("a valid box");
        [
            polygon.overlaps(&aabb),
            aabb.overlaps(&polygon),
            polygon.may_overlap(&aabb),
            aabb.may_overlap(&polygon),
        ]
    }

    /// Whether they meet. Panics if the crate's answer differs.
    pub fn check(&self) -> bool {
        let truth = self.meets();
        assert_eq!(self.answers(), [truth; 4], "{}: {self:?}", S::name());
        truth
    }
}
