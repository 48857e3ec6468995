//! Triangles, segments and points against triangles.

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::Sample;
use septum_kit::flat::{Flat, FlatCase, Truth};

/// `overlaps`, in either order, and `may_overlap`; for points `contains`; `crossing` of triangles.
pub fn flat_shapes(data: &[u8]) {
    run::<FlatShapes>(data);
}

struct FlatShapes;

impl Check for FlatShapes {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let triangle = shapes.triangle();
        let flat = match shapes.bytes.below(6) {
            0 => Flat::Ends([shapes.point(), shapes.point()]),
            1 => Flat::Center(shapes.point(), shapes.point()),
            2 => Flat::Point(shapes.point()),
            _ => Flat::Triangle(shapes.triangle()),
        };
        let case = FlatCase { flat, triangle };

        let truth = case.truth();
        let meets = truth != Truth::Apart;
        let (answers, may) = case.answers();
        assert_eq!(answers, vec![meets; answers.len()], "{}", told::<S>(&case));
        assert!(may || !meets, "may_overlap, {}", told::<S>(&case));
        if let Some(relation) = case.relation() {
            assert_eq!(relation, truth.relation(), "relation, {}", told::<S>(&case));
        }
        case.check_crossing();
    }
}
