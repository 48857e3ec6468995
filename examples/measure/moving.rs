//! Shapes that move past a box, and a sphere past a triangle.

use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Sphere, Triangle};

use crate::workload::{Coordinate, HALF, Point, Rng, first, sphere, vector, voorhies};

/// A shape at the start, and its motion.
pub(crate) struct Moving<S, Shape> {
    pub(crate) shape: Shape,
    pub(crate) motion: Motion<S>,
}

/// A moving shape, and the box.
type Scene<S, Shape> = Option<(Moving<S, Shape>, Aabb<S>)>;

/// From the origin to a point within half of [−2, 2]³.
fn motion<S: Coordinate>(rng: &mut Rng) -> Option<Motion<S>> {
    Motion::new(vector::<S>([0; 3]), vector::<S>(rng.point().map(|x| x >> 1))).ok()
}

fn triangle<S: Coordinate>(rng: &mut Rng) -> Scene<S, Triangle<S>> {
    let (shape, aabb) = voorhies(rng)?;
    Some((Moving { shape, motion: motion(rng)? }, aabb))
}

fn cube<S: Coordinate>(rng: &mut Rng) -> Scene<S, Aabb<S>> {
    let cube =
        |center: Point| Aabb::from_center_half_extents(vector(center), vector([HALF; 3])).ok();
    Some((Moving { shape: cube(rng.point())?, motion: motion(rng)? }, cube([0; 3])?))
}

pub(crate) fn triangle_hits<S: Coordinate>(rng: &mut Rng) -> Scene<S, Triangle<S>> {
    first(rng, triangle, true, |m, aabb| m.shape.meets_along(&m.motion, aabb))
}

pub(crate) fn triangle_misses<S: Coordinate>(rng: &mut Rng) -> Scene<S, Triangle<S>> {
    first(rng, triangle, false, |m, aabb| m.shape.meets_along(&m.motion, aabb))
}

pub(crate) fn cube_hits<S: Coordinate>(rng: &mut Rng) -> Scene<S, Aabb<S>> {
    first(rng, cube, true, |m, aabb| m.shape.meets_along(&m.motion, aabb))
}

pub(crate) fn cube_misses<S: Coordinate>(rng: &mut Rng) -> Scene<S, Aabb<S>> {
    first(rng, cube, false, |m, aabb| m.shape.meets_along(&m.motion, aabb))
}

/// A sphere that moves, and a triangle.
type Ball<S> = Option<(Moving<S, Sphere<S>>, Triangle<S>)>;

fn ball<S: Coordinate>(rng: &mut Rng) -> Ball<S> {
    let (triangle, shape) = sphere(rng)?;
    Some((Moving { shape, motion: motion(rng)? }, triangle))
}

/// Not at the start.
pub(crate) fn ball_hits<S: Coordinate>(rng: &mut Rng) -> Ball<S> {
    first(rng, ball, true, |m, t| !m.shape.overlaps(t) && m.shape.meets_along(&m.motion, t))
}

pub(crate) fn ball_misses<S: Coordinate>(rng: &mut Rng) -> Ball<S> {
    first(rng, ball, false, |m, t| m.shape.meets_along(&m.motion, t))
}
