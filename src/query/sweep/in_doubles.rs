//! The time of the first contact in `f64`. The axis whose gap closes last is known from floats
//! side by side, or found without a division. If `f64` knows its time to the last place of the scalar, that is the answer. For a
//! scalar with as many digits as `f64`, the gap and the speed on that axis are computed again in
//! 106 digits.

use super::error_bound::{LONG, at_start};
use super::kernel::Course;
use super::latest::Closing;
use super::{FirstContact, Given, Last, Passing};
use crate::arithmetic::{Double, Each, Embeds, Filtered, Number, Soft, dot, exp2, turn};
use crate::query::Axis;
use crate::query::triangle_aabb::kernel::normal;
use crate::robust::certain_sign;
use crate::scalar::Scalar;

/// Sizes within which products of two volumes, and the remainders of products of lengths, do not
/// overflow or underflow.
const RANGE: (f64, f64) = (exp2(-150), exp2(150));

/// Below every gap, whatever its error.
const NONE: f64 = f64::NEG_INFINITY;

/// Gaps at the start and speeds on the 13 axes, in the order of [`Axis::ALL`], with their errors;
/// [`NONE`] where there is certainly no gap.
struct Gaps {
    gap: [f64; 13],
    error: [f64; 13],
    speed: [f64; 13],
    speed_error: [f64; 13],
}

impl Course<Filtered<f64>> {
    /// `None` outside the range of the bounds.
    #[inline(always)]
    fn gaps(&self) -> Option<Gaps> {
        let size = self.frame.size_along(&self.d);
        if !(size > RANGE.0 && size < RANGE.1) {
            return None;
        }
        let bounds = at_start(size)?;
        let mut all =
            Gaps { gap: [NONE; 13], error: [0.0; 13], speed: [1.0; 13], speed_error: [0.0; 13] };
        for i in 0..3 {
            all.set(i, self.closing_face(i));
        }
        let n = normal(&self.frame);
        all.set(3, Some(self.closing_plane(&n, &bounds)));
        for i in 0..3 {
            for k in 0..3 {
                all.set(4 + 3 * i + k, self.closing_edge(i, k, n[i], &bounds));
            }
        }
        Some(all)
    }
}

impl Gaps {
    #[inline(always)]
    fn set(&mut self, k: usize, closing: Option<Closing<f64>>) {
        if let Some([[gap, error], [speed, speed_error]]) = closing {
            (self.gap[k], self.error[k]) = (gap, error);
            (self.speed[k], self.speed_error[k]) = (speed, speed_error);
        }
    }

    /// The axis whose gap closes last by the computed numbers; `None` if no axis has a gap by them.
    #[inline(always)]
    fn last(&self) -> Option<usize> {
        let (mut last, mut gap, mut speed) = (None, 0.0, 1.0);
        for k in 0..13 {
            if self.gap[k] * speed > gap * self.speed[k] {
                (last, gap, speed) = (Some(k), self.gap[k], self.speed[k]);
            }
        }
        last
    }

    /// Whether all axes but `last` have certainly closed before a time. Twice the errors cover the
    /// roundings here.
    #[inline(always)]
    fn others_close_before(&self, last: usize, t: f64) -> bool {
        let closes = |k: usize| {
            let speed = self.speed[k] - 2.0 * self.speed_error[k];
            self.gap[k] + 2.0 * self.error[k] < t * speed
        };
        (0..13).fold(true, |so_far, k| so_far & ((k == last) | closes(k)))
    }

    /// Whether there is certainly no gap.
    fn are_none(&self) -> bool {
        (0..13).all(|k| self.gap[k].is_not_above(self.error[k]))
    }
}

fn at_start_of<S: Scalar>(gaps: &Gaps) -> Option<FirstContact<S>> {
    gaps.are_none().then(FirstContact::default)
}

/// The first contact for a scalar with as many digits as `f64`.
#[inline(never)]
pub(super) fn first_contact_of_long<S: Scalar>(
    passing: &Passing<'_, S>,
    last: Option<Last>,
) -> Option<FirstContact<S>>
where
    Filtered<f64>: Embeds<S>,
{
    let course = passing.course::<Filtered<f64>>()?;
    let on_axis = |last: Last| {
        let t = time_on::<S>(passing, &course, last.axis)?;
        last.at(S::at_most(Soft::of_normal(t)))
    };
    if let Some(found) = last.and_then(on_axis) {
        return Some(found);
    }
    let gaps = course.gaps()?;
    let Some(last) = gaps.last() else { return at_start_of(&gaps) };
    if certain_sign(gaps.gap[last], gaps.error[last]) <= 0 {
        return None;
    }
    let axis = *Axis::ALL.get(last)?;
    let t = time_on::<S>(passing, &course, axis)?;
    let found = || FirstContact { t: S::at_most(Soft::of_normal(t)), axis: Some(axis) };
    gaps.others_close_before(last, t).then(found)
}

/// When an axis closes, rounded down.
#[inline(always)]
fn time_on<S: Scalar>(
    passing: &Passing<'_, S>,
    course: &Course<Filtered<f64>>,
    axis: Axis,
) -> Option<f64>
where
    Filtered<f64>: Embeds<S>,
{
    let size = course.frame.size_along(&course.d);
    if !(size > RANGE.0 && size < RANGE.1) {
        return None;
    }
    let (gap, speed) = passing.given::<Filtered<f64>>()?.long(axis, course);
    let error = match axis {
        Axis::Face(_) => size,
        Axis::Edge { .. } => size * size,
        Axis::Normal => size * size * size,
    } * LONG;
    rounded_down(gap, speed, error)
}

/// gap/speed rounded down, if the error decides on which side of it the nearby floats lie.
fn rounded_down(gap: Double, speed: Double, error: f64) -> Option<f64> {
    let left = |t: f64| gap.minus(speed.times(Double::of(t))).high;
    let is_at_most = |t: f64| {
        let left = left(t);
        (left.abs() > error).then_some(left > 0.0)
    };
    let next = |t: f64| f64::from_bits(t.to_bits() + 1);
    let mut t = gap.high / speed.high;
    if !(t > f64::MIN_POSITIVE && t <= 1.0) {
        return None;
    }
    // The quotient is within two units in the last place.
    if is_at_most(t)? {
        for _ in 0..3 {
            let above = next(t);
            if !is_at_most(above)? {
                return Some(t);
            }
            t = above;
        }
        return None;
    }
    for _ in 0..3 {
        t = f64::from_bits(t.to_bits() - 1);
        if is_at_most(t)? {
            return Some(t);
        }
    }
    None
}

impl Given<Filtered<f64>> {
    /// The gap on an axis that has one, and the speed at which it closes.
    fn long(&self, axis: Axis, course: &Course<Filtered<f64>>) -> (Double, Double) {
        let Self { triangle: [a, b, c], way: [from, to], .. } = self;
        let e = [Double::way(b, a), Double::way(c, b), Double::way(a, c)];
        let (zero, one) = (Double::ZERO, Double::of(1.0));
        let n = || Double::cross(&e[0], &e[1]);
        // The axis, and how far the vertices lie beyond the named one.
        let (axis, vertex, beyond) = match axis {
            Axis::Face(i) => {
                let mut unit = [zero; 3];
                unit[usize::from(i % 3)] = one;
                (unit, None, zero)
            }
            Axis::Normal => (n(), Some(0), zero),
            Axis::Edge { axis, edge } => {
                let (i, j, l) = turn(axis.into());
                let k = usize::from(edge % 3);
                let mut axis = [zero; 3];
                (axis[j], axis[l]) = (e[k][l].negated(), e[k][j]);
                (axis, Some(k), n()[i])
            }
        };
        // The side of the box on which the triangle lies; `f64` is certain of it.
        let on_axis = |v: &[f64; 3]| dot::<Filtered<f64>>(&axis.each(|x| x.high), v);
        let v = &course.frame.v;
        let is_above = on_axis(&v[0]) + on_axis(&v[1]) + on_axis(&v[2]) > 0.0;
        let all = [a, b, c];
        let nearer = |x: f64, y: f64| if is_above { x < y } else { x > y };
        let vertex = match vertex {
            Some(k) if nearer(beyond.high, 0.0) => all[(k + 2) % 3],
            Some(k) => all[k % 3],
            // Along a coordinate axis the vertices are as given.
            None => {
                let nearest = |a, b| if nearer(on_axis(a), on_axis(b)) { a } else { b };
                nearest(nearest(a, b), c)
            }
        };
        let d = Double::way(to, from);
        let (mut gap, mut speed) = (zero, zero);
        for i in 0..3 {
            let to_vertex = self.beyond_corner(i, vertex[i], (axis[i].high > 0.0) == is_above);
            gap = gap.plus(axis[i].times(to_vertex));
            speed = speed.minus(axis[i].times(d[i]));
        }
        if is_above { (gap, speed) } else { (gap.negated(), speed.negated()) }
    }

    /// How far a coordinate lies beyond the greatest or the least one of the box.
    fn beyond_corner(&self, i: usize, x: f64, is_greatest: bool) -> Double {
        let Self { p, q, is_by_center, .. } = self;
        if *is_by_center {
            let half = Double::of(q[i]);
            let from_center = Double::difference(x, p[i]);
            if is_greatest { from_center.minus(half) } else { from_center.plus(half) }
        } else {
            Double::difference(x, if is_greatest { q[i] } else { p[i] })
        }
    }
}
