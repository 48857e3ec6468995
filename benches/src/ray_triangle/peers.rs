//! The peers, each through the functions that its users call, on shapes in its own types, made
//! before the clock starts.

use bvh::ray::{Intersection, Ray as BvhRay};
use nalgebra::Point3;
use obvhs::ray::Ray as ObvhsRay;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle as ObvhsTriangle;
use parry3d::query::{Ray as ParryRay, RayCast, RayIntersection};
use parry3d::shape::Triangle as ParryTriangle;
use septum::{Cull, HitRules, Ray, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;
use crate::peer_shapes::{
    Distance, bvh_point, bvh_ray, obvhs_ray, obvhs_triangle, parry_ray, parry_vector,
};
use crate::unit::F32;

use super::ours::course_by;
use super::scenes::Scene;

#[inline(never)]
fn parry(r: &ParryRay, t: &ParryTriangle) -> Option<RayIntersection> {
    t.cast_local_ray_and_get_normal(r, f32::MAX, false)
}

#[inline(never)]
fn parry_t(r: &ParryRay, t: &ParryTriangle) -> Option<f32> {
    t.cast_local_ray(r, f32::MAX, false)
}

#[inline(never)]
fn obvhs(r: &ObvhsRay, t: &ObvhsTriangle) -> Distance {
    Distance(t.intersect(r))
}

#[inline(never)]
fn obvhs_prepared(r: &ObvhsRay, t: &RtTriangle) -> Distance {
    Distance(t.intersect(r))
}

#[inline(never)]
fn bvh(r: &BvhRay<f32, 3>, [a, b, c]: &[Point3<f32>; 3]) -> Intersection<f32> {
    r.intersects_triangle(a, b, c)
}

/// The peers' questions in our types.
type Ours = Course<Ray<f32>, Triangle<f32>>;

/// The course for the peer that culls back faces.
pub fn culling(scene: &Scene) -> Ours {
    let from_before =
        |r: &Ray<f64>, t: &Triangle<f64>| r.is_hit_with(t, HitRules::new().culling(Cull::Back));
    course_by(scene, &F32, "culls", from_before)
}

/// Every peer, in `f32`; the peer that culls has a truth of its own.
pub fn peers(plain: &Ours, culling: &Ours) -> Vec<Candidate> {
    let parry3d = plain.prepared("", |p| p.map(parry_ray, parry_triangle));
    let obvh = plain.prepared("ray prepared", |p| p.map(obvhs_ray, obvhs_triangle));
    let rt = |t: &Triangle<f32>| RtTriangle::from(&obvhs_triangle(t));
    let obvh_rt = plain.prepared("both prepared", |p| p.map(obvhs_ray, rt));
    let bvhs = culling.prepared("culls", |p| p.map(bvh_ray, |t| t.vertices().map(bvh_point)));
    let none = Promise::Nothing;
    vec![
        parry3d.candidate("parry3d cast_local_ray_and_get_normal", none, parry),
        parry3d.candidate("parry3d cast_local_ray", none, parry_t),
        obvh.candidate("obvhs Triangle::intersect", none, obvhs),
        obvh_rt.candidate("obvhs RtTriangle::intersect", none, obvhs_prepared),
        bvhs.candidate("bvh intersects_triangle", none, bvh),
    ]
}

fn parry_triangle(t: &Triangle<f32>) -> ParryTriangle {
    let [a, b, c] = t.vertices().map(parry_vector);
    ParryTriangle::new(a, b, c)
}

impl Answer for Intersection<f32> {
    fn count(&self) -> usize {
        Distance(self.distance).count()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        Distance(self.distance).tell(verdicts);
    }
}
