//! Lines in floats between a point and the nearest point of a flat shape, with bounds.
//!
//! u is the unit roundoff. Scalars of up to 32 bits are numbers of `f64`, and a difference has a
//! rounding. `line.g` proves the bounds.
//!
//! * Across an edge, t = (d·e)/(e·e). |d·e| is at most |d|·|e|, so that t·|e| errs by 11·u·|d| and a
//!   coordinate of d − t·e by less than [`WAY`]·u·|d|. If a coordinate of e is zero, it is that of d.
//! * A coordinate of a normal errs by [`NORMAL`]·u·P, with P the greater of its two products, and n·d
//!   by [`VOLUME`]·u times the sum of P·|dᵢ|.
//! * In double words a product errs by 5·u² of itself, and a sum by 3·u². Across an edge r² − d² is
//!   r² − d·d + (d·e)²/(e·e), and over a face r² − (n·d)²/(n·n).
//!
//! A line that is accepted has coordinates of zero, or not below 2^-180: their squares are normal
//! numbers, and so are products of six lengths of `f32` and what double words lose of them.

use super::answer::Part;
use super::body::{Flat, Vec64, dot};
use super::filter::cross_with_products;
use super::settled::U;
use crate::arithmetic::{Double, Each, exp2, largest, pick, three, turn};
use crate::query::Feature;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Roundoffs of a way across an edge, per |d|₁ of the vector d from an end of the edge.
const WAY: u16 = 18;
/// Roundoffs of a coordinate of a normal, per the greater of its two products.
const NORMAL: u16 = 9;
/// Roundoffs of a volume, per the sum of such a product times |dᵢ|.
const VOLUME: u16 = 19;
/// Roundoffs of a scalar product, beside those of one factor.
const DOT: u16 = 5;
/// Squares of the unit roundoff in r² − d², per r², or across an edge per r² + |d|².
const GAP: u16 = 72;
/// The same over a face, per the squares of the errors of the normal times r², and of the volume.
const GAP_OF_FACE: u16 = 2;

pub(super) fn roundoffs(count: u16) -> f64 {
    f64::from(count) * U
}

/// A direction from the nearest point of a flat shape to an end of the segment. Lengths are in
/// the units of `InDouble::units`.
pub(super) struct Line<S> {
    pub(super) a: Vec64,
    /// How far each coordinate may be off. A coordinate of zero without an error is exact.
    pub(super) errors: Vec64,
    /// How far apart they are times |a|, below zero out of a box, and how far that may be off; by
    /// default it is a·a.
    pub(super) height: Option<[f64; 2]>,
    /// The nearest point, and as numbers of the scalar.
    at: Vec64,
    pub(super) point: [S; 3],
    pub(super) part: Part,
}

pub(super) fn less<S: Scalar>(x: &[S; 3], y: &[S; 3]) -> Vec64 {
    three(|i| x[i].units_beyond(y[i]))
}

impl<S: Scalar> Line<S> {
    /// From a point without an error, by a vector that has one rounding in each coordinate.
    fn of_points(at: Vec64, to: &[S; 3], point: [S; 3], part: Part) -> Self {
        let (a, point) = (three(|i| to[i].units() - at[i]), unsigned(point));
        Self { a, errors: a.each(|x| x.abs() * U), height: None, at, point, part }
    }

    /// Whether a vector, rounded likewise, certainly leads back along the line.
    pub(super) fn is_behind(&self, v: &Vec64) -> bool {
        let error = |i: usize| v[i].abs() * (self.errors[i] + roundoffs(DOT) * self.a[i].abs());
        dot(&self.a, v) < -1.01 * (error(0) + error(1) + error(2))
    }

    /// Whether a vector is certainly along the face from which the line comes, without a rounding.
    pub(super) fn is_level(&self, v: &Vec64) -> bool {
        let is_across = |i| v[i] == 0.0 || (self.a[i] == 0.0 && self.errors[i] == 0.0);
        matches!(self.part, Part::Face(_)) && (0..3).all(is_across)
    }

    /// To a point outside of a triangle. The corners behind it are certainly nearer to no point.
    pub(super) fn of_triangle(triangle: &Triangle<S>, to: &[S; 3]) -> Option<Self> {
        let Ok(closest) = triangle.closest_point(*to) else { return None };
        let (point, v) = (closest.point.to_array(), triangle.points());
        let at = point.each(S::units);
        let edge = |from: usize, to: usize| less(pick(&v, to), pick(&v, from));
        match closest.feature {
            Feature::Vertex(k) => {
                let (k, next, before) = turn(k.into());
                let line = Self::of_points(at, to, point, Part::Vertex(k as u8));
                let is_behind = |to: usize| line.is_behind(&edge(k, to));
                (is_behind(next) && is_behind(before)).then_some(line)
            }
            Feature::Edge(k) => {
                let (k, next, before) = turn(k.into());
                let (d, e) = (less(to, pick(&v, k)), edge(k, next));
                let t = dot(&d, &e) / dot(&e, &e);
                let error = roundoffs(WAY) * (d[0].abs() + d[1].abs() + d[2].abs());
                let errors = three(|i| if e[i] == 0.0 { d[i].abs() * U } else { error });
                let a = three(|i| d[i] - e[i] * t);
                let part = Part::Edge(k as u8);
                let line = Self { a, errors, height: None, at, point, part };
                line.is_behind(&edge(k, before)).then_some(line)
            }
            Feature::Interior => {
                let d = less(to, &v[0]);
                let (n, products) = cross_with_products(&edge(0, 1), &edge(0, 2));
                let volume = dot(&n, &d);
                let error = |i: usize| roundoffs(VOLUME) * products[i] * d[i].abs();
                let error = error(0) + error(1) + error(2);
                let a = if volume < 0.0 { n.each(|x| -x) } else { n };
                let errors = products.each(|x| roundoffs(NORMAL) * x);
                let height = Some([volume.abs(), error]);
                let line = Self { a, errors, height, at, point, part: Part::Face(0) };
                (volume.abs() > 1.01 * error).then_some(line)
            }
        }
    }

    /// To a point outside of a box, or from its surface back to a point within. In exact numbers a
    /// corner comes before an edge that it ends, and the first of two corners in one place.
    pub(super) fn of_box(aabb: &Aabb<S>, to: &[S; 3]) -> Option<Self> {
        let ends = ends(aabb)?;
        let (mut point, mut beyond, mut is_clear) = (*to, [None; 3], true);
        let mut at = to.each(S::units);
        for i in 0..3 {
            let [low, high] = ends[i];
            let end = if at[i] < low {
                Some((low, 0))
            } else if at[i] > high {
                Some((high, 1))
            } else {
                is_clear &= at[i] != low && at[i] != high;
                None
            };
            if let Some((end, side)) = end {
                (at[i], point[i], beyond[i]) = (end, nearest(end)?, Some(side));
            }
            is_clear &= low != high;
        }
        let side = |i: usize| pick(&beyond, i).unwrap_or(0);
        let is_out = beyond.each(|side: Option<u8>| side.is_some());
        let axis = |is: bool| is_out.iter().position(|&out| out == is).unwrap_or(0);
        let part = match is_out.iter().filter(|&&out| out).count() {
            0 => return Self::out_of_box(&ends, to),
            1 => Part::Face(2 * axis(true) as u8 + side(axis(true))),
            2 => {
                let (i, next, after) = turn(axis(false));
                Part::Edge(4 * i as u8 + side(next) + 2 * side(after))
            }
            _ => Part::Vertex(side(0) + 2 * side(1) + 4 * side(2)),
        };
        let line = Self::of_points(at, to, point, part);
        (is_clear || matches!(part, Part::Face(_))).then_some(line)
    }

    /// To the face of a box that is certainly nearer than the others.
    fn out_of_box(ends: &[[f64; 2]; 3], to: &[S; 3]) -> Option<Self> {
        let (mut least, mut next, mut number) = (f64::INFINITY, f64::INFINITY, 0);
        for (n, end) in ends.as_flattened().iter().enumerate() {
            let depth = (end - to[n / 2].units()).abs();
            if depth < least {
                (next, least, number) = (least, depth, n);
            } else if depth < next {
                next = depth;
            }
        }
        let (mut at, mut point, mut a, axis) = (to.each(S::units), *to, [0.0; 3], number / 2);
        at[axis] = ends[axis][number % 2];
        point[axis] = nearest(at[axis])?;
        a[axis] = if number % 2 == 1 { 1.0 } else { -1.0 };
        let height = Some([-least, roundoffs(1) * least]);
        let part = Part::Face(number as u8);
        let line = Self { a, errors: [0.0; 3], height, at, point: unsigned(point), part };
        (least * (1.0 + roundoffs(4)) < next).then_some(line)
    }

    /// r² − d², and how far it may be off, both times the third number: in double words. d is the
    /// distance, and r the radius.
    pub(super) fn gap(&self, flat: Flat<'_, S>, to: &[S; 3], r: f64) -> [f64; 3] {
        let way = |x: &[S; 3], y: &[S; 3]| Double::way(&x.each(S::units), &y.each(S::units));
        let rr = square(Double::of(r));
        match (flat, self.part) {
            (Flat::Triangle(triangle), Part::Edge(k)) => {
                let (v, (k, next, _)) = (triangle.points(), turn(k.into()));
                let (d, e) = (way(to, pick(&v, k)), way(pick(&v, next), pick(&v, k)));
                let (dd, ee, de) = (Double::dot(&d, &d), Double::dot(&e, &e), Double::dot(&d, &e));
                let gap = rr.minus(dd).times(ee).plus(square(de));
                [gap.high, f64::from(GAP) * U * U * (rr.high + dd.high) * ee.high, ee.high]
            }
            (Flat::Triangle(triangle), Part::Face(_)) => {
                let [a, b, c] = triangle.points();
                let n = Double::cross(&way(&b, &a), &way(&c, &a));
                let nn = Double::dot(&n, &n);
                let gap = rr.times(nn).minus(square(Double::dot(&n, &way(to, &a))));
                let ([x, y, z], [_, volume]) = (self.errors, self.height.unwrap_or([0.0; 2]));
                let error = rr.high * (x * x + y * y + z * z) + volume * volume;
                [gap.high, f64::from(GAP_OF_FACE) * error, nn.high]
            }
            _ => {
                let d = Double::way(&to.each(S::units), &self.at);
                [rr.minus(Double::dot(&d, &d)).high, f64::from(GAP) * U * U * rr.high, 1.0]
            }
        }
    }

    /// The depth along a coordinate axis, if so few digits hold all numbers that nothing is rounded, in
    /// exact numbers either: r − d by r²·n², (n·d)², and the roots and quotients of these.
    pub(super) fn exact_depth(&self, flat: Flat<'_, S>, to: &[S; 3], r: f64) -> Option<f64> {
        let is_exact = |x: &Double| x.low == 0.0;
        let n = match (flat, self.part) {
            (Flat::Triangle(_), Part::Edge(_)) => return None,
            (Flat::Triangle(triangle), Part::Face(_)) => {
                let [a, b, c] = triangle.points().each(|x| x.each(S::units));
                let n = Double::cross(&Double::way(&b, &a), &Double::way(&c, &a));
                n.iter().all(is_exact).then(|| n[0].plus(n[1]).plus(n[2]))?
            }
            _ => Double::of(1.0),
        };
        let way = Double::way(&to.each(S::units), &self.at);
        let d = largest(&way.each(|x| x.high));
        let is_deep = self.height.is_some_and(|[height, _]| height < 0.0);
        let depth = Double::difference(r, if is_deep { -d } else { d });
        let (nr, nd) = (n.times(Double::of(r)), n.times(Double::of(d)));
        let (whole, part) = (square(nr), square(nd));
        let all = [depth, square(n), nr, nd, whole, part, whole.minus(part)];
        way.iter().chain(&all).all(is_exact).then_some(depth.high)
    }
}

/// Given coordinates, in which exact numbers know no sign of zero.
fn unsigned<S: Scalar>(point: [S; 3]) -> [S; 3] {
    point.each(|x| if x == S::ZERO { S::ZERO } else { x })
}

fn square(x: Double) -> Double {
    x.times(x)
}

/// The number of the scalar to which a number of units rounds, if that is certain.
fn nearest<S: Scalar>(x: f64) -> Option<S> {
    let near = |x: f64| S::ZERO.plus_double(x * S::UNIT);
    let (nearest, room) = (near(x), x * exp2(-50));
    // Where two are as near, exact numbers decide.
    let is_clear = S::FLOAT.is_some() && near(x - room) == near(x + room);
    let is_known = nearest.units() == x || is_clear && nearest.units().abs() < f64::INFINITY;
    is_known.then_some(nearest)
}

/// The ends of a box along each axis, in units, if `f64` rounds none.
fn ends<S: Scalar>(aabb: &Aabb<S>) -> Option<[[f64; 2]; 3]> {
    let (p, q, is_by_center) = aabb.numbers();
    let [p, q] = [p, q].each(|x| x.each(S::units));
    if !is_by_center {
        return Some(three(|i| [p[i], q[i]]));
    }
    let ends = three(|i| [Double::difference(p[i], q[i]), Double::difference(p[i], -q[i])]);
    let is_exact = ends.as_flattened().iter().all(|end| end.low == 0.0);
    is_exact.then(|| ends.each(|ends| ends.each(|end| end.high)))
}
