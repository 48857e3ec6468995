//! Polygon against axis-aligned box.

use septum::Vec3;
use septum::polygon::Polygon;
use septum::published;

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::Sample;
use septum_kit::polygons::PolygonCase;

/// `overlaps` and `may_overlap`, in either order; and that the rounded method terminates.
pub fn polygon_aabb(data: &[u8]) {
    run::<PolygonAabb>(data);
}

struct PolygonAabb;

impl Check for PolygonAabb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let aabb = shapes.aabb();
        let count = 3 + shapes.bytes.below(8);
        let case = PolygonCase { vertices: (0..count).map(|_| shapes.point()).collect(), aabb };

        assert_eq!(case.answers(), [case.meets(); 4], "{}", told::<S>(&case));
        let vertices: Vec<_> = case.vertices.iter().map(|v| Vec3::from(*v)).collect();
        let polygon = Polygon::new(&vertices).expect("three vertices or more");
        let aabb = case.aabb.shape().expect("a box");
        let _ = published::green_hatch::overlaps(&polygon, &aabb);
    }
}
