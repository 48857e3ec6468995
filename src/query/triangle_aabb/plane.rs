use super::frame::Frame;
use crate::arithmetic::{Arithmetic, Number, cross, dot, three};
use crate::robust::Uncertain;

/// The triangle's normal, e0 × e1.
#[inline(always)]
pub(in crate::query) fn normal<N: Arithmetic>(frame: &Frame<N>) -> [N::Area; 3] {
    let [e0, e1, _] = &frame.e;
    cross::<N>(e0, e1)
}

/// Whether the triangle's normal separates: whether the plane of the triangle
/// misses the box.
///
/// The triangle projects to one number, n·v, and the box to ±Σ h·|n|: the
/// distances along n to the two critical corners of Haines and Wallace.
#[inline(always)]
pub(in crate::query) fn plane<N: Arithmetic>(
    n: &[N::Area; 3],
    v: &[N::Length; 3],
    h: &[N::Length; 3],
    error_bound: N::Volume,
) -> Uncertain {
    let distance = dot::<N>(n, v);
    if N::LARGE {
        // A short number changes its sign more easily than a long one.
        let h = three(|i| if n[i] < N::Area::ZERO { -h[i] } else { h[i] });
        let certain = distance.magnitude() > dot::<N>(n, &h);
        return Uncertain { certain, possible: certain };
    }
    let radius = N::volume(n[0].magnitude(), h[0])
        + N::volume(n[1].magnitude(), h[1])
        + N::volume(n[2].magnitude(), h[2]);
    let beyond = distance.magnitude() - radius;
    Uncertain::above(beyond, error_bound)
}
