//! The peers, each through the functions that its users call, on shapes in its own types. Shapes
//! are made, and prepared, before the clock starts.

use bvh::aabb::Aabb as BvhAabb;
use bvh::ray::Ray as BvhRay;
use obvhs::aabb::Aabb as ObvhsAabb;
use obvhs::ray::Ray as ObvhsRay;
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::query::{Ray as ParryRay, RayCast};
use septum::{Aabb, Ray, Vec3};

use crate::candidate::{Candidate, Course, Promise};
use crate::peer_shapes::{
    Distance, bvh_point, bvh_ray, obvhs_ray, obvhs_vector, parry_ray, parry_vector,
};
use crate::unit::{F32, Form};

use super::ours::course;
use super::scenes::Scene;

#[inline(never)]
fn parry(r: &ParryRay, b: &ParryAabb) -> Option<f32> {
    b.cast_local_ray(r, f32::MAX, true)
}

#[inline(never)]
fn parry_clip(r: &ParryRay, b: &ParryAabb) -> Option<(f32, f32)> {
    b.clip_ray_parameters(r)
}

#[inline(never)]
fn obvhs(r: &ObvhsRay, b: &ObvhsAabb) -> Distance {
    Distance(b.intersect_ray(r))
}

#[inline(never)]
fn bvh(r: &BvhRay<f32, 3>, b: &BvhAabb<f32, 3>) -> bool {
    r.intersects_aabb(b)
}

#[inline(never)]
fn bvh_slice(r: &BvhRay<f32, 3>, b: &BvhAabb<f32, 3>) -> Option<(f32, f32)> {
    r.intersection_slice_for_aabb(b)
}

fn in_parry(ours: &Course<Ray<f32>, Aabb<f32>>) -> Course<ParryRay, ParryAabb> {
    let aabb = |b: &Aabb<f32>| {
        let (min, max) = corners(b);
        ParryAabb::new(parry_vector(min), parry_vector(max))
    };
    ours.prepared(Form::Corners.name(), |p| p.map(parry_ray, aabb))
}

/// The test that all ratios refer to.
pub fn yardstick(scene: &Scene) -> Candidate {
    let course = course(scene, &F32, Form::Corners);
    parry_cast(&course, "yardstick: parry3d cast_local_ray")
}

/// The same test under its own name.
pub fn parry_cast(ours: &Course<Ray<f32>, Aabb<f32>>, who: &str) -> Candidate {
    in_parry(ours).candidate(who, Promise::Nothing, parry)
}

/// Every peer, in `f32`, on boxes by their corners.
pub fn peers(ours: &Course<Ray<f32>, Aabb<f32>>) -> Vec<Candidate> {
    let form = Form::Corners.name();
    let parry3d = in_parry(ours);
    let obvh = ours.prepared(form, |p| {
        p.map(obvhs_ray, |b| {
            let (min, max) = corners(b);
            ObvhsAabb::new(obvhs_vector(min), obvhs_vector(max))
        })
    });
    let bvhs = ours.prepared(form, |p| {
        p.map(bvh_ray, |b| {
            let (min, max) = corners(b);
            BvhAabb::with_bounds(bvh_point(min), bvh_point(max))
        })
    });
    let none = Promise::Nothing;
    vec![
        parry3d.candidate("parry3d clip_ray_parameters", none, parry_clip),
        obvh.candidate("obvhs intersect_ray", none, obvhs),
        bvhs.candidate("bvh intersects_aabb", none, bvh),
        bvhs.candidate("bvh intersection_slice_for_aabb", none, bvh_slice),
    ]
}

fn corners(b: &Aabb<f32>) -> (Vec3<f32>, Vec3<f32>) {
    b.min_max().expect("made of corners")
}
