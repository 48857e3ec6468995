use core::cmp::Ordering;

use super::Rule;
use super::grid::Grid;
use super::line::{Limit, Line};
use crate::arithmetic::{Each, Parts};
use crate::scalar::Scalar;
use crate::shape::{Ray, Segment, SegmentForm, Vec3};

mod start;

impl<S: Scalar> Grid<S> {
    /// Which voxels does a segment meet, in order from its first end to its second? (Voxel
    /// traversal, 3D DDA.)
    ///
    /// *Geometry*: the part of the segment outside the grid meets nothing. The rule says which
    /// voxels the walk visits:
    ///
    /// | rule | voxels | order where the segment meets several planes at one point |
    /// | --- | --- | --- |
    /// | [`Closed`](Rule::Closed) | every closed voxel that has a point of the segment, once each; a face, an edge or a corner is enough | all voxels around the point: steps in x, y, x and y, z, and so on |
    /// | [`HalfOpen`](Rule::HalfOpen) | every voxel that holds a point of the segment | the voxel that holds the point, then the voxel behind it |
    /// | [`Thin`](Rule::Thin) | the voxels of `HalfOpen`, and voxels that join them: consecutive voxels share a face | one plane after the other: rising x, y, z, then falling z, y, x |
    ///
    /// *Ends*: the walk is the walk through an endless grid with the same planes, restricted to
    /// the voxels of this grid. Therefore the walk in a [`part`](Grid::part) is the walk in the
    /// whole grid, restricted to the part, in the same order.
    ///
    /// With `HalfOpen` and `Thin` the walk begins in the voxel of the first end and ends in the
    /// voxel of the second end, if the grid has them, and the walk backwards visits the same
    /// voxels in reverse order. With `Closed` the walk backwards visits the same voxels.
    ///
    /// If the segment enters or leaves the grid through an edge or a corner, a thin walk may begin
    /// or end with a voxel that touches the segment only there. This voxel joins its neighbour to
    /// a voxel outside the grid. It may be the only voxel of the walk.
    ///
    /// *Numerics*: exact in every scalar.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: two comparisons and a multiplication for each voxel, and an exact sign where the
    /// segment comes within rounding of an edge. The first voxel takes a bisection on each axis,
    /// wherever the segment begins.
    ///
    /// *Source*: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing",
    /// *Eurographics* 1987. Here exact signs order the planes, so that no error accumulates.
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
                let ends = [S::ONE.negated(), S::ONE].each(Limit::Times);
                (center, [Vec3::splat(S::ZERO), half], ends)
            }
        };
        let line = Line::new(self, anchor.to_array(), way.each(|p| p.to_array()));
        Walk::new(self, line, limits.each(Some), rule)
    }

    /// Which voxels does a ray meet in its range, in order? See
    /// [`walk_segment`](Self::walk_segment) for the rules, the ends and the source.
    ///
    /// *Cost*: as of `walk_segment`. An end of the range takes exact sums, unless it is zero or
    /// infinite.
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
        let way = [Vec3::splat(S::ZERO), ray.direction()].each(|p| p.to_array());
        let line = Line::new(self, ray.origin().to_array(), way);
        let limit = |t: S| match t.parts() {
            Parts { magnitude: 0, .. } => Limit::Anchor,
            t => Limit::Times(t),
        };
        Walk::new(self, line, [ray.t_min().map(limit), ray.t_max().map(limit)], rule)
    }
}

/// Iterator over the voxels along a segment or a ray; [`Grid::walk_segment`] and
/// [`Grid::walk_ray`] make it.
#[derive(Clone, Debug)]
pub struct Walk<S> {
    grid: Grid<S>,
    line: Line<S>,
    rule: Rule,
    axes: [Axis; 3],
    /// The closed voxels around the present point. A set of bits is a set of axes to step along:
    /// `next` is the next such set, `around` has the axes whose planes hold the point, and every
    /// set must have an axis of `must`.
    next: u8,
    around: u8,
    must: u8,
    is_over: bool,
}

/// The state of the walk on one axis.
#[derive(Clone, Copy, Debug)]
struct Axis {
    at: i32,
    /// 1 or −1. If the line lies in a plane of the axis, the step leads from the lower layer to the
    /// upper layer.
    step: i32,
    /// The next plane, and the number of planes left.
    plane: i32,
    left: i32,
}

impl<S: Scalar> Walk<S> {
    /// Returns the axes whose next planes the line meets first, a bit for each.
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

    /// Advances to the point where the line meets the next planes; `false` at the end.
    #[inline(always)]
    fn go_on(&mut self) -> bool {
        let last = self.grid.resolution().each(|n| n as i32 - 1);
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
            // A point on a plane belongs to the voxel above it: at the point the line has crossed
            // rising planes, and falling planes behind it.
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

    /// Returns the voxel one step along each of these axes, if the grid has it.
    #[inline(always)]
    fn voxel(&self, steps: u8) -> Option<[u32; 3]> {
        let mut voxel = [0; 3];
        for i in 0..3 {
            let Axis { at, step, .. } = self.axes[i];
            let at = if steps & 1 << i != 0 { at + step } else { at };
            // A negative index becomes one far beyond the grid.
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
