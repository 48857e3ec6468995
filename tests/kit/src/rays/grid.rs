//! Every triangle of some points against some rays. The oracle runs once for three vertices, the
//! crate for all six orders in `f32`, and in the other scalars for one of them in turn. The check is
//! in this package so that it is compiled with full optimization.

use std::ops::Range;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::prepared::{HitRay, HitTriangle};
use septum::{Facing, Feature, Ray, Triangle};

use super::{RayCase, Truth, crossing};
use crate::{Each, Sample, VERTEX_ORDERS};

type Point = [f64; 3];

/// The points of the cube with whole coordinates up to `most`.
pub fn grid(most: i64) -> Vec<[f64; 3]> {
    let side = || -most..=most;
    let row = |x, y| side().map(move |z| [x as f64, y as f64, z as f64]);
    side().flat_map(|x| side().flat_map(move |y| row(x, y))).collect()
}

/// All triples of grid points regardless of order, repetitions included.
fn triples(points: &[Point]) -> impl Iterator<Item = [Point; 3]> {
    let n = points.len();
    (0..n).flat_map(move |a| {
        (a..n).flat_map(move |b| (b..n).map(move |c| [points[a], points[b], points[c]]))
    })
}

/// The facing and feature of the hit after reordering the vertices.
fn reordered(truth: &Truth, order: [usize; 3], is_odd: bool) -> (Facing, Feature) {
    let facing = match (truth.facing, is_odd) {
        (facing, false) => facing,
        (Facing::Front, true) => Facing::Back,
        (Facing::Back, true) => Facing::Front,
    };
    let place = |vertex: u8| order.iter().position(|&k| k == usize::from(vertex)).unwrap() as u8;
    let feature = match truth.feature {
        Feature::Interior => Feature::Interior,
        Feature::Vertex(k) => Feature::Vertex(place(k)),
        // The edge opposite a vertex begins at the next one.
        Feature::Edge(k) => Feature::Edge((place((k + 2) % 3) + 1) % 3),
    };
    (facing, feature)
}

/// Checks the crate, in some orders of the vertices.
fn check<S: Sample>(
    vertices: &[Point; 3],
    ray: &Ray<S>,
    truth: Option<&Truth>,
    orders: Range<usize>,
) {
    let vertices = vertices.each(|v| v.each(S::nearest));
    for n in orders {
        let order = VERTEX_ORDERS[n];
        let [a, b, c] = order.each(|k| vertices[k]);
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        let found = ray.hit(&triangle);
        let expected = truth.map(|truth| reordered(truth, order, n >= 3));
        let is_right = found.map(|hit| (hit.facing, hit.feature)) == expected
            && ray.is_hit(&triangle) == expected.is_some()
            && HitRay::new(ray).is_hit(&HitTriangle::new(&triangle)) == expected.is_some();
        assert!(is_right, "{triangle:?}, {ray:?}: {found:?}, not {expected:?}");
    }
}

fn rays_in<S: Sample>(rays: &[(Point, Point)]) -> Vec<Ray<S>> {
    let ray = |&(o, d): &(Point, Point)| Ray::new(o.each(S::nearest), d.each(S::nearest)).unwrap();
    rays.iter().map(ray).collect()
}

/// The numbers of crossings in the interior, and of contacts.
pub fn every_triangle(points: &[[f64; 3]], rays: &[([f64; 3], [f64; 3])]) -> [u32; 2] {
    let (single, double) = (rays_in::<f32>(rays), rays_in::<f64>(rays));
    let (i4f4, i8f8) = (rays_in::<I4F4>(rays), rays_in::<I8F8>(rays));
    let (i16f16, i32f32) = (rays_in::<I16F16>(rays), rays_in::<I32F32>(rays));
    let mut counts = [0; 2];
    for (turn, vertices) in triples(points).enumerate() {
        for (n, &(origin, direction)) in rays.iter().enumerate() {
            let truth = crossing(&RayCase::new(origin, direction, vertices));
            let truth = truth.as_ref();
            if let Some(truth) = truth {
                counts[usize::from(truth.feature != Feature::Interior)] += 1;
            }
            check(&vertices, &single[n], truth, 0..6);
            let order = (n + turn) % 6;
            let next = order + 1;
            check(&vertices, &double[n], truth, order..next);
            check(&vertices, &i4f4[n], truth, order..next);
            check(&vertices, &i8f8[n], truth, order..next);
            check(&vertices, &i16f16[n], truth, order..next);
            check(&vertices, &i32f32[n], truth, order..next);
        }
    }
    counts
}
