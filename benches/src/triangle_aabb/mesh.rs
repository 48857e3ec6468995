//! The main job: voxelizing a mesh triangle by triangle and voxel by voxel, with each box made just
//! before its test.

use std::f64::consts::PI;

use septum::prepared::PreparedTriangle;
use septum::published::{akenine_moller, akenine_moller::Order, shared_normal};
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::obj::{self, Triangles};
use crate::pairs::Inlined;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, I8F8_15, I16F16_18, I16F16_26, I32F32_34, Unit};

use super::peers::on_the_way;
use super::voxels::{self, Scene, Voxel, Voxels};

/// Voxels along the longest side.
const RESOLUTIONS: [u32; 2] = [128, 512];

/// The Utah teapot in 128 voxels.
pub fn teapot() -> Scene {
    voxels::scene(&obj::teapot(), RESOLUTIONS[0])
}

/// A sphere of 65,000 triangles, most of them smaller than one of 128 voxels.
fn sphere() -> Triangles {
    const RINGS: usize = 128;
    let point = |ring: usize, step: usize| {
        let (theta, phi) = (PI * ring as f64, PI * step as f64);
        let (theta, phi) = (theta / RINGS as f64, phi / RINGS as f64);
        [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
    };
    let mut triangles = Vec::new();
    for ring in 0..RINGS {
        for step in 0..2 * RINGS {
            let (a, b) = (point(ring, step), point(ring, step + 1));
            let (c, d) = (point(ring + 1, step), point(ring + 1, step + 1));
            if ring > 0 {
                triangles.push([a, c, b]);
            }
            if ring + 1 < RINGS {
                triangles.push([b, c, d]);
            }
        }
    }
    triangles
}

#[inline(always)]
fn aabb<S: Scalar>((center, half): Voxel<S>) -> Aabb<S> {
    Aabb::from_center_half_extents(center, [half; 3]).expect("a voxel is a box")
}

struct Prepared;
impl<S: Scalar> Inlined<Triangle<S>, Voxel<S>> for Prepared {
    type Made = PreparedTriangle<S>;
    fn make(triangle: &Triangle<S>) -> Self::Made {
        PreparedTriangle::new(triangle)
    }
    #[inline(always)]
    fn ask(triangle: &Self::Made, voxel: Voxel<S>) -> bool {
        triangle.overlaps(&aabb(voxel))
    }
}

/// A test that needs no preparation of the triangle.
macro_rules! plain {
    ($name:ident, $test:expr) => {
        struct $name;
        impl<S: Scalar> Inlined<Triangle<S>, Voxel<S>> for $name {
            type Made = Triangle<S>;
            fn make(triangle: &Triangle<S>) -> Self::Made {
                *triangle
            }
            #[inline(always)]
            fn ask(triangle: &Self::Made, voxel: Voxel<S>) -> bool {
                $test(triangle, &aabb(voxel))
            }
        }
    };
}
plain!(Exact, Triangle::overlaps);
plain!(Rounded, shared_normal::overlaps);
// The compiler decides whether to inline `overlaps`; this form is always inlined.
plain!(AsPublished, |t, b| akenine_moller::overlaps_in(t, b, Order::default()));

fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Triangle<S>, Voxels<S>> {
    let pairs = scene.map_voxels(|t| unit.triangle(t), |x| (unit.near)(x * unit.scale));
    let wide = pairs.map_voxels(|t| unit.wide_triangle(t), unit.value);
    let truth = wide.answers_inlined::<Exact>();
    Course::new((unit.name, "on the way"), pairs, truth)
}

pub fn yardstick(scene: &Scene) -> Candidate {
    let course = course(scene, &F32);
    course.candidate_inlined::<AsPublished>("yardstick: as published", Promise::Nothing)
}

fn ours<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Vec<Candidate> {
    let course = course(scene, unit);
    vec![
        course.candidate_inlined::<Prepared>("exact, prepared", Promise::Exact),
        course.candidate_inlined::<Exact>("exact", Promise::Exact),
        course.candidate_inlined::<Rounded>("rounded", Promise::Nothing),
    ]
}

pub fn groups() -> Vec<Group<Scene>> {
    fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
        (unit.name, Box::new(move |scene| ours(scene, &unit)))
    }
    vec![
        group(F32),
        group(F64),
        group(I8F8_15),
        group(I16F16_18),
        group(I16F16_26),
        group(I32F32_34),
        ("f32 parry3d box3d-rust", Box::new(|scene| on_the_way(&course(scene, &F32)))),
    ]
}

/// The teapot, the sphere, and the caller's meshes.
pub fn run(session: &mut Session, meshes: &[(String, Triangles)]) {
    let ours = [("teapot".to_owned(), obj::teapot()), ("fine sphere".to_owned(), sphere())];
    let groups = groups();
    for (name, triangles) in ours.iter().chain(meshes) {
        for resolution in RESOLUTIONS {
            let title = format!("triangle/box: {name} in {resolution} voxels");
            session.measure(&title, || voxels::scene(triangles, resolution), yardstick, &groups);
        }
    }
}
