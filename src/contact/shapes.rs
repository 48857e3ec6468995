//! The shapes of a contact with a sphere or a capsule: a flat one and a round one.

use crate::shape::{Aabb, Triangle, Vec3};

/// A triangle or a box.
#[derive(Clone, Copy, Debug)]
pub enum Flat<'a, S> {
    Triangle(&'a Triangle<S>),
    Aabb(&'a Aabb<S>),
}

/// The points within a radius of a segment, which may be a point.
#[derive(Clone, Copy, Debug)]
pub struct Round<S> {
    pub(super) ends: [Vec3<S>; 2],
    pub(super) radius: S,
}
