use core::ops::Mul;

use crate::arithmetic::{Arithmetic, Each, Number, cross3, dot3, greatest, least, three, turn};
use crate::query::relation::Reading;

/// A triangle and a parallelepiped as operands of products: the vertices relative to the centre,
/// the triangle's edges, the axes u_i, the half-extents along them, and one in the unit of an axis.
pub(super) struct Parallelepiped<P> {
    pub(super) t: [[P; 3]; 3],
    pub(super) e: [[P; 3]; 3],
    pub(super) u: [[P; 3]; 3],
    pub(super) h: [P; 3],
    pub(super) one: P,
}

/// How far computed axes may be from the truth.
pub(in crate::query) struct ErrorBound<P> {
    pub(in crate::query) face: P,
    pub(super) edge: P,
    pub(super) plane: P,
}

/// A vector as operands.
#[inline(always)]
pub(in crate::query) fn operands<N: Arithmetic>(x: [N::Length; 3]) -> [N::Product; 3] {
    x.each(N::operand)
}

/// The vector to a point from another, as operands.
#[inline(always)]
pub(in crate::query) fn way<N: Arithmetic>(
    to: [N::Length; 3],
    from: [N::Length; 3],
) -> [N::Product; 3] {
    operands::<N>([to[0] - from[0], to[1] - from[1], to[2] - from[2]])
}

/// The relation of a triangle and a parallelepiped from the 13 axes. `looks_twice` leaves out
/// axes that are certainly zero or that other axes decide. On vectors that are zero or nearly, a
/// rounded gap never exceeds its bound.
///
/// It is the test for an axis-aligned box in the basis of the box's axes. For a vector x, the
/// components u_i·x replace coordinates on normals, and the components w_i·x with w_i = u_j × u_k
/// replace coordinates on edges. With n the triangle's normal and t_k its vertices relative to the
/// centre, the projections are
///
/// * on a face, w_i·t_k of the vertices and ±h_i·|u_0·w_0| of the box;
/// * on the normal, n·t_0 of the triangle and ±Σ h_i·|u_i·n| of the box;
/// * on e_k × u_i, p = u_i·(e_k × t_k) of the edge, p + u_i·n of the opposite vertex, and
///   ±(h_j·|w_l·e_k| + h_l·|w_j·e_k|) of the box.
///
/// A product with too few axes or half-extents has one as a factor instead, which is
/// not 1 in fixed point.
///
/// An edge that is parallel to an axis up to rounding is decided as with two boxes (see
/// `obb_obb::kernel`). Seen along e_k the triangle is a segment with normal n. Flattened by h_i =
/// 0, the box is a parallelogram with sides along u_j and u_l. If n, e_k × u_j and e_k × u_l do not
/// separate these two, e_k × u_i does not separate the shapes. A triangle two of whose vertices are one has
/// no normal, and is a point in that view: the other two decide.
#[inline(always)]
pub(super) fn all_axes<P: Number + Mul<Output = P>, R: Reading>(
    s: &Parallelepiped<P>,
    error_bound: &ErrorBound<P>,
    looks_twice: bool,
) -> R {
    let Parallelepiped { t, e, u, h, one } = s;
    let n = cross3(&e[0], &e[1]);
    let w = [cross3(&u[1], &u[2]), cross3(&u[2], &u[0]), cross3(&u[0], &u[1])];
    let un = [dot3(&u[0], &n), dot3(&u[1], &n), dot3(&u[2], &n)];

    let volume = dot3(&u[0], &w[0]).magnitude();
    let mut so_far = R::NONE;
    for i in 0..3 {
        let on = |k: usize| dot3(&w[i], &t[k]) * *one;
        let (a, b, c, r) = (on(0), on(1), on(2), h[i] * volume);
        let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
        so_far.add(greatest(low, -high) - r, (high - low) + r, error_bound.face);
    }

    // On the plane, for a box with half-extents of half of `h`.
    let on_plane = |h: &[P; 3]| {
        let r = un[0].magnitude() * h[0] + un[1].magnitude() * h[1] + un[2].magnitude() * h[2];
        ((dot3(&n, &t[0]) * *one).magnitude() - r, r)
    };
    let is_thin = looks_twice && e.contains(&[P::ZERO; 3]);
    if !is_thin {
        let (gap, reach) = on_plane(h);
        so_far.add(gap, reach, error_bound.plane);
    }

    for k in 0..3 {
        let m = cross3(&e[k], &t[k]);
        let along = [dot3(&w[0], &e[k]), dot3(&w[1], &e[k]), dot3(&w[2], &e[k])];
        // On e_k × u_i, for the same box.
        let on_edge = |i: usize, h: &[P; 3]| {
            let (i, j, l) = turn(i);
            // Everything is doubled, because the middle of the interval need not be an integer.
            let p = dot3(&u[i], &m) * *one;
            let q = un[i] * *one;
            let r = along[l].magnitude() * h[j] + along[j].magnitude() * h[l];
            let reach = q.magnitude() + (r + r);
            ((p + p + q).magnitude() - reach, reach)
        };
        for i in 0..3 {
            let (gap, reach) = on_edge(i, h);
            if looks_twice && gap >= -error_bound.edge {
                let (i, j, l) = turn(i);
                let is_settled = |h: &[P; 3]| {
                    (is_thin || on_plane(h).0 < -error_bound.plane)
                        && on_edge(j, h).0 < -error_bound.edge
                        && on_edge(l, h).0 < -error_bound.edge
                };
                let flattened = || three(|j| if j == i { P::ZERO } else { h[j] });
                if lie_along_one_axis(&e[k], &u[i]) || is_settled(&flattened()) {
                    continue;
                }
            }
            so_far.add(gap, reach, error_bound.edge);
        }
    }
    so_far
}

/// Whether the cross product of two vectors is certainly zero: both lie along one coordinate axis,
/// or one product is zero.
#[inline(always)]
pub(in crate::query) fn lie_along_one_axis<P: Number>(a: &[P; 3], b: &[P; 3]) -> bool {
    let is_zero = |x: P, y: P| (x == P::ZERO) | (y == P::ZERO);
    let is_minor_zero = |j: usize, k: usize| is_zero(a[j], b[k]) & is_zero(a[k], b[j]);
    is_minor_zero(0, 1) & is_minor_zero(1, 2) & is_minor_zero(2, 0)
}
