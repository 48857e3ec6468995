//! The 15 axes of two parallelepipeds.
//!
//! S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree: A Hierarchical Structure for Rapid
//! Interference Detection", SIGGRAPH 1996: the normals of three faces of each, and the nine
//! cross products of an axis of the one with one of the other. Theirs are orthonormal; here
//! nothing is assumed of them but that they span space. Let u_i and v_j be the axes, h and k
//! the half-extents, d the way from centre to centre, w_i = u_j × u_k and z_j likewise of v.
//! On every axis x separates if |x·d| exceeds the sum of h_i·|x·u_i| and k_j·|x·v_j|:
//!
//! * w_i: h_i·|det u| and k_j·|w_i·v_j|;
//! * z_j: k_j·|det v| and h_i·|z_j·u_i|;
//! * u_i × v_j: the products with u_l and v_p are, but for signs, w_m·v_j and z_q·u_i, which
//!   are there already.
//!
//! Where axes are parallel their cross product is zero, and then nothing exceeds nothing: no
//! case of its own. What is flat, or a segment or point, has its separating axis among these
//! too. Within the span of the extents that there are, it is zero along some of them. The normals
//! of the faces beside these are zero there too, and span all such axes.

use core::ops::Mul;

use crate::arithmetic::{Number, turn};
use crate::query::relation::{Nearness, Relation};
use crate::query::triangle_obb::{cross, dot};

/// Two parallelepipeds as operands of products: from centre to centre, axes and half-extents
/// of both, and one in the unit of an axis.
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
    [cross(v, w), cross(w, u), cross(u, v)]
}

/// How two parallelepipeds lie to each other; `None` in doubt.
#[inline(always)]
pub(super) fn all_axes<P: Number + Mul<Output = P>>(
    boxes: &Boxes<P>,
    error: P,
    is_certain: bool,
) -> Option<Relation> {
    let Boxes { d, u, h, v, k, one } = boxes;
    let mut found = Nearness::NONE;
    // Centres so far apart, and boxes that reach so far.
    let add = |found: &mut Nearness, distance: P, reach: P| {
        found.add(distance.magnitude() - reach, reach, error);
    };

    let w = normals(u);
    let volume = dot(&u[0], &w[0]).magnitude();
    let mut on_v = [[P::ZERO; 3]; 3];
    for i in 0..3 {
        on_v[i] = [0, 1, 2].map(|j: usize| dot(&w[i], &v[j]).magnitude());
        add(&mut found, dot(&w[i], d) * *one, h[i] * volume + dot(k, &on_v[i]));
    }
    if found.is_disjoint {
        return Some(Relation::Disjoint);
    }

    let z = normals(v);
    let volume = dot(&v[0], &z[0]).magnitude();
    let mut on_u = [[P::ZERO; 3]; 3];
    for j in 0..3 {
        on_u[j] = [0, 1, 2].map(|i: usize| dot(&z[j], &u[i]).magnitude());
        add(&mut found, dot(&z[j], d) * *one, k[j] * volume + dot(h, &on_u[j]));
    }
    if found.is_disjoint {
        return Some(Relation::Disjoint);
    }

    for i in 0..3 {
        let (i, l, m) = turn(i);
        let n = cross(d, &u[i]);
        for j in 0..3 {
            let (j, p, q) = turn(j);
            let reach =
                (h[l] * on_v[m][j] + h[m] * on_v[l][j]) + (k[p] * on_u[q][i] + k[q] * on_u[p][i]);
            add(&mut found, dot(&n, &v[j]) * *one, reach);
        }
    }
    found.relation(is_certain)
}
