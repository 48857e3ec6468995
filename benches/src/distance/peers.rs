//! The textbook's methods in plain floats, and parry3d's.

use nalgebra::{RealField, Vector3};
use parry3d::math::Pose;
use parry3d::query::details::intersection_test_point_query_ball;
use parry3d::query::{PointQuery, intersection_test};
use parry3d::shape::{Ball, Capsule as ParryCapsule, Triangle as ParryTriangle};
use septum::{Capsule, Sphere, Triangle, Vec3};
use septum_kit::Sample;

use super::Asked;
use crate::candidate::{Candidate, Course, Promise};
use crate::peer_shapes::parry_vector;

type In<L, S> = Course<L, Triangle<S>>;

const PUBLISHED: &str = "as published (Ericson)";

/// The point of a triangle closest to p.
///
/// Source: C. Ericson, *Real-Time Collision Detection*, 2005, section 5.1.5.
pub fn closest_point<T: RealField + Copy>(p: Vector3<T>, [a, b, c]: [Vector3<T>; 3]) -> Vector3<T> {
    let zero = T::zero();
    let (ab, ac) = (b - a, c - a);
    let products = |q: Vector3<T>| (ab.dot(&(p - q)), ac.dot(&(p - q)));
    let ((d1, d2), (d3, d4)) = (products(a), products(b));
    if d1 <= zero && d2 <= zero {
        return a;
    }
    if d3 >= zero && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= zero && d1 >= zero && d3 <= zero {
        return a + ab * (d1 / (d1 - d3));
    }
    let (d5, d6) = products(c);
    if d6 >= zero && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= zero && d2 >= zero && d6 <= zero {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= zero && d4 - d3 >= zero && d5 - d6 >= zero {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let scale = T::one() / (va + vb + vc);
    a + ab * (vb * scale) + ac * (vc * scale)
}

fn vector<T: RealField + Copy>(v: Vec3<T>) -> Vector3<T> {
    Vector3::new(v.x, v.y, v.z)
}

fn of_triangle<T: RealField + Sample>(p: Vector3<T>, triangle: &Triangle<T>) -> Vector3<T> {
    closest_point(p, triangle.vertices().map(vector))
}

/// Section 5.2.7 of the same book.
#[inline(never)]
fn sphere_by_ericson<T: RealField + Sample>(sphere: &Sphere<T>, triangle: &Triangle<T>) -> bool {
    let center = vector(sphere.center());
    let v = of_triangle(center, triangle) - center;
    v.dot(&v) <= sphere.radius() * sphere.radius()
}

#[inline(never)]
fn closest_by_ericson<T: RealField + Sample>(asked: &Asked<T>, triangle: &Triangle<T>) -> bool {
    let found: [T; 3] = of_triangle(Vector3::from(asked.point), triangle).into();
    // A NaN, which is wrong, has no mantissa.
    let approximate = |x: T| if x.is_finite() { x.approximate() } else { f64::NAN };
    asked.is_close(found.map(approximate))
}

pub(super) fn ericson_sphere<T: RealField + Sample>(course: &In<Sphere<T>, T>) -> Candidate {
    course.candidate(PUBLISHED, Promise::Nothing, sphere_by_ericson)
}

pub(super) fn ericson_closest<T: RealField + Sample>(course: &In<Asked<T>, T>) -> Candidate {
    course.candidate(PUBLISHED, Promise::Nothing, closest_by_ericson)
}

fn of_parry(triangle: &Triangle<f32>) -> ParryTriangle {
    let [a, b, c] = triangle.vertices().map(parry_vector);
    ParryTriangle::new(a, b, c)
}

#[inline(never)]
fn sphere_by_parry((at, ball): &(Pose, Ball), triangle: &ParryTriangle) -> bool {
    intersection_test_point_query_ball(at, triangle, ball).intersecting
}

#[inline(never)]
fn capsule_by_parry(capsule: &ParryCapsule, triangle: &ParryTriangle) -> bool {
    let at = Pose::IDENTITY;
    intersection_test(&at, capsule, &at, triangle).is_ok_and(|meet| meet.intersecting)
}

#[inline(never)]
fn closest_by_parry(asked: &Asked<f32>, triangle: &ParryTriangle) -> bool {
    let found = triangle.project_local_point(asked.point.into(), false).point;
    asked.is_close([found.x, found.y, found.z].map(f64::from))
}

pub(super) fn parry_sphere(course: &In<Sphere<f32>, f32>) -> Candidate {
    let ball =
        |s: &Sphere<f32>| (Pose::from_translation(parry_vector(s.center())), Ball::new(s.radius()));
    let course = course.prepared("", |pairs| pairs.map(ball, of_parry));
    course.candidate("parry3d", Promise::Nothing, sphere_by_parry)
}

pub(super) fn parry_capsule(course: &In<Capsule<f32>, f32>) -> Candidate {
    let capsule = |c: &Capsule<f32>| {
        let (a, b) = c.ends();
        ParryCapsule::new(parry_vector(a), parry_vector(b), c.radius())
    };
    let course = course.prepared("", |pairs| pairs.map(capsule, of_parry));
    course.candidate("parry3d", Promise::Nothing, capsule_by_parry)
}

pub(super) fn parry_closest(course: &In<Asked<f32>, f32>) -> Candidate {
    let asked = |a: &Asked<f32>| Asked { ..*a };
    let course = course.prepared("", |pairs| pairs.map(asked, of_parry));
    course.candidate("parry3d", Promise::Nothing, closest_by_parry)
}
