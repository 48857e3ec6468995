//! The time in `f64` at which an axis closes, given that it closes last. Only this axis is
//! computed, with the numbers and bounds of `in_doubles`.

use super::error_bound::{AtStart, FACE, at_start};
use super::{FirstContact, Given, Last};
use crate::arithmetic::{Filtered, Number, greatest, least};
use crate::query::Axis;
use crate::scalar::Scalar;

/// A number of a row, by its address: a branch on the axis would be unpredictable.
#[inline(always)]
fn at<T: Copy>(x: &[T; 3], i: usize) -> T {
    x.get(i).copied().unwrap_or(x[0])
}

/// The next axis in cyclic order.
#[inline(always)]
fn after(i: usize) -> usize {
    at(&[1, 2, 0], i)
}

/// The gap at the start and the triangle's motion along the axis, each with its error.
struct Gap {
    gap: [f64; 2],
    way: [f64; 2],
}

/// The first contact, if `f64` has digits enough.
#[inline(always)]
pub(super) fn first_contact<S: Scalar>(
    given: &Given<Filtered<f64>>,
    last: Last,
) -> Option<FirstContact<S>> {
    let Gap { gap: [gap, error], way: [way, way_error] } = given.on_axis(last)?;
    let [low, high] = gap.portion(way, [error, way_error]).map(S::at_most);
    let is_known = (low == high) & (gap > error);
    if is_known { last.at(low) } else { None }
}

impl Given<Filtered<f64>> {
    /// A coordinate in the frame of the box.
    #[inline(always)]
    fn in_frame(&self, x: f64, i: usize) -> f64 {
        let (p, q) = (at(&self.p, i), at(&self.q, i));
        if self.is_by_center { x - p } else { ((x - p) + (x - q)).half() }
    }

    #[inline(always)]
    fn half(&self, i: usize) -> f64 {
        let (p, q) = (at(&self.p, i), at(&self.q, i));
        if self.is_by_center { q } else { (q - p).half() }
    }

    #[inline(always)]
    fn way(&self, i: usize) -> f64 {
        let [from, to] = &self.way;
        at(to, i) - at(from, i)
    }

    /// Coordinate i of the edge from vertex k.
    #[inline(always)]
    fn edge(&self, k: usize, i: usize) -> f64 {
        let v = &self.triangle;
        at(&at(v, after(k)), i) - at(&at(v, k), i)
    }

    /// Coordinate i of the normal.
    #[inline(always)]
    fn normal(&self, i: usize) -> f64 {
        let (j, l) = (after(i), after(after(i)));
        self.edge(0, j) * self.edge(1, l) - self.edge(0, l) * self.edge(1, j)
    }

    /// An axis with a possible gap, positive or negative.
    #[inline(always)]
    fn on_axis(&self, Last { axis, size, .. }: Last) -> Option<Gap> {
        let AtStart { gap: bound, area_speed, volume_speed }: AtStart<Filtered<f64>> =
            at_start(size)?;
        Some(match axis {
            Axis::Face(i) => {
                let i = usize::from(i);
                let [a, b, c] = &self.triangle;
                let (a, b, c) = (at(a, i), at(b, i), at(c, i));
                let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
                let (p, q) = (at(&self.p, i), at(&self.q, i));
                let gap = if self.is_by_center {
                    greatest(low - p, p - high) - q
                } else {
                    greatest(low - q, p - high)
                };
                let way = self.way(i).magnitude();
                let error = (gap.magnitude() + self.half(i) + way).error(FACE);
                Gap { gap: [gap, error], way: [way, way.error(2)] }
            }
            Axis::Normal => {
                let (mut middle, mut reach, mut way) = (0.0, 0.0, 0.0);
                for i in 0..3 {
                    let n = self.normal(i);
                    middle += n * self.in_frame(self.triangle[0][i], i);
                    reach += n.magnitude() * self.half(i);
                    way += n * self.way(i);
                }
                let gap = middle.magnitude() - reach;
                Gap { gap: [gap, bound.plane], way: [way.magnitude(), volume_speed] }
            }
            Axis::Edge { axis, edge } => {
                let i = usize::from(axis);
                let (j, l) = (after(i), after(after(i)));
                let k = usize::from(edge);
                let (e, f, v) = (self.edge(k, j), self.edge(k, l), at(&self.triangle, k));
                let p = e * self.in_frame(at(&v, l), l) - f * self.in_frame(at(&v, j), j);
                let r = f.magnitude() * self.half(j) + e.magnitude() * self.half(l);
                let middle = self.normal(i).half();
                let gap = (p + middle).magnitude() - (middle.magnitude() + r);
                let way = (e * self.way(l) - f * self.way(j)).magnitude();
                Gap { gap: [gap, bound.edge], way: [way, area_speed] }
            }
        })
    }
}
