//! A moving box on its way down a tree.

use super::descent::along_octant;
use super::grid_ray::GridRay;
use super::node::{Cell, Grid, Node};
use super::overlapping::sealed::Bounded;
use super::walk::{Descend, Met};
use crate::arithmetic::{Each, three};
use crate::query::{Motion, Sweep};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Vec3};

/// A moving box on its way down the tree.
pub(super) struct Moving<'a, S: Scalar, F> {
    /// When the box meets another on its way.
    meets_at: F,
    motion: &'a Motion<S>,
    grid: &'a Grid<S>,
    fast: GridRay,
    /// The part of the grid that a box at rest meets.
    cell: Cell,
    /// The time of the best contact so far, if any; later contacts are not needed.
    end: Option<S>,
}

/// When a box anywhere meets another on its way.
pub(super) fn meets_at<S: Scalar>(aabb: &Aabb<S>) -> impl Fn(&Motion<S>, &Aabb<S>) -> Option<S> {
    |way, cell| Some(aabb.first_contact(way, cell)?.t)
}

impl<'a, S: Scalar, F: Fn(&Motion<S>, &Aabb<S>) -> Option<S>> Moving<'a, S, F> {
    pub(super) fn new(
        grid: &'a Grid<S>,
        aabb: &Aabb<S>,
        motion: &'a Motion<S>,
        meets_at: F,
    ) -> Self {
        let (from, to) = (motion.from().to_array(), motion.to().to_array());
        let at_rest = if from == to { aabb.corners() } else { None };
        let cell = at_rest.map_or(Cell::ALL, |corners| grid.cell(corners));
        // A choice known at compile time, so that machines without floats link none.
        let fast = if S::IS_FAST {
            let d = three(|i| to[i].steps_from(from[i], &grid.0[i]));
            let is_zero = three(|i| from[i] == to[i]);
            GridRay::between(places(grid, aabb), d, is_zero, [Some(0.0), Some(1.0)])
        } else {
            GridRay::EVERYWHERE
        };
        Self { meets_at, motion, grid, fast, cell, end: None }
    }

    #[inline(never)]
    fn meets_exactly(&self, node: &Node) -> Met {
        let (mut mask, mut sooner) = (node.meeting(&self.cell), [0; 4]);
        let (from, to) = (self.motion.from().to_array(), self.motion.to().to_array());
        for k in 0..4 {
            if mask >> k & 1 == 0 {
                continue;
            }
            let cell = node.cell(k);
            let first = (self.meets_at)(self.motion, &self.grid.aabb(&cell));
            if first.is_none_or(|t| self.end.is_some_and(|end| t > end)) {
                mask ^= 1 << k;
            }
            sooner[k] = along_octant(&cell, three(|i| to[i].partial_cmp(&from[i])));
        }
        Met { mask, sooner }
    }

    /// Excludes contacts later than `t`, which was rounded down.
    pub(super) fn limit(&mut self, t: S) {
        self.end = Some(t);
        if S::IS_FAST {
            self.fast.limit(t.farthest());
        }
    }
}

/// The corners of a box, in steps of a grid. They may lie between the numbers of the scalar, or
/// beyond them. For a box given by its centre they are infinite on axes with so many steps that the
/// sum of centre and half-extent might be off by a part of one.
fn places<S: Scalar>(grid: &Grid<S>, aabb: &Aabb<S>) -> [[f64; 3]; 2] {
    const LONG: f64 = (1_u64 << 40) as f64;
    let place = |p: &Vec3<S>| {
        let p = p.to_array();
        three(|i| p[i].place(&grid.0[i]))
    };
    match aabb.form() {
        AabbForm::Corners { min, max } => [place(min), place(max)],
        AabbForm::Center { center, half } => {
            let (c, h) = (place(center), half.to_array());
            let h = three(|i| h[i].length(&grid.0[i]));
            let is_known = |i: usize| c[i].abs() <= LONG && h[i].abs() <= LONG;
            [-1.0, 1.0].each(|sign| {
                three(|i| if is_known(i) { c[i] + sign * h[i] } else { sign * f64::INFINITY })
            })
        }
    }
}

impl<S: Scalar, F: Fn(&Motion<S>, &Aabb<S>) -> Option<S>> Descend for Moving<'_, S, F> {
    #[inline(always)]
    fn meets(&self, node: &Node) -> Met {
        if !S::IS_FAST {
            return self.meets_exactly(node);
        }
        let met = self.fast.meets(node);
        if self.fast.is_known() {
            met
        } else {
            Met { mask: met.mask & node.meeting(&self.cell), ..met }
        }
    }

    #[inline(always)]
    fn reaches(&self, sooner: i32) -> bool {
        !S::IS_FAST || self.fast.reaches(sooner)
    }
}
