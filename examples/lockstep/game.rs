//! Boxes that fall, turn, stack and rest; players steer two of them. The game has the shape that
//! rollback libraries ask for: it saves its state, loads one, and advances by a tick.

use fixed::types::I16F16;
use heapless::Vec;
use septum::Aabb;
use septum::broad_phase::BoxTree;
use septum::contact::contact;
use septum::mesh::Node;

use crate::body::{Body, Pose};
use crate::number::{Number, ratio};
use crate::solver::{Pair, Touch, solve, touches};
use crate::terrain::{Ground, SIDE, height_above};

/// Ticks from one build of the broad phase to the next.
const REBUILD: u32 = 32;
/// The turn of a player in a tick, in radians.
const TURN: I16F16 = I16F16::lit("0.05");

/// The number of points that a tick may have for each body. Further points are dropped, on every
/// machine alike.
pub(crate) const POINTS: usize = 16;

/// All that a save keeps.
#[derive(Clone, Copy)]
pub(crate) struct State<T, const N: usize> {
    bodies: [Body<T>; N],
    /// The players' directions, in radians.
    headings: [I16F16; 2],
}

/// A state, and the order of the bodies in the broad phase with its age in ticks. No answer depends
/// on the order, so a load leaves it alone.
#[derive(Clone)]
pub(crate) struct Game<'a, T: Number, const N: usize, const TOUCHES: usize> {
    ground: &'a Ground<'a, T>,
    state: State<T, N>,
    order: [u16; N],
    age: u32,
}

impl<'a, T: Number, const N: usize, const TOUCHES: usize> Game<'a, T, N, TOUCHES> {
    pub(crate) fn new(ground: &'a Ground<'a, T>) -> Self {
        Self { ground, state: State::new(), order: [0; N], age: 0 }
    }

    pub(crate) fn save(&self) -> State<T, N> {
        self.state
    }

    pub(crate) fn load(&mut self, state: &State<T, N>) {
        self.state = *state;
    }

    /// Advances by a tick. The bits of an input mean left, right, back and forward.
    pub(crate) fn advance(&mut self, inputs: [u8; 2]) {
        self.steer(inputs);
        let bodies = &mut self.state.bodies;
        bodies.iter_mut().filter(|body| !body.rests()).for_each(Body::fall);
        let mut found = Vec::new();
        self.find(&mut found);
        solve(&mut self.state.bodies, &mut found);
        for body in &mut self.state.bodies {
            body.advance(self.ground);
        }
    }

    fn steer(&mut self, inputs: [u8; 2]) {
        let State { bodies, headings } = &mut self.state;
        for ((body, heading), input) in bodies.iter_mut().zip(headings).zip(inputs) {
            let by =
                |less: u8, more: u8| i32::from(input >> more & 1) - i32::from(input >> less & 1);
            *heading += TURN * by(0, 1);
            // Within a turn, which `cordic` goes through in half turns.
            *heading %= I16F16::TAU;
            let (sin, cos) = cordic::sin_cos(*heading);
            let thrust = T::THRUST * T::of(I16F16::from_num(by(2, 3)));
            body.velocity[0] = body.velocity[0] + thrust * T::of(cos);
            body.velocity[2] = body.velocity[2] + thrust * T::of(sin);
            if input & 15 != 0 {
                body.wake();
            }
        }
    }

    /// Finds the points where bodies overlap each other, or the ground.
    fn find(&mut self, found: &mut Vec<Touch<T>, TOUCHES>) {
        let bodies = &mut self.state.bodies;
        let poses = bodies.each_ref().map(Body::pose);
        let Ok(nowhere) = Aabb::from_center_half_extents([T::ZERO; 3], [T::ZERO; 3]) else {
            return;
        };
        let boxes = poses.map(|pose| pose.map_or(nowhere, |pose| pose.aabb));
        let mut nodes = [Node::EMPTY; N];
        let nodes = &mut nodes[..Node::count_for(N)];
        let tree = if self.age % REBUILD == 0 {
            BoxTree::build(&boxes, nodes, &mut self.order)
        } else {
            BoxTree::refit(&boxes, nodes, &self.order)
        };
        self.age += 1;
        let mut room = [[0; 2]; TOUCHES];
        let near = tree.and_then(|tree| tree.pairs(&mut room)).unwrap_or_default();
        // Ascending: the pairs of a body follow each other.
        let mut near = near.iter().map(|pair| pair.map(usize::from)).peekable();
        for i in 0..N {
            let pose = &poses[i];
            if let (Some(pose), false) = (pose, bodies[i].rests()) {
                on_ground(bodies, self.ground, i, pose, found);
            }
            while let Some([_, j]) = near.next_if(|pair| pair[0] == i) {
                let (Some(pose), Some(other)) = (pose, &poses[j]) else { continue };
                if bodies[i].rests() && bodies[j].rests() {
                    continue;
                }
                let Some(contact) = contact(&pose.obb, &other.obb) else { continue };
                for (k, l) in [(i, j), (j, i)] {
                    if bodies[k].speed() > T::WAKES && bodies[l].rests() {
                        bodies[l].wake();
                    }
                }
                let pair = Pair { first: i, second: Some(j) };
                for touch in touches(bodies, pair, &contact, T::ONE) {
                    let _ = found.push(touch);
                }
            }
        }
    }
}

fn on_ground<T: Number, const TOUCHES: usize>(
    bodies: &[Body<T>],
    ground: &Ground<'_, T>,
    i: usize,
    pose: &Pose<T>,
    found: &mut Vec<Touch<T>, TOUCHES>,
) {
    // The contact moves the triangle out of the box, so the box moves the opposite way.
    let contacts = ground.tree.contacts(&pose.obb, &ground.interior);
    for (_, contact) in contacts.into_iter().flatten() {
        for touch in touches(bodies, Pair { first: i, second: None }, &contact, -T::ONE) {
            let _ = found.push(touch);
        }
    }
}

impl<T: Number, const N: usize> State<T, N> {
    /// Boxes in layers above the ground.
    fn new() -> Self {
        const ROW: usize = 6;
        let mut bodies = [Body::new([T::ZERO; 3], ratio(1, 4)); N];
        for (k, body) in bodies.iter_mut().enumerate() {
            let gap = ratio::<T>(SIDE - 2, ROW);
            // A grid, and each box a few sixteenths of a metre aside.
            let at = |n: usize, aside: T| ratio::<T>(6, 5) + gap * ratio(n % ROW, 1) + aside;
            let aside = ratio::<T>(k % 7, 16);
            let y = ratio::<T>(2, 1) + ratio(3 * (k / (ROW * ROW)), 4);
            let position = [at(k, aside), y, at(k / ROW, aside * T::HALF)];
            *body = Body::new(position, ratio(16 - k % 5, 64));
            body.spin = [aside, ratio(3, 5), ratio(k % 3, 2)];
            if k % 4 == 3 {
                // A bullet: in one tick it moves five times its own length.
                body.velocity = [ratio(90, 1), -ratio::<T>(120, 1), ratio(30, 1)];
            }
        }
        Self { bodies, headings: [I16F16::ZERO; 2] }
    }

    /// Whether each body is inside of the wall and above the ground.
    pub(crate) fn is_whole(&self) -> bool {
        self.bodies.iter().all(|body| height_above(body.position).is_some_and(|y| y > 0))
    }

    /// How many bodies rest.
    pub(crate) fn resting(&self) -> usize {
        self.bodies.iter().filter(|body| body.rests()).count()
    }

    /// The checksum of every bit that changes: FNV-1a.
    pub(crate) fn checksum(&self) -> u64 {
        let headings = self.headings.iter().map(|heading| heading.bits());
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for number in self.bodies.iter().flat_map(Body::numbers).chain(headings) {
            for byte in number.to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
        hash
    }
}
