//! Triangle against axis-aligned box: the verdict, the witness, and whether the
//! triangle is degenerate.

use septum::Axis;
use septum::published;
use septum::relation::{Relate, Relation};

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::{Case, GROUP_ORDERS, Sample, is_collinear, meets, separates};

/// `overlaps`, `may_overlap`, `separating_axis`, `is_separated_by`, `is_degenerate`; and that the
/// rounded methods terminate.
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
        assert_eq!(triangle.overlaps(&aabb), truth, "overlaps, {}", told::<S>(&case));
        let may = triangle.may_overlap(&aabb);
        assert!(may || !truth, "may_overlap, {}", told::<S>(&case));

        let is_disjoint = triangle.relation(&aabb) == Relation::Disjoint;
        assert_eq!(is_disjoint, !truth, "relation, {}", told::<S>(&case));

        let mut first = None;
        for axis in Axis::ALL {
            let truth = separates(&case, axis);
            let found = triangle.is_separated_by(&aabb, axis);
            assert_eq!(found, truth, "{axis:?}, {}", told::<S>(&case));
            first = first.or(truth.then_some(axis));
        }
        let found = triangle.separating_axis(&aabb);
        assert_eq!(found, first, "separating_axis, {}", told::<S>(&case));

        let flat = is_collinear(&case);
        assert_eq!(triangle.is_degenerate(), flat, "is_degenerate, {}", told::<S>(&case));

        let _ = published::shared_normal::overlaps(&triangle, &aabb);
        let published = published::akenine_moller::overlaps(&triangle, &aabb);
        for order in GROUP_ORDERS {
            let ordered = published::akenine_moller::overlaps_in(&triangle, &aabb, order);
            assert_eq!(ordered, published, "{order:?}, {}", told::<S>(&case));
        }
    }
}
