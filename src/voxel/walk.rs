use core::cmp::Ordering;

use super::Rule;
use super::grid::Grid;
use super::line::{Limit, Line};
use crate::arithmetic::Parts;
use crate::scalar::Scalar;
use crate::shape::{Ray, Segment, SegmentForm, Vec3};

mod start;

impl<S: Scalar> Grid<S> {
    /// The voxels that a segment meets, in the order in which it meets them, from its first end
    /// to its second.
    ///
    /// *Geometry*: the part of the segment outside the grid meets nothing. What is met depends on
    /// the rule:
    ///
    /// | rule | voxels | where several planes are met at once |
    /// | --- | --- | --- |
    /// | [`Closed`](Rule::Closed) | all that it has a point in common with, those beside a face, an edge or a corner that it touches too: each once | all around that point, those that differ from the one before in x first, then y, x and y, z, and so on |
    /// | [`HalfOpen`](Rule::HalfOpen) | those that its points are in | in the order of its points: at the point itself the voxel above all planes, thereafter the one that it goes on into |
    /// | [`Thin`](Rule::Thin) | those of `HalfOpen`, and voxels that join them, so that each shares a face with the next | one plane after the other: where the segment rises x, y, z, then where it falls z, y, x |
    ///
    /// *Ends*: a walk goes along its segment through a grid without end, and returns the voxels of
    /// this grid. So the walk in a [`part`](Grid::part) is the walk in the whole grid, restricted
    /// to the part, in the same order. By `HalfOpen` and `Thin` it begins in the voxel that holds
    /// the first point and ends in the voxel that holds the last, if these are in the grid, and
    /// the walk from the second end to the first has the same voxels in the reverse order; by
    /// `Closed` it has the same voxels. Where the segment enters or leaves the grid through an
    /// edge or a corner, a thin walk may begin or end with a voxel that has only that edge or
    /// corner in common with the segment: it joins the next voxel to one beyond the grid. It may
    /// be the only voxel of the walk.
    ///
    /// *Numerics*: exact in every scalar.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: two comparisons and a multiplication for each voxel, and an exact sign where the
    /// line comes within rounding of an edge. The first voxel takes a few exact signs, wherever
    /// the segment begins.
    ///
    /// *Source*: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
    /// *Eurographics* 1987; the order of planes is an exact sign here, and nothing adds up.
    ///
    /// ```
    /// use septum::Segment;
    /// use septum::voxel::{Grid, Rule};
    ///
    /// let grid = Grid::new([0.0; 3], [1.0; 3], [3, 3, 1])?;
    /// let segment = Segment::new([0.5, 0.5, 0.5], [2.5, 2.5, 0.5])?;
    /// let walk = |rule| grid.walk_segment(&segment, rule).map(|[x, y, _]| (x, y));
    /// assert!(walk(Rule::HalfOpen).eq([(0, 0), (1, 1), (2, 2)]));
    /// assert!(walk(Rule::Thin).eq([(0, 0), (1, 0), (1, 1), (2, 1), (2, 2)]));
    /// assert!(walk(Rule::Closed).eq([(0, 0), (1, 0), (0, 1), (1, 1), (2, 1), (1, 2), (2, 2)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn walk_segment(&self, segment: &Segment<S>, rule: Rule) -> Walk<S> {
        let (anchor, way, limits) = match *segment.form() {
            SegmentForm::Ends(a, b) => (a, [a, b], [Limit::Anchor, Limit::To]),
            SegmentForm::Center { center, half } => {
                let ends = [S::ONE.negated(), S::ONE].map(Limit::Times);
                (center, [Vec3::splat(S::ZERO), half], ends)
            }
        };
        let line = Line::new(self, anchor.to_array(), way.map(|p| p.to_array()));
        Walk::new(self, line, limits.map(Some), rule)
    }

    /// The voxels that a ray meets, in the order in which it meets them: as
    /// [`walk_segment`](Self::walk_segment) for all of the ray's range.
    ///
    /// A range that neither begins at zero nor is open takes exact sums at its ends.
    ///
    /// ```
    /// use septum::Ray;
    /// use septum::voxel::{Grid, Rule};
    ///
    /// let grid = Grid::new([0.0; 3], [0.5; 3], [4, 4, 4])?;
    /// let ray = Ray::new([-3.0, 0.1, 0.1], [1.0, 0.0, 0.25])?;
    /// let walk = grid.walk_ray(&ray, Rule::HalfOpen);
    /// assert!(walk.eq([[0, 0, 1], [1, 0, 1], [1, 0, 2], [2, 0, 2], [3, 0, 2]]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn walk_ray(&self, ray: &Ray<S>, rule: Rule) -> Walk<S> {
        let way = [Vec3::splat(S::ZERO), ray.direction()].map(|p| p.to_array());
        let line = Line::new(self, ray.origin().to_array(), way);
        let limit = |t: S| match t.parts() {
            Parts { magnitude: 0, .. } => Limit::Anchor,
            t => Limit::Times(t),
        };
        Walk::new(self, line, [ray.t_min().map(limit), ray.t_max().map(limit)], rule)
    }
}

/// The voxels along a line: what [`Grid::walk_segment`] and [`Grid::walk_ray`] return.
#[derive(Clone, Debug)]
pub struct Walk<S> {
    grid: Grid<S>,
    line: Line<S>,
    rule: Rule,
    axes: [Axis; 3],
    /// The voxels beside the present one that are met together with it: each bit of a number is
    /// an axis to go one step along. The next such number; the axes there are; of these, at least
    /// one must be gone along.
    next: u8,
    around: u8,
    must: u8,
    is_over: bool,
}

/// What the walk does along an axis.
#[derive(Clone, Copy, Debug)]
struct Axis {
    at: i32,
    /// 1 or −1. Where the line runs along two layers, it goes from the lower to the upper one
    /// and back.
    step: i32,
    /// The next plane, and how many are left.
    plane: i32,
    left: i32,
}

impl<S: Scalar> Walk<S> {
    /// The axes whose next planes are met next, a bit for each.
    #[inline(always)]
    fn meets(&self) -> u8 {
        let mut met = 0;
        let mut first: Option<(usize, i32)> = None;
        for i in 0..3 {
            let axis = &self.axes[i];
            if axis.left <= 0 {
                continue;
            }
            let plane = (i, axis.plane);
            let order = first.map_or(Ordering::Less, |f| self.line.order(&self.grid, plane, f));
            match order {
                Ordering::Less => (met, first) = (1 << i, Some(plane)),
                Ordering::Equal => met |= 1 << i,
                Ordering::Greater => {}
            }
        }
        met
    }

    /// Goes on to where the next planes are met; whether there are any.
    #[inline(always)]
    fn go_on(&mut self) -> bool {
        let last = self.grid.resolution().map(|n| n as i32 - 1);
        let mut rising = 0;
        for i in 0..3 {
            let (axis, bit) = (&mut self.axes[i], 1 << i);
            let way = self.line.way(i);
            if way != Ordering::Equal && self.around & bit != 0 {
                axis.at += axis.step;
                self.around &= !bit;
            }
            match way {
                Ordering::Greater if axis.at > last[i] => return false,
                Ordering::Less if axis.at < 0 => return false,
                Ordering::Greater => rising |= bit,
                _ => {}
            }
        }
        let mut met = self.meets();
        if met == 0 {
            return false;
        }
        if self.rule != Rule::Closed && met & rising != 0 {
            // A point on a plane is above it: so it has crossed those that it rises to, and not
            // yet those that it falls to.
            met &= rising;
        }
        if self.rule == Rule::Thin {
            let falls = met & rising == 0;
            met = if falls { 1 << met.ilog2() } else { met & met.wrapping_neg() };
        }
        for i in 0..3 {
            let axis = &mut self.axes[i];
            if met & 1 << i != 0 {
                axis.plane += axis.step;
                axis.left -= 1;
                if self.rule != Rule::Closed {
                    axis.at += axis.step;
                }
            }
        }
        if self.rule == Rule::Closed {
            self.around |= met;
            self.must = met;
        }
        self.next = 0;
        true
    }

    /// The voxel one step along each of these axes, if it is in the grid.
    #[inline(always)]
    fn voxel(&self, steps: u8) -> Option<[u32; 3]> {
        let mut voxel = [0; 3];
        for i in 0..3 {
            let Axis { at, step, .. } = self.axes[i];
            let at = if steps & 1 << i != 0 { at + step } else { at };
            // Below zero it is far beyond the grid.
            voxel[i] = at as u32;
            if voxel[i] >= self.grid.resolution()[i] {
                return None;
            }
        }
        Some(voxel)
    }
}

impl<S: Scalar> Iterator for Walk<S> {
    type Item = [u32; 3];

    #[inline]
    fn next(&mut self) -> Option<[u32; 3]> {
        while !self.is_over {
            while self.next < 8 {
                let steps = self.next;
                self.next += 1;
                let is_met = self.must == 0 || steps & self.must != 0;
                if steps & !self.around == 0 && is_met {
                    if let Some(voxel) = self.voxel(steps) {
                        return Some(voxel);
                    }
                }
            }
            self.is_over = !self.go_on();
        }
        None
    }
}
