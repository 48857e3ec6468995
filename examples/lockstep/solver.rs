//! Collision response: impulses at the points where bodies overlap, one after the other, repeated
//! until they converge (E. Catto, "Iterative Dynamics with Temporal Coherence", Game Developers
//! Conference 2005).

use septum::contact::Contact;

use crate::body::Body;
use crate::vector::{Vector, cross, dot, minus, plus, root, times};

/// The number of corrections of each impulse.
const ROUNDS: usize = 8;
/// The depth that a contact may keep, so that it persists in the next tick.
const SLOP: f32 = 0.004;
/// The part of a greater depth that is corrected in a tick, and the greatest correction.
const UNDONE: f32 = 0.2;
const UNDONE_AT_MOST: f32 = 0.01;
const FRICTION: f32 = 0.6;

/// A point where two bodies, or a body and the ground, overlap.
#[derive(Clone, Copy)]
pub(crate) struct Touch {
    first: u16,
    /// The second body; `None` for the ground.
    second: Option<u16>,
    /// The unit normal out of the second body.
    normal: Vector,
    /// The offsets from the centres.
    arms: [Vector; 2],
    /// The inverse of the effective mass along the normal, and of the least effective mass along
    /// any direction.
    masses: [f32; 2],
    /// The target speed of separation.
    parting: f32,
    /// The accumulated impulses: along the normal, and across it.
    pressed: f32,
    rubbed: Vector,
}

/// The two bodies of a touch; the second may be the ground.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) first: usize,
    pub(crate) second: Option<usize>,
}

/// The points of a contact. `sign` is 1 if its first shape is the pair's first body, else −1.
pub(crate) fn touches<'a>(
    bodies: &'a [Body],
    pair: Pair,
    contact: &'a Contact<f32>,
    sign: f32,
) -> impl Iterator<Item = Touch> + 'a {
    let normal = times(contact.translation.normal.to_array(), sign);
    contact.points().iter().filter_map(move |point| {
        let (p, q) = (point.on_first.to_array(), point.on_second.to_array());
        let middle = times(plus(p, q), 0.5);
        let a = bodies.get(pair.first)?;
        let b = match pair.second {
            Some(second) => Some(bodies.get(second)?),
            None => None,
        };
        let arms = [minus(middle, a.position), b.map_or([0.0; 3], |b| minus(middle, b.position))];
        let mut masses = [0.0; 2];
        for (body, arm) in [Some(a), b].into_iter().zip(arms) {
            let Some(body) = body.filter(|body| !body.rests()) else { continue };
            let turn = cross(arm, normal);
            masses[0] += body.inverse_mass() + body.inverse_inertia() * dot(turn, turn);
            masses[1] += body.inverse_mass() + body.inverse_inertia() * dot(arm, arm);
        }
        if masses[0] == 0.0 {
            return None;
        }
        let undone = UNDONE * (point.depth - SLOP);
        Some(Touch {
            first: pair.first as u16,
            second: pair.second.map(|second| second as u16),
            normal,
            arms,
            masses,
            parting: undone.clamp(0.0, UNDONE_AT_MOST),
            pressed: 0.0,
            rubbed: [0.0; 3],
        })
    })
}

impl Touch {
    fn velocity(&self, bodies: &[Body]) -> Vector {
        let of = |k: u16, arm| bodies[usize::from(k)].velocity_at(arm);
        let second = self.second.map_or([0.0; 3], |k| of(k, self.arms[1]));
        minus(of(self.first, self.arms[0]), second)
    }

    fn apply(&self, bodies: &mut [Body], impulse: Vector) {
        let mut push = |k: u16, impulse, arm| {
            let body = &mut bodies[usize::from(k)];
            if !body.rests() {
                body.push(impulse, arm);
            }
        };
        push(self.first, impulse, self.arms[0]);
        if let Some(second) = self.second {
            push(second, times(impulse, -1.0), self.arms[1]);
        }
    }

    fn correct(&mut self, bodies: &mut [Body]) {
        let along = dot(self.velocity(bodies), self.normal);
        let wanted = self.pressed + (self.parting - along) / self.masses[0];
        let pressed = if wanted > 0.0 { wanted } else { 0.0 };
        self.apply(bodies, times(self.normal, pressed - self.pressed));
        self.pressed = pressed;

        let velocity = self.velocity(bodies);
        let across = minus(velocity, times(self.normal, dot(velocity, self.normal)));
        let mut rubbed = minus(self.rubbed, times(across, 1.0 / self.masses[1]));
        let (square, most) = (dot(rubbed, rubbed), FRICTION * self.pressed);
        if square > most * most {
            rubbed = times(rubbed, most / root(square));
        }
        self.apply(bodies, minus(rubbed, self.rubbed));
        self.rubbed = rubbed;
    }
}

/// Changes velocities so that no depth increases.
pub(crate) fn solve(bodies: &mut [Body], touches: &mut [Touch]) {
    for _ in 0..ROUNDS {
        for touch in &mut *touches {
            touch.correct(bodies);
        }
    }
}
