//! The candidates, on shapes in the peers' own types.

use septum::mesh::Tree;
use septum::{Obb, Ray, Triangle};

use super::foreign::{BulletBox, Embree, JoltBox, JoltVectors, TinyRay, TinyTree, jolt_t};
use crate::candidate::{Candidate, Course, Promise};
use crate::contact::{Sunk, in_form};

const NONE: Promise = Promise::Nothing;

#[inline(never)]
fn jolt_overlaps(a: &JoltBox, b: &JoltBox) -> bool {
    a.overlaps(b)
}

pub(crate) fn boxes(course: &Course<Obb<f32>, Obb<f32>>) -> Vec<Candidate> {
    let jolt = course.prepared("", |p| p.map(JoltBox::new, JoltBox::new));
    vec![jolt.candidate("Jolt OrientedBox::Overlaps", NONE, jolt_overlaps)]
}

#[inline(never)]
fn bullet(sunk: &Sunk<BulletBox>, _: &()) -> bool {
    sunk.is_told_by(BulletBox::contact)
}

pub(crate) fn contacts(course: &Course<Sunk<Obb<f32>>, ()>) -> Vec<Candidate> {
    let bullets = in_form(course, BulletBox::new);
    vec![bullets.candidate("Bullet btBoxBoxDetector", NONE, bullet)]
}

#[inline(never)]
fn jolt_ray(ray: &JoltVectors<2>, triangle: &JoltVectors<3>) -> Option<f32> {
    jolt_t(ray, triangle)
}

pub(crate) fn rays(course: &Course<Ray<f32>, Triangle<f32>>) -> Vec<Candidate> {
    let ray = |r: &Ray<f32>| JoltVectors::new([r.origin(), r.direction()]);
    let triangle = |t: &Triangle<f32>| JoltVectors::new(*t.vertices());
    let jolt = course.prepared("", |p| p.map(ray, triangle));
    vec![jolt.candidate("Jolt RayTriangle", NONE, jolt_ray)]
}

type Numbers = [f32; 6];

#[inline(never)]
fn embree_first(ray: &Numbers, scene: &Embree) -> bool {
    scene.first_hit(ray)
}

#[inline(never)]
fn embree_any(ray: &Numbers, scene: &Embree) -> bool {
    scene.any_hit(ray)
}

#[inline(never)]
fn tiny_first(ray: &TinyRay, tree: &TinyTree) -> bool {
    tree.first_hit(ray)
}

#[inline(never)]
fn tiny_any(ray: &TinyRay, tree: &TinyTree) -> bool {
    tree.any_hit(ray)
}

pub(crate) fn trees(course: &Course<Ray<f32>, Tree<'static, f32, u32>>) -> Vec<Candidate> {
    let numbers = |r: &Ray<f32>| {
        let (o, d) = (r.origin(), r.direction());
        [o.x, o.y, o.z, d.x, d.y, d.z]
    };
    let embree = |is_robust| {
        course.prepared("", |p| p.map(numbers, |tree| Embree::new(tree.mesh(), is_robust)))
    };
    let (fast, robust) = (embree(false), embree(true));
    let tiny = course
        .prepared("", |p| p.map(|r| TinyRay::new(&numbers(r)), |tree| TinyTree::new(tree.mesh())));
    vec![
        fast.candidate("embree, first hit", NONE, embree_first),
        fast.candidate("embree, any hit", NONE, embree_any),
        robust.candidate("embree robust, first hit", NONE, embree_first),
        robust.candidate("embree robust, any hit", NONE, embree_any),
        tiny.candidate("tinybvh BVH8_CPU, first hit", NONE, tiny_first),
        tiny.candidate("tinybvh BVH8_CPU, any hit", NONE, tiny_any),
    ]
}
