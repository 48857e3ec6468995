//! The main job: a mesh in voxels, asked as a voxelizer asks, triangle by triangle and
//! voxel by voxel, each box made on the way.

use std::f64::consts::PI;
use std::io::Cursor;

use septum::prepared::PreparedTriangle;
use septum::{Aabb, Scalar, Triangle, published};

use crate::candidate::{Candidate, Course, Promise};
use crate::geometry::{Cell, Point};
use crate::session::Group;
use crate::unit::{F32, F64, I16F16_18, I32F32_34, Unit};

use super::scenes::{Scene, bounding_box};

/// Voxels along the longest side, which is that of the cube that all scalars hold.
const RESOLUTION: f64 = 128.0;
const SIDE: f64 = 4.0 / RESOLUTION;

/// The Utah teapot in voxels.
pub fn teapot() -> Scene {
    voxels(&teapot_triangles())
}

/// The Utah teapot.
pub(crate) fn teapot_triangles() -> Vec<[Point; 3]> {
    let file = include_bytes!("../../../examples/assets/teapot.obj");
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::GenericFailure);
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(file), &options, no_materials)
        .expect("the teapot is a mesh");
    let mut triangles = Vec::new();
    for tobj::Model { mesh, .. } in &models {
        let point =
            |&i: &u32| std::array::from_fn(|k| f64::from(mesh.positions[3 * i as usize + k]));
        for corners in mesh.indices.as_chunks::<3>().0 {
            triangles.push(std::array::from_fn(|k| point(&corners[k])));
        }
    }
    triangles
}

/// A sphere of 32,000 triangles, most of them smaller than a voxel.
pub fn sphere() -> Scene {
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
    voxels(&triangles)
}

/// Every triangle against the voxels that its bounding box touches. Coordinates are rounded
/// as the narrowest scalar rounds them, to 16 places, so that all have the same mesh.
fn voxels(triangles: &[[Point; 3]]) -> Scene {
    let all: Vec<Point> = triangles.iter().flatten().copied().collect();
    let extreme = |i: usize, f: fn(f64, f64) -> f64| all.iter().map(|p| p[i]).reduce(f);
    let low: Point = std::array::from_fn(|i| extreme(i, f64::min).expect("a mesh has points"));
    let high: Point = std::array::from_fn(|i| extreme(i, f64::max).expect("a mesh has points"));
    let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let placed = |p: Point| {
        std::array::from_fn(|i| {
            let x = (p[i] - (low[i] + high[i]) / 2.0) * 4.0 / longest;
            (x * 65_536.0).round() / 65_536.0
        })
    };
    let mut scene = Scene::default();
    for triangle in triangles {
        let triangle = triangle.map(placed);
        let (min, max) = bounding_box(&triangle);
        // A coordinate on a face touches the voxels on both sides.
        let first: [i32; 3] = std::array::from_fn(|i| (min[i] / SIDE).ceil() as i32 - 1);
        let last: [i32; 3] = std::array::from_fn(|i| (max[i] / SIDE).floor() as i32);
        let center = |n: i32| (f64::from(n) + 0.5) * SIDE;
        let mut cells = Vec::new();
        for z in first[2]..=last[2] {
            for y in first[1]..=last[1] {
                for x in first[0]..=last[0] {
                    let center = [x, y, z].map(center);
                    cells.push(Cell { center, half: [SIDE / 2.0; 3] });
                }
            }
        }
        scene.push(triangle, cells);
    }
    scene
}

/// What a voxelizer has of a voxel: the centre, and half of its side.
type Voxel<S> = ([S; 3], S);

#[inline(always)]
fn aabb<S: Scalar>(&(center, half): &Voxel<S>) -> Aabb<S> {
    Aabb::from_center_half_extents(center, [half; 3]).expect("a voxel is a box")
}

fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Course<Triangle<S>, Voxel<S>> {
    let pairs = scene.map(|t| unit.triangle(t), |c| (unit.point(c.center), unit.point(c.half)[0]));
    let wide = pairs.map(|t| unit.wide_triangle(t), |v| unit.wide_aabb(&aabb(v)));
    Course::new((unit.name, "on the way"), pairs, wide.answers(|t, b| t.overlaps(b)))
}

pub fn yardstick(scene: &Scene) -> Candidate {
    let test = |t: &Triangle<f32>, v: &Voxel<f32>| published::akenine_moller::overlaps(t, &aabb(v));
    course(scene, &F32).candidate_made("yardstick: as published", Promise::Nothing, |t| *t, test)
}

fn ours<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Vec<Candidate> {
    let course = course(scene, unit);
    let exact = |t: &Triangle<S>, v: &Voxel<S>| t.overlaps(&aabb(v));
    let prepared = |t: &PreparedTriangle<S>, v: &Voxel<S>| t.overlaps(&aabb(v));
    let rounded = |t: &Triangle<S>, v: &Voxel<S>| published::shared_normal::overlaps(t, &aabb(v));
    vec![
        course.candidate_made("exact, prepared", Promise::Exact, PreparedTriangle::new, prepared),
        course.candidate_made("exact", Promise::Exact, |t| *t, exact),
        course.candidate_made("rounded", Promise::Nothing, |t| *t, rounded),
    ]
}

pub fn groups() -> Vec<Group<Scene>> {
    fn group<S: Scalar>(unit: Unit<S>) -> Group<Scene> {
        (unit.name, Box::new(move |scene| ours(scene, &unit)))
    }
    vec![group(F32), group(F64), group(I16F16_18), group(I32F32_34)]
}
