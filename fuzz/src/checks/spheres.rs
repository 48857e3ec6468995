//! Sphere and capsule against triangle, segment, ray, boxes, capsule and sphere; sphere that moves past
//! triangle and box.

use crate::scalars::{Check, run};
use crate::shapes::{Shapes, magnitude};
use crate::told::told;
use septum::Obb;
use septum_kit::Sample;
use septum_kit::spheres::{CapsuleCase, Other, Point, SphereCase, SphereSweep};

/// `overlaps`, `relation`, `contains`, `distance_squared`, where a ray enters, and the sweeps.
pub fn spheres(data: &[u8]) {
    run::<Spheres>(data);
}

struct Spheres;

/// Checks a sphere and a capsule, which begins at its centre.
fn check<S: Sample>(ends: [Point<S>; 2], radius: S, other: Other<S>) {
    let case = CapsuleCase { ends, radius, other };
    let is_right = case.answers().check(case.truth(), case.relation());
    assert!(is_right, "{}", told::<S>(&case));
    let case = SphereCase { center: ends[0], radius, other };
    let is_right = case.answers().check(case.truth(), case.relation());
    assert!(is_right, "{}", told::<S>(&case));
    let is_rounded = case.distance_squared().is_none_or(|(_, is_rounded)| is_rounded);
    assert!(is_rounded, "{}", told::<S>(&case));
}

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
        check(ends, radius, other);
        if ends[1] != [S::ZERO; 3] {
            let ray = Other::Ray([shapes.point(), ends[1]], [Some(radius), None]);
            check(ends, radius, ray);
            let case = SphereCase { center, radius, other: ray };
            assert!(case.check_range().is_none_or(|x| x.is_ok()), "{}", told::<S>(&case));
            let case = CapsuleCase { ends, radius, other: ray };
            assert!(case.check_range().is_none_or(|x| x.is_ok()), "{}", told::<S>(&case));
        }
        if matches!(other, Other::Triangle(_) | Other::Box(_)) {
            SphereSweep { center, radius, way: ends, other }.check();
        }
        let (axes, half) = ([(); 3].map(|()| shapes.point()), shapes.point().map(magnitude));
        if Obb::from_skewed_axes(ends[1], axes, half).is_ok() {
            check(ends, radius, Other::Obb(ends[1], axes, half));
        }
    }
}
