//! Cosine and sine of a part of a turn, by the same few operations on every machine.
//!
//! An angle is counted in turns, so subtracting the nearest quarter is exact and leaves at most an
//! eighth. There it becomes y = 2π·r, |y| ≤ π/4. The Taylor series of sine and cosine are summed
//! from their ends in z = y² ≤ 0.617.
//!
//! # Error, of integers
//!
//! In units of 2^-B, B being 30 or 62. Products and coefficients are off by 1/2. π/2 is off by
//! 0.39, and |r| is at most half of 2^B in units of a quarter: y is off by 0.70, and z by
//! 2·0.786·0.70 + 0.5 = 1.60. A partial sum c + z·h, with h off by e, is off by
//! 1/2 + 1/2 + 0.617·e + 1.60·|h|:
//!
//! * far from the beginning h is small, and that is at most 1/(1 − 0.617) = 2.62;
//! * the second of the sine, |h| ≤ 1/120: 1 + 0.617·2.62 + 0.01 = 2.63; the first, |h| ≤ 1/6, with
//!   an exact coefficient: 1/2 + 0.617·2.63 + 0.27 = 2.40; times y: 1/2 + 0.786·2.40 + 0.70 = 3.09;
//! * the second of the cosine, |h| ≤ 1/24: 1 + 0.617·2.62 + 0.07 = 2.69; the first, |h| ≤ 1/2:
//!   1/2 + 0.617·2.69 + 0.80 = 2.96.
//!
//! The first term of the series that is left out is below 0.13 units in the cosine of 30 bits,
//! and below 0.02 elsewhere. Both are within 4 units.
//!
//! # Error, of `f64`
//!
//! In units of u = 2^-53: 2π is off by 0.36 of itself, the product by 1, so y is off by 1.07;
//! z by 2·0.786·1.07 + 0.62 = 2.31. The sum z·h of the sine, |h| ≤ 1/6, is off by
//! 0.103 + 0.617·0.42 + 2.31/6, and with the 1 by 1 more: 1.75; times y: 0.71 + 0.786·1.75 +
//! 1.07 = 3.16. That of the cosine, |h| ≤ 1/2: 0.31 + 0.617·1.3 + 2.31/2 + 1 = 3.27. (h, the
//! sum before, is off by its own rounding, by that of its coefficient, and by less than a quarter
//! of itself more: 2.5/6 and 2.5/2.) Both are within 4u.

/// The last terms of the sums are y^(2·`TERMS` − 1) and y^(2·`TERMS` − 2).
#[cfg(feature = "fixed")]
macro_rules! cos_sin {
    ($(#[$doc:meta])* $cos_sin:ident, $raw:ident, $turn:ident, $wide:ident, $bits:literal,
     $half_pi:literal, $terms:literal) => {
        $(#[$doc])*
        pub(crate) fn $cos_sin(turn: $turn) -> ($raw, $raw) {
            const ONE: $raw = 1 << $bits;
            /// 1/n!, to the nearest.
            const fn over_factorial(n: $wide) -> $raw {
                let (mut factorial, mut k): ($wide, $wide) = (1, 2);
                while k <= n {
                    factorial *= k;
                    k += 1;
                }
                (((2 << $bits) / factorial + 1) / 2) as $raw
            }
            /// The coefficients of y^first, y^(first + 2) and so on.
            const fn series(first: usize) -> [$raw; $terms] {
                let (mut series, mut k) = ([0; $terms], 0);
                while k < $terms {
                    let term = over_factorial((2 * k + first) as $wide);
                    series[k] = if k % 2 == 0 { term } else { -term };
                    k += 1;
                }
                series
            }
            const COSINE: [$raw; $terms] = series(0);
            const SINE: [$raw; $terms] = series(1);

            let times = |a: $raw, b: $raw| {
                (($wide::from(a) * $wide::from(b) + (1 << ($bits - 1))) >> $bits) as $raw
            };
            let quarters = turn.wrapping_add(1 << ($bits - 1)) >> $bits;
            let rest = turn.wrapping_sub(quarters << $bits) as $raw;
            let y = times(rest, $half_pi);
            let z = times(y, y);
            let sum = |series: &[$raw; $terms]| {
                series.iter().rev().fold(0, |sum: $raw, &term| times(sum, z) + term)
            };
            let (cos, sin) = (sum(&COSINE), times(sum(&SINE), y));
            // Only rounding can exceed one.
            let (cos, sin) = (cos.clamp(-ONE, ONE), sin.clamp(-ONE, ONE));
            turned(cos, sin, quarters as u32)
        }
    };
}
#[cfg(feature = "fixed")]
cos_sin!(
    /// Cosine and sine of `turn`/2^32 turns, times 2^30, each within 4.
    cos_sin_30, i32, u32, i64, 30, 1_686_629_713, 6
);
#[cfg(feature = "fixed")]
cos_sin!(
    /// Cosine and sine of `turn`/2^64 turns, times 2^62, each within 4.
    cos_sin_62, i64, u64, i128, 62, 7_244_019_458_077_122_842, 10
);

/// Cosine and sine of a finite number of turns, each within 4·2^-53.
#[inline(never)] // On s390x: see `axes::faces_in_double`.
pub(crate) fn cos_sin_f64(turns: f64) -> (f64, f64) {
    /// 1/n!, with the sign of the series' term.
    const fn term(n: u32) -> f64 {
        let (mut factorial, mut k) = (1_u64, 2);
        while k <= n {
            factorial *= k as u64;
            k += 1;
        }
        // 19! is a float.
        let term = 1.0 / factorial as f64;
        if n % 4 < 2 { term } else { -term }
    }
    /// The coefficients of y^first, y^(first + 2) and so on.
    const fn series(first: u32) -> [f64; 10] {
        let (mut series, mut k) = ([0.0; 10], 0);
        while k < 10 {
            series[k] = term(2 * k as u32 + first);
            k += 1;
        }
        series
    }
    const COSINE: [f64; 10] = series(0);
    const SINE: [f64; 10] = series(1);

    // All of this is exact. Beyond 2^52 a float is an integer.
    let part = if turns.abs() < (1_i64 << 52) as f64 { turns - (turns as i64) as f64 } else { 0.0 };
    let quarters = (4.0 * part + if part < 0.0 { -0.5 } else { 0.5 }) as i32;
    let rest = part - f64::from(quarters) * 0.25;

    let y = rest * core::f64::consts::TAU;
    let z = y * y;
    let sum = |series: &[f64; 10]| series.iter().rev().fold(0.0, |sum, &term| sum * z + term);
    turned(sum(&COSINE), sum(&SINE) * y, quarters as u32)
}

/// (cos, sin), rotated by this number of quarters.
fn turned<T: Copy + core::ops::Neg<Output = T>>(cos: T, sin: T, quarters: u32) -> (T, T) {
    match quarters % 4 {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::{cos_sin_30, cos_sin_62, cos_sin_f64};

    /// Each against the next more accurate one, within the bounds above and the error of that one:
    /// 3.09 and 3.27 units.
    #[test]
    fn no_error_exceeds_its_bound() {
        let (mut most_30, mut most_f64) = (0.0_f64, 0.0_f64);
        for k in 0..400_000_u64 {
            let turn = (k * 10_737 + k % 3) as u32;
            let truth = cos_sin_62(u64::from(turn) << 32);
            let found = cos_sin_30(turn);
            // A power of two times a number that `f64` holds.
            let float = cos_sin_f64(f64::from(turn) / 2_f64.powi(32));
            for (found, float, truth) in [(found.0, float.0, truth.0), (found.1, float.1, truth.1)]
            {
                let off = ((i64::from(found) << 32) - truth) as f64 / 2_f64.powi(32);
                most_30 = most_30.max(off.abs());
                let float = (float * 2_f64.powi(62)) as i64;
                most_f64 = most_f64.max((float - truth) as f64 / 2_f64.powi(9));
            }
        }
        assert!(most_30 <= 3.1 && most_30 > 1.0, "{most_30}");
        assert!(most_f64 <= 3.3 && most_f64 > 0.5, "{most_f64}");
    }
}
