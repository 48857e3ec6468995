//! A ray, or a moving box, on the grid of a tree.
//!
//! It is converted once. Its tests against the boxes, whose corners are small integers, then run in
//! `f32`, four boxes at once, whatever the scalar. They never miss a box that the exact ray meets,
//! and seldom report another box.
//!
//! # Why no box is missed
//!
//! On each axis the ray is o + t·d, in steps of the grid. It reaches plane q at t = (q − o)/d. The
//! direction is divided by m, its greatest component in magnitude, and t counts in units of 1/m:
//! then |d| ≤ 1, and d is ±1 on some axis. Let u = 2⁻²⁴. For each plane the code computes (q −
//! ô)·r̂. Here ô errs by u·|ô|; the difference, the product and r̂ = 1/d err by a relative u each.
//! So the computed t is (q − ô + η)/d with |η| ≤ u·|ô| + 3u·|q − ô| ≤ 7u·(2¹⁶ + |ô|), to first
//! order. Before it is rounded, o is shifted by 8u·(2¹⁶ + |o|), up for the least coordinates and
//! down for the greatest. Hence no computed entry is later than the true entry, and no computed
//! exit earlier than the true exit. The `f64` steps before, within a relative 2⁻⁵⁰, and the terms
//! of second order are far below the eighth u.
//!
//! For |o| ≤ 2⁶⁰ and |d| ≥ 2⁻⁶⁴ nothing overflows, and underflow does no harm: a product is zero,
//! or between 2⁻⁶⁰ and 2¹²⁵. If d is smaller, r̂ is 2¹⁰⁰, and the shift also has the way that the ray
//! goes on this axis. The shift of o is at least 2⁻⁵, so the origin lies clear of both planes, at t
//! beyond ±2⁹⁴, or outside both.
//!
//! An axis on which the origin is farther out excludes no box. Nearly always the mesh is flat there,
//! and its steps are tiny: from any height above, those of a floor at z = 0 are too many. The other
//! axes serve without it, and m is the greatest of theirs.

use super::node::{Grid, Node};
use super::walk::Met;
use crate::arithmetic::{Each, OfFour, Quad, exp2, greatest, least, three};
use crate::scalar::Scalar;
use crate::shape::Ray;

/// One number for each child of a node.
type Four = <f32 as OfFour>::Quad;

/// Places farther out have no use on an axis.
pub(super) const FAR: f64 = (1_u64 << 60) as f64;

/// More than a place, and its difference from a plane of the grid, are rounded by in `f32`.
#[inline(always)]
pub(super) fn shift(o: f64) -> f64 {
    const ROUNDOFFS: f64 = 8.0 / (1 << 24) as f64;
    const POINTS: f64 = (1 << 16) as f64;
    ROUNDOFFS * (POINTS + o.abs())
}

/// A ray, or a moving box, on the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct GridRay {
    axes: [GridAxis; 3],
    /// The range of t, in units of 1/m.
    from: f32,
    to: f32,
    /// m, or zero if t does not matter.
    scale: f64,
}

#[derive(Clone, Copy, Debug)]
struct GridAxis {
    /// o for the sides of a box that the ray reaches first, and for its other sides. It is shifted
    /// up for the least coordinates and down for the greatest.
    near: f32,
    far: f32,
    /// 1/d.
    inverse: f32,
    /// Whether the ray reaches the greatest coordinate first.
    is_falling: bool,
}

impl GridAxis {
    /// An axis that excludes no box.
    const OPEN: Self =
        Self { near: f32::INFINITY, far: f32::NEG_INFINITY, inverse: 1.0, is_falling: false };

    /// An axis on which a box between two places moves, given 1/d and the way beside it.
    #[inline(always)]
    fn new(min: f64, max: f64, moved: f64, inverse: f32) -> Self {
        let is_falling = inverse < 0.0;
        let (low, high) = (max + (shift(max) + moved), min - (shift(min) + moved));
        let (low, high) = (low as f32, high as f32);
        let (near, far) = if is_falling { (high, low) } else { (low, high) };
        Self { near, far, inverse, is_falling }
    }
}

impl GridRay {
    /// A ray that meets every box.
    pub(super) const EVERYWHERE: Self =
        Self { axes: [GridAxis::OPEN; 3], from: f32::NEG_INFINITY, to: f32::INFINITY, scale: 0.0 };

    pub(super) fn new<S: Scalar>(grid: &Grid<S>, ray: &Ray<S>) -> Self {
        let (direction, origin) = (ray.direction().to_array(), ray.origin().to_array());
        let o = three(|i| origin[i].place(&grid.0[i]));
        let d = three(|i| direction[i].length(&grid.0[i]));
        let ends = [ray.t_min(), ray.t_max()].each(|t| t.map(S::in_double));
        Self::between([o; 2], d, direction.each(|d| d == S::ZERO), ends)
    }

    /// A moving box between two corners, in steps of the grid. `is_zero` marks the components of
    /// the motion d that are zero, and the last argument is the range of t. A grid box is entered
    /// on its lower side by the greatest corner, and left on its upper side by the least corner.
    pub(super) fn between(
        [min, max]: [[f64; 3]; 2],
        d: [f64; 3],
        is_zero: [bool; 3],
        [from, to]: [Option<f64>; 2],
    ) -> Self {
        const SHORT: f64 = 1.0 / (1_u128 << 64) as f64;
        const UPRIGHT: f32 = (1_u128 << 100) as f32;
        // Beyond, 1/m and t/m might overflow.
        const LEAST_SCALE: f64 = exp2(-960);
        const MOST_SCALE: f64 = exp2(960);

        // No number is NaN.
        let is_near =
            three(|i| min[i].abs() <= FAR && max[i].abs() <= FAR && d[i].abs() < MOST_SCALE);
        let scale = (0..3).fold(0.0, |m, i| if is_near[i] { greatest(m, d[i].abs()) } else { m });
        if scale <= LEAST_SCALE {
            // On axes on which the ray stands still, it is in a box at every t or at none.
            let stands = |i: usize| is_near[i] && is_zero[i];
            let upright = |i: usize| GridAxis::new(min[i], max[i], 0.0, UPRIGHT);
            let axes = three(|i| if stands(i) { upright(i) } else { GridAxis::OPEN });
            return Self { axes, from: 0.0, to: 0.0, scale: 0.0 };
        }
        let axis = |i: usize| {
            let unit = d[i] / scale;
            // The grid ends less than 2·FAR steps along the greatest component from the ray's
            // origin. Until then a component this short moves by less than an eighth of a step.
            let is_short = unit.abs() < SHORT;
            let moved = if is_short && !is_zero[i] { 2.0 * SHORT * FAR } else { 0.0 };
            let inverse = if is_short { UPRIGHT } else { (1.0 / unit) as f32 };
            GridAxis::new(min[i], max[i], moved, inverse)
        };
        let axes = three(|i| if is_near[i] { axis(i) } else { GridAxis::OPEN });
        let from = from.map_or(f32::NEG_INFINITY, |t| -rounded_up(-(t * scale)));
        let to = to.map_or(f32::INFINITY, |t| rounded_up(t * scale));
        Self { axes, from, to, scale }
    }

    #[inline(always)]
    pub(super) fn meets(&self, node: &Node) -> Met {
        let planes = |[a, b, c, d]: [u16; 4]| Four::new([a.into(), b.into(), c.into(), d.into()]);
        let [x, y, z] = three(|i| {
            let GridAxis { near, far, inverse, is_falling } = self.axes[i];
            // By address, without a branch.
            let first = usize::from(is_falling);
            let time =
                |row: usize, o: f32| (planes(node.0[row]) - Four::splat(o)) * Four::splat(inverse);
            (time(i + 3 * first, near), time(i + 3 * (1 - first), far))
        });
        // In pairs: each step down waits for these.
        let enter = x.0.greatest(Four::splat(self.from)).greatest(y.0.greatest(z.0));
        let leave = x.1.least(Four::splat(self.to)).least(y.1.least(z.1));
        // Neither is NaN: an infinity is never multiplied by zero.
        Met { mask: enter.is_at_most(leave), sooner: enter.to_array().each(|t| t.to_bits() as i32) }
    }

    /// Whether the ray is on the grid, rather than treated as meeting every box.
    pub(super) fn is_known(&self) -> bool {
        self.scale > 0.0
    }

    #[inline(always)]
    pub(super) fn reaches(&self, sooner: i32) -> bool {
        sooner <= in_order(self.to)
    }

    pub(super) fn limit(&mut self, t: f64) {
        if self.scale > 0.0 {
            self.to = least(rounded_up(t * self.scale), self.to);
        }
    }
}

/// A number of `f32` above `x`, or infinity if there is none.
fn rounded_up(x: f64) -> f32 {
    const ROOM: f64 = 1.0 / (1 << 22) as f64;
    // With −∞ the sum would be NaN.
    let x = greatest(x, f64::MIN);
    // A result that underflows becomes the least normal number. The last term avoids −0, which
    // `in_order` places below 0.
    (x + x.abs() * ROOM + f64::from(f32::MIN_POSITIVE)) as f32 + 0.0
}

/// An integer that is never below the bits of a float up to `x`. Those of floats below zero are in
/// reverse order, and below all others.
#[inline(always)]
fn in_order(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    bits | bits >> 31
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As of a ray straight through a plate whose thickness is the residue of a quarter turn.
    #[test]
    fn a_short_component_does_not_open_an_axis() {
        // The ray goes through the second box, and passes the first and the third by one step.
        let (low, high) = ([98, 99, 101, u16::MAX], [99, 102, 103, 0]);
        let node = Node([low, low, [0; 4], high, high, [9; 4]]);
        for short in [1e-17, 1e-30, -1e-30, 0.0, f64::MIN_POSITIVE] {
            let origin = [[100.0, 100.0, -5.0]; 2];
            let is_zero = [short == 0.0, short == 0.0, false];
            let ray = GridRay::between(origin, [short, short, 1.0], is_zero, [None; 2]);
            assert_eq!(ray.meets(&node).mask, 2, "{short}");
        }
    }

    /// As of a ray down to a floor whose steps are tiny, or of a body at rest.
    #[test]
    fn an_axis_of_many_steps_leaves_the_others() {
        let (low, high) = ([98, 99, 101, u16::MAX], [99, 102, 103, 0]);
        let node = Node([low, low, [0; 4], high, high, [9; 4]]);
        for z in [f64::INFINITY, -f64::INFINITY, exp2(700), exp2(61), -exp2(61)] {
            for d in [-exp2(999), f64::INFINITY, f64::NAN, 1.0, 0.0] {
                let mask = |y: f64, along: f64, is_zero: [bool; 2], to: Option<f64>| {
                    let is_zero = [is_zero[0], is_zero[1], d == 0.0];
                    let at = [[100.0, y, z]; 2];
                    GridRay::between(at, [0.0, along, d], is_zero, [None, to]).meets(&node).mask
                };
                assert_eq!(mask(100.0, 0.0, [true, true], None), 2, "{z} {d}");
                assert_eq!(mask(90.0, 1.0, [true, false], Some(5.0)), 0, "{z} {d}");
                assert_eq!(mask(90.0, 1.0, [true, false], Some(9.5)), 2, "{z} {d}");
                // A component that may not be zero opens its axis.
                assert_eq!(mask(100.0, 0.0, [true, false], None), 2, "{z} {d}");
                assert_eq!(mask(100.0, 0.0, [false, false], None), 15, "{z} {d}");
            }
        }
    }

    #[test]
    fn ends_of_a_range_are_numbers() {
        for x in [f64::NEG_INFINITY, f64::MIN, -1.0e30, -1.0, 0.0, 1.0, f64::MAX, f64::INFINITY] {
            let up = rounded_up(x);
            // Only −∞ itself is a bound for −∞.
            let is_above = up == f32::NEG_INFINITY || f64::from(up) >= x;
            assert!(is_above && up.to_bits() != (-0.0_f32).to_bits(), "{x}: {up}");
        }
    }
}
