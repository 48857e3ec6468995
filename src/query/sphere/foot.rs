//! The part of a triangle closest to a point, and the foot of the point on it.

use super::error_bound::{Errors, PRODUCT};
use super::kernel::{along, around, largest_of, part, product, squared};
use crate::arithmetic::{Arithmetic, Embeds, Number, cross, greatest, three};
use crate::query::Feature;
use crate::query::orientation::Vector;
use crate::robust::certain_sign;
use crate::scalar::Scalar;

/// Whether a sign is certainly zero or below. Zero stands for doubt, unless nothing is rounded.
#[inline(always)]
fn is_not_above<S, N: Embeds<S>>(sign: i8) -> bool {
    if N::CERTAIN { sign <= 0 } else { sign < 0 }
}

/// A triangle around a point.
pub(super) struct Around<N: Arithmetic> {
    /// The vectors from the vertices to the point.
    pub(super) d: [Vector<N>; 3],
    /// The edges.
    pub(super) e: [Vector<N>; 3],
    /// The normal.
    pub(super) n: [N::Area; 3],
    pub(super) errors: Errors<N>,
}

impl<N: Arithmetic> Around<N> {
    /// `None` out of range.
    #[inline(always)]
    pub(super) fn new(point: &Vector<N>, vertices: &[Vector<N>; 3]) -> Option<Self> {
        let [d, e] = around::<N>(point, vertices);
        let size = greatest(largest_of::<N, 3>(&d), largest_of::<N, 3>(&e));
        let errors = Errors::<N>::new(size, N::Length::ZERO)?;
        let n = part(|| cross::<N>(&e[0], &e[1]));
        Some(Self { d, e, n, errors })
    }
}

/// The part of a segment closest to a point, with vectors from its ends to the point; `None` in
/// doubt.
#[inline(always)]
pub(super) fn feature_of_segment<S, N: Embeds<S>>(
    d: &[Vector<N>; 2],
    e: &Vector<N>,
    errors: &Errors<N>,
) -> Option<Feature> {
    let [start, end] = [0, 1].map(|k: usize| certain_sign(product::<N>(&d[k], e), errors.dot));
    if is_not_above::<S, N>(start) {
        Some(Feature::Vertex(0))
    } else if is_not_above::<S, N>(-end) {
        Some(Feature::Vertex(1))
    } else {
        (start > 0 && end < 0).then_some(Feature::Edge(0))
    }
}

/// The part of a triangle closest to a point; `None` in doubt.
#[inline(always)]
pub(super) fn feature<S, N: Embeds<S>>(Around { d, e, n, errors }: &Around<N>) -> Option<Feature> {
    let next = |k: usize| (k + 1) % 3;
    // Whether the point is past the start of an edge, and past its end.
    let starts = three(|k| certain_sign(product::<N>(&d[k], &e[k]), errors.dot));
    let ends = three(|k| certain_sign(product::<N>(&d[next(k)], &e[k]), errors.dot));
    for k in 0..3 {
        if is_not_above::<S, N>(-ends[k]) && is_not_above::<S, N>(starts[next(k)]) {
            return Some(Feature::Vertex(next(k) as u8));
        }
    }
    let sides = three(|k| {
        // Not indexed in the part, which would check the bounds.
        let (e, d) = (&e[k], &d[k]);
        certain_sign(along::<N>(n, &part(|| cross::<N>(e, d))), errors.side)
    });
    for k in 0..3 {
        if is_not_above::<S, N>(sides[k]) && starts[k] > 0 && ends[k] < 0 {
            return Some(Feature::Edge(k as u8));
        }
    }
    (sides == [1; 3]).then_some(Feature::Interior)
}

/// A point on the line through `a` along `e`, if `d` is the vector from `a` to another point.
#[inline(never)]
pub(super) fn on_edge<S: Scalar, N: Embeds<S>>(
    [a, d, e]: [&Vector<N>; 3],
    one: N::Length,
    errors: &Errors<N>,
) -> Option<[S; 3]> {
    let (ee, de) = (product::<N>(e, e), product::<N>(d, e));
    let cube = N::volume(N::area(one, one), one);
    let den = N::sextic(N::volume(ee, one), cube);
    let coordinate = |i: usize| {
        let num = N::sextic(N::volume(ee, a[i]) + N::volume(de, e[i]), cube);
        if N::CERTAIN {
            return N::coordinate(num, den, [N::Sextic::ZERO; 2]);
        }
        let (a, e) = (a[i].magnitude(), e[i].magnitude());
        let error = N::volume(errors.dot, e)
            + (N::volume(ee, a) + N::volume(de.magnitude(), e)).error(PRODUCT);
        N::coordinate(num, den, [N::sextic(error, cube), den.error(PRODUCT)])
    };
    all(three(|i| part(|| coordinate(i))))
}

/// The foot of a point over a plane with this normal, if n·d is `volume`.
#[inline(never)]
pub(super) fn on_face<S: Scalar, N: Embeds<S>>(
    p: &Vector<N>,
    n: &[N::Area; 3],
    volume: N::Volume,
    one: N::Length,
    errors: &Errors<N>,
) -> Option<[S; 3]> {
    let (nn, unit) = (squared::<N>(n, errors.minor), N::area(one, one));
    let den = N::sextic_of_areas(nn.value, unit);
    let coordinate = |i: usize| {
        let of_point = N::sextic_of_areas(nn.value, N::area(p[i], one));
        let of_normal = N::sextic(volume, N::volume(n[i], one));
        let num = of_point - of_normal;
        if N::CERTAIN {
            return N::coordinate(num, den, [N::Sextic::ZERO; 2]);
        }
        let (p, n) = (p[i].magnitude(), n[i].magnitude());
        let error = N::sextic_of_areas(nn.error, N::area(p, one))
            + N::sextic(errors.volume, N::volume(n + errors.minor, one))
            + N::sextic(volume.magnitude(), N::volume(errors.minor, one))
            + (of_point.magnitude() + of_normal.magnitude()).error(PRODUCT);
        let other = N::sextic_of_areas(nn.error, unit) + den.error(PRODUCT);
        N::coordinate(num, den, [error, other])
    };
    all(three(|i| part(|| coordinate(i))))
}

fn all<S: Copy>([x, y, z]: [Option<S>; 3]) -> Option<[S; 3]> {
    Some([x?, y?, z?])
}
