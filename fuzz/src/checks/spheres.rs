//! Sphere and capsule against triangle, segment, ray, axis-aligned box, capsule and sphere.

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::Sample;
use septum_kit::spheres::{CapsuleCase, Other, SphereCase};

/// `overlaps`, `relation`, `contains` and `distance_squared`.
pub fn spheres(data: &[u8]) {
    run::<Spheres>(data);
}

struct Spheres;

impl Check for Spheres {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let (center, radius) = (shapes.point(), shapes.number());
        let other = match shapes.bytes.one_in(2) {
            true => Other::Triangle([shapes.point(), shapes.point(), shapes.point()]),
            false if shapes.bytes.one_in(2) => Other::Box(shapes.aabb()),
            false if shapes.bytes.one_in(2) => Other::Ends([shapes.point(), shapes.point()]),
            false if shapes.bytes.one_in(2) => Other::Center(shapes.point(), shapes.point()),
            false if shapes.bytes.one_in(2) => Other::Capsule([center, shapes.point()], radius),
            false => Other::Sphere(shapes.point(), radius),
        };
        if radius < S::ZERO {
            return;
        }
        let ends = [center, shapes.point()];
        let case = CapsuleCase { ends, radius, other };
        let is_right = case.answers().check(case.truth(), case.relation());
        assert!(is_right, "{}", told::<S>(&case));
        if ends[1] != [S::ZERO; 3] {
            let other = Other::Ray([shapes.point(), ends[1]], [Some(radius), None]);
            let case = SphereCase { center, radius, other };
            let is_right = case.answers().check(case.truth(), case.relation());
            assert!(is_right, "{}", told::<S>(&case));
            let case = CapsuleCase { ends, radius, other };
            let is_right = case.answers().check(case.truth(), case.relation());
            assert!(is_right, "{}", told::<S>(&case));
        }
        let case = SphereCase { center, radius, other };
        let is_right = case.answers().check(case.truth(), case.relation());
        assert!(is_right, "{}", told::<S>(&case));
        let is_rounded = case.distance_squared().is_none_or(|(_, is_rounded)| is_rounded);
        assert!(is_rounded, "{}", told::<S>(&case));
    }
}
