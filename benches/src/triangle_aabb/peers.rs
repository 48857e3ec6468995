//! The peers, each through the functions that its users call, on shapes in its own types, made
//! before the clock starts.

use box3d_rust::math_functions as box3d;
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::math::{Pose, Rotation, Vector};
use parry3d::query::{self, details};
use parry3d::shape::{Cuboid, Triangle as ParryTriangle};
use septum::{Aabb, Triangle, Vec3};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Inlined;

use super::voxels::{Voxel, Voxels};

/// A cuboid with a pose.
struct Placed {
    cuboid: Cuboid,
    /// The cuboid in the world.
    pose: Pose,
    /// The world, and so the triangle, in the cuboid's frame.
    inverse: Pose,
}

#[inline(never)]
fn parry_intersection_test(t: &ParryTriangle, b: &Placed) -> bool {
    let found = query::intersection_test(&b.pose, &b.cuboid, &Pose::IDENTITY, t);
    found.is_ok_and(|found| found.intersecting)
}

#[inline(never)]
fn parry_cuboid_triangle(t: &ParryTriangle, b: &Placed) -> bool {
    details::intersection_test_cuboid_triangle(&b.inverse, &b.cuboid, t)
}

#[inline(never)]
fn parry_aabb_triangle(t: &ParryTriangle, b: &ParryAabb) -> bool {
    details::intersection_test_aabb_triangle(b, t)
}

struct Box3dBox {
    center: box3d::Vec3,
    extent: box3d::Vec3,
}

#[inline(never)]
fn box3d_bounds_triangle(t: &[box3d::Vec3; 3], b: &Box3dBox) -> bool {
    box3d::test_bounds_triangle_overlap(b.center, b.extent, t[0], t[1], t[2])
}

/// Boxes by centre and half-extents, and by their corners.
type Ours = Course<Triangle<f32>, Aabb<f32>>;

/// Every peer, in `f32`, with boxes in the form that it takes.
pub fn peers(by_center: &Ours, by_corners: &Ours) -> Vec<Candidate> {
    let placed = by_center.prepared("centre", |pairs| {
        pairs.map(parry_triangle, |b| {
            let (center, half) = center_half(b);
            let cuboid = Cuboid::new(vector(half));
            let pose = Pose::from_parts(vector(center), Rotation::IDENTITY);
            Placed { cuboid, inverse: pose.inverse(), pose }
        })
    });
    let aabbs = by_corners.prepared("corners", |pairs| {
        pairs.map(parry_triangle, |b| {
            let (min, max) = b.min_max().expect("made of corners");
            ParryAabb::new(vector(min), vector(max))
        })
    });
    let box3d = by_center.prepared("centre", |pairs| {
        let aabb = |b: &Aabb<f32>| {
            let (center, half) = center_half(b);
            Box3dBox { center: box3d_vec3(center), extent: box3d_vec3(half) }
        };
        pairs.map(|t: &Triangle<f32>| t.vertices().map(box3d_vec3), aabb)
    });
    let none = Promise::Nothing;
    vec![
        box3d.candidate("box3d-rust test_bounds_triangle_overlap", none, box3d_bounds_triangle),
        placed.candidate("parry3d intersection_test", none, parry_intersection_test),
        placed.candidate("parry3d …_cuboid_triangle", none, parry_cuboid_triangle),
        aabbs.candidate("parry3d …_aabb_triangle", none, parry_aabb_triangle),
    ]
}

struct Box3d;
impl Inlined<Triangle<f32>, Voxel<f32>> for Box3d {
    type Made = [box3d::Vec3; 3];
    fn make(triangle: &Triangle<f32>) -> Self::Made {
        triangle.vertices().map(box3d_vec3)
    }
    #[inline(always)]
    fn ask(&[a, b, c]: &Self::Made, (center, half): Voxel<f32>) -> bool {
        let (center, extent) = (box3d_vec3(center.into()), box3d_vec3(Vec3::splat(half)));
        box3d::test_bounds_triangle_overlap(center, extent, a, b, c)
    }
}

struct Parry;
impl Inlined<Triangle<f32>, Voxel<f32>> for Parry {
    type Made = ParryTriangle;
    fn make(triangle: &Triangle<f32>) -> Self::Made {
        parry_triangle(triangle)
    }
    #[inline(always)]
    fn ask(triangle: &Self::Made, (center, half): Voxel<f32>) -> bool {
        // The triangle in the frame of the cuboid.
        let inverse = Pose::from_parts(-vector(center.into()), Rotation::IDENTITY);
        let cuboid = Cuboid::new(Vector::splat(half));
        details::intersection_test_cuboid_triangle(&inverse, &cuboid, triangle)
    }
}

/// The peers that take boxes by their centre, with each box made just before its test.
pub fn on_the_way(course: &Course<Triangle<f32>, Voxels<f32>>) -> Vec<Candidate> {
    let (none, box3d) = (Promise::Nothing, "box3d-rust test_bounds_triangle_overlap");
    vec![
        course.candidate_inlined::<Box3d>(box3d, none),
        course.candidate_inlined::<Parry>("parry3d …_cuboid_triangle", none),
    ]
}

fn center_half(b: &Aabb<f32>) -> (Vec3<f32>, Vec3<f32>) {
    b.center_half_extents().expect("made of centre and half-extents")
}

fn vector(v: Vec3<f32>) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

fn parry_triangle(t: &Triangle<f32>) -> ParryTriangle {
    let [a, b, c] = t.vertices().map(vector);
    ParryTriangle::new(a, b, c)
}

fn box3d_vec3(v: Vec3<f32>) -> box3d::Vec3 {
    box3d::Vec3 { x: v.x, y: v.y, z: v.z }
}
