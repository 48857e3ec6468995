//! Candidates for ray queries on a tree: ours in any scalar, and the peers in `f32`.

use obvhs::bvh2::Bvh2;
use obvhs::cwbvh::CwBvh;
use obvhs::ray::Ray as ObvhsRay;
use parry3d::query::{Ray as ParryRay, RayCast};
use parry3d::shape::TriMesh;
use septum::mesh::Tree;
use septum::prepared::{HitRay, HitTriangle};
use septum::{Hit, Ray, Scalar};

use crate::candidate::{Candidate, Course, Promise};
use crate::native;
use crate::peer_shapes::{obvhs_ray, parry_ray};
use crate::unit::{F32, Unit};

use super::scenes::Scene;
use super::trees::{Obvhs, parry_mesh};

#[inline(never)]
fn first_hit<S: Scalar>(r: &Ray<S>, tree: &Tree<'static, S, u32>) -> Option<(usize, Hit<S>)> {
    tree.first_hit(r)
}

#[inline(never)]
fn is_hit<S: Scalar>(r: &Ray<S>, tree: &Tree<'static, S, u32>) -> bool {
    tree.is_hit(r)
}

#[inline(never)]
fn parry(r: &ParryRay, mesh: &TriMesh) -> Option<f32> {
    mesh.cast_local_ray(r, f32::MAX, false)
}

#[inline(never)]
fn bvh2(r: &ObvhsRay, tree: &Obvhs<Bvh2>) -> bool {
    tree.is_hit(r)
}

#[inline(never)]
fn cwbvh(r: &ObvhsRay, tree: &Obvhs<CwBvh>) -> bool {
    tree.is_hit(r)
}

/// Rays in a scalar, and the tree that all of them descend.
type In<S> = Course<Ray<S>, Tree<'static, S, u32>>;

/// The scene in a scalar. The truth is whether there is a hit, found by testing every triangle
/// exactly in `f64`. At a vertex that six triangles share, no peer promises which triangle it
/// returns.
pub fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> In<S> {
    let pairs = scene.map(|line| unit.ray(line), |mesh| mesh.tree(unit));
    let all = |tree: &Tree<'static, S, u32>| -> Vec<_> {
        tree.mesh().iter().map(|t| HitTriangle::new(&unit.wide_triangle(&t))).collect()
    };
    let wide = pairs.map(|r| HitRay::new(&unit.wide_ray(r)), all);
    let truth = wide.answers(|r, all| all.iter().any(|t| r.is_hit(t)));
    Course::new((unit.name, ""), pairs, truth)
}

/// The tree that all ratios refer to.
pub fn yardstick(scene: &Scene) -> Candidate {
    yardstick_on(&course(scene, &F32))
}

/// The same tree on any course.
pub fn yardstick_on(course: &In<f32>) -> Candidate {
    let mesh = |tree: &Tree<'_, f32, u32>| parry_mesh(tree.mesh()).expect("ours is a mesh, too");
    let course = course.prepared("", |p| p.map(parry_ray, mesh));
    course.candidate("yardstick: parry3d TriMesh", Promise::Nothing, parry)
}

/// Ours in one scalar.
pub fn ours<S: Scalar>(course: &In<S>) -> Vec<Candidate> {
    vec![
        course.candidate("exact first_hit", Promise::Exact, first_hit),
        course.candidate("exact is_hit", Promise::Exact, is_hit),
    ]
}

/// The other peers.
pub fn peers(course: &In<f32>) -> Vec<Candidate> {
    let of_bvh2 = course.prepared("", |p| p.map(obvhs_ray, |tree| Obvhs::bvh2(tree.mesh())));
    let of_cwbvh = course.prepared("", |p| p.map(obvhs_ray, |tree| Obvhs::cwbvh(tree.mesh())));
    let mut all = vec![
        of_bvh2.candidate("obvhs Bvh2, slowest build", Promise::Nothing, bvh2),
        of_cwbvh.candidate("obvhs CwBvh, slowest build", Promise::Nothing, cwbvh),
    ];
    all.extend(native::trees(course));
    all
}
