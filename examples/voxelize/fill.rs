//! Voxelization: which voxels does the mesh meet?

use std::ops::RangeInclusive;
use std::time::Duration;

use fixed::types::{I8F8, I16F16, I32F32};
use septum::prepared::PreparedTriangle;
use septum::published;
use septum::{Aabb, Scalar, ShapeError, Triangle};

use crate::grid::Grid;
use crate::options::{Method, ScalarType};
use crate::placement::Placed;
use crate::progress::Progress;

/// The voxels that the mesh meets, and the cost of finding them.
pub(crate) struct Filled {
    pub(crate) grid: Grid,
    /// Overlap tests made.
    pub(crate) tests: u64,
    /// The time of the tests alone.
    pub(crate) time: Duration,
    /// How far a coordinate moved at most when rounded to the scalar, in voxels.
    pub(crate) moved: f64,
}

/// Sets every voxel that overlaps a triangle, according to the method.
pub(crate) fn fill(
    mesh: &Placed,
    scalar: ScalarType,
    method: Method,
) -> Result<Filled, ShapeError> {
    match scalar {
        ScalarType::F32 => by_method(mesh, method, |x| x as f32, f64::from),
        ScalarType::F64 => by_method(mesh, method, |x| x, |x| x),
        ScalarType::I8F8 => by_method(mesh, method, I8F8::from_num, I8F8::to_num),
        ScalarType::I16F16 => by_method(mesh, method, I16F16::from_num, I16F16::to_num),
        ScalarType::I32F32 => by_method(mesh, method, I32F32::from_num, I32F32::to_num),
    }
}

fn by_method<S: Scalar>(
    mesh: &Placed,
    method: Method,
    nearest: impl Fn(f64) -> S,
    value: impl Fn(S) -> f64,
) -> Result<Filled, ShapeError> {
    let (cells, half) = (Cells::new(mesh, &nearest), [nearest(0.5); 3]);
    let (triangles, moved) = rounded(mesh, nearest, value)?;
    let work = Work { size: mesh.size, cells, half, triangles };
    let (grid, tests, time) = match method {
        Method::Exact => work.run(PreparedTriangle::new, |t, b| t.overlaps(b)),
        Method::ExactPairs => work.run(|t| *t, |t, b| t.overlaps(b)),
        Method::Conservative => work.run(|t| *t, |t, b| t.may_overlap(b)),
        Method::Published => work.run(|t| *t, published::akenine_moller::overlaps),
        Method::Rounded => work.run(|t| *t, published::shared_normal::overlaps),
    }?;
    Ok(Filled { grid, tests, time, moved })
}

/// A triangle, and the voxels that its bounding box touches.
struct Candidates<S> {
    triangle: Triangle<S>,
    ranges: [RangeInclusive<usize>; 3],
}

impl<S> Candidates<S> {
    fn count(&self) -> u64 {
        self.ranges.iter().map(|r| (r.end() - r.start() + 1) as u64).product()
    }
}

/// The mesh rounded to the scalar. All verdicts are about this mesh.
fn rounded<S: Scalar>(
    mesh: &Placed,
    nearest: impl Fn(f64) -> S,
    value: impl Fn(S) -> f64,
) -> Result<(Vec<Candidates<S>>, f64), ShapeError> {
    let mut moved = 0_f64;
    let mut triangles = Vec::with_capacity(mesh.triangles.len());
    for points in &mesh.triangles {
        let [a, b, c] = points.map(|p| p.map(&nearest));
        let values = [a, b, c].map(|p| p.map(&value));
        for (x, y) in points.as_flattened().iter().zip(values.as_flattened()) {
            moved = moved.max((x - y).abs());
        }
        let ranges = [0, 1, 2].map(|i| touched(mesh, i, values.map(|p| p[i])));
        triangles.push(Candidates { triangle: Triangle::new(a, b, c)?, ranges });
    }
    Ok((triangles, moved))
}

/// The voxels along an axis that the interval of these coordinates touches. Both are
/// closed sets, so that a coordinate on a whole number touches both neighbours.
fn touched(mesh: &Placed, axis: usize, [a, b, c]: [f64; 3]) -> RangeInclusive<usize> {
    let last = (mesh.size[axis] - 1) as f64;
    let first_touched = a.min(b).min(c).ceil() - 1.0 - mesh.start(axis);
    let last_touched = a.max(b).max(c).floor() - mesh.start(axis);
    let index = |x: f64| x.clamp(0.0, last) as usize;
    index(first_touched)..=index(last_touched)
}

/// The coordinates of voxel centres along each axis. All are exact in every scalar.
struct Cells<S>([Vec<S>; 3]);

impl<S> Cells<S> {
    fn new(mesh: &Placed, nearest: impl Fn(f64) -> S) -> Self {
        let center = |axis, i| nearest(mesh.start(axis) + i as f64 + 0.5);
        Self([0, 1, 2].map(|axis| (0..mesh.size[axis]).map(|i| center(axis, i)).collect()))
    }
}

struct Work<S> {
    size: [usize; 3],
    cells: Cells<S>,
    half: [S; 3],
    triangles: Vec<Candidates<S>>,
}

impl<S: Scalar> Work<S> {
    fn run<T>(
        &self,
        prepare: impl Fn(&Triangle<S>) -> T,
        overlap: impl Fn(&T, &Aabb<S>) -> bool,
    ) -> Result<(Grid, u64, Duration), ShapeError> {
        let mut grid = Grid::new(self.size);
        let tests = self.triangles.iter().map(Candidates::count).sum();
        let progress = Progress::new("Testing", tests);
        let [xs, ys, zs] = &self.cells.0;
        // Reading the clock takes as long as a test, and is not done after each.
        let mut unreported = 0;
        for Candidates { triangle, ranges: [i, j, k] } in &self.triangles {
            let triangle = prepare(triangle);
            for z in k.clone() {
                for y in j.clone() {
                    for x in i.clone() {
                        let center = [xs[x], ys[y], zs[z]];
                        let voxel = Aabb::from_center_half_extents(center, self.half)?;
                        if overlap(&triangle, &voxel) {
                            grid.set([x, y, z]);
                        }
                    }
                    unreported += (i.end() - i.start() + 1) as u64;
                }
                if unreported > 1 << 16 {
                    progress.add(std::mem::take(&mut unreported));
                }
            }
        }
        Ok((grid, tests, progress.finish()))
    }
}
