//! Spheres and capsules that overlap triangles and boxes: the minimum translation and the point.

use crate::scalars::{Check, run};
use crate::shapes::{Shapes, magnitude};
use septum_kit::Sample;
use septum_kit::spheres::{CapsuleCase, Other};

/// Checks whether there is a contact, its depth, that its vector separates, and where its point is.
pub fn round_contacts(data: &[u8]) {
    run::<RoundContacts>(data);
}

struct RoundContacts;

impl Check for RoundContacts {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let other = match shapes.bytes.one_in(2) {
            true => Other::Triangle(shapes.triangle()),
            false => Other::Box(shapes.aabb()),
        };
        let (a, b) = (shapes.point(), shapes.point());
        let radius = magnitude(shapes.number());
        // A sphere is also a capsule whose ends are equal.
        for ends in [[a, b], [a, a]] {
            let _ = CapsuleCase { ends, radius, other }.check_contacts();
        }
    }
}
