//! A character controller: a capsule that walks a mesh, up and down steps and over gentle slopes.
//!
//! Each step goes up, forward and down: up by the greatest riser, so that it climbs steps; down in
//! parts of its radius until it stands on ground that is not too steep. Gentle ground pushes the capsule
//! straight up, so that it never slides; steep ground pushes it away. A step that would end on a
//! steep slope or over a ledge is not taken. All numbers are I16F16.

use fixed::types::I16F16;
use septum::contact::{Contact, InteriorEdges};
use septum::mesh::Tree;
use septum::{Capsule, Segment, Vec3};

/// The radius, and the length of the segment, upright.
const RADIUS: I16F16 = I16F16::lit("0.25");
const HEIGHT: I16F16 = I16F16::lit("0.75");
/// The length of a step.
pub(crate) const STEP: I16F16 = I16F16::lit("0.125");
/// The greatest riser, up or down.
const RISER: I16F16 = I16F16::lit("0.3125");
/// By how much it sinks at once: less than its radius, so that no ground is passed.
const SINK: I16F16 = I16F16::lit("0.0625");
/// The least y of the normal of gentle ground: slopes of up to 53°, and edges of steps that are nearer
/// to the axis than 0.8 times the radius. So a step of half the radius, straight on, mounts a riser.
const GENTLE: I16F16 = I16F16::lit("0.6");
/// The rounds in which contacts are resolved, the deepest contact in each.
const ROUNDS: usize = 8;

type Point = [I16F16; 3];

/// The ground, with the interior edges, which must not catch the capsule.
pub(crate) struct Ground<'a> {
    pub(crate) tree: Tree<'a, I16F16, u16>,
    pub(crate) interior: &'a [InteriorEdges],
}

/// What the ground does to a capsule.
enum Footing {
    /// It stands, at this place of its lower end.
    Stands(Point),
    /// It stands on nothing, or on steep ground only.
    Falls(Point),
    /// It is stuck.
    Stuck,
}

/// A capsule with its lower end at a place, which stands on the ground.
#[derive(Clone, Copy)]
pub(crate) struct Walker {
    pub(crate) at: Point,
}

fn plus(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn higher([x, y, z]: Point, by: I16F16) -> Point {
    [x, y + by, z]
}

impl Ground<'_> {
    /// The deepest contact of the capsule; the first of equals.
    fn deepest(&self, at: Point) -> Option<Contact<I16F16>> {
        let capsule = Capsule::new(at, higher(at, HEIGHT), RADIUS).ok()?;
        let all = self.tree.contacts(&capsule, self.interior).ok()?;
        let deeper = |best: Contact<I16F16>, new: Contact<I16F16>| {
            if new.translation.depth > best.translation.depth { new } else { best }
        };
        all.map(|(_, contact)| contact).reduce(deeper)
    }

    /// Moves the capsule out of the ground.
    fn settle(&self, mut at: Point) -> Footing {
        let mut stands = false;
        for _ in 0..ROUNDS {
            let Some(contact) = self.deepest(at) else {
                return if stands { Footing::Stands(at) } else { Footing::Falls(at) };
            };
            // The triangle is the first shape: the capsule moves against the vector.
            let out = contact.translation;
            let up = -out.normal.y;
            if up >= GENTLE {
                // A unit more, because the quotient is rounded down.
                at = higher(at, out.depth / up + I16F16::DELTA);
                stands = true;
            } else {
                let [x, y, z] = out.vector.to_array();
                at = plus(at, [-x, -y, -z]);
            }
        }
        Footing::Stuck
    }

    /// Lets the capsule down until it stands, by no more than `most`.
    fn lower(&self, mut at: Point, most: I16F16) -> Option<Point> {
        let lowest = at[1] - most;
        while at[1] > lowest {
            at = match self.settle(higher(at, -SINK)) {
                Footing::Stands(at) => return Some(at),
                Footing::Falls(next) if next[1] < at[1] => next,
                _ => return None,
            };
        }
        None
    }
}

impl Walker {
    /// A capsule that is let down from a place.
    pub(crate) fn new(ground: &Ground<'_>, from: Point) -> Option<Self> {
        Some(Self { at: ground.lower(from, I16F16::lit("64"))? })
    }

    /// Takes a step in a direction, a unit vector across the ground. `false` if there is no footing.
    pub(crate) fn step(&mut self, ground: &Ground<'_>, [x, z]: [I16F16; 2]) -> bool {
        let raised = higher(plus(self.at, [x * STEP, I16F16::ZERO, z * STEP]), RISER);
        let (Footing::Falls(raised) | Footing::Stands(raised)) = ground.settle(raised) else {
            return false;
        };
        let stands = ground.lower(raised, RISER + RISER);
        if let Some(at) = stands {
            self.at = at;
        }
        stands.is_some()
    }

    /// Whether the axis of the capsule is clear of the ground.
    pub(crate) fn is_free(&self, ground: &Ground<'_>) -> bool {
        let top = Vec3::from(higher(self.at, HEIGHT));
        let axis = Segment::new(Vec3::from(self.at), top);
        axis.is_ok_and(|axis| ground.tree.overlapping(&axis).next().is_none())
    }
}
