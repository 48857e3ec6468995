//! An integer stage of oriented boxes with boxes, segments and rays, in fixed point: every
//! vector cut to 19 bits, with a bound on the error.
//!
//! A box, as a segment, is symmetric about a centre. Let d be the vector from centre to centre and
//! g_r the half-vectors that span the two: h_i·u_i of a box, half the way of a segment. The shapes
//! have a point in common exactly if d lies in the zonotope of all g_r, the sums of s_r·g_r with
//! |s_r| ≤ 1. On an axis x the gap is |x·d| − Σ |x·g_r|, and x separates if that is above zero.
//!
//! Vectors here are integers, d' and g'_r, whose components are off by up to e_d and e_r. So on any
//! axis the gap is off by at most E·|x|_1, where E = e_d + Σ e_r and |x|_1 is the sum of the
//! magnitudes of the components.
//!
//! * If the gap on any axis exceeds E·|x|_1, the shapes are disjoint. The axis itself may be
//!   rounded.
//! * The facets of the integer zonotope have normals g'_p × g'_q. If the gap on each of these is
//!   below −E·|x|_1, the zonotope about d' contains the cube of half-width E about zero. So on
//!   *every* axis the gap is at most −E·|x|_1, and that of the true vectors at most zero: the
//!   shapes meet. As it is below zero, their interiors meet. At least one normal must not be zero.
//!   (If all g' lie in a plane, its normal has a gap of zero or more.)
//!
//! # Numbers
//!
//! In units of the last place that is left, with components up to 2^19:
//!
//! | quantity | magnitude | error |
//! | --- | --- | --- |
//! | factors of a product, to the nearest, cut to 30 bits | 2^30 | 1/2 |
//! | product, of which 41 bits or more are cut | 2^60 | 2^-11 + 2^-40 |
//! | d of two boxes; the end of a segment | 2^19 | 1/2 + 2^-12 |
//! | half-vector of a box | 2^19 | 1/2 + 2^-10 |
//! | middle and half-vector of a segment between two ends, halved | 2^19 | 1 + 2^-11 |
//! | the same of a ray, whose ends are sums of two vectors up to 2^18 | 2^19 | 3/2 and 1, and 2^-9 |
//! | component of a normal, of two products | 2^39 | |
//! | x·g, of three products | 3·2^58 | |
//! | sum of four of these, less x·d, and E·\|x\|_1 | 2^61.9 | |
//!
//! Two boxes: E = 1/2 + 6·1/2 = 7/2 and less than 2^-6. A ray and a box: E = 3/2 + 1 + 3·1/2 = 4
//! and less than 2^-6. [`ERROR`] is above both. `obb_short.g` proves the sums.

mod axes;
pub(super) mod floats;

use self::axes::relation;
use crate::arithmetic::{Each, InRaw, Raw, Word, greatest, out_of_line, product, three};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Obb, Ray, Segment, SegmentForm, Vec3};

/// In how many bits a component is left, beside its sign.
const LENGTH: i32 = 19;
/// In how many bits a factor of a product is left.
const FACTOR: i32 = 30;
/// E: by how much a component of d and all half-vectors may be off together.
const ERROR: i64 = 5;

/// Vectors in units of two to the `exponent`, in raw bits.
#[derive(Clone, Copy)]
pub(super) struct Scaled<const K: usize> {
    numbers: [[i64; 3]; K],
    exponent: i32,
    /// Their magnitudes are at most two to this, in raw bits.
    end: i32,
}

impl<const K: usize> Scaled<K> {
    fn new(numbers: [[i64; 3]; K], exponent: i32) -> Self {
        Self { numbers, exponent, end: bits(&numbers) + exponent }
    }

    /// In units of two to the `unit`, to the nearest.
    pub(super) fn cut(&self, unit: i32) -> [[i32; 3]; K] {
        Raw::cut(self.numbers, unit - self.exponent)
    }
}

/// How many bits hold the numbers.
pub(super) fn bits<const K: usize>(numbers: &[[i64; 3]; K]) -> i32 {
    size(numbers).bits()
}

/// The raw bits of a vector.
#[inline(always)]
pub(super) fn raw<S: InRaw>(v: &Vec3<S>) -> [i64; 3] {
    [v.x.raw().into(), v.y.raw().into(), v.z.raw().into()]
}

/// A number at least as great as each of the numbers, and less than twice the greatest.
#[inline(always)]
pub(super) fn size<W: Word, const K: usize>(x: &[[W; 3]; K]) -> W {
    let mut size = W::ZERO;
    for x in x {
        size = size | x[0].folded() | x[1].folded() | x[2].folded();
    }
    size
}

/// A sum of up to four raw vectors over two to the `halved`, for the components that `of` returns.
fn sum(of: impl Fn(usize) -> i128, halved: i32) -> Scaled<1> {
    let whole = three(of);
    let is_long = whole.iter().any(|&x| i64::try_from(x).is_err());
    // The shift loses far less than the last place that is left of numbers so long.
    let down = if is_long { 3 } else { 0 };
    let numbers = [three(|i| (whole[i] >> down) as i64)];
    Scaled::new(numbers, down - halved)
}

/// Each vector times a number, with the fraction bits of the two factors in the raw bits.
pub(super) fn products<const K: usize>(
    times: [i64; K],
    vectors: [[i64; 3]; K],
    fraction: i32,
) -> Scaled<K> {
    let mut factors = [[0; 3]; K];
    for (to, x) in factors.iter_mut().zip(times) {
        *to = [x, 0, 0];
    }
    let (long, other) = (bits(&factors), bits(&vectors));
    let cut = |bits: i32| greatest(bits - FACTOR, 0);
    let exponent = cut(long) + cut(other) - fraction;
    let (factors, vectors) = (Raw::cut(factors, cut(long)), Raw::cut(vectors, cut(other)));
    let mut numbers = [[0; 3]; K];
    for k in 0..K {
        numbers[k] = three(|i| product(factors[k][0], vectors[k][i]));
    }
    let left = |bits: i32| bits - cut(bits);
    Scaled { numbers, exponent, end: left(long) + left(other) + exponent }
}

/// The half-vectors of an oriented box.
fn spans<S: Scalar + InRaw>(obb: &Obb<S>) -> Scaled<3> {
    let [u, v, w] = obb.axes();
    products(raw(&obb.half_extents()), [raw(u), raw(v), raw(w)], S::FRACTION_BITS)
}

/// How two oriented boxes lie to each other; `None` in doubt.
pub(super) fn boxes<S: Scalar + InRaw>(first: &Obb<S>, second: &Obb<S>) -> Option<Relation> {
    let (a, b) = (raw(&first.center()), raw(&second.center()));
    let way = sum(|i| i128::from(b[i]) - i128::from(a[i]), 0);
    relation_of_boxes(way, spans(first), spans(second), i32::MIN)
}

/// How an axis-aligned box and an oriented one lie to each other; `None` in doubt.
pub(super) fn aabb_and_obb<S: Scalar + InRaw>(aabb: &Aabb<S>, obb: &Obb<S>) -> Option<Relation> {
    let c = raw(&obb.center());
    let (way, half) = match aabb.form() {
        AabbForm::Center { center, half } => {
            let (a, h) = (raw(center), raw(half));
            (sum(|i| i128::from(c[i]) - i128::from(a[i]), 0), sum(|i| h[i].into(), 0))
        }
        AabbForm::Corners { min, max } => {
            let (p, q) = (raw(min), raw(max));
            let from_both = |i: usize| 2 * i128::from(c[i]) - i128::from(p[i]) - i128::from(q[i]);
            (sum(from_both, 1), sum(|i| i128::from(q[i]) - i128::from(p[i]), 1))
        }
    };
    let mut along = [[0; 3]; 3];
    for i in 0..3 {
        along[i][i] = half.numbers[0][i];
    }
    let Scaled { exponent, end, .. } = half;
    relation_of_boxes(way, Scaled { numbers: along, exponent, end }, spans(obb), i32::MIN)
}

/// The unit of vectors that end there, and at least two to the `least`.
fn unit_of([a, b, c]: [i32; 3], least: i32) -> i32 {
    greatest(greatest(a, greatest(b, c)) - LENGTH, least)
}

fn relation_of_boxes(
    way: Scaled<1>,
    first: Scaled<3>,
    second: Scaled<3>,
    least: i32,
) -> Option<Relation> {
    let unit = unit_of([way.end, first.end, second.end], least);
    let ([way], [a, b, c], [e, f, g]) = (way.cut(unit), first.cut(unit), second.cut(unit));
    relation(&way, &[a, b, c, e, f, g])
}

#[inline(always)]
fn is_apart(way: &[i32; 3], half: &[[i32; 3]; 4]) -> Option<bool> {
    relation(way, half).map(|found| found == Relation::Disjoint)
}

/// Whether a segment and an oriented box are disjoint; `None` in doubt.
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub(super) fn segment<S: Scalar + InRaw>(segment: &Segment<S>, obb: &Obb<S>) -> Option<bool> {
    let (c, spans) = (raw(&obb.center()), spans(obb));
    let from = |p: &Vec3<S>| {
        let p = raw(p);
        sum(|i| i128::from(p[i]) - i128::from(c[i]), 0)
    };
    let (first, second, is_halved) = match segment.form() {
        SegmentForm::Ends(a, b) => (from(a), from(b), true),
        SegmentForm::Center { center, half } => {
            let half = raw(half);
            (from(center), sum(|i| half[i].into(), 0), false)
        }
    };
    let unit = unit_of([first.end, second.end, spans.end], i32::MIN);
    let ([p], [q], [u, v, w]) = (first.cut(unit), second.cut(unit), spans.cut(unit));
    let (way, half) = if is_halved { middle_and_half(&p, &q) } else { (p, q) };
    is_apart(&way, &[u, v, w, half])
}

/// Whether a ray and an oriented box are disjoint; `None` in doubt.
///
/// Let the box and the way to it reach less than 2^n from the origin of the ray. Where the ray has
/// no end, or one beyond that, it is cut where it is beyond that for certain.
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub(super) fn ray<S: Scalar + InRaw>(ray: &Ray<S>, obb: &Obb<S>) -> Option<bool> {
    let (c, p, d) = (raw(&obb.center()), raw(&ray.origin()), [raw(&ray.direction())]);
    let (spans, way) = (spans(obb), sum(|i| i128::from(p[i]) - i128::from(c[i]), 0));
    // |way| ≤ 2^way.end, and the half-vectors reach up to 3·2^spans.end.
    let reach = greatest(way.end, spans.end + 2) + 1;
    let unit = reach + 2 - LENGTH;
    // As long as two to the reach, and up to twice as long.
    let [beyond] = Raw::cut(d, bits(&d) + 1 - LENGTH);
    let Some([from, to]) = ends(ray, reach, unit, beyond) else { return Some(true) };
    let [way] = way.cut(unit);
    is_ray_apart(&way, [from, to], spans.cut(unit))
}

/// Whether the part of a line between two points misses a box, given the way from the centre of the box to the
/// line's origin, and the points from there.
fn is_ray_apart(way: &[i32; 3], [from, to]: [[i32; 3]; 2], spans: [[i32; 3]; 3]) -> Option<bool> {
    let (middle, half) = middle_and_half(&from, &to);
    let [u, v, w] = spans;
    let way = three(|i| way[i] + middle[i]);
    is_apart(&way, &[u, v, w, half])
}

/// The vectors from the origin of a ray to its ends, in units of two to the `unit`. The vector
/// `beyond`, or its opposite, replaces an end farther than two to the `reach`, and a missing one.
/// `None` if all of the ray lies farther.
pub(super) fn ends<S: Scalar + InRaw>(
    ray: &Ray<S>,
    reach: i32,
    unit: i32,
    beyond: [i32; 3],
) -> Option<[[i32; 3]; 2]> {
    let t = |t: Option<S>| t.map(|t| (t.raw().into(), S::FRACTION_BITS));
    let d = || [raw(&ray.direction())];
    between([t(ray.t_min()), t(ray.t_max())], d, reach, unit, beyond)
}

/// The same, given each t with the fraction bits of its product with the direction `d`.
#[inline(always)]
fn between(
    ends: [Option<(i64, i32)>; 2],
    d: impl Fn() -> [[i64; 3]; 1],
    reach: i32,
    unit: i32,
    beyond: [i32; 3],
) -> Option<[[i32; 3]; 2]> {
    let far = |is_ahead: bool| if is_ahead { beyond } else { beyond.each(|x| -x) };
    let at = |t: i64, fraction: i32, is_last: bool| {
        let d = d();
        // At least 2^(t's bits − 1) times 2^(d's bits − 1).
        if bits(&[[t, 0, 0]]) + bits(&d) - fraction - 2 < reach {
            let [at] = products([t], d, fraction).cut(unit);
            return Some(at);
        }
        ((t > 0) == is_last).then(|| far(is_last))
    };
    let end = |t: Option<(i64, i32)>, is_last: bool| match t {
        None => Some(far(is_last)),
        Some((0, _)) => Some([0; 3]),
        Some((t, fraction)) => out_of_line(|| at(t, fraction, is_last)),
    };
    Some([end(ends[0], false)?, end(ends[1], true)?])
}

/// The middle of two points, rounded down, and half the way between them.
fn middle_and_half(p: &[i32; 3], q: &[i32; 3]) -> ([i32; 3], [i32; 3]) {
    (three(|i| (p[i] + q[i]) >> 1), three(|i| (q[i] - p[i]) >> 1))
}
