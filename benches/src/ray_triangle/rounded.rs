//! Our rounded methods that prepare the triangle or the ray.

use septum::published;
use septum::published::projected::ProjectedTriangle;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Cull, Hit, Ray, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::peer_shapes::Distance;

#[inline(never)]
fn stored_normal<S: Scalar>(r: &Ray<S>, t: &NormalTriangle<S>) -> Option<Hit<S>> {
    published::stored_normal::hit(r, t, Cull::Nothing)
}

/// t alone, or infinity.
#[inline(never)]
fn stored_normal_t(r: &Ray<f32>, t: &NormalTriangle<f32>) -> Distance {
    Distance(published::stored_normal::t(r, t, Cull::Nothing, f32::INFINITY))
}

#[inline(never)]
fn projected<S: Scalar>(r: &Ray<S>, t: &ProjectedTriangle<S>) -> Option<Hit<S>> {
    published::projected::hit(r, t, Cull::Nothing)
}

#[inline(never)]
fn volumes<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    published::volumes::hit(r, t, Cull::Nothing)
}

#[inline(never)]
fn watertight<S: Scalar>(r: &ShearedRay<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    r.hit(t, Cull::Nothing)
}

#[inline(never)]
fn watertight_at_once<S: Scalar>(r: &Ray<S>, t: &Triangle<S>) -> Option<Hit<S>> {
    ShearedRay::new(r).hit(t, Cull::Nothing)
}

/// The rounded methods in one scalar.
pub fn rounded<S: Scalar>(plain: &Course<Ray<S>, Triangle<S>>) -> Vec<Candidate> {
    let normal = plain.prepared("triangle prepared", |p| p.map(Ray::clone, NormalTriangle::new));
    let flat = plain.prepared("triangle prepared", |p| p.map(Ray::clone, ProjectedTriangle::new));
    let sheared = plain.prepared("ray prepared", |p| p.map(ShearedRay::new, Triangle::clone));
    let none = Promise::Nothing;
    vec![
        normal.candidate("stored normal", none, stored_normal),
        flat.candidate("projected", none, projected),
        plain.candidate("volumes", none, volumes),
        sheared.candidate("watertight (Woop)", none, watertight),
        plain.candidate("watertight (Woop)", none, watertight_at_once),
    ]
}

/// A test in `f32` that returns only t, as the peers do.
pub fn distance_only(plain: &Course<Ray<f32>, Triangle<f32>>) -> Candidate {
    let normal = plain.prepared("triangle prepared", |p| p.map(Ray::clone, NormalTriangle::new));
    normal.candidate("stored normal, t alone", Promise::Nothing, stored_normal_t)
}
