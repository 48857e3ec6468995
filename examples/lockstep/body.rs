//! A box with its pose and its motion.

use septum::sweep::Motion;
use septum::{Aabb, Obb};

use crate::number::{Number, ratio};
use crate::terrain::Ground;
use crate::vector::{Vector, cross, plus, times, within};

/// The number of calm ticks after which a body rests.
const CALM: u8 = 30;

/// A cube.
#[derive(Clone, Copy)]
pub(crate) struct Body<T> {
    pub(crate) position: Vector<T>,
    /// A unit quaternion: x, y, z, w.
    rotation: [T; 4],
    pub(crate) velocity: Vector<T>,
    /// In radians a second.
    pub(crate) spin: Vector<T>,
    half: T,
    pub(crate) inverse_mass: T,
    /// A cube has the same moment of inertia about every axis.
    pub(crate) inverse_inertia: T,
    /// The number of ticks for which it has been calm.
    calm: u8,
}

/// A pose, in the crate's types.
#[derive(Clone, Copy)]
pub(crate) struct Pose<T> {
    pub(crate) obb: Obb<T>,
    /// The bounding box.
    pub(crate) aabb: Aabb<T>,
}

impl<T: Number> Body<T> {
    pub(crate) fn new(position: Vector<T>, half: T) -> Self {
        let part = ratio::<T>(1, 4) / half;
        let inverse_mass = part * part * part;
        let inverse_inertia = inverse_mass * ratio(3, 2) / half / half;
        let rest = [T::ZERO; 3];
        Self {
            position,
            rotation: [T::ZERO, T::ZERO, T::ZERO, T::ONE],
            velocity: rest,
            spin: rest,
            half,
            inverse_mass,
            inverse_inertia,
            calm: 0,
        }
    }

    pub(crate) fn pose(&self) -> Option<Pose<T>> {
        let obb = Obb::from_quaternion(self.position, self.rotation, [self.half; 3]).ok()?;
        Some(Pose { obb, aabb: obb.aabb()? })
    }

    /// The velocity of the point at this offset from the centre.
    pub(crate) fn velocity_at(&self, from_center: Vector<T>) -> Vector<T> {
        plus(self.velocity, cross(self.spin, from_center))
    }

    /// Applies an impulse at this offset from the centre.
    pub(crate) fn push(&mut self, impulse: Vector<T>, from_center: Vector<T>) {
        self.velocity = plus(self.velocity, times(impulse, self.inverse_mass));
        let turn = cross(from_center, impulse);
        self.spin = plus(self.spin, times(turn, self.inverse_inertia));
    }

    pub(crate) fn rests(&self) -> bool {
        self.calm >= CALM
    }

    pub(crate) fn wake(&mut self) {
        self.calm = 0;
    }

    /// The speed of its corners, approximately.
    pub(crate) fn speed(&self) -> T {
        let [[x, y, z], [i, j, k]] = [self.velocity, times(self.spin, self.half * ratio(7, 4))];
        T::length(&[x, y, z, i, j, k])
    }

    /// Slows down a little, and falls.
    pub(crate) fn fall(&mut self) {
        self.velocity = times(self.velocity, T::DRAG);
        self.spin = times(self.spin, T::DRAG);
        self.velocity[1] = self.velocity[1] - T::GRAVITY;
    }

    /// Moves for a tick. An obstacle in the path of the core stops the body there: nothing tunnels.
    pub(crate) fn advance(&mut self, ground: &Ground<'_, T>) {
        self.velocity = self.velocity.map(limited);
        self.spin = self.spin.map(limited);
        self.calm = if self.speed() < T::STILL { (self.calm + 1).min(CALM) } else { 0 };
        if self.rests() {
            (self.velocity, self.spin) = ([T::ZERO; 3], [T::ZERO; 3]);
            return;
        }
        self.position = self.end_of_way(ground);

        let [x, y, z, w] = self.rotation;
        let [i, j, k] = self.spin.map(|x| x / (T::RATE + T::RATE));
        let turned = [
            x + (i * w + j * z - k * y),
            y + (j * w + k * x - i * z),
            z + (k * w + i * y - j * x),
            w - (i * x + j * y + k * z),
        ];
        let length = T::length(&turned);
        self.rotation = turned.map(|x| x / length);
    }

    /// The end of the tick's motion: the new place, or the last place before the core, an
    /// axis-aligned cube inside the body, is in the ground. If the core is in the ground at the
    /// start, a contact pushes the body out, and it moves slowly.
    fn end_of_way(&self, ground: &Ground<'_, T>) -> Vector<T> {
        let way = self.velocity.map(|x| x / T::RATE);
        let to = plus(self.position, way);
        let (length, slow) = (T::length(&way), self.half * ratio(1, 4));
        if length <= slow {
            return to;
        }
        let core = Aabb::from_center_half_extents(self.position, [T::HALF * self.half; 3]);
        let (Ok(core), Ok(motion)) = (core, Motion::new(self.position, to)) else {
            return self.position;
        };
        match ground.tree.last_free(&core, &motion) {
            Some((place, _)) => place.to_array(),
            None => plus(self.position, times(way, slow / length)),
        }
    }

    /// All of its numbers that change.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = u32> {
        let moving = self.position.into_iter().chain(self.rotation).chain(self.velocity);
        moving.chain(self.spin).map(T::bits).chain([u32::from(self.calm)])
    }
}

/// A speed that is not above the greatest.
fn limited<T: Number>(speed: T) -> T {
    let magnitude = within(if speed < T::ZERO { -speed } else { speed }, T::FASTEST);
    if speed < T::ZERO { -magnitude } else { magnitude }
}
