//! The grid of a tree: between coordinates in space and 16-bit steps.

use super::node::Cell;
use super::{Index, Mesh};
use crate::scalar::Scalar;
use crate::shape::{Aabb, joined};

/// The steps along each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid<S: Scalar>(pub(super) [S::SeptumSteps; 3]);

impl<S: Scalar> Grid<S> {
    /// The grid that encloses all triangles of a mesh.
    pub(super) fn around<I: Index>(mesh: &Mesh<'_, S, I>) -> Self {
        let all = mesh.iter().map(|triangle| triangle.corners()).reduce(joined);
        Self::between(all.unwrap_or([[S::ZERO; 3]; 2]))
    }

    /// The grid between two corners.
    pub(super) fn between([min, max]: [[S; 3]; 2]) -> Self {
        // By pattern, because indices are checked in builds for small code.
        let ([a, b, c], [d, e, f]) = (min, max);
        Self([S::steps(a, d), S::steps(b, e), S::steps(c, f)])
    }

    /// The smallest grid box around the box between two corners, clamped to the grid. It meets
    /// every grid box that encloses a point of the given box.
    #[cfg_attr(not(feature = "small"), inline(always))]
    #[cfg_attr(feature = "small", inline(never))]
    pub(super) fn cell(&self, [min, max]: [[S; 3]; 2]) -> Cell {
        let [x, y, z] = &self.0;
        Cell {
            low: [min[0].point_below(x), min[1].point_below(y), min[2].point_below(z)],
            high: [max[0].point_above(x), max[1].point_above(y), max[2].point_above(z)],
        }
    }

    /// The corners of a grid box, in space.
    #[inline(always)]
    pub(super) fn corners(&self, cell: &Cell) -> [[S; 3]; 2] {
        let [x, y, z] = &self.0;
        let at = |q: [u16; 3]| [S::point(x, q[0]), S::point(y, q[1]), S::point(z, q[2])];
        [at(cell.low), at(cell.high)]
    }

    /// The length of a number of steps along an axis, comparable between axes: its logarithm, with
    /// 17 bits after the exponent.
    pub(super) fn size(&self, axis: usize, steps: u32) -> i64 {
        let Some(log) = steps.checked_ilog2() else { return i64::MIN };
        let digits = (u64::from(steps) << 32 >> log) as u32 >> 15;
        let exponent = S::exponent(&self.0[axis % 3]) + log as i32;
        i64::from(exponent) << 17 | i64::from(digits)
    }

    /// A grid box, in space.
    #[inline(always)]
    pub(super) fn aabb(&self, cell: &Cell) -> Aabb<S> {
        let [min, max] = self.corners(cell);
        Aabb::between(min.into(), max.into())
    }
}
