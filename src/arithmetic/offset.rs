//! Differences of coordinates in `f32`, for kernels in vectors, in every scalar.

#[cfg(feature = "fixed")]
use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
#[cfg(feature = "fixed")]
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

/// A scalar whose coordinates have differences in `f32`. In fixed point the unit of a difference is
/// the last place, and for 64 bits 2^24 of it, so that cubes of sizes are numbers of `f32`.
pub(crate) trait Offset: Copy {
    /// Whether the functions below are valid for all these coordinates.
    fn have_offsets<const K: usize>(points: &[[Self; 3]; K]) -> bool;

    /// The difference to another coordinate, rounded to the nearest; `f64` rounds twice. Rounding
    /// keeps order.
    fn offset(self, other: Self) -> f32;

    /// The sum of the differences to two coordinates, rounded like one; `f32` rounds both and their
    /// sum.
    fn offset_of_two(self, one: Self, other: Self) -> f32;

    /// Whether all are integer multiples of this power of two, or of its half. Numbers so great
    /// that they always are may count as if they were not.
    fn are_multiples<const K: usize>(points: &[[Self; 3]; K], unit: f32) -> bool;
}

impl Offset for f32 {
    #[inline(always)]
    fn have_offsets<const K: usize>(_: &[[f32; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn are_multiples<const K: usize>(points: &[[f32; 3]; K], unit: f32) -> bool {
        // 1.5·2^k units, with k the digits after the first: adding it rounds to units.
        let shifter = unit * (3 << (f32::MANTISSA_DIGITS - 2)) as f32;
        points.as_flattened().iter().all(|x| (x + shifter) - shifter == *x)
    }
    #[inline(always)]
    fn offset(self, other: f32) -> f32 {
        self - other
    }
    #[inline(always)]
    fn offset_of_two(self, one: f32, other: f32) -> f32 {
        (self - one) + (self - other)
    }
}

// Beyond the greatest `f32` they are infinite.
impl Offset for f64 {
    #[inline(always)]
    fn have_offsets<const K: usize>(_: &[[f64; 3]; K]) -> bool {
        true
    }
    #[inline(always)]
    fn are_multiples<const K: usize>(points: &[[f64; 3]; K], unit: f32) -> bool {
        let shifter = f64::from(unit) * (3_u64 << (f64::MANTISSA_DIGITS - 2)) as f64;
        points.as_flattened().iter().all(|x| (x + shifter) - shifter == *x)
    }
    #[inline(always)]
    fn offset(self, other: f64) -> f32 {
        (self - other) as f32
    }
    #[inline(always)]
    fn offset_of_two(self, one: f64, other: f64) -> f32 {
        ((self - one) + (self - other)) as f32
    }
}

/// From the raw bits, in a word with this number of bits, for coordinates below the limit; and the
/// number of last places in a unit.
#[cfg(feature = "fixed")]
macro_rules! by_raw_bits {
    ($($fixed:ident, $bound:ident: $word:ident, $limit:expr, $units:expr,
       |$x:ident| $in_float:expr;)*) => {$(
        impl<Frac: $bound> Offset for $fixed<Frac> {
            // One comparison for all: if x is outside, x + limit is below zero or has a high bit.
            #[inline(always)]
            fn have_offsets<const K: usize>(points: &[[Self; 3]; K]) -> bool {
                let limit: Option<$word> = $limit;
                let Some(limit) = limit else { return true };
                let bits = |x: &Self| $word::from(x.to_bits()).wrapping_add(limit);
                points.as_flattened().iter().fold(0, |all, x| all | bits(x)) & !(2 * limit - 1) == 0
            }
            #[inline(always)]
            fn are_multiples<const K: usize>(points: &[[Self; 3]; K], unit: f32) -> bool {
                let below = ((unit * $units) as $word - 1).max(0);
                points.as_flattened().iter().fold(0, |all, x| all | $word::from(x.to_bits())) & below == 0
            }
            #[inline(always)]
            fn offset(self, other: Self) -> f32 {
                let bits = |x: Self| $word::from(x.to_bits());
                let $x = bits(self).wrapping_sub(bits(other));
                $in_float
            }
            #[inline(always)]
            fn offset_of_two(self, one: Self, other: Self) -> f32 {
                let bits = |x: Self| $word::from(x.to_bits());
                let (x, one, other) = (bits(self), bits(one), bits(other));
                let $x = x.wrapping_sub(one).wrapping_add(x.wrapping_sub(other));
                $in_float
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
by_raw_bits! {
    FixedI8, LeEqU8: i32, None, 1.0, |x| x as f32;
    FixedI16, LeEqU16: i32, None, 1.0, |x| x as f32;
    FixedI32, LeEqU32: i32, Some(1 << 29), 1.0, |x| x as f32;
    // Below 2^51, adding two numbers converts a whole vector to `f64`; the processor's conversion
    // takes one number at a time.
    FixedI64, LeEqU64: i64, Some(1 << 49), (1_u32 << 24) as f32, |x| in_double(x) as f32;
}

/// A number below 2^51 in magnitude, divided by 2^24.
#[cfg(feature = "fixed")]
#[inline(always)]
fn in_double(x: i64) -> f64 {
    // 1.5·2^52 over 2^24: the last place is 2^-24.
    const SHIFTER: f64 = (3_u64 << (51 - 24)) as f64;
    f64::from_bits(SHIFTER.to_bits().wrapping_add(x as u64)) - SHIFTER
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use fixed::types::{I8F8, I16F16, I32F32};

    use super::Offset;

    /// Coordinates at both ends of the valid range, where the next number is outside, and near
    /// zero.
    fn check<S: Offset>(bits: u32, units: f32, from_bits: fn(i64) -> S) {
        let end = 1_i64 << (bits - 1);
        let held = |x: i64| S::have_offsets(&[[from_bits(0), from_bits(x), from_bits(0)]]);
        assert!(held(end - 1) && held(-end) && !held(end) && !held(-end - 1));
        let numbers = [-end, 1 - end, -1, 0, 1, 3, 0x2_aaaa, end / 3, end - 1];
        for a in numbers {
            for b in numbers {
                assert_eq!(from_bits(a).offset(from_bits(b)) * units, (a - b) as f32);
                for c in numbers {
                    let (twice, whole) = (from_bits(a), (2 * a - b - c) as f32);
                    assert_eq!(twice.offset_of_two(from_bits(b), from_bits(c)) * units, whole);
                }
            }
        }
    }

    #[test]
    fn offsets_are_the_nearest_up_to_their_limit() {
        check(30, 1.0, |x| I16F16::from_bits(x as i32));
        check(50, 16_777_216.0, I32F32::from_bits);
        let end = [I8F8::MIN, I8F8::MAX, I8F8::ZERO];
        assert!(I8F8::have_offsets(&[end]));
        assert_eq!(I8F8::MAX.offset_of_two(I8F8::MIN, I8F8::MIN), 131_070.0);
        assert_eq!(1e300_f64.offset(0.0), f32::INFINITY);
    }

    #[test]
    fn multiples_are_told_from_others() {
        for unit in [1.0, 2.0, 64.0, 1024.0] {
            let held = |x: i64| {
                let float = (x as f64 / 4.0) as f32;
                assert_eq!(
                    f32::are_multiples(&[[0.0, 0.0, float]], unit / 4.0),
                    f64::are_multiples(&[[f64::from(float), 0.0, 0.0]], unit / 4.0)
                );
                let short = f32::are_multiples(&[[float; 3]], unit / 4.0);
                assert_eq!(I16F16::are_multiples(&[[I16F16::from_bits(x as i32); 3]], unit), short);
                let long = I32F32::from_bits(x);
                assert_eq!(I32F32::are_multiples(&[[long; 3]], unit / 16_777_216.0), short);
                short
            };
            for x in -3000..3000 {
                assert_eq!(held(x), x % unit as i64 == 0, "{x} {unit}");
            }
        }
        // Far from zero, where a unit is less than the last place.
        assert!(f64::are_multiples(&[[1e30; 3]], 1.0));
        assert!(!f64::are_multiples(&[[1e12 + 0.5; 3]], 1.0));
    }
}
