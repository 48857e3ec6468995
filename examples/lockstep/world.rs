//! Boxes that fall, turn, stack and rest; players steer two of them. Queries are exact, and
//! everything else is sums, products and quotients of floats in a fixed order, so that every
//! machine computes the same bits.

use heapless::Vec;
use septum::broad_phase::BoxTree;
use septum::contact::{contact, contact_in_mesh};
use septum::mesh::Node;
use septum::{Aabb, ShapeError, Vec3};

use crate::body::{Body, Pose};
use crate::solver::{Pair, Touch, solve, touches};
use crate::terrain::{Ground, SIDE, height_above};

/// Of 60 ticks a second.
const GRAVITY: f32 = 9.81 / 3600.0;
const THRUST: f32 = 0.004;
const DRAG: f32 = 0.995;
/// A body faster than this wakes the bodies that it touches.
const WAKES: f32 = 0.0004;

/// Ticks from one build of the broad phase to the next.
const REBUILD: u32 = 32;

/// The whole state: N bodies.
#[derive(Clone, Copy)]
pub(crate) struct World<const N: usize> {
    bodies: [Body; N],
    /// The order of the bodies in the broad phase, and its age in ticks. No answer depends on it, so
    /// that it is not hashed.
    order: [u16; N],
    age: u32,
}

/// The number of points that a tick may have for each body. Further points are dropped, on every
/// machine alike.
pub(crate) const POINTS: usize = 16;

impl<const N: usize> World<N> {
    /// Boxes in layers above the ground.
    pub(crate) fn new() -> Self {
        const ROW: usize = 6;
        let mut bodies = [Body::new([0.0; 3], 0.25); N];
        for (k, body) in bodies.iter_mut().enumerate() {
            let [x, z, y] = [k % ROW, k / ROW % ROW, k / (ROW * ROW)].map(|n| n as f32);
            let aside = (k % 7) as f32 / 16.0;
            let gap = (SIDE as f32 - 2.0) / ROW as f32;
            let position = [1.2 + gap * x + aside, 2.0 + 0.75 * y, 1.2 + gap * z + aside / 2.0];
            *body = Body::new(position, 0.25 - (k % 5) as f32 / 64.0);
            body.spin = [aside / 64.0, 0.01, (k % 3) as f32 / 128.0];
            if k % 4 == 3 {
                // A bullet: it moves ten times its own length in one tick.
                body.velocity = [3.0, -4.0, 1.0];
            }
        }
        Self { bodies, order: [0; N], age: 0 }
    }

    /// The world as it is loaded from a save without the order of the broad phase.
    pub(crate) fn loaded(&self) -> Self {
        Self { order: [0; N], age: 0, ..*self }
    }

    /// Runs one tick. The bits of an input mean left, right, back and forward.
    pub(crate) fn step<const TOUCHES: usize>(&mut self, ground: &Ground<'_>, inputs: [u8; 2]) {
        for (body, input) in self.bodies.iter_mut().zip(inputs) {
            let push = |bit: u8| if input >> bit & 1 == 1 { THRUST } else { 0.0 };
            body.velocity[0] += push(1) - push(0);
            body.velocity[2] += push(3) - push(2);
            if input & 15 != 0 {
                body.wake();
            }
        }
        for body in self.bodies.iter_mut().filter(|body| !body.rests()) {
            body.velocity = body.velocity.map(|x| x * DRAG);
            body.spin = body.spin.map(|x| x * DRAG);
            body.velocity[1] -= GRAVITY;
        }
        let mut found: Vec<Touch, TOUCHES> = Vec::new();
        self.find(ground, &mut found);
        solve(&mut self.bodies, &mut found);
        for body in &mut self.bodies {
            body.advance(ground);
        }
    }

    /// Finds the points where bodies overlap each other, or the ground.
    fn find<const TOUCHES: usize>(&mut self, ground: &Ground<'_>, found: &mut Vec<Touch, TOUCHES>) {
        let poses = self.bodies.each_ref().map(Body::pose);
        let boxes = poses.map(|pose| pose.map_or(NOWHERE, |pose| pose.aabb));
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
        // Ascending, so that those of a body follow each other.
        let mut near = near.iter().map(|pair| pair.map(usize::from)).peekable();
        for i in 0..N {
            let pose = &poses[i];
            if let (Some(pose), false) = (pose, self.bodies[i].rests()) {
                self.on_ground(ground, i, pose, found);
            }
            while let Some([_, j]) = near.next_if(|pair| pair[0] == i) {
                let (Some(pose), Some(other)) = (pose, &poses[j]) else { continue };
                if self.bodies[i].rests() && self.bodies[j].rests() {
                    continue;
                }
                let Some(contact) = contact(&pose.obb, &other.obb) else { continue };
                for (k, l) in [(i, j), (j, i)] {
                    if self.bodies[k].speed_squared() > WAKES && self.bodies[l].rests() {
                        self.bodies[l].wake();
                    }
                }
                let pair = Pair { first: i, second: Some(j) };
                for touch in touches(&self.bodies, pair, &contact, 1.0) {
                    let _ = found.push(touch);
                }
            }
        }
    }

    fn on_ground<const TOUCHES: usize>(
        &self,
        ground: &Ground<'_>,
        i: usize,
        pose: &Pose,
        found: &mut Vec<Touch, TOUCHES>,
    ) {
        for k in ground.tree.overlapping(&pose.obb) {
            let (Some(triangle), Some(&interior)) =
                (ground.tree.mesh().triangle(k), ground.interior.get(k))
            else {
                continue;
            };
            // The contact moves the triangle out of the box, so the box moves the opposite way.
            if let Some(contact) = contact_in_mesh(&triangle, interior, &pose.obb) {
                for touch in touches(&self.bodies, Pair { first: i, second: None }, &contact, -1.0)
                {
                    let _ = found.push(touch);
                }
            }
        }
    }

    /// Whether each body is inside of the wall and above the ground.
    pub(crate) fn is_whole(&self) -> bool {
        self.bodies.iter().all(|body| height_above(body.position).is_some_and(|y| y > 0.0))
    }

    /// How many bodies rest.
    pub(crate) fn resting(&self) -> usize {
        self.bodies.iter().filter(|body| body.rests()).count()
    }

    /// The hash of every bit of the state: FNV-1a.
    pub(crate) fn hash(&self) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for number in self.bodies.iter().flat_map(Body::numbers) {
            for byte in number.to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
        hash
    }
}

/// The box of a body without a pose.
const NOWHERE: Aabb<f32> = {
    let zero = Vec3::splat(0.0);
    ShapeError::unwrap(Aabb::<f32>::const_from_center_half_extents(zero, zero))
};
