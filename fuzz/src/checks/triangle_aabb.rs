//! Triangle against axis-aligned box: the verdict, the witness, and whether the
//! triangle is degenerate.

use septum::{Axis, Order};

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::support::{Case, Sample, is_collinear, meets, separates};

/// `overlaps`, `may_overlap`, `separating_axis`, `is_separated_by`, `is_degenerate`; and
/// that the rounded methods come to an end.
pub fn triangle_aabb(data: &[u8]) {
    run::<TriangleAabb>(data);
}

struct TriangleAabb;

impl Check for TriangleAabb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let aabb = shapes.aabb();
        let case = Case { vertices: shapes.triangle(), aabb };
        let (triangle, aabb) = case.shapes();

        let truth = meets(&case);
        assert_eq!(triangle.overlaps(&aabb), truth, "overlaps, {}: {case:?}", S::name());
        let may = triangle.may_overlap(&aabb);
        assert!(may || !truth, "may_overlap, {}: {case:?}", S::name());

        let mut first = None;
        for axis in Axis::ALL {
            let truth = separates(&case, axis);
            let found = triangle.is_separated_by(&aabb, axis);
            assert_eq!(found, truth, "{axis:?}, {}: {case:?}", S::name());
            first = first.or(truth.then_some(axis));
        }
        let found = triangle.separating_axis(&aabb);
        assert_eq!(found, first, "separating_axis, {}: {case:?}", S::name());

        let flat = is_collinear(&case);
        assert_eq!(triangle.is_degenerate(), flat, "is_degenerate, {}: {case:?}", S::name());

        let _ = triangle.overlaps_rounded(&aabb);
        let published = triangle.overlaps_as_published(&aabb);
        for order in ORDERS {
            let ordered = triangle.overlaps_as_published_in(&aabb, order);
            assert_eq!(ordered, published, "{order:?}, {}: {case:?}", S::name());
        }
    }
}

const ORDERS: [Order; 5] = [
    Order::EdgesNormalFaces,
    Order::FacesEdgesNormal,
    Order::FacesNormalEdges,
    Order::NormalEdgesFaces,
    Order::NormalFacesEdges,
];
