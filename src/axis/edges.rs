use super::{Frame, Split};
use crate::scalar::{Number, Numbers};

/// Whether one of the nine cross products of a coordinate axis x_i and an edge
/// e_k separates.
///
/// Project on x_i × e_k from the vertex v_k where the edge begins. The whole
/// edge falls on p = (e_k × v_k)_i, and the vertex opposite on p + n_i: the
/// component of the triangle's normal, the same for all three edges. So the
/// triangle covers the interval from p to p + n_i, whose middle is p + n_i/2 and
/// whose radius is |n_i|/2, and the box covers ±r with r = h_j·|e_l| + h_l·|e_j|.
/// The axis separates if |p + n_i/2| > |n_i|/2 + r.
#[inline(always)]
pub(crate) fn edges<N: Numbers>(frame: &Frame<N>, n: &[N::Area; 3], slack: N::Area) -> Split {
    let mut split = Split::NONE;
    for k in 0..3 {
        for i in 0..3 {
            split = split.or(one_edge(frame, n, slack, i, k));
        }
    }
    split
}

/// Whether the cross product of coordinate axis `i` and edge `k` separates.
#[inline(always)]
pub(crate) fn one_edge<N: Numbers>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    slack: N::Area,
    i: usize,
    k: usize,
) -> Split {
    let (j, l) = ((i + 1) % 3, (i + 2) % 3);
    let (e, v, h) = (&frame.e[k], &frame.v[k], &frame.h);

    let p = N::area(e[j], v[l]) - N::area(e[l], v[j]);
    let r = N::area(e[l].magnitude(), h[j]) + N::area(e[j].magnitude(), h[l]);
    let middle = N::middle(n[i]);
    let far = (p + middle).magnitude();
    let radius = middle.magnitude();

    let certain = far > (radius + slack) + r;
    if N::FINAL {
        return Split { certain, possible: certain };
    }
    // An edge along x_i has e_j = e_l = 0, known exactly: the axis is nought and
    // separates nothing. Without this, every box-shaped mesh would be in doubt.
    let is_axis = (e[j] != N::Length::ZERO) | (e[l] != N::Length::ZERO);
    Split { certain, possible: (far > (radius - slack) + r) & is_axis }
}
