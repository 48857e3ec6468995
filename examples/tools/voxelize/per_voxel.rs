//! One overlap test for each voxel that the bounding box of a triangle touches, which the method by
//! rows avoids.

use std::ops::Range;

use septum::prepared::PreparedTriangle;
use septum::voxel::Grid;
use septum::{Aabb, Scalar, Triangle, published};

use crate::options::Method;

/// A test for each voxel.
pub(crate) struct PerVoxel<S> {
    method: Method,
    /// The planes of the grid on each axis.
    planes: [Vec<S>; 3],
}

impl<S: Scalar> PerVoxel<S> {
    /// `None` for the method by rows.
    pub(crate) fn new(grid: &Grid<S>, method: Method) -> Option<Self> {
        if method == Method::Rows {
            return None;
        }
        let size = grid.resolution();
        let planes = [0, 1, 2].map(|axis| {
            let corner = |k: u32, end: usize| {
                let mut voxel = [0; 3];
                voxel[axis] = k;
                let (min, max) = grid.voxel(voxel).and_then(|v| v.min_max()).expect("a voxel");
                [min, max][end].to_array()[axis]
            };
            (0..size[axis]).map(|k| corner(k, 0)).chain([corner(size[axis] - 1, 1)]).collect()
        });
        Some(Self { method, planes })
    }

    /// The voxels along an axis that the triangle's box touches, as closed sets.
    fn touched(&self, axis: usize, triangle: &Triangle<S>) -> Range<u32> {
        let planes = &self.planes[axis];
        let all = triangle.vertices().map(|v| v.to_array()[axis]);
        let is_before = |p: S| all.iter().all(|&x| p < x);
        let is_not_behind = |p: S| all.iter().any(|&x| p <= x);
        let from = planes.partition_point(|&p| is_before(p)).saturating_sub(1);
        let to = planes.partition_point(|&p| is_not_behind(p)).min(planes.len() - 1);
        from as u32..to as u32
    }

    /// The number of voxels that the triangle is tested against.
    pub(crate) fn candidates(&self, triangle: &Triangle<S>) -> u64 {
        [0, 1, 2].map(|axis| self.touched(axis, triangle).len() as u64).iter().product()
    }

    /// Sets the bits of the voxels that the triangle meets, in the layers of `words`.
    pub(crate) fn fill(&self, triangle: &Triangle<S>, layers: Range<u32>, words: &mut [u64]) {
        match self.method {
            Method::Rows | Method::PerVoxel => {
                let triangle_prepared = PreparedTriangle::new(triangle);
                self.ask(triangle, layers, words, |v| triangle_prepared.overlaps(v));
            }
            Method::ExactPairs => self.ask(triangle, layers, words, |v| triangle.overlaps(v)),
            Method::Conservative => self.ask(triangle, layers, words, |v| triangle.may_overlap(v)),
            Method::Published => self
                .ask(triangle, layers, words, |v| published::akenine_moller::overlaps(triangle, v)),
            Method::Rounded => self
                .ask(triangle, layers, words, |v| published::shared_normal::overlaps(triangle, v)),
        }
    }

    fn ask(
        &self,
        triangle: &Triangle<S>,
        layers: Range<u32>,
        words: &mut [u64],
        overlaps: impl Fn(&Aabb<S>) -> bool,
    ) {
        let [xs, ys, zs] = &self.planes;
        let [x, y, z] = [0, 1, 2].map(|axis| self.touched(axis, triangle));
        let (row_words, rows) = ((xs.len() - 1).div_ceil(64), ys.len() - 1);
        for z in z.start.max(layers.start)..z.end.min(layers.end) {
            for y in y.clone() {
                let row = ((z - layers.start) as usize * rows + y as usize) * row_words;
                for x in x.clone() {
                    let corner =
                        |x: u32, y: u32, z: u32| [xs[x as usize], ys[y as usize], zs[z as usize]];
                    let ends = (corner(x, y, z), corner(x + 1, y + 1, z + 1));
                    let voxel = Aabb::from_min_max(ends.0, ends.1).expect("a voxel");
                    if overlaps(&voxel) {
                        words[row + x as usize / 64] |= 1 << (x % 64);
                    }
                }
            }
        }
    }
}
