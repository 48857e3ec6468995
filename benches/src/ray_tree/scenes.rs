//! The workloads: a knot of 90,000 triangles, and rays at it.

use septum::Scalar;
use septum::mesh::Tree;
use septum_kit::Rng;

use crate::geometry::{Line, Point};
use crate::pairs::Pairs;
use crate::unit::Unit;

use super::knot::{Aim, knot, rays};
use super::trees::tree;

/// A scale that keeps the rays' origins in the range of every scalar. It rounds nothing in floats.
const SCALE: f64 = 0.25;

/// Rays, all against one mesh.
pub type Scene = Pairs<Line, Mesh>;

/// A mesh before its conversion to a scalar.
pub struct Mesh {
    points: Vec<Point>,
    faces: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh in a scalar, with a tree over it.
    pub fn tree<S: Scalar>(&self, unit: &Unit<S>) -> Tree<'static, S, u32> {
        let vertices = self.points.iter().map(|&p| unit.point(p).into()).collect();
        tree(vertices, &self.faces).expect("the knot is a mesh").0
    }
}

/// `count` rays from a seed.
pub fn scene(aim: Aim, seed: u64, count: usize) -> Scene {
    let (points, faces) = knot(900);
    let placed = |p: [f32; 3]| p.map(|x| f64::from(x) * SCALE);
    let line = |[origin, target]: [[f32; 3]; 2]| Line::towards(placed(origin), placed(target));
    let lines = rays(&points, aim, count, &mut Rng::new(seed)).into_iter().map(line).collect();
    let points = points.into_iter().map(placed).collect();
    Pairs::all_against(lines, vec![Mesh { points, faces }])
}

const RAYS: usize = 4_000;

/// Rays from anywhere to anywhere.
pub fn random() -> Scene {
    scene(Aim::Anywhere, 7, RAYS)
}

/// Rays at vertices.
pub fn at_vertices() -> Scene {
    scene(Aim::Vertex, 8, RAYS)
}
