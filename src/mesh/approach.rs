//! How far boxes and triangles are from a point: in floats where they are fast, in integers for fixed
//! point elsewhere.
//!
//! # Why no box is excluded that has a point within the limit
//!
//! In floats the point is converted once to the grid of the tree, as is a ray: see
//! [`grid_ray`](super::grid_ray). On each axis its place o is shifted by 8u·(2¹⁶ + |o|) toward the
//! box, with u = 2⁻²⁴, which exceeds what o and its difference from a corner are rounded by. So the
//! gap is not above the true gap. It is multiplied by the step of the axis over the greatest step, a
//! power of two. The square and the sum err by less than 8u of themselves, and the limit is 16u of
//! itself above the distance.
//!
//! On an axis with far shorter steps than another, as of a flat mesh, o is counted in longer steps.
//! All planes then lie within one step, and stand for up to 2¹⁶, by which o is shifted too.

use core::cmp::Ordering;

use super::from_origin::{beyond_box, enclosing};
use super::grid_ray::{FAR, shift};
use super::node::{Grid, Node};
use super::walk::{Descend, Met};
use crate::arithmetic::{Each, OfFour, Quad, least, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// One number for each child of a node.
type Four = <f32 as OfFour>::Quad;

/// A squared distance, from `least` to `most`.
#[derive(Clone, Copy)]
pub(super) struct Bounds<T> {
    least: T,
    most: T,
}

impl<T: PartialOrd + Copy> Bounds<T> {
    /// How two distances compare, if their bounds do not overlap.
    #[inline(always)]
    pub(super) fn compare(&self, other: &Self) -> Option<Ordering> {
        if self.least > other.most {
            Some(Ordering::Greater)
        } else if self.most < other.least {
            Some(Ordering::Less)
        } else {
            None
        }
    }

    /// The bounds, if the distance is not above another.
    pub(super) fn up_to(self, other: &Self) -> Self {
        Self { most: least(self.most, other.most), ..self }
    }
}

/// A point on its way down a tree.
pub(super) trait Approach<S>: Descend {
    /// A number for squared distances.
    type Square: PartialOrd + Copy;
    /// The distance of a triangle; `None` if it is certainly beyond the limit.
    fn bounds(&self, triangle: &Triangle<S>) -> Option<Bounds<Self::Square>>;
    /// Excludes triangles that are farther.
    fn limit(&mut self, to: &Bounds<Self::Square>);
}

/// A point in `f64`, and on the grid.
pub(super) struct InFloats<S> {
    p: [S; 3],
    /// The place in steps, shifted up for the least coordinates and down for the greatest.
    low: [f32; 3],
    high: [f32; 3],
    /// The step of each axis over the greatest step.
    step: [f32; 3],
    /// The greatest steps that a unit of the scalar has.
    per_unit: f64,
    /// The square of the greatest distance, in units of the scalar, and its bound in greatest steps.
    most: f64,
    limit: f32,
}

impl<S: Scalar> InFloats<S> {
    pub(super) fn new(grid: &Grid<S>, p: [S; 3], within: Option<S>) -> Self {
        const FINEST: f64 = 1.0 / (1_u64 << 40) as f64;
        const PLANES: f64 = (1 << 16) as f64;
        let steps = three(|i| S::steps_per_unit(&grid.0[i]));
        let per_unit = least(least(steps[0], steps[1]), steps[2]);
        let (mut low, mut high, mut step) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3], [0.0; 3]);
        for i in 0..3 {
            let (mut o, mut ratio) = (p[i].place(&grid.0[i]), per_unit / steps[i]);
            let mut beside = 0.0;
            if ratio < FINEST {
                (o, ratio, beside) = (o * (ratio / FINEST), FINEST, PLANES);
            }
            // An axis on which the point is farther out excludes no box.
            if o.abs() * ratio <= FAR {
                let shift = shift(o) + beside;
                (low[i], high[i]) = ((o + shift) as f32, (o - shift) as f32);
                step[i] = ratio as f32;
            }
        }
        let mut new =
            Self { p, low, high, step, per_unit, most: f64::INFINITY, limit: f32::INFINITY };
        if let Some(distance) = within {
            // Above the distance, which was rounded.
            let most = distance.units() * (1.0 + 4.0 * f64::EPSILON);
            let most = most * most * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE;
            new.limit(&Bounds { least: 0.0, most });
        }
        new
    }
}

impl<S: Scalar> Descend for InFloats<S> {
    #[inline(always)]
    fn meets(&self, node: &Node) -> Met {
        let planes = |[a, b, c, d]: [u16; 4]| Four::new([a.into(), b.into(), c.into(), d.into()]);
        let [x, y, z] = three(|i| {
            let below = planes(node.0[i]) - Four::splat(self.low[i]);
            let above = Four::splat(self.high[i]) - planes(node.0[3 + i]);
            let gap = below.greatest(above).greatest(Four::splat(0.0)) * Four::splat(self.step[i]);
            gap * gap
        });
        let sum = x + y + z;
        // No number is NaN, and none below zero: as integers they compare likewise.
        let sooner = sum.to_array().each(|x| x.to_bits() as i32);
        Met { mask: !sum.exceeds(Four::splat(self.limit)) & 15, sooner }
    }

    #[inline(always)]
    fn reaches(&self, sooner: i32) -> bool {
        sooner <= self.limit.to_bits() as i32
    }
}

impl<S: Scalar> Approach<S> for InFloats<S> {
    type Square = f64;

    #[inline(always)]
    fn bounds(&self, triangle: &Triangle<S>) -> Option<Bounds<f64>> {
        let vectors = triangle.points().each(|v| three(|i| v[i].units_beyond(self.p[i])));
        if beyond_box(&vectors) > self.most {
            return None;
        }
        let [least, most] = enclosing(&vectors);
        (least <= self.most).then_some(Bounds { least, most })
    }

    fn limit(&mut self, to: &Bounds<f64>) {
        const ROOM: f64 = 1.0 / (1 << 20) as f64;
        self.most = least(to.most, self.most);
        let square = self.most * self.per_unit * self.per_unit;
        let limit = (square + square * ROOM + f64::from(f32::MIN_POSITIVE)) as f32;
        // It is NaN after an infinity times zero.
        self.limit = if limit < f32::INFINITY { limit } else { f32::INFINITY };
    }
}

/// A point in fixed point, in units of the last place.
pub(super) struct InIntegers<S: Scalar> {
    p: [S; 3],
    grid: Grid<S>,
    /// The square of the greatest distance.
    most: u128,
}

impl<S: Scalar> InIntegers<S> {
    pub(super) fn new(grid: &Grid<S>, p: [S; 3], within: Option<S>) -> Self {
        let most = within.map_or(u128::MAX, |r| square(gap(r, S::ZERO)));
        Self { p, grid: *grid, most }
    }

    /// The squared distance of a box, and at the ends of the type at least that.
    fn beyond(&self, [min, max]: [[S; 3]; 2]) -> u128 {
        (0..3).fold(0, |sum: u128, i| {
            let p = self.p[i];
            let q = if p < min[i] {
                min[i]
            } else if p > max[i] {
                max[i]
            } else {
                p
            };
            sum.saturating_add(square(gap(p, q)))
        })
    }
}

/// |a − b| of numbers in fixed point.
fn gap<S: Scalar>(a: S, b: S) -> u128 {
    let (a, b) = (a.parts(), b.parts());
    let (m, n) = (u128::from(a.magnitude), u128::from(b.magnitude));
    if a.negative == b.negative { m.abs_diff(n) } else { m + n }
}

#[inline(never)]
fn square(x: u128) -> u128 {
    x.saturating_mul(x)
}

/// A sort key of a number.
fn key(x: u128) -> i32 {
    let zeros = x.leading_zeros().min(127);
    ((127 - zeros) << 23 | (x << zeros >> 104) as u32 & 0x7f_ffff) as i32
}

impl<S: Scalar> Descend for InIntegers<S> {
    fn meets(&self, node: &Node) -> Met {
        let (mut mask, mut sooner) = (0, [0; 4]);
        for k in 0..4 {
            let square = self.beyond(self.grid.corners(&node.cell(k)));
            sooner[k] = key(square);
            mask |= u32::from(square <= self.most) << k;
        }
        Met { mask, sooner }
    }

    fn reaches(&self, sooner: i32) -> bool {
        sooner <= key(self.most)
    }
}

impl<S: Scalar> Approach<S> for InIntegers<S> {
    type Square = u128;

    fn bounds(&self, triangle: &Triangle<S>) -> Option<Bounds<u128>> {
        if self.beyond(triangle.corners()) > self.most {
            return None;
        }
        let q = triangle.closest_point(self.p).ok()?.point.to_array();
        let (mut least, mut most) = (0_u128, 0_u128);
        for i in 0..3 {
            // Each coordinate is rounded by up to half a unit.
            let gap = gap(self.p[i], q[i]);
            least = least.saturating_add(square(gap.saturating_sub(1)));
            most = most.saturating_add(square(gap + 1));
        }
        (least <= self.most).then_some(Bounds { least, most })
    }

    fn limit(&mut self, to: &Bounds<u128>) {
        self.most = least(to.most, self.most);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As above a floor whose steps are tiny.
    #[test]
    fn a_flat_axis_counts() {
        for z in [0.0, 1e-300, 6e-17, 0.1, 100.0] {
            let grid = Grid::between([[0.0, 0.0, z], [128.0, 128.0, z]]);
            let cells = |at: f64| {
                let mut node = Node::EMPTY;
                node.set(0, grid.cell([[at, at, z], [at + 1.0, at + 1.0, z]]));
                node
            };
            let within =
                |distance: f64| InFloats::<f64>::new(&grid, [64.0, 64.0, 105.0], Some(distance));
            assert_eq!(within(106.0 - z).meets(&cells(64.0)).mask & 1, 1, "{z}");
            assert_eq!(within(106.0 - z).meets(&cells(100.0)).mask & 1, 0, "{z}");
            assert_eq!(within(104.0 - z).meets(&cells(64.0)).mask & 1, 0, "{z}");
        }
    }

    #[test]
    fn keys_keep_order() {
        let numbers = (0..128).flat_map(|k| [1_u128 << k, (1 << k) + (1 << k >> 1), (1 << k) - 1]);
        let mut last = 0;
        let mut sorted: [u128; 384] = [0; 384];
        numbers.zip(&mut sorted).for_each(|(x, to)| *to = x);
        sorted.sort_unstable();
        for x in sorted {
            assert!(key(x) >= last, "{x}");
            last = key(x);
        }
        assert!(key(u128::MAX) > key(1 << 127));
    }
}
