//! The axes of an oriented box: the check that they are orthonormal, and the box's extent along a
//! coordinate axis.

use super::{Ordinal, Scalar};
use crate::arithmetic::{Each, Number};
use crate::robust::ExactSum;

/// Operations for the construction and the bounding box of an oriented box.
pub(crate) trait Axes: Copy {
    /// Whether the axes are orthonormal: each dot product within one eighth of 0, or of 1. `None`
    /// if the type holds no axis of length one.
    fn are_orthonormal(axes: &[[Self; 3]; 3]) -> Option<bool>;

    /// c − r rounded down and c + r rounded up, with r = Σ|aᵢ|·hᵢ. Fixed point clamps to its range;
    /// floats return `None` on overflow.
    fn enclosed(center: Self, across: [Self; 3], half: [Self; 3]) -> Option<(Self, Self)>;
}

macro_rules! float {
    ($float:ident, $are_orthonormal:ident, |$c:ident, $across:ident, $half:ident| $enclosed:expr) => {
        /// Whether the axes are orthonormal, in the float's own arithmetic. The rounding of a dot
        /// product is far below an eighth; an overflow gives an infinity or a NaN, which fails the
        /// check.
        pub(crate) const fn $are_orthonormal(axes: &[[$float; 3]; 3]) -> Option<bool> {
            const fn is_near(a: &[$float; 3], b: &[$float; 3], target: $float) -> bool {
                let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                (dot - target).abs() <= 0.125
            }
            let [u, v, w] = axes;
            Some(
                is_near(u, u, 1.0)
                    && is_near(v, v, 1.0)
                    && is_near(w, w, 1.0)
                    && is_near(u, v, 0.0)
                    && is_near(v, w, 0.0)
                    && is_near(w, u, 0.0),
            )
        }

        impl Axes for $float {
            fn are_orthonormal(axes: &[[Self; 3]; 3]) -> Option<bool> {
                $are_orthonormal(axes)
            }

            fn enclosed($c: Self, $across: [Self; 3], $half: [Self; 3]) -> Option<(Self, Self)> {
                let (low, high): (Self, Self) = $enclosed;
                // Zero minus or plus a number is never −0.
                let (low, high) = (0.0 - low, 0.0 + high);
                (low.is_finite() && high.is_finite()).then_some((low, high))
            }
        }
    };
}
float!(f32, are_orthonormal_f32, |c, across, half| {
    faces_in_double(c.into(), across.each(f64::from), half.each(f64::from))
});
float!(f64, are_orthonormal_f64, |c, across, half| {
    let face = |c| face_exactly(c, across, half);
    (face(-c), face(c))
});

/// The next number above a finite one; infinity after the greatest.
fn next_up<S: Ordinal>(x: S) -> S {
    S::of_ordinal(x.ordinal() + 1)
}

/// Roundoffs of three sums, relative to the sum of all magnitudes. Proved in `axes.g`.
const SUMS: u16 = 8;

/// −c + r and c + r rounded up to `f32`, with r = Σ|aᵢ|·hᵢ; all inputs are numbers of `f32`. The
/// result comes from `f64`, unless its error leaves two candidates.
///
/// The products are exact in `f64`. If the three sums are exact too, so is the result. Otherwise
/// each sum errs by a relative 2⁻⁵³, its magnitude is at most |c| + r, and all three together err
/// by less than `margin`.
#[inline(never)] // QEMU before 8.0 multiplies two f32 widened for it wrongly on s390x (MDEBR).
fn faces_in_double(c: f64, across: [f64; 3], half: [f64; 3]) -> (f32, f32) {
    // A sum is exact if subtracting the greater operand returns the smaller operand.
    let sum = |(a, was_exact): (f64, bool), b: f64| {
        let s = a + b;
        let (greater, other) = if a.abs() < b.abs() { (b, a) } else { (a, b) };
        (s, was_exact & (s - greater == other))
    };
    let product = |a: f64, h: f64| a.abs() * h;
    let ([a, b, d], [h, k, l]) = (across, half);
    let extent = sum(sum((product(a, h), true), product(b, k)), product(d, l));
    let up = |x: f64| {
        let near = x as f32;
        if near.is_finite() && f64::from(near) < x { next_up(near) } else { near }
    };
    let face = |c: f64| {
        let (middle, is_exact) = sum(extent, c);
        if is_exact {
            return up(middle);
        }
        let margin = (c.abs() + extent.0).error(SUMS);
        let (least, greatest) = (up(middle - margin), up(middle + margin));
        if least == greatest {
            return greatest;
        }
        let short = |x: f64| x as f32;
        face_exactly(short(c), across.each(short), half.each(short))
    };
    (face(-c), face(c))
}

/// c + Σ|aᵢ|·hᵢ rounded up, by exact sums.
#[cold]
fn face_exactly<S>(c: S, across: [S; 3], half: [S; 3]) -> S
where
    S: Scalar + core::ops::Neg<Output = S>,
{
    let mut face = S::SeptumSum::new();
    face.add(&[c.parts(), S::ONE]);
    for (a, h) in across.into_iter().zip(half) {
        let mut a = a.parts();
        a.negative = false;
        face.add(&[a, h.parts()]);
    }
    let mut one = S::SeptumSum::new();
    one.add(&[S::ONE, S::ONE]);
    let is_below = |x: S| {
        let mut rest = face;
        rest.add(&[x.parts().negated(), S::ONE]);
        rest.sign() == core::cmp::Ordering::Greater
    };
    // The quotient is the nearest number or one of its neighbours.
    let mut x = S::quotient(&face, &one);
    while x.is_finite() && is_below(x) {
        x = next_up(x);
    }
    loop {
        let inward = -next_up(-x);
        if !x.is_finite() || is_below(inward) {
            return x;
        }
        x = inward;
    }
}

/// Whether the axes are orthonormal, in units of 2^-14, or of the type's last place if that is
/// coarser.
///
/// The caller has refused components above 9/8, so the sum of three products is below 2^30.
#[cfg(feature = "fixed")]
pub(crate) const fn are_orthonormal_fixed(axes: &[[i32; 3]; 3], fraction_bits: u32) -> bool {
    const fn is_near(a: &[i32; 3], b: &[i32; 3], target: i32, eighth: i32) -> bool {
        let off = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] - target;
        -eighth <= off && off <= eighth
    }
    let [u, v, w] = axes;
    let one = 1 << (2 * fraction_bits);
    // Rounded down: an integer is within one eighth if it is within this integer.
    let eighth = one >> 3;
    is_near(u, u, one, eighth)
        && is_near(v, v, one, eighth)
        && is_near(w, w, one, eighth)
        && is_near(u, v, 0, eighth)
        && is_near(v, w, 0, eighth)
        && is_near(w, u, 0, eighth)
}

/// The number of fraction bits that the check of axes keeps, at most.
#[cfg(feature = "fixed")]
pub(crate) const KEPT_BITS: u32 = 14;

/// The check of fixed-point axes, in a form that a `const fn` can use.
#[cfg(feature = "fixed")]
macro_rules! fixed_axes_are_orthonormal {
    ($fixed:ty, $axes:expr) => {{
        use $crate::scalar::axes::{KEPT_BITS, are_orthonormal_fixed};

        let fraction_bits = <$fixed>::FRAC_NBITS;
        let shift = fraction_bits.saturating_sub(KEPT_BITS);
        let unit = fraction_bits - shift;
        let one = 1_i32 << unit;
        let most = one + (one >> 3);
        let (axes, mut kept, mut are_short) = ($axes, [[0; 3]; 3], true);
        let mut k = 0;
        while k < 3 {
            let mut i = 0;
            while i < 3 {
                let x = axes[k][i].to_bits() as i64 >> shift;
                are_short &= -(most as i64) <= x && x <= most as i64;
                kept[k][i] = x as i32;
                i += 1;
            }
            k += 1;
        }
        if <$fixed>::INT_NBITS == 0 {
            None
        } else {
            Some(are_short && are_orthonormal_fixed(&kept, unit))
        }
    }};
}
#[cfg(feature = "fixed")]
pub(crate) use fixed_axes_are_orthonormal;

/// For each type, an unsigned word for the sum of three products of its raw magnitudes: 3·2^(2b−2)
/// is below 2^(2b).
#[cfg(feature = "fixed")]
macro_rules! fixed {
    ($($fixed:ident, $bound:ident, $sum:ident;)*) => {$(
        impl<Frac: fixed::types::extra::$bound> Axes for fixed::$fixed<Frac> {
            fn are_orthonormal(axes: &[[Self; 3]; 3]) -> Option<bool> {
                fixed_axes_are_orthonormal!(fixed::$fixed<Frac>, *axes)
            }

            fn enclosed(c: Self, across: [Self; 3], half: [Self; 3]) -> Option<(Self, Self)> {
                let product = |a: Self, h: Self| {
                    $sum::from(a.to_bits().unsigned_abs()) * $sum::from(h.to_bits().unsigned_abs())
                };
                let ([a, b, d], [h, k, l]) = (across, half);
                let sum = product(a, h) + product(b, k) + product(d, l);
                let whole = sum >> Self::FRAC_NBITS;
                let part = sum & (((1 as $sum) << Self::FRAC_NBITS) - 1);
                let extent = whole + $sum::from(part != 0);
                Some(match extent.try_into() {
                    Ok(extent) => (
                        Self::from_bits(c.to_bits().saturating_sub_unsigned(extent)),
                        Self::from_bits(c.to_bits().saturating_add_unsigned(extent)),
                    ),
                    Err(_) => (Self::MIN, Self::MAX),
                })
            }
        }
    )*};
}
#[cfg(feature = "fixed")]
fixed! {
    FixedI8, LeEqU8, u16;
    FixedI16, LeEqU16, u32;
    FixedI32, LeEqU32, u64;
    FixedI64, LeEqU64, u128;
}
