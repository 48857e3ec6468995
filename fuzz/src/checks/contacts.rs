//! Overlapping shapes: the minimum translation.

use super::oriented_pairs::obb;
use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use septum_kit::Sample;
use septum_kit::boxes::AnyBox;
use septum_kit::contacts::{ContactCase, Solid};

/// Checks whether there is a contact, and the minimum depth over all axes.
pub fn contacts(data: &[u8]) {
    run::<Contacts>(data);
}

struct Contacts;

fn solid<S: Sample>(shapes: &mut Shapes<'_, S>) -> Solid<S> {
    match shapes.bytes.below(3) {
        0 => Solid::Triangle(shapes.triangle()),
        1 => Solid::Box(AnyBox::Aabb(shapes.aabb())),
        _ => Solid::Box(AnyBox::Obb(obb(shapes))),
    }
}

impl Check for Contacts {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let (first, second) = (solid(shapes), solid(shapes));
        // Without linear programming, because numbers may have any size.
        let _ = ContactCase { first, second }.check(false);
    }
}
