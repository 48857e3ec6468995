//! The part of a triangle closest to a point, and the foot of the point on it.

use super::error_bound::{Errors, PRODUCT};
use super::kernel::{around, largest_of, product, squared};
use crate::arithmetic::{
    Arithmetic, Embeds, Filtered, Number, cross, dot, greatest, least, part, three, two,
};
use crate::query::Feature;
use crate::query::orientation::Vector;
use crate::scalar::Scalar;

/// Whether a number is certainly above zero, if it errs by up to `error`.
#[inline(always)]
fn is_above<N: Arithmetic, T: Number>(x: T, error: T) -> bool {
    if N::CERTAIN { x.is_positive() } else { x > error }
}

/// Whether a number is certainly zero or below. In floats zero is in doubt.
#[inline(always)]
fn is_not_above<N: Arithmetic, T: Number>(x: T, error: T) -> bool {
    if N::CERTAIN { !x.is_positive() } else { x < -error }
}

/// A triangle around a point.
pub(super) struct Around<N: Arithmetic> {
    /// The vectors from the vertices to the point.
    pub(super) d: [Vector<N>; 3],
    /// The edges.
    pub(super) e: [Vector<N>; 3],
    pub(super) errors: Errors<N>,
    /// The error of [`side`].
    pub(super) side: N::Quartic,
}

impl<N: Arithmetic> Around<N> {
    /// `None` out of range.
    #[inline(always)]
    pub(super) fn new(point: &Vector<N>, vertices: &[Vector<N>; 3]) -> Option<Self> {
        let [d, e] = around::<N>(point, vertices);
        let size = greatest(largest_of::<N, 3>(&d), largest_of::<N, 3>(&e));
        let errors = Errors::<N>::of_lengths(size)?;
        Some(Self { d, e, errors, side: Errors::<N>::side_by_dots(size) })
    }

    /// The normal.
    #[inline(always)]
    pub(super) fn normal(&self) -> [N::Area; 3] {
        part(|| cross::<N>(&self.e[0], &self.e[1]))
    }
}

/// The part of a segment closest to a point, with vectors from its ends to the point; `None` in
/// doubt.
#[inline(always)]
pub(super) fn feature_of_segment<N: Arithmetic>(
    d: &[Vector<N>; 2],
    e: &Vector<N>,
    errors: &Errors<N>,
) -> Option<Feature> {
    let [start, end] = two(|k| product::<N>(&d[k], e));
    if is_not_above::<N, _>(start, errors.dot) {
        Some(Feature::Vertex(0))
    } else if is_not_above::<N, _>(-end, errors.dot) {
        Some(Feature::Vertex(1))
    } else {
        let is_between = is_above::<N, _>(start, errors.dot) && is_above::<N, _>(-end, errors.dot);
        is_between.then_some(Feature::Edge(0))
    }
}

/// n·(e × d) for the edge e before another, f, by the dot products at its ends.
///
/// With e·e = e·d − e·d', and n·(e × d) = (e·e)·(f·d) − (e·d)·(e·f), it is (e·d)·(e·d' + f·d') +
/// (e·d')·(g·d): d' goes from the end of e, where f starts, and the third edge, g, ends at its start.
#[inline(always)]
pub(super) fn side<N: Arithmetic>(
    [start, end]: [N::Area; 2],
    after: N::Area,
    before: N::Area,
) -> N::Quartic {
    part(|| N::quartic(start, end + after) + N::quartic(end, before))
}

/// The part of a triangle closest to a point; `None` in doubt.
#[inline(always)]
pub(super) fn feature<N: Arithmetic>(around: &Around<N>) -> Option<Feature> {
    let Around { d, e, errors, side: error } = around;
    let next = |k: usize| (k + 1) % 3;
    // Whether the point is past the end of an edge, and not past the start of the next.
    let (mut starts, mut ends) = ([N::Area::ZERO; 3], [N::Area::ZERO; 3]);
    for k in 0..3 {
        let v = next(k);
        (ends[k], starts[v]) = (product::<N>(&d[v], &e[k]), product::<N>(&d[v], &e[v]));
        if is_not_above::<N, _>(-ends[k], errors.dot) & is_not_above::<N, _>(starts[v], errors.dot)
        {
            return Some(Feature::Vertex(v as u8));
        }
    }
    let mut is_inside = true;
    for k in 0..3 {
        let side = side::<N>([starts[k], ends[k]], starts[next(k)], ends[next(next(k))]);
        if is_not_above::<N, _>(side, *error)
            & is_above::<N, _>(starts[k], errors.dot)
            & is_above::<N, _>(-ends[k], errors.dot)
        {
            return Some(Feature::Edge(k as u8));
        }
        is_inside &= is_above::<N, _>(side, *error);
    }
    is_inside.then_some(Feature::Interior)
}

/// A point on the line through `a` along `e`, if `d` is the vector from `a` to another point.
#[inline(always)]
pub(super) fn on_edge<S: Scalar, N: Embeds<S>>(
    [a, d, e]: [&Vector<N>; 3],
    one: N::Length,
    errors: &Errors<N>,
) -> Option<[S; 3]> {
    if N::CERTAIN {
        return exactly_on_edge::<S, N>([a, d, e], one);
    }
    let num = N::volume(product::<N>(d, e), one);
    let den = N::quartic(product::<N>(e, e), N::area(one, one));
    let step = three(|i| N::area(e[i], one));
    let errors = (N::Area::ZERO, N::volume(errors.dot, one), den.error(PRODUCT));
    N::on_line(a, &step, num, den, errors)
}

/// The foot of a point over a plane with this normal, if n·d is `volume`.
#[inline(always)]
pub(super) fn on_face<S: Scalar, N: Embeds<S>>(
    p: &Vector<N>,
    n: &[N::Area; 3],
    volume: N::Volume,
    one: N::Length,
    errors: &Errors<N>,
) -> Option<[S; 3]> {
    let nn = squared::<N>(n, errors.minor);
    if N::CERTAIN {
        return exactly_on_face::<S, N>(p, n, volume, nn.value, one);
    }
    let errors = (errors.minor, errors.volume, nn.error);
    N::on_line(p, n, -volume, nn.value, errors)
}

#[inline(never)]
fn exactly_on_edge<S: Scalar, N: Embeds<S>>(
    [a, d, e]: [&Vector<N>; 3],
    one: N::Length,
) -> Option<[S; 3]> {
    let (ee, de) = (product::<N>(e, e), product::<N>(d, e));
    let cube = N::volume(N::area(one, one), one);
    let den = N::sextic(N::volume(ee, one), cube);
    let coordinate = |i: usize| {
        let num = N::sextic(N::volume(ee, a[i]) + N::volume(de, e[i]), cube);
        N::coordinate(num, den, [N::Sextic::ZERO; 2])
    };
    all(three(|i| part(|| coordinate(i))))
}

#[inline(never)]
fn exactly_on_face<S: Scalar, N: Embeds<S>>(
    p: &Vector<N>,
    n: &[N::Area; 3],
    volume: N::Volume,
    nn: N::Quartic,
    one: N::Length,
) -> Option<[S; 3]> {
    let den = N::sextic_of_areas(nn, N::area(one, one));
    let coordinate = |i: usize| {
        let of_point = N::sextic_of_areas(nn, N::area(p[i], one));
        let of_normal = N::sextic(volume, N::volume(n[i], one));
        N::coordinate(of_point - of_normal, den, [N::Sextic::ZERO; 2])
    };
    all(three(|i| part(|| coordinate(i))))
}

/// The foot of a point over a triangle in a plane across a coordinate axis, as of a floor: no number is
/// computed. Floats leave a doubt about a foot of zero, and those of 53 digits about every foot.
fn across_axis<S: Scalar>([a, b, c]: &[[S; 3]; 3], mut point: [S; 3]) -> Option<[S; 3]> {
    let axis = (0..3).find(|&i| a[i] == b[i] && b[i] == c[i])?;
    point[axis] = a[axis];
    // An exact zero has no sign.
    Some(three(|i| if point[i] == S::ZERO { S::ZERO } else { point[i] }))
}

fn all<S: Copy>([x, y, z]: [Option<S>; 3]) -> Option<[S; 3]> {
    Some([x?, y?, z?])
}

/// The part of a triangle closest to a point, and the closest point, in `f64`, for hosts; `None` in
/// doubt.
///
/// The same signs as in [`feature`], without loops: each part has an answer of its own, from numbers
/// in registers, and the first that is certain is the answer. Numbers for the parts after it would
/// take longer than a branch.
#[inline(always)]
pub(super) fn in_double<S: Scalar>(
    vertices: &[[S; 3]; 3],
    point: [S; 3],
) -> Option<(Feature, [S; 3])>
where
    Filtered<f64>: Embeds<S>,
{
    type N = Filtered<f64>;
    let [a, b, c, p] = N::embed(&[vertices[0], vertices[1], vertices[2], point])?;
    let around = Around::<N>::new(&p, &[a, b, c])?;
    let Around { d, e, errors, side: error } = &around;
    // One branch for both.
    let is_past = |end: f64, start: f64| least(end, -start) > errors.dot;
    let vertex = |k: usize| Some((Feature::Vertex(k as u8), vertices[k]));
    let (end2, start0) = (product::<N>(&d[0], &e[2]), product::<N>(&d[0], &e[0]));
    if is_past(end2, start0) {
        return vertex(0);
    }
    let (end0, start1) = (product::<N>(&d[1], &e[0]), product::<N>(&d[1], &e[1]));
    if is_past(end0, start1) {
        return vertex(1);
    }
    let (end1, start2) = (product::<N>(&d[2], &e[1]), product::<N>(&d[2], &e[2]));
    if is_past(end1, start2) {
        return vertex(2);
    }
    let is_beside =
        |side: f64, start: f64, end: f64| (side < -*error) & (least(start, -end) > errors.dot);
    let side0 = side::<N>([start0, end0], start1, end2);
    if is_beside(side0, start0, end0) {
        return Some((Feature::Edge(0), on_edge::<S, N>([&a, &d[0], &e[0]], 1.0, errors)?));
    }
    let side1 = side::<N>([start1, end1], start2, end0);
    if is_beside(side1, start1, end1) {
        return Some((Feature::Edge(1), on_edge::<S, N>([&b, &d[1], &e[1]], 1.0, errors)?));
    }
    let side2 = side::<N>([start2, end2], start0, end1);
    if is_beside(side2, start2, end2) {
        return Some((Feature::Edge(2), on_edge::<S, N>([&c, &d[2], &e[2]], 1.0, errors)?));
    }
    let is_inside = least(least(side0, side1), side2) > *error;
    let n = around.normal();
    let foot = || on_face::<S, N>(&p, &n, dot::<N>(&n, &d[0]), 1.0, errors);
    let foot = || foot().or_else(|| across_axis(vertices, point));
    if is_inside { Some((Feature::Interior, foot()?)) } else { None }
}

#[cfg(test)]
mod tests {
    use super::in_double;
    use crate::query::Feature;

    /// In the plane of each coordinate axis: over its interior, and beside an edge.
    #[test]
    fn a_foot_on_a_level_triangle_needs_no_exact_numbers() {
        for axis in 0..3 {
            let at = |[x, y, z]: [f64; 3]| {
                let mut p = [0.0; 3];
                (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (z, x, y);
                p
            };
            for height in [-0.0, 1.0 / 3.0, -7.0] {
                let level = [[-1.0, -1.0, height], [2.0, -1.0, height], [0.0, 2.0, height]].map(at);
                // An exact zero has no sign.
                let foot = at([0.1, -0.0, height]).map(|x| (x + 0.0).to_bits());
                let (feature, found) = in_double(&level, at([0.1, -0.0, 0.3])).unwrap();
                assert_eq!((feature, found.map(f64::to_bits)), (Feature::Interior, foot));

                let short = |p: [f64; 3]| p.map(|x| x as f32);
                let (feature, found) =
                    in_double(&level.map(short), short(at([0.7, -9.0, 0.3]))).unwrap();
                let foot = short(at([0.7, -1.0, height])).map(|x| (x + 0.0).to_bits());
                assert_eq!((feature, found.map(f32::to_bits)), (Feature::Edge(0), foot));
            }
            // A coordinate of this normal is rounded to zero.
            let (d, next) = (1e-12_f32, 1.000_000_2e-12_f32);
            let point = [0.6, -0.3, 0.0];
            let steep = [[-1.0, -1.0, -1.0], [d, next, 2.0], [1.0, 1.0, -1.0]];
            let turned = |p: [f32; 3]| [p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]];
            assert_eq!(in_double(&steep.map(turned), turned(point)), None);
        }
    }
}
