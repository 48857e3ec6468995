//! The kernel in floats, with the three axes of the box side by side. It has the same axes and
//! operations as the kernel of single numbers, so its answers are the same.

use super::error_bound::{ErrorBound, Sizes, error_bound};
use super::kernel::{Operands, any_axis, farthest};
use super::{Disjoint, Line};
use crate::arithmetic::{
    Filtered, Float, InFloat, Number, Quad, THREE, cross3, greatest, three_in_float,
};
use crate::query::obb_rows::{ObbInFloats, Vectors, fits, holds_one};
use crate::query::triangle_obb::lie_along_one_axis;
use crate::robust::Uncertain;
use crate::scalar::Scalar;
use crate::shape::SegmentForm;

/// Whether one of the six axes separates, if floats decide it.
#[inline(never)]
pub(super) fn is_separated<S: Scalar + InFloat<F>, F: Float>(
    question: &Disjoint<'_, S>,
) -> Option<bool> {
    if !holds_one::<S, F>() {
        return None;
    }
    let ObbInFloats { center, axes: u, half: h } = ObbInFloats::<F>::new(question.obb);
    let [p, q, ends] = question.rows();
    let (p, q, ends): ([F; 3], [F; 3], [F; 3]) =
        (three_in_float(p), three_in_float(q), three_in_float(ends));
    if !fits::<S, F::Quad, 5>(&[p, q, ends, center, h]) {
        return None;
    }
    let from = |p: [F; 3], q: [F; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let (zero, one) = (F::ZERO, F::from(1));
    let (d, ends) = match question.line {
        Line::Ray(ray) => {
            let place = <S as InFloat<F>>::PLACE;
            let unit = if place > zero { place } else { one };
            (q, [ray.t_min().map(|_| ends[0] * unit), ray.t_max().map(|_| ends[1] * unit)])
        }
        Line::Segment(segment) => match segment.form() {
            SegmentForm::Ends(..) => (from(q, p), [Some(zero), Some(one)]),
            SegmentForm::Center { .. } => (q, [Some(-one), Some(one)]),
        },
    };
    Operands { m: from(p, center), d, ends, u, h, one }.is_separated::<S, F::Quad>()
}

impl<F: Float> Operands<F> {
    #[inline(always)]
    fn is_separated<S: InFloat<F>, Q: Quad<Lane = F>>(&self) -> Option<bool> {
        let Self { m, d, .. } = *self;
        let (u, h) = (Vectors::<Q>::new(&self.u), Q::of_three(self.h));
        let axes = u.largest().most();
        if S::LIMIT.is_some_and(|limit| axes >= limit * S::PLACE) {
            return None;
        }
        let (zero, one) = (F::ZERO, F::from(1));
        let sizes = Sizes { axes: greatest(axes, one), ..self.sizes() };
        let [from, to] = sizes.without_far(self.ends, one);
        let sizes = Sizes { ends: farthest([from, to]), ..sizes };
        let error = error_bound::<Filtered<F>>(one, &sizes)?;

        let w = u.normals();
        let along = w.dot(d);
        let (next, last) = (along.turned().magnitude(), along.turned().turned().magnitude());
        let reach = h.turned() * last + h.turned().turned() * next;
        let mut so_far = exceeds(u.dot(cross3(&m, &d)).magnitude() - reach, error.line);
        // On a zero vector a rounded gap never exceeds its bound.
        if so_far.possible & !so_far.certain & THREE != 0 {
            let others = !self.zeros();
            so_far = so_far.and(Uncertain::known(others));
            if so_far.possible & !so_far.certain & THREE != 0 {
                return self.by_second_look(&error);
            }
        }

        let (middle, reach) = (w.dot(m), h * Q::splat(u.determinant(&w).magnitude()));
        let at = |end: Option<F>| end.map(|t| middle + along * Q::splat(t));
        let (start, end) = (at(from), at(to));
        for is_upper in [true, false] {
            let upward = |x: Q| if is_upper { x } else { Q::splat(zero) - x };
            let beyond = |x: Q| exceeds(upward(x) - reach, error.face);
            // A line without an end separates only if it leads away from the box or parallel to it.
            let first = start
                .map_or_else(|| reaches(upward(Q::splat(zero) - along), error.direction), beyond);
            let last = end.map_or_else(|| reaches(upward(along), error.direction), beyond);
            let mut both = first.and(last);
            if start.is_none() & end.is_none() {
                both = both.and(beyond(middle));
            }
            so_far = so_far.or(both);
        }
        let any = |bits: u32| bits & THREE != 0;
        Uncertain { certain: any(so_far.certain), possible: any(so_far.possible) }.verdict()
    }

    /// The answer if the direction may be nearly parallel to an axis.
    #[cold]
    #[inline(never)]
    fn by_second_look(&self, error: &ErrorBound<F>) -> Option<bool> {
        any_axis(self, error, true).verdict()
    }

    /// The axes of the box whose product with the direction is certainly zero.
    #[inline(never)]
    fn zeros(&self) -> u32 {
        let bit = |i: usize| u32::from(lie_along_one_axis(&self.d, &self.u[i])) << i;
        bit(0) | bit(1) | bit(2)
    }
}

/// The numbers that are above zero, given their errors, as bits.
#[inline(always)]
fn exceeds<Q: Quad<Lane: Float>>(x: Q, error: Q::Lane) -> Uncertain<u32> {
    Uncertain { certain: x.exceeds(Q::splat(error)), possible: x.may_be_above(Q::splat(error)) }
}

/// The numbers that are zero or above.
#[inline(always)]
fn reaches<Q: Quad<Lane: Float>>(x: Q, error: Q::Lane) -> Uncertain<u32> {
    exceeds(Q::splat(Q::Lane::ZERO) - x, error).not()
}

#[cfg(all(test, not(feature = "small")))]
mod tests {
    use super::*;
    use crate::arithmetic::REGISTERS_ARE_WIDE;
    use crate::query::obb_rows::tests::Numbers;
    use crate::robust::Predicate;
    use crate::shape::{Ray, Segment};

    #[test]
    fn rows_say_what_single_numbers_say() {
        let mut numbers = Numbers(11);
        let mut counts = [0; 3];
        for n in 0..6_000 {
            let obb = numbers.obb();
            let (mut p, q) = (numbers.point(), numbers.point());
            if n % 4 == 0 {
                // Through a corner, or nearly.
                let (c, [u, v, w], h) = (obb.center(), *obb.axes(), obb.half_extents());
                let corner = [
                    c.x + u.x * h.x + v.x * h.y + w.x * h.z,
                    c.y + u.y * h.x + v.y * h.y + w.y * h.z,
                    c.z + u.z * h.x + v.z * h.y + w.z * h.z,
                ];
                p = [0, 1, 2].map(|i: usize| corner[i] - 0.375 * q[i]);
            }
            let ray = Ray::new(p, if q == [0.0; 3] { [1.0; 3] } else { q }).unwrap();
            let ray =
                [ray, ray.with_range(None, 0.5).unwrap(), ray.with_range(-0.25, 2.0).unwrap()]
                    [n % 3];
            let segment = Segment::new(p, q).unwrap();
            for line in [Line::Ray(&ray), Line::Segment(&segment)] {
                let question = Disjoint { line, obb: &obb };
                let found = is_separated::<f32, f32>(&question);
                assert_eq!(
                    found,
                    question.filter::<Filtered<f32>>(),
                    "{ray:?} {segment:?} {obb:?}"
                );
                let wide = is_separated::<f32, f64>(&question);
                assert_eq!(wide, question.filter::<Filtered<f64>>(), "{ray:?} {segment:?} {obb:?}");
                counts[found.map_or(0, |r| 1 + usize::from(r))] += 1;
            }
        }
        assert!(counts[1] > 1_000 && counts[2] > 1_000 && counts[0] > 50, "{counts:?}");
    }

    /// Ends at all distances: those far beyond the box count as none.
    #[test]
    fn far_ends_leave_no_doubt() {
        let mut numbers = Numbers(12);
        let mut in_doubt = 0;
        for n in 0..4_000 {
            let (obb, p, q) = (numbers.obb(), numbers.point(), numbers.point());
            let end = if n % 2 == 0 { 2.0_f32.powi(n / 2 % 8 - 4) } else { f32::MAX / (n as f32) };
            let ranges = [(Some(0.0), Some(end)), (Some(-end), None), (Some(end), None)];
            let (from, to) = ranges[n as usize % 3];
            let Ok(ray) = Ray::new(p, q) else { continue };
            let ray = ray.with_range(from, to).unwrap();
            let question = Disjoint { line: Line::Ray(&ray), obb: &obb };
            let found = is_separated::<f32, f32>(&question);
            assert_eq!(found, question.filter::<Filtered<f32>>(), "{ray:?} {obb:?}");
            let wide = is_separated::<f32, f64>(&question);
            for found in [found, wide].into_iter().flatten() {
                assert_eq!(found, question.exact(), "{ray:?} {obb:?}");
            }
            in_doubt += u32::from(found.is_none() && end > 1e6 && n % 3 != 2);
        }
        assert!(!REGISTERS_ARE_WIDE || in_doubt < 20, "{in_doubt}");
    }
}
