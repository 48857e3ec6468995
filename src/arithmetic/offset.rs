//! Differences of coordinates in `f32`, for kernels in vectors, in every scalar.

use super::words::{InRaw, RawOffset, Word};

/// A scalar whose coordinates have differences in `f32`. In fixed point the unit of a difference is
/// the last place, and for 64 bits 2^24 of it, so that cubes of sizes are numbers of `f32`.
pub(crate) trait Offset: Copy {
    /// Whether the functions below are valid for all these coordinates.
    fn have_offsets<const K: usize>(points: &[[Self; 3]; K]) -> bool;

    /// The same for offsets to zero alone.
    #[inline(always)]
    fn have_offsets_to_zero<const K: usize>(points: &[[Self; 3]; K]) -> bool {
        Self::have_offsets(points)
    }

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

/// From the raw bits, in words that wrap, for coordinates below the limit.
impl<S: InRaw> Offset for S {
    // One comparison for all: if x is outside, x + limit is below zero or has a high bit.
    #[inline(always)]
    fn have_offsets<const K: usize>(points: &[[S; 3]; K]) -> bool {
        let (limit, zero) = (S::Raw::OFFSET_LIMIT, S::Raw::ZERO);
        let bits = |x: &S| x.raw().plus(limit);
        let all = || points.as_flattened().iter().fold(zero, |all, x| all | bits(x));
        S::ALWAYS_NEAR || all() & S::Raw::OUTSIDE == zero
    }
    // Words of 32 bits need no difference that might overflow.
    #[inline(always)]
    fn have_offsets_to_zero<const K: usize>(points: &[[S; 3]; K]) -> bool {
        S::Raw::BITS <= 32 || Self::have_offsets(points)
    }
    #[inline(always)]
    fn are_multiples<const K: usize>(points: &[[S; 3]; K], unit: f32) -> bool {
        let below = S::Raw::below_unit(unit);
        points.as_flattened().iter().fold(S::Raw::ZERO, |all, x| all | x.raw()) & below
            == S::Raw::ZERO
    }
    #[inline(always)]
    fn offset(self, other: S) -> f32 {
        self.raw().minus(other.raw()).in_offset()
    }
    #[inline(always)]
    fn offset_of_two(self, one: S, other: S) -> f32 {
        let (x, one, other) = (self.raw(), one.raw(), other.raw());
        x.minus(one).plus(x.minus(other)).in_offset()
    }
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
