//! The 15 axes of two parallelepipeds.
//!
//! S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid Interference
//! Detection", SIGGRAPH 1996, test the normals of three faces of each box, and the nine cross
//! products of an axis of one box and an axis of the other. Their axes are orthonormal; here they
//! need only span space. u_i and v_j are the axes, h and k the half-extents, d the difference of
//! the centres, w_i = u_j × u_k, and z_j likewise from v. An axis x separates if |x·d| exceeds the
//! sum of h_i·|x·u_i| and k_j·|x·v_j|. These products are
//!
//! * on w_i: h_i·|det u| and k_j·|w_i·v_j|;
//! * on z_j: k_j·|det v| and h_i·|z_j·u_i|;
//! * on u_i × v_j: the products with u_l and v_p are ±w_m·v_j and ±z_q·u_i, which are known from
//!   the faces.
//!
//! The three coordinate axes come first. They take no products of axes, and any axis may separate
//! two shapes.
//!
//! If axes are parallel, their cross product is zero and never separates. Boxes with the same
//! orientation, or rotated about one coordinate axis, always have such pairs. Floats cannot tell a
//! zero from an almost-zero there, so they leave these pairs out.
//!
//! For a flat box, a segment or a point these axes also suffice. A separating axis may be chosen
//! within the span of the extents that are not zero. It is then zero along some of them, and so are
//! the normals of the faces beside these; the normals span all such axes.
//!
//! # Nearly parallel axes
//!
//! If u_i and v_j are parallel up to rounding, u_i × v_j is a short vector, and its gap is smaller
//! than the error bound. Four other axes decide. Seen along u_i the first box is a parallelogram
//! with sides along u_l and u_m. Flatten the second box by k_j = 0, which removes almost nothing of
//! it; it becomes a parallelogram with sides along v_p and v_q. The normals of these sides are w_l,
//! w_m, u_i × v_p and u_i × v_q. If none of the four separates the first box from the flattened
//! one, the two projections have a point in common. Then no axis perpendicular to u_i separates the
//! boxes, and u_i × v_j is such an axis. If all four gaps are below zero, the projections overlap
//! in their interiors, so the gap on u_i × v_j is below zero too, unless the vector is zero.
//!
//! This holds for any two axes, so there is no threshold for nearly parallel ones. The error bound
//! is that of the axes, which holds for all half-extents up to R/A, including zero.

use core::ops::Mul;

use super::error_bound::ErrorBound;
use crate::arithmetic::{Number, cross3, dot3, three, turn};
use crate::query::relation::{Nearness, Reading, Relation};
use crate::query::triangle_obb::lie_along_one_axis;

/// Two parallelepipeds as operands of products: the difference of the centres, axes and
/// half-extents of both boxes, and one in the unit of an axis.
pub(super) struct Boxes<P> {
    pub(super) d: [P; 3],
    pub(super) u: [[P; 3]; 3],
    pub(super) h: [P; 3],
    pub(super) v: [[P; 3]; 3],
    pub(super) k: [P; 3],
    pub(super) one: P,
}

#[inline(always)]
fn normals<P: Number + Mul<Output = P>>([u, v, w]: &[[P; 3]; 3]) -> [[P; 3]; 3] {
    [cross3(v, w), cross3(w, u), cross3(u, v)]
}

/// Whether the cross product of two axes is certainly zero, as for boxes with the same orientation,
/// or rotated about one coordinate axis.
#[inline(always)]
pub(super) fn is_zero<P: Number>(a: &[P; 3], b: &[P; 3]) -> bool {
    (*a == *b) | (*a == [-b[0], -b[1], -b[2]]) | lie_along_one_axis(a, b)
}

/// The relation of two parallelepipeds; `None` in doubt. `looks_twice` leaves out products of axes
/// that are certainly zero or that other axes decide.
#[inline(always)]
pub(super) fn all_axes<P: Number + Mul<Output = P>>(
    boxes: &Boxes<P>,
    error: &ErrorBound<P>,
    is_certain: bool,
    looks_twice: bool,
) -> Option<Relation> {
    let Boxes { d, u, h, v, k, one } = boxes;
    // The coordinates first, because three coordinates cost as much as one other axis.
    let mut is_disjoint = false;
    for c in 0..3 {
        let reach = |h: &[P; 3], u: &[[P; 3]; 3]| {
            h[0] * u[0][c].magnitude() + h[1] * u[1][c].magnitude() + h[2] * u[2][c].magnitude()
        };
        let gap = (d[c] * *one).magnitude() - (reach(h, u) + reach(k, v));
        is_disjoint |= gap > error.coordinate;
    }
    if is_disjoint {
        return Some(Relation::Disjoint);
    }

    let mut found = Nearness::NONE;
    // Adds the gap between the distance of the centres and the reach of the boxes.
    let add = |found: &mut Nearness, distance: P, reach: P| {
        found.add(distance.magnitude() - reach, reach, error.axis);
    };

    let w = normals(u);
    let volume = dot3(&u[0], &w[0]).magnitude();
    let mut on_v = [[P::ZERO; 3]; 3];
    // The axis of a face of the first box, for a second box with half-extents of half of `k`.
    let on_face = |i: usize, on_v: &[P; 3], k: &[P; 3]| {
        (dot3(&w[i], d) * *one, h[i] * volume + dot3(k, on_v))
    };
    for i in 0..3 {
        on_v[i] = three(|j| dot3(&w[i], &v[j]).magnitude());
        let (distance, reach) = on_face(i, &on_v[i], k);
        add(&mut found, distance, reach);
    }
    if found.is_disjoint {
        return Some(Relation::Disjoint);
    }

    let z = normals(v);
    let volume = dot3(&v[0], &z[0]).magnitude();
    let mut on_u = [[P::ZERO; 3]; 3];
    for j in 0..3 {
        on_u[j] = three(|i| dot3(&z[j], &u[i]).magnitude());
        add(&mut found, dot3(&z[j], d) * *one, k[j] * volume + dot3(h, &on_u[j]));
    }
    if found.is_disjoint {
        return Some(Relation::Disjoint);
    }

    for i in 0..3 {
        let (i, l, m) = turn(i);
        let n = cross3(d, &u[i]);
        let on_pair = |j: usize, k: &[P; 3]| {
            let (j, p, q) = turn(j);
            let reach =
                (h[l] * on_v[m][j] + h[m] * on_v[l][j]) + (k[p] * on_u[q][i] + k[q] * on_u[p][i]);
            (dot3(&n, &v[j]) * *one, reach)
        };
        for j in 0..3 {
            let (distance, reach) = on_pair(j, k);
            // On a vector that is zero or nearly, a rounded gap never exceeds its bound.
            if looks_twice {
                let overlaps =
                    |(distance, reach): (P, P)| distance.magnitude() - reach < -error.axis;
                let (j, p, q) = turn(j);
                let flattened = || three(|p| if p == j { P::ZERO } else { k[p] });
                let is_settled = |k: &[P; 3]| {
                    overlaps(on_face(l, &on_v[l], k))
                        && overlaps(on_face(m, &on_v[m], k))
                        && overlaps(on_pair(p, k))
                        && overlaps(on_pair(q, k))
                };
                let is_clear = overlaps((distance, reach));
                if !is_clear && (is_zero(&u[i], &v[j]) || is_settled(&flattened())) {
                    continue;
                }
            }
            add(&mut found, distance, reach);
        }
    }
    found.answer(is_certain)
}
