//! A whole mesh: the teapot of `keep_out`, with 1,044 triangles in flash, by a tree and one by one.
//! The tree is built here, in RAM; in flash it has the same size. Boxes surround vertices, and are
//! a thirtieth or a 120th of the mesh wide; rays point at vertices, and half of the points are on
//! the mesh.

use core::hint::black_box;

use fixed::types::I16F16;
use septum::mesh::{Mesh, Node, Tree};
use septum::{Aabb, HitRules, Ray, Triangle, Vec3};

use crate::CORE;
use crate::firmware::say;
use crate::meter::{Ask, Meter, Taken};
use crate::workload::Rng;

#[rustfmt::skip]
#[allow(dead_code, reason = "its parts are for others")]
#[path = "../assets/teapot.rs"]
mod teapot;

use teapot::{FACES, VERTICES};

/// The number of questions of each kind.
const CASES: usize = 16;
const TRIANGLES: usize = FACES.len();

type Teapot<'a> = Tree<'a, I16F16, u16>;

/// Measures all queries about the mesh; `false` on failure.
pub(crate) fn all(meter: &Meter) -> bool {
    let mut nodes = [Node::EMPTY; Node::count_for(TRIANGLES)];
    let mut order = [0; TRIANGLES];
    let Ok(mesh) = Mesh::new(&VERTICES, &FACES) else { return false };
    let Ok(tree) = Tree::build(mesh, &mut nodes, &mut order) else { return false };
    let mut rng = Rng::new();
    let mut points = [(); CASES].map(|()| near(&mut rng));
    let boxes = |half: I16F16| points.map(|p| Aabb::from_center_half_extents(p, [half; 3]));
    let (boxes, small) = (boxes(I16F16::lit("0.5")), boxes(I16F16::lit("0.125")));
    let one = I16F16::ONE;
    let rays = points.map(|p| {
        let o = Vec3::new(p.x.signum() + one, one + one, I16F16::lit("20"));
        Ray::new(o, [p.x - o.x, p.y - o.y, p.z - o.z])
    });
    line(meter, "mesh/box", "tree", &tree, &boxes, |t, b| t.overlapping(b).count() > 0);
    line(meter, "mesh/small box", "tree", &tree, &small, |t, b| t.overlapping(b).count() > 0);
    line(meter, "mesh/box", "one by one", &tree, &boxes, |t, b| {
        triangles(t).filter(|t| t.overlaps(b)).count() > 0
    });
    line(meter, "mesh/ray first hit", "tree", &tree, &rays, |t, r| {
        black_box(t.first_hit(r)).is_some()
    });
    line(meter, "mesh/ray any hit", "tree", &tree, &rays, |t, r| t.is_hit(r));
    line(meter, "mesh/ray any hit", "one by one", &tree, &rays, |t, r| {
        triangles(t).filter(|t| r.is_hit(t)).count() > 0
    });
    // Half of them on the mesh.
    for p in points.iter_mut().step_by(2) {
        p.y += I16F16::lit("0.375");
    }
    let points = points.map(Ok::<_, ()>);
    line(meter, "mesh/point contains", "tree", &tree, &points, |t, &p| t.contains(p));
    line(meter, "mesh/point contains", "one by one", &tree, &points, |t, &p| {
        let Ok(row) = Ray::new(p, [I16F16::ONE, I16F16::ZERO, I16F16::ZERO]) else { return false };
        let rules = HitRules::new().once();
        triangles(t).filter(|t| t.contains(p) || row.is_hit_with(t, rules)).count() % 2 == 1
    });
    // A sixteenth of the size is near the origin.
    let small = |p: Vec3<I16F16>| Vec3::from(p.to_array().map(|x| x >> 4));
    let vertices = VERTICES.map(small);
    let Ok(mesh) = Mesh::new(&vertices, &FACES) else { return false };
    let Ok(tree) = Tree::build(mesh, &mut nodes, &mut order) else { return false };
    let Ok(tree) = tree.near() else { return false };
    let rays =
        rays.map(|r| r.and_then(|r| Ray::new(small(r.origin()), small(r.direction()))?.near()));
    line(meter, "mesh/ray first hit", "near", &tree, &rays, |t, r| {
        black_box(t.first_hit(r)).is_some()
    });
    line(meter, "mesh/ray any hit", "near", &tree, &rays, |t, r| t.is_hit(r));
    true
}

fn triangles(tree: &Teapot<'_>) -> impl Iterator<Item = Triangle<I16F16>> {
    tree.mesh().iter()
}

/// A vertex of the mesh.
fn near(rng: &mut Rng) -> Vec3<I16F16> {
    VERTICES[rng.below(VERTICES.len())]
}

fn line<T: Copy, B: Copy, E>(
    meter: &Meter,
    query: &str,
    mode: &str,
    tree: &T,
    shapes: &[Result<B, E>; CASES],
    ask: Ask<T, B>,
) {
    let mut taken = Taken::default();
    for shape in shapes.iter().flatten() {
        meter.add(&mut taken, &[(*tree, *shape)], ask);
    }
    let (instructions, stack) = (taken.instructions(), taken.stack() as u32);
    say!("{},{},I16F16,{},teapot,{},{}", CORE, query, mode, instructions, stack);
}
