//! The numbers of a scalar in their order.

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

/// Moves from one number toward another by `of` their distance, but no farther.
#[cfg(feature = "fixed")]
macro_rules! moved {
    ($fixed:ident, $raw:ident, $wide:ident, $from:expr, $to:expr, $of:expr) => {{
        let (from, to) = ($from.to_bits(), $to.to_bits());
        let length = $wide::from(to.abs_diff(from));
        // Modulo 2^bits: the sum fits.
        let part = ($of)(length).min(length) as $raw;
        fixed::$fixed::from_bits(if to < from {
            from.wrapping_sub(part)
        } else {
            from.wrapping_add(part)
        })
    }};
}

/// $wide holds the product of two distances.
#[cfg(feature = "fixed")]
macro_rules! fixed {
    ($($fixed:ident, $bound:ident, $raw:ident, $wide:ident;)*) => {$(
        impl<Frac: fixed::types::extra::$bound> Ordinal for fixed::$fixed<Frac> {
            #[inline]
            fn ordinal(self) -> i64 {
                self.to_bits().into()
            }
            #[inline]
            fn of_ordinal(n: i64) -> Self {
                Self::from_bits(n as _)
            }
            fn between(from: Self, to: Self, way: [Self; 3]) -> Self {
                let [a, x, b] = way.map(Self::to_bits);
                let (part, whole) = ($wide::from(x.abs_diff(a)), $wide::from(b.abs_diff(a)));
                let of = |length: $wide| (length * part).checked_div(whole).unwrap_or(0);
                moved!($fixed, $raw, $wide, from, to, of)
            }
            fn at_time(from: Self, to: Self, t: Self) -> Self {
                let part = $wide::try_from(t.to_bits()).unwrap_or(0);
                moved!($fixed, $raw, $wide, from, to, |length| (length * part) >> Self::FRAC_NBITS)
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
fixed! {
    FixedI8, LeEqU8, i8, u64;
    FixedI16, LeEqU16, i16, u64;
    FixedI32, LeEqU32, i32, u64;
    FixedI64, LeEqU64, i64, u128;
}
