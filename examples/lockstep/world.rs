//! Boxes that fall and slide. Players steer two of them. Every operation is one on
//! integers, and products are rounded down, so that every machine computes the same.

use fixed::types::I16F16;
use septum::{Aabb, Triangle};

use crate::terrain::{SIDE, met_by};

type Number = I16F16;

const fn lit(text: &str) -> Number {
    Number::lit(text)
}

const GRAVITY: Number = lit("0.00390625");
const THRUST: Number = lit("0.005");
const DRAG: Number = lit("0.984375");
const SLIDE: Number = lit("0.01");
/// How far a box is lifted in one tick, where the ground rises before it.
const LIFT: Number = lit("0.0625");

#[derive(Clone, Copy)]
struct Body {
    position: [Number; 3],
    velocity: [Number; 3],
    half: Number,
}

impl Body {
    /// The box, unless it left the range of its coordinates.
    fn aabb(&self) -> Option<Aabb<Number>> {
        let [x, y, z] = self.position;
        let corner = |d: Number| [x + d, y + d, z + d];
        Aabb::from_min_max(corner(-self.half), corner(self.half)).ok()
    }

    fn ground(&self) -> Option<Triangle<Number>> {
        met_by(&self.aabb()?)
    }

    /// Whether two boxes have more than a surface in common.
    fn meets(&self, other: &Self) -> bool {
        let reach = self.half + other.half;
        self.position.iter().zip(other.position).all(|(a, b)| (*a - b).abs() < reach)
    }
}

/// The whole state.
#[derive(Clone, Copy)]
pub(crate) struct World {
    bodies: [Body; 6],
}

impl World {
    pub(crate) fn new() -> Self {
        let mut bodies =
            [Body { position: [Number::ZERO; 3], velocity: [Number::ZERO; 3], half: lit("0.25") };
                6];
        for (k, body) in (0..).zip(&mut bodies) {
            let along = Number::from_num(k) * lit("1.5") + lit("1.125");
            body.position = [along, lit("2.5") + Number::from_num(k) / 4, lit("9") - along];
            body.half -= Number::from_num(k) / 64;
        }
        Self { bodies }
    }

    /// Runs one tick. The bits of an input mean left, right, back and forward.
    pub(crate) fn step(&mut self, inputs: [u8; 2]) {
        for (body, input) in self.bodies.iter_mut().zip(inputs) {
            let push = |bit: u8| if input >> bit & 1 == 1 { THRUST } else { Number::ZERO };
            body.velocity[0] += push(1) - push(0);
            body.velocity[2] += push(3) - push(2);
        }
        for k in 0..self.bodies.len() {
            for i in [0, 2] {
                self.slide(k, i);
            }
            self.fall(k);
        }
    }

    fn is_blocked(&self, k: usize, body: &Body) -> bool {
        self.bodies.iter().enumerate().any(|(j, other)| j != k && body.meets(other))
    }

    /// Moves a box along a horizontal axis. It slides over the ground where that is not
    /// too steep, and stays within the walls.
    fn slide(&mut self, k: usize, i: usize) {
        let mut moved = self.bodies[k];
        moved.velocity[i] *= DRAG;
        let end = Number::from_num(SIDE) - moved.half;
        moved.position[i] = (moved.position[i] + moved.velocity[i]).clamp(moved.half, end);
        if moved.ground().is_some() {
            moved.position[1] += LIFT;
        }
        if moved.ground().is_some() || self.is_blocked(k, &moved) {
            self.bodies[k].velocity[i] = -self.bodies[k].velocity[i] / 2;
        } else {
            self.bodies[k] = moved;
        }
    }

    /// Moves a box down. A box on the ground gains speed downhill.
    fn fall(&mut self, k: usize) {
        let mut moved = self.bodies[k];
        moved.velocity[1] = (moved.velocity[1] - GRAVITY).max(-moved.half);
        moved.position[1] += moved.velocity[1];
        let ground = moved.ground();
        if ground.is_none() && !self.is_blocked(k, &moved) {
            self.bodies[k] = moved;
            return;
        }
        let velocity = &mut self.bodies[k].velocity;
        velocity[1] = Number::ZERO;
        if let Some(ground) = ground {
            let [a, b, c] = *ground.vertices();
            let (e, f) = ([b.x - a.x, b.y - a.y, b.z - a.z], [c.x - a.x, c.y - a.y, c.z - a.z]);
            velocity[0] += (e[1] * f[2] - e[2] * f[1]) * SLIDE;
            velocity[2] += (e[0] * f[1] - e[1] * f[0]) * SLIDE;
        }
    }

    /// The hash of every bit of the state: FNV-1a.
    pub(crate) fn hash(&self) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for body in &self.bodies {
            for number in body.position.iter().chain(&body.velocity) {
                for byte in number.to_bits().to_le_bytes() {
                    hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
                }
            }
        }
        hash
    }
}
