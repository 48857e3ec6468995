use super::Split;
use crate::scalar::{Number, Numbers};

/// A triangle and a parallelepiped, all as operands of products: the vertices
/// from its centre, the triangle's edges, the axes u_i, the half-extents along
/// them, and one in the unit of an axis.
pub(crate) struct Skewed<P> {
    pub(crate) t: [[P; 3]; 3],
    pub(crate) e: [[P; 3]; 3],
    pub(crate) u: [[P; 3]; 3],
    pub(crate) h: [P; 3],
    pub(crate) one: P,
}

/// Whether one of the 13 axes of a triangle and a parallelepiped separates.
///
/// The same test as for an axis-aligned box, in the basis of the box's axes: for
/// vectors x, the components u_i·x take the place of coordinates on normals, and
/// the components w_i·x with w_i = u_j × u_k that of coordinates on edges. So
/// with n the triangle's normal and t_k its vertices from the centre,
///
/// * faces: the vertices project to w_i·t_k, the box to ±h_i·|u_0·w_0|;
/// * normal: the triangle projects to n·t_0, the box to ±Σ h_i·|u_i·n|;
/// * edges: on e_k × u_i the edge falls on p = u_i·(e_k × t_k), the vertex
///   opposite on p + u_i·n, the box on ±(h_j·|w_l·e_k| + h_l·|w_j·e_k|).
///
/// Where a product lacks an axis or a half-extent, one stands in for it: in fixed
/// point it is not 1.
#[inline(always)]
pub(crate) fn skewed<N: Numbers>(s: &Skewed<N::Product>, slack: [N::Product; 3]) -> Split {
    let Skewed { t, e, u, h, one } = s;
    let n = cross(&e[0], &e[1]);
    let w = [cross(&u[1], &u[2]), cross(&u[2], &u[0]), cross(&u[0], &u[1])];
    let un = [dot(&u[0], &n), dot(&u[1], &n), dot(&u[2], &n)];

    let volume = dot(&u[0], &w[0]).magnitude();
    let mut split = Split::NONE;
    for i in 0..3 {
        let on = |k: usize| dot(&w[i], &t[k]) * *one;
        let (a, b, c, r) = (on(0), on(1), on(2), h[i] * volume);
        let beyond = |slack: N::Product| {
            let r = r + slack;
            ((a > r) & (b > r) & (c > r)) | ((a < -r) & (b < -r) & (c < -r))
        };
        split = split.or(Split { certain: beyond(slack[0]), possible: beyond(-slack[0]) });
    }

    let r = un[0].magnitude() * h[0] + un[1].magnitude() * h[1] + un[2].magnitude() * h[2];
    let beyond = (dot(&n, &t[0]) * *one).magnitude() - r;
    split = split.or(Split { certain: beyond > slack[2], possible: beyond > -slack[2] });

    for k in 0..3 {
        let m = cross(&e[k], &t[k]);
        let along = [dot(&w[0], &e[k]), dot(&w[1], &e[k]), dot(&w[2], &e[k])];
        for i in 0..3 {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            // All doubled: the middle of the interval need not be a whole number.
            let p = dot(&u[i], &m) * *one;
            let q = un[i] * *one;
            let r = along[l].magnitude() * h[j] + along[j].magnitude() * h[l];
            let beyond = (p + p + q).magnitude() - (q.magnitude() + (r + r));
            split = split.or(Split { certain: beyond > slack[1], possible: beyond > -slack[1] });
        }
    }
    split
}

#[inline(always)]
fn cross<P: Number + core::ops::Mul<Output = P>>(a: &[P; 3], b: &[P; 3]) -> [P; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn dot<P: Number + core::ops::Mul<Output = P>>(a: &[P; 3], b: &[P; 3]) -> P {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
