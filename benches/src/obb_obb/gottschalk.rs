//! Two oriented boxes by 15 axes, rounded, four numbers of `f32` at once: as engines of games have
//! it.
//!
//! Written from S. Gottschalk, M. C. Lin, D. Manocha, SIGGRAPH 1996, and C. Ericson, "Real-Time
//! Collision Detection", 2005, section 4.4.1: the products of the axes of both boxes, and their
//! magnitudes with a threshold added for parallel edges, serve all axes.

use septum::{Obb, Vec3};
use wide::f32x4;

/// A box in vectors; the fourth number of each is zero.
pub(crate) struct Vectors {
    center: f32x4,
    axes: [f32x4; 3],
    half: f32x4,
}

impl Vectors {
    pub(crate) fn new(obb: &Obb<f32>) -> Self {
        let vector = |v: Vec3<f32>| f32x4::new([v.x, v.y, v.z, 0.0]);
        let (center, half) = (vector(obb.center()), vector(obb.half_extents()));
        Self { center, axes: obb.axes().map(vector), half }
    }
}

/// Added to each product's magnitude, for boxes of about size one.
const THRESHOLD: f32 = 1e-6;

#[inline(never)]
pub(crate) fn overlap(a: &Vectors, b: &Vectors) -> bool {
    let axes = transposed(a.axes);
    let columns = b.axes.map(|v| sum(axes, v));
    let rows = transposed(columns);
    let way = sum(axes, b.center - a.center);
    let size = |x: f32x4| x.abs() + f32x4::splat(THRESHOLD);
    let (column_sizes, row_sizes) = (columns.map(size), rows.map(size));

    if exceeds(way, a.half + sum(column_sizes, b.half)) {
        return false;
    }
    if exceeds(sum(rows, way), b.half + sum(row_sizes, a.half)) {
        return false;
    }
    let (next, last) = (turned(b.half), turned(turned(b.half)));
    // The axes that are products of axis i of the first box, with each of the second.
    let separates = |i: usize, l: usize, m: usize| {
        let distance = lane(way, m) * rows[l] - lane(way, l) * rows[m];
        let of_first = lane(a.half, l) * row_sizes[m] + lane(a.half, m) * row_sizes[l];
        let of_second = next * turned(turned(row_sizes[i])) + last * turned(row_sizes[i]);
        exceeds(distance, of_first + of_second)
    };
    !(separates(0, 1, 2) || separates(1, 2, 0) || separates(2, 0, 1))
}

#[inline(always)]
fn exceeds(distance: f32x4, reach: f32x4) -> bool {
    distance.abs().simd_gt(reach).to_bitmask() & 7 != 0
}

/// The sum of three rows, each times a number of `times`.
#[inline(always)]
fn sum([x, y, z]: [f32x4; 3], times: f32x4) -> f32x4 {
    x * lane(times, 0) + y * lane(times, 1) + z * lane(times, 2)
}

#[inline(always)]
fn lane(v: f32x4, k: usize) -> f32x4 {
    f32x4::splat(v.to_array()[k])
}

/// The first three numbers turned by one place.
#[inline(always)]
fn turned(v: f32x4) -> f32x4 {
    let [x, y, z, w] = v.to_array();
    f32x4::new([y, z, x, w])
}

#[inline(always)]
fn transposed(rows: [f32x4; 3]) -> [f32x4; 3] {
    let [a, b, c] = rows.map(f32x4::to_array);
    [0, 1, 2].map(|i| f32x4::new([a[i], b[i], c[i], 0.0]))
}
