//! The boxes of a tree that a ray meets.
//!
//! Where floats are fast, the ray is on the grid of the tree ([`GridRay`]). On other machines the
//! exact test runs for each box.

use core::cmp::Ordering;

use self::sealed::Cast;
use super::grid_ray::GridRay;
use super::node::{Cell, Grid, Node};
use super::walk::{Descend, Met};
use crate::arithmetic::{Each, least};
use crate::query::{Hit, HitRules};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Ray, Triangle};

pub(super) mod sealed {
    use core::cmp::Ordering;

    use crate::query::{Hit, HitRules};
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Ray, Triangle};

    /// A ray that is cast through a tree, with the code that it links.
    pub trait Cast<S: Scalar>: Copy {
        /// The ordinary ray.
        fn ray(&self) -> &Ray<S>;

        /// The ray, up to `t_max`.
        fn until(self, t_max: S) -> Self;

        /// Whether the ray meets a box of the tree.
        fn meets(&self, aabb: &Aabb<S>) -> bool;

        /// [`Ray::hit_with`].
        fn hit(&self, triangle: &Triangle<S>, rules: HitRules) -> Option<Hit<S>>;

        /// [`Ray::is_hit_with`].
        fn is_hit(&self, triangle: &Triangle<S>, rules: HitRules) -> bool;

        /// The order of two hits, given the t of each.
        fn compare(&self, a: (&Triangle<S>, S), b: (&Triangle<S>, S)) -> Ordering;
    }
}

impl<S: Scalar> Cast<S> for Ray<S> {
    #[inline(always)]
    fn ray(&self) -> &Self {
        self
    }
    #[inline(always)]
    fn until(self, t_max: S) -> Self {
        Self::until(self, t_max)
    }
    #[inline(always)]
    fn meets(&self, aabb: &Aabb<S>) -> bool {
        self.overlaps(aabb)
    }
    #[inline(always)]
    fn hit(&self, triangle: &Triangle<S>, rules: HitRules) -> Option<Hit<S>> {
        self.hit_with(triangle, rules)
    }
    #[inline(always)]
    fn is_hit(&self, triangle: &Triangle<S>, rules: HitRules) -> bool {
        self.is_hit_with(triangle, rules)
    }
    #[inline(always)]
    fn compare(&self, a: (&Triangle<S>, S), b: (&Triangle<S>, S)) -> Ordering {
        self.compare_found(a, b)
    }
}

/// A ray on its way down the tree.
#[derive(Clone, Debug)]
pub(super) struct Descent<S: Scalar, R = Ray<S>> {
    pub(super) ray: R,
    grid: Grid<S>,
    fast: GridRay,
    /// The part of the grid that the ray can reach, for the exact test.
    octant: Cell,
}

impl<S: Scalar, R: Cast<S>> Descend for Descent<S, R> {
    #[inline(always)]
    fn meets(&self, node: &Node) -> Met {
        if S::IS_FAST { self.fast.meets(node) } else { self.meets_exactly(node) }
    }

    #[inline(always)]
    fn reaches(&self, sooner: i32) -> bool {
        !S::IS_FAST || self.fast.reaches(sooner)
    }
}

impl<S: Scalar, R: Cast<S>> Descent<S, R> {
    pub(super) fn new(grid: &Grid<S>, ray: &R) -> Self {
        // A choice known at compile time, so that machines without floats link none.
        let fast = if S::IS_FAST { GridRay::new(grid, ray.ray()) } else { GridRay::EVERYWHERE };
        let octant = if S::IS_FAST { Cell::ALL } else { octant(grid, ray.ray()) };
        Self { ray: *ray, grid: *grid, fast, octant }
    }

    fn meets_exactly(&self, node: &Node) -> Met {
        let (mut mask, mut sooner) = (node.meeting(&self.octant), [0; 4]);
        let d = self.ray.ray().direction().to_array();
        for k in 0..4 {
            if mask >> k & 1 == 0 {
                continue;
            }
            let cell = node.cell(k);
            if !self.ray.meets(&self.grid.aabb(&cell)) {
                mask ^= 1 << k;
                continue;
            }
            sooner[k] = along_octant(&cell, d.each(|d| d.partial_cmp(&S::ZERO)));
        }
        Met { mask, sooner }
    }

    /// Excludes boxes beyond a hit at t, which was rounded.
    pub(super) fn limit(&mut self, t: S) {
        if S::IS_FAST {
            self.fast.limit(t.farthest());
        } else if let Some(t) = t.farthest_number() {
            let end = self.ray.ray().t_max().map_or(t, |end| least(end, t));
            self.ray = self.ray.until(end);
        }
    }
}

/// How far a box lies along the octant of a direction with these signs.
pub(super) fn along_octant(cell: &Cell, signs: [Option<Ordering>; 3]) -> i32 {
    (0..3).fold(0, |sum, i| match signs[i] {
        Some(Ordering::Less) => sum - i32::from(cell.high[i]),
        Some(Ordering::Greater) => sum + i32::from(cell.low[i]),
        _ => sum,
    })
}

/// The part of the grid that a ray can reach, by the signs of its direction.
fn octant<S: Scalar>(grid: &Grid<S>, ray: &Ray<S>) -> Cell {
    let mut to = Cell::ALL;
    if ray.t_min().is_none_or(|t| t < S::ZERO) {
        return to;
    }
    let (origin, direction) = (ray.origin().to_array(), ray.direction().to_array());
    let at = grid.cell([origin, origin]);
    for i in 0..3 {
        if direction[i] >= S::ZERO {
            to.low[i] = at.low[i];
        }
        if direction[i] <= S::ZERO {
            to.high[i] = at.high[i];
        }
    }
    to
}
