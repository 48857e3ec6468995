//! Shapes in the peers' types, and conversions of their results.

use bvh::ray::Ray as BvhRay;
use nalgebra::{Point3, Vector3};
use obvhs::ray::Ray as ObvhsRay;
use obvhs::triangle::Triangle as ObvhsTriangle;
use parry3d::math::Vector;
use parry3d::query::Ray as ParryRay;
use septum::{Ray, Triangle, Vec3};

use crate::pairs::Answer;

pub fn parry_ray(r: &Ray<f32>) -> ParryRay {
    ParryRay::new(parry_vector(r.origin()), parry_vector(r.direction()))
}

pub fn parry_vector(v: Vec3<f32>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

/// With reciprocals.
pub fn obvhs_ray(r: &Ray<f32>) -> ObvhsRay {
    ObvhsRay::new_inf(obvhs_vector(r.origin()), obvhs_vector(r.direction()))
}

/// Its vectors are `glam`'s, in the version that it was built with.
pub fn obvhs_vector<V: From<[f32; 3]>>(v: Vec3<f32>) -> V {
    V::from([v.x, v.y, v.z])
}

pub fn obvhs_triangle(t: &Triangle<f32>) -> ObvhsTriangle {
    let [v0, v1, v2] = t.vertices().map(obvhs_vector);
    ObvhsTriangle { v0, v1, v2 }
}

/// With reciprocals. It normalizes the direction.
pub fn bvh_ray(r: &Ray<f32>) -> BvhRay<f32, 3> {
    let d = r.direction();
    BvhRay::new(bvh_point(r.origin()), Vector3::new(d.x, d.y, d.z))
}

pub fn bvh_point(v: Vec3<f32>) -> Point3<f32> {
    Point3::new(v.x, v.y, v.z)
}

/// t, or infinity.
pub struct Distance(pub f32);

impl Answer for Distance {
    fn count(&self) -> usize {
        usize::from(self.0 < f32::INFINITY)
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.push(self.0 < f32::INFINITY);
    }
}
