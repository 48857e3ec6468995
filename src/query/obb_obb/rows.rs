//! The kernel in floats, with the three axes of a box side by side. It has the same axes and
//! operations as the kernel of single numbers, so its answers are the same.

use super::Lie;
use super::error_bound::error_bound;
use super::floats::{Doubt, of_boxes};
use super::kernel::Boxes;
use crate::arithmetic::{Each, Filtered, Float, InFloat, Quad, THREE, greatest};
use crate::query::obb_rows::{Vectors, transposed};
use crate::query::relation::{Asked, Relation};
use crate::scalar::Scalar;

/// The relation of the boxes, if floats decide it.
#[inline(never)]
pub(super) fn relation<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
) -> Option<Relation> {
    of_boxes::<S, F>(question, |boxes| match boxes.relation::<S, F::Quad>()? {
        Ok(relation) => Some(relation),
        Err(_) if question.asked == Asked::MayOverlap => None,
        Err(doubt) => boxes.in_doubt(question, &doubt),
    })
}

/// The same, if the boxes are known to be near contact and of a size within the range of the error
/// bound.
#[cold]
#[inline(never)]
pub(super) fn relation_near_contact<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
) -> Option<Relation> {
    of_boxes::<S, F>(question, |boxes| boxes.exactly(&boxes.given(question)))
        .or_else(|| relation::<S, F>(question))
}

impl<F: Float> Boxes<F> {
    /// The relation or the doubt; `None` if the numbers are out of range.
    #[inline(always)]
    fn relation<S: InFloat<F>, Q: Quad<Lane = F>>(&self) -> Option<Result<Relation, Doubt<F>>> {
        let Self { d, u: [u0, u1, u2], h, v: [v0, v1, v2], k, .. } = *self;
        let (u, v) = (Vectors::<Q>::new(&self.u), Vectors::new(&self.v));
        let rows = |x: [F; 3]| Q::of_three(x);
        let one = F::from(1);
        let axes = u.largest().greatest(v.largest()).most();
        if S::LIMIT.is_some_and(|limit| axes >= limit * S::PLACE) {
            return None;
        }
        let (way, half) = (rows(d).magnitude().most(), rows(h).greatest(rows(k)).most());
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
        let [a, b, c] = pairs.each(open);
        let open = open(of_first) | open(of_second) << 3 | a << 6 | b << 9 | c << 12;
        Some(Err(Doubt { error, are_faces_clear, open }))
    }
}

#[cfg(all(test, not(feature = "small")))]
mod tests {
    use super::*;
    use crate::arithmetic::{cross3, dot3, three};
    use crate::query::obb_obb::First;
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

    #[test]
    fn what_is_short_is_exact() {
        let mut numbers = Numbers(11);
        let mut answered = [0; 3];
        for n in 0..10_000 {
            // Up to 23 digits; 17 or more are requested.
            let digits = 1 << (8 + n % 16);
            let mut whole = || (numbers.next() * digits as f32).round();
            let mut point = || [whole(), whole(), whole()];
            let [a, h, k] = [point(), point(), point()].map(|p| p.map(|x| x / 64.0));
            let (i, j) = (n % 5, n / 5 % 5);
            let (u, v, are_whole) = (AXES[i], AXES[j], i < 4 && j < 4);
            let (h, k) = (h.map(f32::abs), k.map(f32::abs));
            // They touch along z or along a normal of the first, as closely as the numbers allow.
            let axis = if n & 256 == 0 { [0.0, 0.0, 1.0] } else { cross3(&u[1], &u[2]) };
            let along = (0..3).find(|&i| axis[i] != 0.0).unwrap();
            let reach: f32 =
                u.iter().zip(h).chain(v.iter().zip(k)).map(|(x, h)| dot3(x, &axis).abs() * h).sum();
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
        assert!(answered.iter().all(|&n| n > 300), "{answered:?}");
    }
}
