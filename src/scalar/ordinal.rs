//! The numbers of a scalar in their order.

#[cfg(feature = "fixed")]
use crate::arithmetic::{Each, InRaw, Word};

/// A number for each value of a scalar, adjacent values numbered adjacently. Sealed, as
/// [`Backend`](super::Backend).
pub(crate) trait Ordinal: Copy {
    /// The number of a finite value. Both zeros are number zero.
    fn ordinal(self) -> i64;

    /// The value of a number; beyond the greatest float there is infinity.
    fn of_ordinal(n: i64) -> Self;

    /// The number between `from` and `to` that is as far from `from`, as a part of the distance, as
    /// x is on the way from a to b. Fixed point rounds it toward `from`. Floats compute `from + (to
    /// − from)·((x − a)/(b − a))` in `f64`, from halves of all numbers if a difference overflows.
    fn between(from: Self, to: Self, way: [Self; 3]) -> Self;

    /// The number that is a part `t` of the way from `from` to `to`, rounded likewise. Parts below
    /// zero and NaN count as zero, parts above one as one.
    fn at_time(from: Self, to: Self, t: Self) -> Self;
}

/// `from` + (`to` − `from`)·(x − a)/(b − a), no farther than `to`; x is between a and b.
fn blend(from: f64, to: f64, [a, x, b]: [f64; 3]) -> f64 {
    if from == to {
        return from;
    }
    let (length, whole) = (to - from, b - a);
    let y = if length.is_finite() && whole.is_finite() {
        from + length * ((x - a) / whole)
    } else {
        let [p, q, a, x, b] = [from, to, a, x, b].map(|x| x * 0.5);
        (p + (q - p) * ((x - a) / (b - a))) * 2.0
    };
    let (low, high) = if from < to { (from, to) } else { (to, from) };
    if y < low {
        low
    } else if y > high {
        high
    } else {
        y
    }
}

macro_rules! float {
    ($float:ident, $signed:ident) => {
        impl Ordinal for $float {
            #[inline]
            fn ordinal(self) -> i64 {
                let bits = self.to_bits() as $signed;
                let size = i64::from(bits & $signed::MAX);
                if bits < 0 { -size } else { size }
            }
            #[inline]
            fn of_ordinal(n: i64) -> Self {
                let size = Self::from_bits(n.unsigned_abs() as _);
                if n < 0 { -size } else { size }
            }
            fn between(from: Self, to: Self, way: [Self; 3]) -> Self {
                blend(from.into(), to.into(), way.map(f64::from)) as Self
            }
            fn at_time(from: Self, to: Self, t: Self) -> Self {
                if t > 0.0 { Self::between(from, to, [0.0, t, 1.0]) } else { from }
            }
        }
    };
}
float!(f32, i32);
float!(f64, i64);

/// In raw bits.
#[cfg(feature = "fixed")]
impl<S: InRaw> Ordinal for S {
    #[inline]
    fn ordinal(self) -> i64 {
        self.raw().into()
    }
    #[inline]
    fn of_ordinal(n: i64) -> Self {
        Self::from_raw(n)
    }
    fn between(from: Self, to: Self, way: [Self; 3]) -> Self {
        let [a, x, b] = way.each(Self::ordinal);
        let (part, whole) = (x.abs_diff(a), b.abs_diff(a));
        if S::Raw::BITS <= 32 {
            moved(from, to, |length| (length * part).checked_div(whole))
        } else {
            let wide = |length: u64| u128::from(length) * u128::from(part);
            moved(from, to, |length| {
                Some(wide(length).checked_div(whole.into())?.try_into().unwrap_or(u64::MAX))
            })
        }
    }
    fn at_time(from: Self, to: Self, t: Self) -> Self {
        let part = u64::try_from(t.ordinal()).unwrap_or(0);
        if S::Raw::BITS <= 32 {
            moved(from, to, |length| Some((length * part) >> S::FRACTION_BITS))
        } else {
            let wide = |length: u64| (u128::from(length) * u128::from(part)) >> S::FRACTION_BITS;
            moved(from, to, |length| Some(wide(length).try_into().unwrap_or(u64::MAX)))
        }
    }
}

/// Moves from one number toward another by `of` their distance, but no farther; not at all without
/// a distance.
#[cfg(feature = "fixed")]
#[inline(always)]
fn moved<S: InRaw>(from: S, to: S, of: impl Fn(u64) -> Option<u64>) -> S {
    let (a, b) = (from.ordinal(), to.ordinal());
    let length = b.abs_diff(a);
    let part = of(length).unwrap_or(0).min(length) as i64;
    // Modulo 2^64: the sum fits.
    S::from_raw(if b < a { a.wrapping_sub(part) } else { a.wrapping_add(part) })
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use crate::arithmetic::Each;
    use dashu_int::IBig;
    use fixed::types::{I4F4, I16F16, I32F32};

    use super::{InRaw, Ordinal};

    /// Moves at both ends of a type and near zero, against integers of any size.
    fn check<S: InRaw>() {
        let (least, most) = (-S::GREATEST - 1, S::GREATEST);
        let all = [least, least + 1, -5, 0, 1, 7, most / 3, most - 1, most];
        let is_held = |raw: i128| S::held(raw).is_some();
        assert!(is_held(most.into()) && !is_held(i128::from(most) + 1));
        assert!(is_held(least.into()) && !is_held(i128::from(least) - 1));
        let big = |x: i64| IBig::from(x);
        for (from, to) in all.into_iter().flat_map(|from| all.map(|to| (from, to))) {
            let length = if to < from { big(from) - big(to) } else { big(to) - big(from) };
            let moved = |part: IBig| {
                let part = if part > length { length.clone() } else { part };
                if to < from { big(from) - part } else { big(from) + part }
            };
            let [p, q] = [from, to].each(S::from_raw);
            for t in all {
                let found = S::at_time(p, q, S::from_raw(t)).ordinal();
                let part = (&length * big(t.max(0))) >> S::FRACTION_BITS as usize;
                assert_eq!(big(found), moved(part), "{from} {to} {t}");
                for (a, b) in [(least, most), (most, least), (least, 0), (7, -5), (t, t)] {
                    if (a.min(b)..=a.max(b)).contains(&t) {
                        let found = S::between(p, q, [a, t, b].each(S::from_raw)).ordinal();
                        let (part, whole) = (big(t) - big(a), big(b) - big(a));
                        let part = if a == b { IBig::ZERO } else { &length * part / whole };
                        assert_eq!(big(found), moved(part), "{from} {to} {a} {t} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn moves_are_those_of_integers_of_any_size() {
        check::<I4F4>();
        check::<I16F16>();
        check::<I32F32>();
    }
}
