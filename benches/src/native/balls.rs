//! Peers' spheres that move past triangles.

#![allow(unsafe_code)]

use super::Balls;
use super::foreign::{Owned, Pointer};
use crate::sweep::Shot;

// Each reads what its pointers point to and keeps no pointer; those named `new` return a value to
// be freed once, and those named `free` free it.
unsafe extern "C" {
    fn bullet_ball_new(numbers: *const f32) -> Pointer;
    fn bullet_ball_free(this: Pointer);
    fn bullet_ball_cast(this: Pointer) -> f32;
    fn bullet_ball_depth(this: Pointer) -> f32;
    fn bullet_ball_closest(this: Pointer, point: *mut f32);
    fn jolt_ball_new(numbers: *const f32) -> Pointer;
    fn jolt_ball_free(this: Pointer);
    fn jolt_ball_cast(this: Pointer) -> f32;
    fn jolt_ball_depth(this: Pointer) -> f32;
    fn jolt_ball_closest(this: Pointer, point: *mut f32);
}

/// The functions of a peer.
#[derive(Clone, Copy)]
struct Peer {
    names: [&'static str; 3],
    new: unsafe extern "C" fn(*const f32) -> Pointer,
    free: unsafe extern "C" fn(Pointer),
    cast: unsafe extern "C" fn(Pointer) -> f32,
    depth: unsafe extern "C" fn(Pointer) -> f32,
    closest: unsafe extern "C" fn(Pointer, *mut f32),
}

const PEERS: [Peer; 2] = [
    Peer {
        names: [
            "Bullet btSubsimplexConvexCast",
            "Bullet SphereTriangleDetector",
            "Bullet closestPtPointTriangle",
        ],
        new: bullet_ball_new,
        free: bullet_ball_free,
        cast: bullet_ball_cast,
        depth: bullet_ball_depth,
        closest: bullet_ball_closest,
    },
    Peer {
        names: [
            "Jolt CastSphereVsTriangles",
            "Jolt CollideSphereVsTriangles",
            "Jolt GetClosestPointOnTriangle",
        ],
        new: jolt_ball_new,
        free: jolt_ball_free,
        cast: jolt_ball_cast,
        depth: jolt_ball_depth,
        closest: jolt_ball_closest,
    },
];

impl Peer {
    fn ball(self, shot: &Shot) -> Owned {
        let Shot { center, half, way, triangle } = shot;
        let numbers = [&center[..], way, &half[..1], triangle.as_flattened()].concat();
        // SAFETY: the function reads sixteen numbers.
        Owned(unsafe { (self.new)(numbers.as_ptr()) }, self.free)
    }

    fn balls(self, shots: &[Shot]) -> Balls {
        let all = || shots.iter().map(|shot| self.ball(shot)).collect::<Vec<_>>();
        let (casts, contacts, centers) = (all(), all(), all());
        Balls {
            names: self.names,
            cast: Box::new(move |i| {
                // SAFETY: a ball.
                let t = unsafe { (self.cast)(casts[i].0) };
                t.is_finite().then_some(t)
            }),
            depth: Box::new(move |i| {
                // SAFETY: as above.
                let depth = unsafe { (self.depth)(contacts[i].0) };
                depth.is_finite().then_some(depth)
            }),
            closest: Box::new(move |i| {
                let mut point = [0.0; 3];
                // SAFETY: a ball, and room for three numbers.
                unsafe { (self.closest)(centers[i].0, point.as_mut_ptr()) };
                point
            }),
        }
    }
}

/// Balls of half the size of the shots' boxes, by each peer.
pub fn balls(shots: &[Shot]) -> Vec<Balls> {
    PEERS.iter().map(|peer| peer.balls(shots)).collect()
}
