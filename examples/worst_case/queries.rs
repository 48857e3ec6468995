//! The queries, and their lines of output.

use core::hint::black_box;

use fixed::types::I16F16;
use septum::HitRules;
use septum::contact::contact;
use septum::relation::{Relate, Relation};
use septum::sweep::Sweep;

use crate::CORE;
use crate::cases::{
    capsule, ray_aabb, ray_obb, ray_triangle, segment_aabb, segment_obb, sphere, sphere_sweep,
    sweep, triangle_aabb, triangle_obb,
};
use crate::draw::{Draw, Path, Raw, Rng};
use crate::firmware::say;
use crate::meter::{Ask, Meter, Taken};

/// The number of pairs of shapes in a path.
const CASES: usize = 4096;
/// No further cases run after this many instructions.
const ENOUGH: u64 = 30_000_000;
/// The number of bits of coordinates, without the sign, for near shapes.
const NEAR: u32 = 17;

const AABB: &str = "triangle/box";
const OBB: &str = "triangle/oriented box";
const IS_HIT: &str = "ray/triangle is_hit";
const HIT: &str = "ray/triangle hit";
const SPHERE: &str = "sphere/triangle";
const CAPSULE: &str = "capsule/triangle";
const RELATION: &str = "triangle/box relation";
const MEETS_ALONG: &str = "triangle/box meets_along";
const FIRST_CONTACT: &str = "triangle/box first_contact";
/// The slowest rules: a hit on an edge takes further tests.
const ONCE: HitRules = HitRules::new().once();

/// Cases as shapes near the origin; `None` if they are not.
macro_rules! near {
    ($cases:expr) => {
        |draw: &mut Draw| {
            let (one, other) = $cases(draw)?;
            Some((one.near().ok()?, other.near().ok()?))
        }
    };
}

/// Shapes that were checked to be near.
pub(crate) fn near(meter: &Meter) {
    type S = I16F16;
    let aabb = near!(triangle_aabb::<S>);
    let obb = near!(triangle_obb::<S>);
    let ray = near!(ray_triangle::<S>);
    let moving = |draw: &mut Draw| {
        let ((triangle, motion), aabb) = sweep::<S>(draw)?;
        Some((triangle.near().ok()?.moving(motion).ok()?, aabb.near().ok()?))
    };
    let lines = Lines { meter, scalar: S::NAME, reach: "near", most: NEAR };
    lines.say(AABB, aabb, |t, b| t.overlaps(b));
    lines.say(OBB, obb, |t, b| t.overlaps(b));
    lines.say(IS_HIT, ray, |r, t| r.is_hit_with(t, ONCE));
    lines.say(HIT, ray, |r, t| black_box(r.hit_with(t, ONCE)).is_some());
    lines.say(SPHERE, near!(sphere::<S>), |t, b| t.overlaps(b));
    lines.say(CAPSULE, near!(capsule::<S>), |t, b| t.overlaps(b));
    lines.say(RELATION, aabb, |t, b| t.relation(b) != Relation::Disjoint);
    lines.say(MEETS_ALONG, moving, |t, b| t.meets(b));
    lines.say(FIRST_CONTACT, moving, |t, b| black_box(t.first_contact(b)).is_some());
    lines.say("triangle/box relation_along", moving, |t, b| {
        t.relation_along(b) != Relation::Disjoint
    });
    lines.say("triangle/box last_free", moving, |t, b| black_box(t.last_free(b)).is_some());
    lines.say("ray/box", near!(ray_aabb::<S>), |r, b| r.overlaps(b));
    lines.say("segment/box", near!(segment_aabb::<S>), |s, b| s.overlaps(b));
    lines.say("ray/oriented box", near!(ray_obb::<S>), |r, b| r.overlaps(b));
    lines.say("segment/oriented box", near!(segment_obb::<S>), |s, b| s.overlaps(b));
}

/// Shapes anywhere.
pub(crate) fn any<S: Raw>(meter: &Meter) {
    let lines = Lines { meter, scalar: S::NAME, reach: "any", most: S::BITS - 1 };
    lines.say(AABB, triangle_aabb::<S>, |t, b| t.overlaps(b));
    lines.say(OBB, triangle_obb::<S>, |t, b| t.overlaps(b));
    lines.say(IS_HIT, ray_triangle::<S>, |r, t| r.is_hit_with(t, ONCE));
    lines.say(HIT, ray_triangle::<S>, |r, t| black_box(r.hit_with(t, ONCE)).is_some());
}

/// Longer queries, in one scalar.
pub(crate) fn longer(meter: &Meter) {
    type S = I16F16;
    let lines = Lines { meter, scalar: S::NAME, reach: "any", most: S::BITS - 1 };
    lines.say(RELATION, triangle_aabb::<S>, |t, b| t.relation(b) != Relation::Disjoint);
    lines.say("triangle/oriented box relation", triangle_obb::<S>, |t, b| {
        t.relation(b) != Relation::Disjoint
    });
    lines.say(MEETS_ALONG, sweep::<S>, |(t, m), b| t.meets_along(m, b));
    lines.say(FIRST_CONTACT, sweep::<S>, |(t, m), b| black_box(t.first_contact(m, b)).is_some());
    lines
        .say("triangle/box contact", triangle_aabb::<S>, |t, b| black_box(contact(t, b)).is_some());
    lines.say(SPHERE, sphere::<S>, |t, b| t.overlaps(b));
    lines.say(CAPSULE, capsule::<S>, |t, b| t.overlaps(b));
    lines.say("triangle closest point", sphere::<S>, |t, b| {
        black_box(t.closest_point(b.center())).is_ok()
    });
    lines.say("sphere/triangle first_contact", sphere_sweep::<S>, |t, (b, m)| {
        black_box(b.first_contact(m, t)).is_some()
    });
}

struct Lines<'a> {
    meter: &'a Meter,
    scalar: &'static str,
    reach: &'static str,
    most: u32,
}

impl Lines<'_> {
    /// Prints, for each path, the most instructions of the query.
    fn say<A, B>(&self, query: &str, shapes: fn(&mut Draw) -> Option<(A, B)>, ask: Ask<A, B>) {
        let Self { meter, scalar, reach, most } = *self;
        for path in Path::ALL {
            let mut draw = Draw { rng: Rng::new(), path, most };
            let (mut instructions, mut taken) = (0, Taken::default());
            for pair in (0..CASES).filter_map(|_| shapes(&mut draw)) {
                let before = taken.total();
                meter.add(&mut taken, &[pair], ask);
                instructions = (taken.total() - before).max(instructions);
                if taken.total() > ENOUGH {
                    break;
                }
            }
            let (path, stack) = (path.name(), taken.stack() as u32);
            say!("{},{},{},{},{},{},{}", CORE, query, scalar, reach, path, instructions, stack);
        }
    }
}
