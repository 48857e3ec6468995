//! Plane against axis-aligned box.

use septum::Side;

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::{Given, Sample, side};

/// `side_of` and `overlaps`.
pub fn plane_aabb(data: &[u8]) {
    run::<PlaneAabb>(data);
}

struct PlaneAabb;

impl Check for PlaneAabb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let aabb = shapes.aabb();
        let given = match shapes.bytes.one_in(2) {
            true => Given::Point(shapes.point()),
            false => Given::Offset(shapes.number()),
        };
        let normal = shapes.point();
        let (Ok(plane), Ok(shape)) = (given.plane(normal), aabb.shape()) else {
            assert_eq!(normal, [S::ZERO; 3]);
            return;
        };
        let truth = side(normal, given, aabb);
        let told = || told::<S>(&(given, normal, aabb));
        assert_eq!(plane.side_of(&shape), truth, "side_of, {}", told());
        assert_eq!(plane.overlaps(&shape), truth == Side::Both, "overlaps, {}", told());
    }
}
