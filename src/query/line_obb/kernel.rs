//! The six axes of a part of a line and a parallelepiped.
//!
//! Let u_i be the axes of the box, w_i = u_j × u_k, h_i the half-extents, m the way from the
//! centre to the line's origin and d its direction. The point at t is inside if for all i
//! |w_i·m + t·(w_i·d)| ≤ h_i·|u_0·w_0| (Cramer's rule). So
//!
//! * w_i separates if the part of the line lies beyond that on one side: both its ends do. Where
//!   there is no end, the line must not come back that way.
//! * d × u_i separates the whole line: it falls on u_i·(m × d), the box on
//!   ±(h_j·|w_l·d| + h_l·|w_j·d|).
//!
//! A convex set in the plane across d, the box seen along the line, has its edges along the u_i: so
//! the last three tell every line that misses. What is flat needs no others: a gap between closed
//! sets stays open if the box is a little thicker. Where d is zero nothing exceeds nothing.
//!
//! A direction that is parallel to u_i but for rounding leaves d × u_i in doubt. The two others
//! settle it, as with two boxes (`obb_obb::kernel`): if d × u_j and d × u_l do not separate the line
//! from the box flattened by h_i = 0, a parallelogram seen along d, the line meets the box.

use core::ops::Mul;

use super::error_bound::{ErrorBound, Sizes};
use crate::arithmetic::{Number, greatest, largest, three, turn};
use crate::query::triangle_obb::{cross, dot, lie_along_one_axis};
use crate::robust::Uncertain;

/// A part of a line and a parallelepiped, all as operands of products: from the box's centre to
/// the origin of the line, its direction and the ends of t, the axes and half-extents, and one in
/// the unit of an axis.
pub(super) struct Operands<P> {
    pub(super) m: [P; 3],
    pub(super) d: [P; 3],
    pub(super) ends: [Option<P>; 2],
    pub(super) u: [[P; 3]; 3],
    pub(super) h: [P; 3],
    pub(super) one: P,
}

impl<P: Number> Operands<P> {
    /// How great they are.
    #[inline(always)]
    pub(super) fn sizes(&self) -> Sizes<P> {
        let farthest = |t: &Option<P>| t.map_or(P::ZERO, |t| t.magnitude());
        Sizes {
            axes: self.u.iter().fold(self.one, |most, u| greatest(most, largest(u))),
            way: largest(&self.m),
            direction: largest(&self.d),
            ends: greatest(farthest(&self.ends[0]), farthest(&self.ends[1])),
            half: largest(&self.h),
        }
    }
}

/// Whether one of the six axes separates. `LOOKS_TWICE` leaves out products with the direction that
/// are zero for certain, or settled by the two others.
#[inline(always)]
pub(super) fn any_axis<P: Number + Mul<Output = P>, const LOOKS_TWICE: bool>(
    s: &Operands<P>,
    error: &ErrorBound<P>,
) -> Uncertain {
    let Operands { m, d, ends: [from, to], u, h, one } = s;
    let w = [cross(&u[1], &u[2]), cross(&u[2], &u[0]), cross(&u[0], &u[1])];
    let along = [dot(&w[0], d), dot(&w[1], d), dot(&w[2], d)];
    let mut so_far = Uncertain::NONE;

    let across = cross(m, d);
    let on_line = |i: usize, h: &[P; 3]| {
        let (i, j, l) = turn(i);
        let reach = h[j] * along[l].magnitude() + h[l] * along[j].magnitude();
        (dot(&across, &u[i]) * *one).magnitude() - reach
    };
    for i in 0..3 {
        let gap = on_line(i, h);
        // On a zero, or nearly one, a rounded gap is never clear of its bound.
        if LOOKS_TWICE && gap >= -error.line {
            let (i, j, l) = turn(i);
            let flattened = three(|j| if j == i { P::ZERO } else { h[j] });
            let overlaps = |i: usize| on_line(i, &flattened) < -error.line;
            if lie_along_one_axis(d, &u[i]) || (overlaps(j) && overlaps(l)) {
                continue;
            }
        }
        so_far = so_far.or(Uncertain::above(gap, error.line));
    }

    let volume = dot(&u[0], &w[0]).magnitude();
    for i in 0..3 {
        let (middle, reach) = (dot(&w[i], m) * *one, h[i] * volume);
        let at = |end: &Option<P>| end.map(|t| middle + along[i] * t);
        let (start, end) = (at(from), at(to));
        for is_upper in [true, false] {
            let beyond = |x: P| {
                let gap = if is_upper { x - reach } else { -x - reach };
                Uncertain::above(gap, error.face)
            };
            // Where there is no end the line goes on for ever, and away from the box or along it.
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
