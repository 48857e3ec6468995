//! The six axes of a part of a line and a parallelepiped.
//!
//! u_i are the axes of the box, w_i = u_j × u_k, h_i the half-extents, m the vector from the centre
//! to the line's origin, and d the line's direction. By Cramer's rule the point at t is inside if
//! |w_i·m + t·(w_i·d)| ≤ h_i·|u_0·w_0| for all i. This gives two kinds of axes:
//!
//! * w_i separates if both ends of the part of the line lie beyond the box on the same side. If the
//!   part has no end there, the line must not come back from that side.
//! * d × u_i separates the whole line. The line projects to u_i·(m × d), the box to ±(h_j·|w_l·d| +
//!   h_l·|w_j·d|).
//!
//! Seen along the line, the box is a convex set whose edges are parallel to the u_i, so the last
//! three axes find every line that misses. Flat boxes need no other axes: a gap between closed sets
//! stays open if the box is made slightly thicker. If d is zero, no axis separates.
//!
//! If the direction is parallel to u_i up to rounding, d × u_i is in doubt. The two other axes
//! decide, as with two boxes (`obb_obb::kernel`). Flatten the box by h_i = 0, which gives a
//! parallelogram seen along d. If neither d × u_j nor d × u_l separates the line from it, the line
//! meets the box.

use core::ops::Mul;

use super::error_bound::{ErrorBound, Sizes};
use crate::arithmetic::{Each, Number, cross3, dot3, greatest, largest, three, turn};
use crate::query::triangle_obb::lie_along_one_axis;
use crate::robust::Uncertain;

/// A part of a line and a parallelepiped as operands of products: the vector from the box's centre
/// to the line's origin, its direction, the ends of t, the axes and half-extents, and one in the
/// unit of an axis.
pub(super) struct Operands<P> {
    pub(super) m: [P; 3],
    pub(super) d: [P; 3],
    pub(super) ends: [Option<P>; 2],
    pub(super) u: [[P; 3]; 3],
    pub(super) h: [P; 3],
    pub(super) one: P,
}

impl<P: Number> Operands<P> {
    /// The greatest magnitudes of the operands.
    #[inline(always)]
    pub(super) fn sizes(&self) -> Sizes<P> {
        Sizes {
            axes: self.u.iter().fold(self.one, |most, u| greatest(most, largest(u))),
            way: largest(&self.m),
            direction: largest(&self.d),
            ends: farthest(self.ends),
            half: largest(&self.h),
        }
    }
}

/// The greatest magnitude of an end.
#[inline(always)]
pub(super) fn farthest<P: Number>(ends: [Option<P>; 2]) -> P {
    let [from, to] = ends.each(|t| t.map_or(P::ZERO, |t| t.magnitude()));
    greatest(from, to)
}

/// Whether one of the six axes separates. `looks_twice` leaves out products with the direction that
/// are certainly zero or that the two others decide.
#[inline(always)]
pub(super) fn any_axis<P: Number + Mul<Output = P>>(
    s: &Operands<P>,
    error: &ErrorBound<P>,
    looks_twice: bool,
) -> Uncertain {
    let Operands { m, d, ends: [from, to], u, h, one } = s;
    let w = [cross3(&u[1], &u[2]), cross3(&u[2], &u[0]), cross3(&u[0], &u[1])];
    let along = [dot3(&w[0], d), dot3(&w[1], d), dot3(&w[2], d)];
    let mut so_far = Uncertain::NONE;

    let across = cross3(m, d);
    let on_line = |i: usize, h: &[P; 3]| {
        let (i, j, l) = turn(i);
        let reach = h[j] * along[l].magnitude() + h[l] * along[j].magnitude();
        (dot3(&across, &u[i]) * *one).magnitude() - reach
    };
    for i in 0..3 {
        let gap = on_line(i, h);
        // On a vector that is zero or nearly, a rounded gap never exceeds its bound.
        if looks_twice && gap >= -error.line {
            let (i, j, l) = turn(i);
            let flattened = three(|j| if j == i { P::ZERO } else { h[j] });
            let overlaps = |i: usize| on_line(i, &flattened) < -error.line;
            if lie_along_one_axis(d, &u[i]) || (overlaps(j) && overlaps(l)) {
                continue;
            }
        }
        so_far = so_far.or(Uncertain::above(gap, error.line));
    }

    let volume = dot3(&u[0], &w[0]).magnitude();
    for i in 0..3 {
        let (middle, reach) = (dot3(&w[i], m) * *one, h[i] * volume);
        let at = |end: &Option<P>| end.map(|t| middle + along[i] * t);
        let (start, end) = (at(from), at(to));
        for is_upper in [true, false] {
            let beyond = |x: P| {
                let gap = if is_upper { x - reach } else { -x - reach };
                Uncertain::above(gap, error.face)
            };
            // A line without an end separates only if it leads away from the box or parallel to it.
            let leaves = |x: P| Uncertain::not_below(x, error.direction);
            let upward = if is_upper { along[i] } else { -along[i] };
            let first = start.map_or_else(|| leaves(-upward), beyond);
            let last = end.map_or_else(|| leaves(upward), beyond);
            let mut both = first.and(last);
            if start.is_none() & end.is_none() {
                both = both.and(beyond(middle));
            }
            so_far = so_far.or(both);
        }
    }
    so_far
}
