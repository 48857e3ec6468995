//! Möller–Trumbore as in the paper, with early returns: the naive implementation of a user. In
//! fixed point it wraps.

use std::ops::{Add, Div, Mul, Sub};

use fixed::Wrapping;
use fixed::types::I16F16;
use septum::{Ray, Scalar, Triangle, Vec3};

use crate::candidate::{Candidate, Course, Promise};
use crate::unit::F32;

use super::ours::course;
use super::scenes::Scene;

/// The operations that the paper's code needs.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    const ZERO: Self;
    const ONE: Self;
    /// A smaller determinant is a miss: the paper's epsilon, or zero.
    const EPSILON: Self;
}

impl Real for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const EPSILON: Self = 0.000001;
}

impl Real for Wrapping<I16F16> {
    const ZERO: Self = Wrapping(I16F16::ZERO);
    const ONE: Self = Wrapping(I16F16::ONE);
    const EPSILON: Self = Wrapping(I16F16::DELTA);
}

/// The test that all ratios refer to.
pub fn yardstick(scene: &Scene) -> Candidate {
    in_floats(&course(scene, &F32))
}

/// The same test on any course.
pub fn in_floats(course: &Course<Ray<f32>, Triangle<f32>>) -> Candidate {
    in_c(course, "yardstick: Möller–Trumbore as in C", |x| x)
}

/// The same test in wrapping fixed point.
pub fn wrapping(course: &Course<Ray<I16F16>, Triangle<I16F16>>) -> Candidate {
    in_c(course, "Möller–Trumbore as in C, wrapping", Wrapping)
}

fn in_c<S: Scalar, T: Real>(
    course: &Course<Ray<S>, Triangle<S>>,
    who: &str,
    number: fn(S) -> T,
) -> Candidate {
    let vector = |v: Vec3<S>| v.to_array().map(number);
    let ray = |r: &Ray<S>| [vector(r.origin()), vector(r.direction())];
    let triangle = |t: &Triangle<S>| t.vertices().map(vector);
    let course = course.prepared("", |p| p.map(ray, triangle));
    course.candidate(who, Promise::Nothing, moller_trumbore)
}

#[inline(never)]
fn moller_trumbore<T: Real>(
    [origin, direction]: &[[T; 3]; 2],
    [a, b, c]: &[[T; 3]; 3],
) -> Option<[T; 3]> {
    let (edge1, edge2) = (sub(b, a), sub(c, a));
    let p = cross(direction, &edge2);
    let det = dot(&edge1, &p);
    if det > T::ZERO - T::EPSILON && det < T::EPSILON {
        return None;
    }
    let inverse = T::ONE / det;
    let s = sub(origin, a);
    let u = dot(&s, &p) * inverse;
    if u < T::ZERO || u > T::ONE {
        return None;
    }
    let q = cross(&s, &edge1);
    let v = dot(direction, &q) * inverse;
    if v < T::ZERO || u + v > T::ONE {
        return None;
    }
    let t = dot(&edge2, &q) * inverse;
    if t < T::ZERO {
        return None;
    }
    Some([t, u, v])
}

#[inline(always)]
fn sub<T: Real>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn dot<T: Real>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<T: Real>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
