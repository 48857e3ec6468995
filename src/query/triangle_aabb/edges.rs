use super::frame::Frame;
use crate::arithmetic::{Arithmetic, Number, of_two};
use crate::robust::Uncertain;

/// Whether one of the nine cross products of a coordinate axis x_i and an edge e_k separates.
///
/// Project on x_i × e_k from the vertex v_k where the edge begins. The whole edge projects to p =
/// (e_k × v_k)_i, and the opposite vertex to p + n_i. The component n_i of the triangle's normal is
/// the same for all three edges. So the triangle covers the interval from p to p + n_i, with middle
/// p + n_i/2 and radius |n_i|/2. The box covers ±r with r = h_j·|e_l| + h_l·|e_j|. The axis
/// separates if |p + n_i/2| > |n_i|/2 + r.
#[inline(always)]
pub(super) fn edges<N: Arithmetic>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    error_bound: N::Area,
) -> Uncertain {
    let mut so_far = Uncertain::NONE;
    for k in 0..3 {
        for i in 0..3 {
            so_far = so_far.or(one_edge(frame, n, error_bound, i, k));
        }
    }
    so_far
}

/// Whether the cross product of coordinate axis `i` and edge `k` separates.
#[inline(always)]
pub(super) fn one_edge<N: Arithmetic>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    error_bound: N::Area,
    i: usize,
    k: usize,
) -> Uncertain {
    let (j, l) = ((i + 1) % 3, (i + 2) % 3);
    let (e, v, h) = (&frame.e[k], &frame.v[k], &frame.h);

    let p = N::minor([e[j], v[l]], [e[l], v[j]]);
    let r = N::area(e[l].magnitude(), h[j]) + N::area(e[j].magnitude(), h[l]);
    let middle = of_two::<N, _>(n[i]);
    let far = (p + middle).magnitude();
    let radius = middle.magnitude();

    if N::CERTAIN {
        return Uncertain::known(far > radius + r);
    }
    // Rounded as in `rows`, so that the same is certain on every machine.
    let beyond = far - (radius + r);
    // An edge along x_i has e_j = e_l = 0, exactly: the axis is zero and separates nothing. Without
    // this rule every box-shaped mesh would be in doubt.
    let is_axis = (e[j] != N::Length::ZERO) | (e[l] != N::Length::ZERO);
    let found = Uncertain::above(beyond, error_bound);
    Uncertain { possible: found.possible & is_axis, ..found }
}
