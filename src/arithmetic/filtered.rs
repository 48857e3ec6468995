//! Floats with a bound on their error.

use core::cmp::Ordering;

use super::ends::{enclosed, enclosed_on_line};
use super::float::Float;
use super::multiples::in_forty_bits;
use super::platform::REGISTERS_ARE_WIDE;
use super::quad::{OfFour, Quad};
use super::system::{Embeds, Factor, OneType, convert};

type Row = <f64 as OfFour>::Quad;

/// The number system of a float type with a bound on its error. It answers only if the result
/// exceeds the bound.
pub type Filtered<F> = OneType<F>;

impl<F: Float> Factor for F {
    const CERTAIN: bool = false;

    #[inline(always)]
    fn in_forty_bits<const K: usize>(coordinates: &[[F; 3]; K]) -> Option<[[i64; 3]; K]> {
        in_forty_bits(coordinates)
    }
}

/// The factor by which the gap between a numerator and a product must exceed their errors, to cover
/// its own roundings. `filtered.g` proves it.
const CLEARANCE: u16 = 2;

/// How the quotient of two numbers with errors compares with `t`.
#[inline(always)]
pub(super) fn compare_quotient<F: Float>(
    num: F,
    den: F,
    [num_error, den_error]: [F; 2],
    t: F,
    infinity: F,
) -> Option<Ordering> {
    let product = t * den;
    let clearance = F::from(CLEARANCE);
    let error = clearance * (num_error + t.magnitude() * den_error)
        + clearance * F::ROUNDOFF * product.magnitude();
    let gap = num - product;
    if gap.magnitude() > error && product.magnitude() < infinity {
        return gap.partial_cmp(&F::ZERO);
    }
    if !REGISTERS_ARE_WIDE {
        // Small cores save the code.
        return None;
    }
    // The least that the product may be is beyond the type, as with the greatest number for t. But for
    // three roundings it is so in truth, and a numerator of at most half the greatest number is less.
    let least = t.magnitude() * (den.magnitude() - clearance * den_error);
    let is_beyond = least == infinity && clearance * (num.magnitude() + num_error) < infinity;
    if is_beyond { F::ZERO.partial_cmp(&product) } else { None }
}

macro_rules! embeds {
    ($from:ty => $to:ty, $divides:literal, $clear:expr, |$num:ident, $den:ident| $quotients:expr
     $(, |$row:ident, $errors:ident| $of_row:expr)?
     $(, nearest: |$between:ident| $nearest:expr)?) => {
        impl Embeds<$from> for Filtered<$to> {
            type OfAreas = Self;

            const DIVIDES: bool = $divides;
            const HAS_QUOTIENTS: bool = {
                let clear: Option<$to> = $clear;
                clear.is_some()
            };

            #[inline(always)]
            fn holds<const K: usize>(_: &[[$from; 3]; K]) -> bool {
                true
            }
            #[inline(always)]
            fn embed_held<const K: usize>(coordinates: &[[$from; 3]; K]) -> [[$to; 3]; K] {
                convert(coordinates, 0.0, |x| x.into())
            }
            fn one() -> Option<$to> {
                Some(1.0)
            }
            fn times_one(d: $to, _: $to) -> $to {
                d
            }
            #[inline(always)]
            fn quotient_of_lengths(num: $to, den: $to) -> $from {
                (num / den) as $from
            }
            #[inline(always)]
            fn quotients(
                $num: [$to; 3],
                $den: $to,
                [error, other]: [$to; 2],
            ) -> ([$from; 3], bool) {
                let clear: Option<$to> = $clear;
                let is_clear = |value: $to, error: $to| {
                    clear.is_some_and(|clear| value.abs() >= clear * error)
                };
                let are_clear = is_clear($num[0], error)
                    & is_clear($num[1], other)
                    & is_clear($num[2], other)
                    & is_clear($den, other);
                ($quotients, are_clear)
            }
            $(#[inline(always)]
            fn nearest($between: [$to; 2]) -> Option<$from> {
                $nearest
            })?
            $(#[inline(always)]
            fn quotients_of_row($row: [$to; 4], $errors: [$to; 2]) -> ([$from; 3], bool) {
                $of_row
            })?
            #[inline(always)]
            fn coordinate(num: $to, den: $to, errors: [$to; 2]) -> Option<$from> {
                Self::nearest(enclosed(num, den, errors)?)
            }
            #[inline(always)]
            fn on_line(
                a: &[$to; 3],
                v: &[$to; 3],
                num: $to,
                den: $to,
                errors: ($to, $to, $to),
            ) -> Option<[$from; 3]> {
                let [x, y, z] = enclosed_on_line(a, v, num, den, errors)?;
                // A line across an axis has the coordinate of `a`, and an exact zero no sign.
                let given = |i: usize| v[i] == 0.0 && errors.0 == 0.0;
                let at = |i: usize, ends| {
                    Self::nearest(ends).or_else(|| given(i).then(|| a[i] as $from + 0.0))
                };
                Some([at(0, x)?, at(1, y)?, at(2, z)?])
            }
            #[inline(always)]
            fn compare_quotient(
                num: $to,
                den: $to,
                errors: [$to; 2],
                t: $from,
            ) -> Option<Ordering> {
                compare_quotient::<$to>(num, den, errors, t.into(), <$to>::INFINITY)
            }
        }
    };
}
// An `f32` quotient computed in `f32` would be too inaccurate.
embeds! { f32 => f32, false, None, |_num, _den| [0.0; 3] }
const CLEAR: f64 = 33_554_432.0;

/// The same for `f32`, with the divisor first.
#[inline(always)]
fn quotients_of_row(row @ [den, ..]: [f64; 4], [error, other]: [f64; 2]) -> ([f32; 3], bool) {
    let row = Row::new(row);
    let limits = Row::new([other, error, other, other]) * Row::splat(CLEAR);
    let [_, t, u, v] = (row / Row::splat(den)).to_array();
    ([t as f32, u as f32, v as f32], limits.exceeds(row.magnitude()) == 0)
}

/// The `f32` to which all numbers between these two round.
#[inline(always)]
fn nearest([low, high]: [f64; 2]) -> Option<f32> {
    let (nearest, last) = (low as f32, high as f32);
    let is_normal = (nearest.abs() > f32::MIN_POSITIVE) & (nearest.abs() < f32::MAX);
    (is_normal & (nearest == last)).then_some(nearest)
}

// Both numbers are within 2^-25 of themselves: with the last rounding less than 2 ulp.
embeds! { f32 => f64, true, Some(CLEAR), |num, den| {
    [(num[0] / den) as f32, (num[1] / den) as f32, (num[2] / den) as f32]
}, |row, errors| quotients_of_row(row, errors), nearest: |between| nearest(between) }
// They are never both within 2^-53; more accurate numbers are computed only for hits.
embeds! { f64 => f64, true, None, |_num, _den| [0.0; 3], nearest: |between| {
    let [low, high] = between;
    let is_normal = (low.abs() > f64::MIN_POSITIVE) & (low.abs() < f64::MAX);
    (is_normal & (low == high)).then_some(low)
} }

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_beyond_every_quotient_are_certain() {
        if !REGISTERS_ARE_WIDE {
            return;
        }
        let compare =
            |num, den, errors, t| compare_quotient::<f64>(num, den, errors, t, f64::INFINITY);
        for t in [f64::MAX, 1e300, -f64::MAX] {
            for den in [3e9, -3e9] {
                let expected =
                    (t * den < 0.0).then_some(Ordering::Greater).or(Some(Ordering::Less));
                for num in [0.0, 7.5, -7.5, 1e300] {
                    assert_eq!(compare(num, den, [1.0; 2], t), expected, "{num} {den} {t}");
                }
            }
        }
        // The divisor may be small or zero, and the numerator beyond.
        assert_eq!(compare(7.5, 3e9, [1.0, 3e9], f64::MAX), None);
        assert_eq!(compare(f64::MAX, 3e9, [1.0; 2], f64::MAX), None);
    }
}
