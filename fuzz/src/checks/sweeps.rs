//! A triangle moving past a box, and a box moving past a box.

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use septum_kit::sweeps::{BoxSweep, SweepCase};
use septum_kit::{Case, Sample};

/// `meets_along` and `first_contact`, from either shape.
pub fn sweeps(data: &[u8]) {
    run::<Sweeps>(data);
}

struct Sweeps;

impl Check for Sweeps {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let case = Case { vertices: shapes.triangle(), aabb: shapes.aabb() };
        let way = [shapes.point(), shapes.point()];
        SweepCase { case, way }.check();
        BoxSweep { boxes: [case.aabb, shapes.aabb()], way }.check();
    }
}
