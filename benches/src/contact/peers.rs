//! The peers, in `f32`: each tells the depth, if there is a contact.

use std::cell::RefCell;

use parry3d::query::details::contact_manifold_cuboid_cuboid;
use parry3d::query::{self, ContactManifold};
use septum::Obb;

use super::Sunk;
use crate::candidate::{Candidate, Course, Promise};
use crate::obb_obb::{Placed, placed};

thread_local! {
    // As engines keep it: its memory serves one pair after the other.
    static MANIFOLD: RefCell<ContactManifold<(), ()>> = RefCell::default();
}

/// parry3d's `contact`: one point.
#[must_use]
pub fn of_contact(first: &Placed, second: &Placed) -> Option<f64> {
    let found = query::contact(&first.pose, &first.cuboid, &second.pose, &second.cuboid, 0.0);
    found.ok().flatten().map(|c| -f64::from(c.dist))
}

/// parry3d's manifold: all points, and the depth of the deepest.
#[must_use]
pub fn of_manifold(first: &Placed, second: &Placed) -> Option<f64> {
    MANIFOLD.with_borrow_mut(|manifold| {
        // Nothing remains of the last pair.
        manifold.clear();
        let between = first.pose.inv_mul(&second.pose);
        contact_manifold_cuboid_cuboid(&between, &first.cuboid, &second.cuboid, 0.0, manifold);
        let deepest = manifold.points.iter().map(|p| -p.dist).reduce(f32::max);
        deepest.map(f64::from)
    })
}

impl<T> Sunk<T> {
    /// Touching is no contact here.
    pub(crate) fn is_told_by(&self, ask: impl Fn(&T, &T) -> Option<f64>) -> bool {
        let [first, second] = &self.pair;
        self.is_right(ask(first, second).filter(|depth| *depth > 0.0), 0.0)
    }
}

#[inline(never)]
fn contact(sunk: &Sunk<Placed>, _: &()) -> bool {
    sunk.is_told_by(of_contact)
}

#[inline(never)]
fn manifold(sunk: &Sunk<Placed>, _: &()) -> bool {
    sunk.is_told_by(of_manifold)
}

/// Our shapes.
type Ours = Course<Sunk<Obb<f32>>, ()>;

/// The shapes in a peer's form.
pub(crate) fn in_form<T: 'static>(course: &Ours, form: fn(&Obb<f32>) -> T) -> Course<Sunk<T>, ()> {
    let sunk =
        |sunk: &Sunk<Obb<f32>>| Sunk { pair: sunk.pair.each_ref().map(form), depth: sunk.depth };
    course.prepared("", |pairs| pairs.map(sunk, |()| ()))
}

pub(crate) fn parry_contact(course: &Ours) -> Candidate {
    in_form(course, placed).candidate("parry3d contact", Promise::Nothing, contact)
}

pub(crate) fn parry_manifold(course: &Ours, who: &str) -> Candidate {
    in_form(course, placed).candidate(who, Promise::Nothing, manifold)
}
