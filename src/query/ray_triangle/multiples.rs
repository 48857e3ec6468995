//! The question in short multiples of a power of two, for `f32` on cores without `f64`.
//!
//! All volumes are exact, so verdict, side and feature are too. t, u and v must have the bits that
//! `f64`, or a stage after it, gives (`super::question`). That stage also has the exact lengths,
//! which have 30 bits. For lengths below 2^a, 2^b and 2^c, and with u = 2^-53,
//!
//! * an area is two products and their difference, off by 2u + 2u of 2^(a+b);
//! * a volume is three products of an area and a length, off by 4u each, rounded by 2u each and
//!   added, 4u + 6u: 28u of 2^(a+b+c), and less than 2^-48 of it with the second order.
//!
//! A volume that is k bits shorter, at least 2^(a+b+c-k), has a relative error of 2^(k-48). So the
//! quotient in `f64` of two volumes that are no shorter is within a relative 2·2^(k-48) + 2^-53,
//! and second orders; stages after `f64` are within 2^-61. `ShortFloat::rounded_quotient` computes
//! the quotient to 2^-50, and answers only if no number within 2^(k-46) rounds to another float. A
//! zero volume has a quotient of zero with the sign of the determinant, in every stage.

use super::crosses::Crosses;
use super::kernel::{Crossing, Setting};
use super::words::Counted;
use super::{Facing, Hit};
use crate::arithmetic::{Divisor, Each, Leading64, ProductSum, minus3};
use crate::scalar::Scalar;

/// The number of bits by which a volume may be shorter than its lengths. For k = 0, no number
/// within 2^-46 of a quotient may round to another float.
const SHORTER: i32 = 19;
const CLEAR: i32 = 46;

impl<S: Scalar> Crosses<'_, S> {
    /// The hit of a ray with the range t ≥ 0; `None` if another stage must answer.
    #[cold]
    #[inline(never)]
    pub(super) fn in_multiples(&self) -> Option<Option<Hit<S>>> {
        if !self.has_usual_range() {
            return None;
        }
        let [a, b, c, o, d] = self.rows();
        let ([a, b, c, o], unit) = S::short(&[a, b, c, o])?;
        let ([d], unit_of_d) = S::short(&[d])?;
        let setting = Setting { d, e: [minus3(&b, &a), minus3(&c, &a)], s: minus3(&o, &a) };
        let first_sign = |a: &[i32; 3], b: &[i32; 3]| {
            let [x, y, z] = cross(a, b).each(|x| x.cmp(&0));
            x.then(y).then(z)
        };
        let counted = self.counted(
            &setting,
            (cross, dot),
            |t, _, _| t.cmp(&0),
            |k| setting.perturbed(k, minus3, first_sign),
        );
        let Some(Counted { is_front, volumes }) = counted else { return Some(None) };
        let Crossing { det, t, sides: [_, u, v] } = volumes;

        let Setting { d, e: [e1, e2], s } = &setting;
        let edges = bits(e1).max(bits(e2));
        let size = edges.max(bits(s));
        let full = bits(d) + edges + size;
        let shorter = |x: Leading64, full: i32| full + 1 - x.bits();
        let den = Leading64::new(det)?;
        let shortest = shorter(den, full).max(0);
        let divisor = Divisor::new(den);
        let quotient = |x: i128, full: i32, exponent: i32| {
            let Some(x) = Leading64::new(x) else { return Some(S::zero(!is_front)) };
            let k = shorter(x, full).max(shortest);
            if k > SHORTER { None } else { S::rounded_quotient(x, &divisor, exponent, CLEAR - k) }
        };
        Some(Some(Hit {
            t: quotient(t, edges + edges + size, unit - unit_of_d)?,
            u: quotient(u, full, 0)?,
            v: quotient(v, full, 0)?,
            facing: Facing::of(is_front),
            feature: volumes.feature(),
        }))
    }
}

/// The number of bits of the longest component, without its sign.
fn bits(x: &[i32; 3]) -> i32 {
    let all = x[0].unsigned_abs() | x[1].unsigned_abs() | x[2].unsigned_abs();
    32 - all.leading_zeros() as i32
}

#[inline(always)]
fn cross(a: &[i32; 3], b: &[i32; 3]) -> [i64; 3] {
    let minor = |j: usize, k: usize| <i64 as ProductSum<i32>>::new(a[j], b[k], -a[k], b[j]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// With lengths below 2^30, areas are below 2^61 and fit, and so do the two sums of a volume.
#[inline(always)]
fn dot(a: &[i64; 3], b: &[i32; 3]) -> i128 {
    let mut volume = <i64 as ProductSum<i32>>::ZERO;
    for (&a, &b) in a.iter().zip(b) {
        volume = <i64 as ProductSum<i32>>::sum(volume, a, b);
    }
    <i64 as ProductSum<i32>>::whole(volume)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::{Cull, HitRules};
    use crate::random::Random;
    use crate::shape::{Ray, Triangle};

    /// The bits equal the result of `f64` and the stages after it, and there is usually an answer.
    #[test]
    fn hits_are_the_same_bits() {
        let mut random = Random(3);
        let mut below = |n: u32| (((random.bits() >> 32) * u64::from(n)) >> 32) as u32;
        // Multiples, small grids, any floats, and small numbers far from the origin.
        let (mut hits, mut said) = ([0; 4], [0; 4]);
        for case in 0..40_000 {
            let kind = case % 4;
            let mut number = || match kind {
                0 => (below(1 << 18) as f32 - 131_072.0) / 65536.0,
                1 => below(5) as f32 - 2.0,
                2 => f32::from_bits(0x3e80_0000 + below(1 << 24)) - 1.0,
                _ => 1000.0 + below(1 << 12) as f32 / 16384.0,
            };
            let mut point = || [number(), number(), number()];
            let (a, b, c, o) = (point(), point(), point(), point());
            let (i, j) = (below(5), below(5));
            let (i, j) = (i.min(4 - j) as f32 / 4.0, j as f32 / 4.0);
            let nudge = if case % 3 == 0 { 0.0 } else { 1.0 / 256.0 };
            let on = [0, 1, 2].each(|k| a[k] + (b[k] - a[k]) * i + (c[k] - a[k]) * j + nudge);
            let triangle = Triangle::new(a, b, c).unwrap();
            let Ok(ray) = Ray::new(o, [0, 1, 2].each(|k| on[k] - o[k])) else { continue };
            let cull = [Cull::Nothing, Cull::Back, Cull::Front][below(3) as usize];
            let rules = HitRules::new().culling(cull);
            let rules = if below(2) == 0 { rules } else { rules.once() };
            let expected = ray.hit_with(&triangle, rules);
            hits[kind] += u32::from(expected.is_some());
            let question = Crosses { ray: &ray, triangle: &triangle, rules };
            if let Some(hit) = question.in_multiples() {
                let bits = |hit: Option<Hit<f32>>| {
                    hit.map(|h| ([h.t, h.u, h.v].each(f32::to_bits), h.facing, h.feature))
                };
                assert_eq!(bits(hit), bits(expected), "{ray:?} {triangle:?}");
                said[kind] += u32::from(hit.is_some());
            }
        }
        assert!(hits.iter().all(|&hits| hits > 500), "{hits:?}");
        // The rest are contacts under the rule that counts a crossing once, and zeros.
        let are_most = said.iter().zip(hits).all(|(said, hits)| *said > hits / 4 * 3);
        assert!(are_most, "{said:?} of {hits:?}");
    }
}
