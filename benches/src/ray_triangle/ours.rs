//! Our methods that take a ray and a triangle as they are, in any scalar.

use septum::prepared::{HitRay, HitTriangle};
use septum::published;
use septum::{Cull, Hit, Ray, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::unit::Unit;

use super::scenes::Scene;

#[inline(never)]
fn exact<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    r.hit(t)
}

#[inline(never)]
fn exact_once<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    r.hit_once(t)
}

#[inline(never)]
fn exact_verdict<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> bool {
    r.is_hit(t)
}

#[inline(never)]
fn prepared<S: Scalar>(r: &HitRay<S>, t: &HitTriangle<S>) -> Option<Hit<S>> {
    r.hit(t)
}

#[inline(never)]
fn prepared_verdict<S: Scalar>(r: &HitRay<S>, t: &HitTriangle<S>) -> bool {
    r.is_hit(t)
}

#[inline(never)]
fn moller_trumbore<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    published::moller_trumbore::hit(r, t, Cull::Nothing)
}

/// The scene in a scalar; the truth is the exact verdict in `f64`.
pub fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Ray<S>, Triangle<S>> {
    course_by(scene, unit, "", Ray::is_hit)
}

/// The same scene with a truth of its own.
pub fn course_by<S: Scalar>(
    scene: &Scene,
    unit: &Unit<S>,
    form: &'static str,
    truth: fn(&Ray<f64>, &Triangle<f64>) -> bool,
) -> Course<Ray<S>, Triangle<S>> {
    let pairs = scene.map(|l| unit.ray(l), |t| unit.triangle(t));
    let wide = pairs.map(|r| unit.wide_ray(r), |t| unit.wide_triangle(t));
    Course::new((unit.name, form), pairs, wide.answers(truth))
}

/// The exact methods, and the common rounded one, in one scalar.
pub fn ours<S: Scalar>(course: &Course<Ray<S>, Triangle<S>>) -> Vec<Candidate> {
    let ready = course.prepared("both prepared", |p| p.map(HitRay::new, HitTriangle::new));
    vec![
        course.candidate("exact hit", Promise::Exact, exact),
        course.candidate("exact is_hit", Promise::Exact, exact_verdict),
        course.candidate("exact hit_once", Promise::NeverInvents, exact_once),
        ready.candidate("exact hit, prepared", Promise::Exact, prepared),
        ready.candidate("exact is_hit, prepared", Promise::Exact, prepared_verdict),
        course.candidate("Möller–Trumbore", Promise::Nothing, moller_trumbore),
    ]
}
