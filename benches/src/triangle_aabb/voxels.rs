//! The voxels that a voxelizer tests, made just before each test.

use std::cell::OnceCell;
use std::ops::Range;
use std::rc::Rc;

use crate::geometry::Point;
use crate::pairs::{Block, Pairs};

use super::scenes::bounding_box;

/// A voxel by its centre and half its side.
pub type Voxel<S> = ([S; 3], S);

/// The voxels that a bounding box touches.
pub struct Voxels<S> {
    /// The centres of all voxels along an axis. They are the same along x, y and z, and for all
    /// blocks of a grid.
    centers: Rc<[S]>,
    half: S,
    /// The ranges of the voxels along x, y and z.
    ranges: [Range<usize>; 3],
}

/// Triangles, each with the voxels that its bounding box touches.
pub type Scene = Pairs<[Point; 3], Voxels<f64>>;

/// A mesh with `resolution` voxels along the longest side, scaled to a cube in the range of every
/// scalar. Coordinates are rounded to 16 fraction bits, as in I16F16.
pub fn scene(triangles: &[[Point; 3]], resolution: u32) -> Scene {
    let side = 4.0 / f64::from(resolution);
    let points = || triangles.as_flattened().iter();
    let low: Point = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let high: Point = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
    let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    // The mesh may be a single point.
    let scale = if longest > 0.0 { 4.0 / longest } else { 0.0 };
    let placed = |p: Point| {
        std::array::from_fn(|i| {
            let x = (p[i] - (low[i] + high[i]) / 2.0) * scale;
            (x * 65_536.0).round() / 65_536.0
        })
    };
    let centers = centers(resolution);
    let mut scene = Scene::default();
    for triangle in triangles {
        let triangle = triangle.map(placed);
        scene.push(triangle, [Voxels::around(&triangle, &centers, side)]);
    }
    scene
}

/// Centres from −2 to 2, and one voxel beyond either end.
fn centers(resolution: u32) -> Rc<[f64]> {
    let (side, end) = (4.0 / f64::from(resolution), resolution.div_ceil(2) as i32 + 1);
    (-end..end).map(|n| (f64::from(n) + 0.5) * side).collect()
}

impl Voxels<f64> {
    /// The voxels that the bounding box of a triangle touches.
    fn around(triangle: &[Point; 3], centers: &Rc<[f64]>, side: f64) -> Self {
        let (min, max) = bounding_box(triangle);
        let end = centers.len() as i32 / 2;
        let ranges = std::array::from_fn(|i| {
            // A coordinate on a face touches the voxels on both sides.
            let first = (min[i] / side).ceil() as i32 - 1;
            let last = (max[i] / side).floor() as i32;
            (first + end) as usize..(last + 1 + end) as usize
        });
        Self { centers: Rc::clone(centers), half: side / 2.0, ranges }
    }
}

impl<L, S: Copy> Pairs<L, Voxels<S>> {
    /// The same in other numbers.
    pub fn map_voxels<M, T: Copy>(
        &self,
        left: impl Fn(&L) -> M,
        number: impl Fn(S) -> T,
    ) -> Pairs<M, Voxels<T>> {
        let shared = OnceCell::new();
        self.map(left, |voxels| {
            let all = || voxels.centers.iter().map(|&x| number(x)).collect();
            Voxels {
                centers: Rc::clone(shared.get_or_init(all)),
                half: number(voxels.half),
                ranges: voxels.ranges.clone(),
            }
        })
    }
}

impl<S: Copy> Block for Voxels<S> {
    type Shape = Voxel<S>;

    #[inline(always)]
    fn each(&self, mut ask: impl FnMut(Voxel<S>)) {
        let [xs, ys, zs] = self.ranges.clone().map(|range| &self.centers[range]);
        for &z in zs {
            for &y in ys {
                for &x in xs {
                    ask(([x, y, z], self.half));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_what_the_bounding_box_touches() {
        // Along x to the ends of the cube, along y on a face, along z within.
        let triangle = [[-2.0, 0.0, -0.25], [2.0, 0.0, -0.25], [1.0, 0.0, 0.25]];
        let mut found = Vec::new();
        Voxels::around(&triangle, &centers(4), 1.0).each(|voxel| found.push(voxel));
        let center = |n: usize| [n % 6, n / 6 % 2, n / 12].map(|k| k as f64);
        let expected = (0..24).map(center).map(|[x, y, z]| ([x - 2.5, y - 0.5, z - 0.5], 0.5));
        assert_eq!(found, expected.collect::<Vec<_>>());
    }
}
