//! The kernel in floats, with the three axes of a box side by side. It has the same axes and
//! operations as the kernel of single numbers, so its answers are the same.

use super::error_bound::{ErrorBound, error_bound};
use super::kernel::{self, all_axes, is_zero};
use super::window::{self, Given};
use super::{First, Lie};
use crate::arithmetic::{Filtered, Float, InFloat, Quad, SMALL_CODE, THREE, greatest};
use crate::query::obb_rows::{ObbInFloats, Vectors, fits, holds_one, in_floats, most, transposed};
use crate::query::relation::{Asked, Relation};
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// Two parallelepipeds: the difference of the centres, axes and half-extents.
struct Boxes<F> {
    d: [F; 3],
    u: [[F; 3]; 3],
    h: [F; 3],
    v: [[F; 3]; 3],
    k: [F; 3],
}

/// The relation of the boxes, if floats decide it.
#[inline(never)]
pub(super) fn relation<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
) -> Option<Relation> {
    let boxes = boxes::<S, F>(question)?;
    match boxes.relation::<S, F::Quad>()? {
        Ok(relation) => Some(relation),
        Err(_) if question.asked == Asked::MayOverlap => None,
        Err(doubt) => boxes.in_doubt(question, &doubt),
    }
}

/// The same, if the boxes are known to be near contact and of a size within the range of the error
/// bound.
#[cold]
#[inline(never)]
pub(super) fn relation_near_contact<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
) -> Option<Relation> {
    let boxes = boxes::<S, F>(question)?;
    boxes.exactly(&boxes.given(question)).or_else(|| relation::<S, F>(question))
}

/// The boxes in floats, if these hold all numbers.
#[inline(always)]
fn boxes<S: Scalar + InFloat<F>, F: Float>(question: &Lie<'_, S>) -> Option<Boxes<F>> {
    let Lie { first, second, .. } = *question;
    if !holds_one::<S, F>() {
        return None;
    }
    let ObbInFloats { center: b, axes: v, half: k } = ObbInFloats::<F>::new(second);
    Some(match first {
        First::Obb(first) => {
            let ObbInFloats { center: a, axes: u, half: h } = ObbInFloats::<F>::new(first);
            if !fits::<S, F::Quad, 4>(&[a, h, b, k]) {
                return None;
            }
            Boxes { d: each(b, a, |b, a| b - a), u, h, v, k }
        }
        First::Aabb(first) => {
            let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
                first.form();
            let (p, q): ([F; 3], [F; 3]) = (in_floats(p.to_array()), in_floats(q.to_array()));
            if !fits::<S, F::Quad, 4>(&[p, q, b, k]) {
                return None;
            }
            let from = |p| each(b, p, |b: F, p| b - p);
            let (d, h) = match first.form() {
                AabbForm::Center { .. } => (from(p), q),
                AabbForm::Corners { .. } => (
                    each(from(p), from(q), |x, y| (x + y).half()),
                    each(q, p, |q, p| (q - p).half()),
                ),
            };
            let (zero, one) = (F::ZERO, F::from(1));
            let u = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
            Boxes { d, u, h, v, k }
        }
    })
}

/// What floats know of two boxes that they do not decide.
struct Doubt<F> {
    error: ErrorBound<F>,
    are_faces_clear: bool,
    /// The axes on which the boxes do not overlap for certain; see [`window::relation`].
    open: u32,
}

#[inline(always)]
fn each<F: Copy>(a: [F; 3], b: [F; 3], f: impl Fn(F, F) -> F) -> [F; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}

impl<F: Float> Boxes<F> {
    /// The relation or the doubt; `None` if the numbers are out of range.
    #[inline(always)]
    fn relation<S: InFloat<F>, Q: Quad<Lane = F>>(&self) -> Option<Result<Relation, Doubt<F>>> {
        let Self { d, u: [u0, u1, u2], h, v: [v0, v1, v2], k } = *self;
        let (u, v) = (Vectors::<Q>::new(&self.u), Vectors::new(&self.v));
        let rows = |x: [F; 3]| Q::of_three(x);
        let one = F::from(1);
        let axes = most(u.largest().greatest(v.largest()));
        if S::LIMIT.is_some_and(|limit| axes >= limit * S::PLACE) {
            return None;
        }
        let (way, half) = (most(rows(d).magnitude()), most(rows(h).greatest(rows(k))));
        let error = error_bound::<Filtered<F>>(one, greatest(axes, one), way, half)?;

        // The sum of three rows, each times a number.
        let sum = |times: [F; 3], [a, b, c]: [Q; 3]| {
            Q::splat(times[0]) * a + Q::splat(times[1]) * b + Q::splat(times[2]) * c
        };
        // The coordinates, first.
        let magnitudes = |u: [[F; 3]; 3]| {
            [rows(u[0]).magnitude(), rows(u[1]).magnitude(), rows(u[2]).magnitude()]
        };
        let reach = sum(h, magnitudes([u0, u1, u2])) + sum(k, magnitudes([v0, v1, v2]));
        let gap = rows(d).magnitude() - reach;
        if gap.exceeds(Q::splat(error.coordinate)) & THREE != 0 {
            return Some(Ok(Relation::Disjoint));
        }

        let (w, z) = (u.normals(), v.normals());
        let volume = Q::splat(u.determinant(&w).magnitude());
        let on_v = [w.dot(v0).magnitude(), w.dot(v1).magnitude(), w.dot(v2).magnitude()];
        let of_first = w.dot(d).magnitude() - (rows(h) * volume + sum(k, on_v));

        let volume = Q::splat(v.determinant(&z).magnitude());
        let [z0, z1, z2] = z.to_arrays();
        let on_u = [u.dot(z0).magnitude(), u.dot(z1).magnitude(), u.dot(z2).magnitude()];
        let [s0, s1, s2] = transposed([on_u[0].three(), on_u[1].three(), on_u[2].three()]);
        let of_second =
            z.dot(d).magnitude() - (rows(k) * volume + sum(h, [rows(s0), rows(s1), rows(s2)]));

        let limit = Q::splat(error.axis);
        let faces = of_first.greatest(of_second);
        if faces.exceeds(limit) & THREE != 0 {
            return Some(Ok(Relation::Disjoint));
        }

        let n = u.crossed_by(d);
        let (next, last) = (rows(h).turned(), rows(h).turned().turned());
        let pair = |v: [F; 3], on_v: Q, [p, q]: [F; 2], on_q: Q, on_p: Q| {
            let of_first = next * on_v.turned().turned() + last * on_v.turned();
            n.dot(v).magnitude() - (of_first + (Q::splat(p) * on_q + Q::splat(q) * on_p))
        };
        let pairs = [
            pair(v0, on_v[0], [k[1], k[2]], on_u[2], on_u[1]),
            pair(v1, on_v[1], [k[2], k[0]], on_u[0], on_u[2]),
            pair(v2, on_v[2], [k[0], k[1]], on_u[1], on_u[0]),
        ];
        let most = pairs[0].greatest(pairs[1]).greatest(pairs[2]);
        if most.exceeds(limit) & THREE != 0 {
            return Some(Ok(Relation::Disjoint));
        }
        let below = Q::splat(-error.axis);
        let is_clear = |gaps: Q| below.exceeds(gaps) & THREE == THREE;
        let are_faces_clear = is_clear(faces);
        if are_faces_clear && (is_clear(most) || self.are_zero_where_near(pairs, below)) {
            return Some(Ok(Relation::Overlapping));
        }
        let open = |gaps: Q| !below.exceeds(gaps) & THREE;
        let [a, b, c] = pairs.map(open);
        let open = open(of_first) | open(of_second) << 3 | a << 6 | b << 9 | c << 12;
        Some(Err(Doubt { error, are_faces_clear, open }))
    }

    /// The relation, where floats are in doubt.
    #[cold]
    #[inline(never)]
    fn in_doubt<S: Scalar + InFloat<F>>(
        &self,
        question: &Lie<'_, S>,
        doubt: &Doubt<F>,
    ) -> Option<Relation> {
        if doubt.are_faces_clear && self.overlap_beside_near_axes(&doubt.error) {
            return Some(Relation::Overlapping);
        }
        let given = self.given(question);
        self.exactly(&given).or_else(|| {
            // `f32` goes on in `f64`.
            let is_last = size_of::<F>() == size_of::<f64>() && !SMALL_CODE;
            if is_last { window::relation(&given, doubt.open) } else { None }
        })
    }

    /// The numbers as given.
    #[inline(always)]
    fn given<S: Scalar + InFloat<F>>(&self, question: &Lie<'_, S>) -> Given<F> {
        let ObbInFloats { center, half, .. } = ObbInFloats::<F>::new(question.second);
        let (first, by_corners) = match question.first {
            First::Obb(first) => {
                let ObbInFloats { center, half, .. } = ObbInFloats::<F>::new(first);
                ([center, half], false)
            }
            First::Aabb(first) => {
                let (AabbForm::Center { center: p, half: q }
                | AabbForm::Corners { min: p, max: q }) = first.form();
                let by_corners = matches!(first.form(), AabbForm::Corners { .. });
                ([p, q].map(|p| in_floats(p.to_array())), by_corners)
            }
        };
        Given { first, second: [center, half], u: self.u, v: self.v, by_corners }
    }

    /// Whether the boxes overlap, if the faces are clear and only pairs of axes that may be nearly
    /// parallel are in doubt.
    #[cold]
    #[inline(never)]
    fn overlap_beside_near_axes(&self, error: &ErrorBound<F>) -> bool {
        all_axes::<F, true>(&self.as_single_numbers(), error, false) == Some(Relation::Overlapping)
    }

    fn as_single_numbers(&self) -> kernel::Boxes<F> {
        let Self { d, u, h, v, k } = *self;
        kernel::Boxes { d, u, h, v, k, one: F::from(1) }
    }

    /// The relation of boxes that are rotated by no angle or by quarter turns. It is exact if the
    /// `given` numbers, centres and half-extents or corners, are short.
    ///
    /// P is the power of two that is not above the greatest of them. All are multiples of the last
    /// place of 192·P, which is P/2^16 in `f32`, so they are below 2^18 of its halves. The
    /// difference of the centres is below 2^19 halves, and that from a corner to the middle below
    /// 2^18; both are integers. Axes of components 0, 1 and −1 have normals of components up to 2
    /// and a determinant of at most 6. A reach is therefore up to 24·2^18, a distance up to
    /// 12·2^18, and their difference below 2^24, so nothing is rounded. `f64` has 2^29 times as
    /// much room. Nothing underflows, because the size is within the range of the error bound.
    #[cold]
    #[inline(never)]
    fn exactly(&self, given: &Given<F>) -> Option<Relation> {
        let Self { u, v, .. } = self;
        let (zero, one) = (F::ZERO, F::from(1));
        let is_whole = |x: &F| *x == zero || x.magnitude() == one;
        if !u.iter().chain(v).flatten().all(is_whole) {
            return None;
        }
        let numbers = || given.first.iter().chain(&given.second).flatten();
        let most = numbers().fold(zero, |most, x| greatest(most, x.magnitude()));
        let shifter = F::from(192) * most.power_of_two_below();
        let is_short = |x: &F| *x + shifter - shifter == *x;
        if !numbers().all(is_short) {
            return None;
        }
        let nothing = ErrorBound { coordinate: zero, axis: zero };
        all_axes::<F, false>(&self.as_single_numbers(), &nothing, true)
    }

    /// Whether all axes that are not clear are certainly zero: products of each axis of one box
    /// with each axis of the second box, in order.
    #[inline(never)]
    fn are_zero_where_near<Q: Quad<Lane = F>>(&self, pairs: [Q; 3], below: Q) -> bool {
        pairs.iter().zip(&self.v).all(|(gaps, v)| {
            let clear = below.exceeds(*gaps);
            self.u.iter().enumerate().all(|(i, u)| clear >> i & 1 == 1 || is_zero(u, v))
        })
    }
}

#[cfg(all(test, not(feature = "small")))]
mod tests {
    use super::*;
    use crate::arithmetic::three;
    use crate::query::obb_rows::tests::Numbers;
    use crate::robust::Predicate;
    use crate::shape::Obb;

    #[test]
    fn rows_say_what_single_numbers_say() {
        let mut numbers = Numbers(7);
        let mut counts = [0; 3];
        for n in 0..4_000 {
            let (mut a, b) = (numbers.obb(), numbers.obb());
            if n % 3 == 0 {
                // Face on face, or nearly.
                let center = a.center();
                let top = b.center().z + b.half_extents().z + a.half_extents().z;
                let at = [center.x, center.y, top];
                a = Obb::from_skewed_axes(at, *b.axes(), a.half_extents()).unwrap();
            }
            let question = Lie { first: First::Obb(&a), second: &b, asked: Asked::Relation };
            let found = relation::<f32, f32>(&question);
            let wide = relation::<f32, f64>(&question);
            let agree = |found: Option<Relation>, single: Option<Relation>| match single {
                // Unless the numbers are short.
                None => found.is_none_or(|found| found == question.exact()),
                _ => found == single,
            };
            assert!(agree(found, question.filter::<Filtered<f32>>()), "{a:?} {b:?}");
            assert!(agree(wide, question.filter::<Filtered<f64>>()), "{a:?} {b:?}");
            counts[found.map_or(0, |r| 1 + usize::from(r == Relation::Overlapping))] += 1;
        }
        assert!(counts.iter().all(|&n| n > 100), "{counts:?}");
    }

    /// The components of the last ones are not integers.
    const AXES: [[[f32; 3]; 3]; 5] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
        [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, -1.0]],
        [[1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]],
        [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]],
    ];

    fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    fn crossed(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
        three(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    }

    #[test]
    fn what_is_short_is_exact() {
        let mut numbers = Numbers(11);
        let mut answered = [0; 3];
        for n in 0..30_000 {
            // Up to 23 digits; 17 or more are requested.
            let digits = 1 << (8 + n % 16);
            let mut whole = || (numbers.next() * digits as f32).round();
            let mut point = || [whole(), whole(), whole()];
            let [a, h, k] = [point(), point(), point()].map(|p| p.map(|x| x / 64.0));
            let (i, j) = (n % 5, n / 5 % 5);
            let (u, v, are_whole) = (AXES[i], AXES[j], i < 4 && j < 4);
            let (h, k) = (h.map(f32::abs), k.map(f32::abs));
            // They touch along z or along a normal of the first, as closely as the numbers allow.
            let axis = if n & 256 == 0 { [0.0, 0.0, 1.0] } else { crossed(u[1], u[2]) };
            let along = (0..3).find(|&i| axis[i] != 0.0).unwrap();
            let reach: f32 =
                u.iter().zip(h).chain(v.iter().zip(k)).map(|(x, h)| dot(*x, axis).abs() * h).sum();
            let mut b = a;
            b[along] += (reach + (n % 3) as f32 / 64.0 - 1.0 / 64.0) / axis[along].abs();
            let second = Obb::from_skewed_axes(b, v, k).unwrap();
            let first = Obb::from_skewed_axes(a, u, h).unwrap();
            let min = three(|i| a[i] - h[i]);
            let boxes = [
                crate::Aabb::from_center_half_extents(a, h).unwrap(),
                crate::Aabb::from_min_max(min, a).unwrap(),
            ];
            let firsts = [First::Obb(&first), First::Aabb(&boxes[0]), First::Aabb(&boxes[1])];
            for (case, first) in firsts.into_iter().enumerate() {
                let question = Lie { first, second: &second, asked: Asked::Relation };
                let truth = question.exact();
                let found = relation::<f32, f32>(&question);
                assert!(found.is_none_or(|found| found == truth), "{case}: {second:?}");
                let wide = relation::<f32, f64>(&question);
                assert!(wide.is_none_or(|wide| wide == truth), "{case}: {second:?}");
                if are_whole {
                    assert!(found.is_some() || digits > 1 << 13, "{case}: {second:?}");
                    assert!(wide.is_some(), "{case}: {second:?}");
                }
                if found.is_some() {
                    answered[truth as usize] += 1;
                }
            }
        }
        assert!(answered.iter().all(|&n| n > 1_000), "{answered:?}");
    }
}
