//! Collision response: impulses at the points where bodies overlap, one after the other, repeated
//! until they converge (E. Catto, "Iterative Dynamics with Temporal Coherence", Game Developers
//! Conference 2005).

use septum::contact::Contact;

use crate::body::Body;
use crate::number::Number;
use crate::vector::{Vector, cross, minus, plus, times, within};

/// The number of corrections of each impulse.
const ROUNDS: usize = 8;

/// A point where two bodies, or a body and the ground, overlap.
#[derive(Clone, Copy)]
pub(crate) struct Touch<T> {
    first: u16,
    /// The second body; `None` for the ground.
    second: Option<u16>,
    /// The unit normal out of the second body.
    normal: Vector<T>,
    /// The offsets from the centres.
    arms: [Vector<T>; 2],
    /// The inverse of the effective mass along the normal, and of the least effective mass along
    /// any direction.
    masses: [T; 2],
    /// The target speed of separation.
    parting: T,
    /// The accumulated impulses: along the normal, and across it.
    pressed: T,
    rubbed: Vector<T>,
}

/// The two bodies of a touch; the second may be the ground.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    pub(crate) first: usize,
    pub(crate) second: Option<usize>,
}

/// The points of a contact. `sign` is 1 if its first shape is the pair's first body, else −1.
pub(crate) fn touches<'a, T: Number>(
    bodies: &'a [Body<T>],
    pair: Pair,
    contact: &'a Contact<T>,
    sign: T,
) -> impl Iterator<Item = Touch<T>> + 'a {
    let normal = times(contact.translation.normal.to_array(), sign);
    contact.points().iter().filter_map(move |point| {
        let (p, q) = (point.on_first.to_array(), point.on_second.to_array());
        let middle = times(plus(p, q), T::HALF);
        let a = bodies.get(pair.first)?;
        let b = match pair.second {
            Some(second) => Some(bodies.get(second)?),
            None => None,
        };
        let arms =
            [minus(middle, a.position), b.map_or([T::ZERO; 3], |b| minus(middle, b.position))];
        let mut masses = [T::ZERO; 2];
        for (body, arm) in [Some(a), b].into_iter().zip(arms) {
            let Some(body) = body.filter(|body| !body.rests()) else { continue };
            let turn = cross(arm, normal);
            masses[0] = masses[0] + body.inverse_mass + body.inverse_inertia * T::dot(turn, turn);
            masses[1] = masses[1] + body.inverse_mass + body.inverse_inertia * T::dot(arm, arm);
        }
        if masses[0] == T::ZERO {
            return None;
        }
        let parting = T::PARTING * (point.depth - T::SLOP);
        Some(Touch {
            first: pair.first as u16,
            second: pair.second.map(|second| second as u16),
            normal,
            arms,
            masses,
            parting: within(parting, T::PARTING_AT_MOST),
            pressed: T::ZERO,
            rubbed: [T::ZERO; 3],
        })
    })
}

impl<T: Number> Touch<T> {
    fn velocity(&self, bodies: &[Body<T>]) -> Vector<T> {
        let of = |k: u16, arm| bodies[usize::from(k)].velocity_at(arm);
        let second = self.second.map_or([T::ZERO; 3], |k| of(k, self.arms[1]));
        minus(of(self.first, self.arms[0]), second)
    }

    fn apply(&self, bodies: &mut [Body<T>], impulse: Vector<T>) {
        let mut push = |k: u16, impulse, arm| {
            let body = &mut bodies[usize::from(k)];
            if !body.rests() {
                body.push(impulse, arm);
            }
        };
        push(self.first, impulse, self.arms[0]);
        if let Some(second) = self.second {
            push(second, times(impulse, -T::ONE), self.arms[1]);
        }
    }

    fn correct(&mut self, bodies: &mut [Body<T>]) {
        let along = T::dot(self.velocity(bodies), self.normal);
        let wanted = self.pressed + (self.parting - along) / self.masses[0];
        let pressed = if wanted > T::ZERO { wanted } else { T::ZERO };
        self.apply(bodies, times(self.normal, pressed - self.pressed));
        self.pressed = pressed;

        let velocity = self.velocity(bodies);
        let across = minus(velocity, times(self.normal, T::dot(velocity, self.normal)));
        let mut rubbed = minus(self.rubbed, times(across, T::ONE / self.masses[1]));
        let (length, most) = (T::length(&rubbed), T::FRICTION * self.pressed);
        if length > most {
            rubbed = times(rubbed, most / length);
        }
        self.apply(bodies, minus(rubbed, self.rubbed));
        self.rubbed = rubbed;
    }
}

/// Changes velocities so that no depth increases.
pub(crate) fn solve<T: Number>(bodies: &mut [Body<T>], touches: &mut [Touch<T>]) {
    for _ in 0..ROUNDS {
        for touch in &mut *touches {
            touch.correct(bodies);
        }
    }
}
