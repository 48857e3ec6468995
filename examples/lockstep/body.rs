//! A box with its pose and its motion.

use septum::sweep::Motion;
use septum::{Aabb, Obb};

use crate::terrain::Ground;
use crate::vector::{Vector, cross, dot, plus, root, times};

/// The number of calm ticks after which a body rests.
const CALM: u8 = 30;

/// A cube. Lengths are in metres, and time is in ticks, 60 a second.
#[derive(Clone, Copy)]
pub(crate) struct Body {
    pub(crate) position: Vector,
    /// A unit quaternion: x, y, z, w.
    rotation: [f32; 4],
    pub(crate) velocity: Vector,
    /// In radians for each tick.
    pub(crate) spin: Vector,
    pub(crate) half: f32,
    /// The number of ticks for which it has been calm.
    calm: u8,
}

/// A pose, in the crate's types.
#[derive(Clone, Copy)]
pub(crate) struct Pose {
    pub(crate) obb: Obb<f32>,
    /// The bounding box.
    pub(crate) aabb: Aabb<f32>,
}

impl Body {
    pub(crate) const fn new(position: Vector, half: f32) -> Self {
        let rotation = [0.0, 0.0, 0.0, 1.0];
        Self { position, rotation, velocity: [0.0; 3], spin: [0.0; 3], half, calm: 0 }
    }

    pub(crate) fn inverse_mass(&self) -> f32 {
        1.0 / (self.half * self.half * self.half)
    }

    /// The inverse moment of inertia; a cube has the same about every axis.
    pub(crate) fn inverse_inertia(&self) -> f32 {
        1.5 * self.inverse_mass() / (self.half * self.half)
    }

    pub(crate) fn pose(&self) -> Option<Pose> {
        let obb = Obb::from_quaternion(self.position, self.rotation, [self.half; 3]).ok()?;
        Some(Pose { obb, aabb: obb.aabb()? })
    }

    /// The velocity of the point at this offset from the centre.
    pub(crate) fn velocity_at(&self, from_center: Vector) -> Vector {
        plus(self.velocity, cross(self.spin, from_center))
    }

    /// Applies an impulse at this offset from the centre.
    pub(crate) fn push(&mut self, impulse: Vector, from_center: Vector) {
        self.velocity = plus(self.velocity, times(impulse, self.inverse_mass()));
        let turn = cross(from_center, impulse);
        self.spin = plus(self.spin, times(turn, self.inverse_inertia()));
    }

    pub(crate) fn rests(&self) -> bool {
        self.calm >= CALM
    }

    pub(crate) fn wake(&mut self) {
        self.calm = 0;
    }

    /// The square of the speed of its corners, approximately.
    pub(crate) fn speed_squared(&self) -> f32 {
        dot(self.velocity, self.velocity) + 3.0 * self.half * self.half * dot(self.spin, self.spin)
    }

    /// Moves for a tick. An obstacle in the path of the core stops the body there: nothing tunnels.
    pub(crate) fn advance(&mut self, ground: &Ground<'_>) {
        const STILL: f32 = 1e-5;
        self.calm = if self.speed_squared() < STILL { (self.calm + 1).min(CALM) } else { 0 };
        if self.rests() {
            (self.velocity, self.spin) = ([0.0; 3], [0.0; 3]);
            return;
        }
        self.position = self.end_of_way(ground);

        let [x, y, z, w] = self.rotation;
        let [i, j, k] = times(self.spin, 0.5);
        let turned = [
            x + (i * w + j * z - k * y),
            y + (j * w + k * x - i * z),
            z + (k * w + i * y - j * x),
            w - (i * x + j * y + k * z),
        ];
        let square = turned.iter().fold(0.0, |sum, x| sum + x * x);
        self.rotation = turned.map(|x| x / root(square));
    }

    /// The end of the tick's motion: the new place, or the place where the core, an axis-aligned
    /// cube inside the body, first meets the ground. If the core meets the ground at the start, a
    /// contact pushes the body out, and it moves slowly.
    fn end_of_way(&self, ground: &Ground<'_>) -> Vector {
        let to = |part: f32| plus(self.position, times(self.velocity, part));
        let (square, slow) = (dot(self.velocity, self.velocity), 0.25 * self.half);
        if square <= slow * slow {
            return to(1.0);
        }
        let core = Aabb::from_center_half_extents(self.position, [0.5 * self.half; 3]);
        let (Ok(core), Ok(way)) = (core, Motion::new(self.position, to(1.0))) else {
            return self.position;
        };
        match ground.tree.first_contact(&core, &way) {
            None => to(1.0),
            Some((_, first)) if first.t > 0.0 => to(first.t),
            Some(_) => to(slow / root(square)),
        }
    }

    /// All of its numbers.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = u32> {
        let moving = self.position.into_iter().chain(self.rotation).chain(self.velocity);
        moving.chain(self.spin).map(f32::to_bits).chain([u32::from(self.calm)])
    }
}
