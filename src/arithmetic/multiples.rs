//! Floats as integer multiples of one power of two.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::float::{Float, bits, quotient};
use super::integer::Int64;
use super::number::{Number, greatest};
use super::parts::Bits;
use super::system::{Embeds, convert};
use super::wide::I256;
use super::window::Window;

/// Whether 60 bits hold all.
fn is_short(bits: Bits) -> bool {
    bits.width() <= 60
}

/// Floats as integer multiples of a power of two for which the greatest has 40 bits, if it divides
/// all of them. The result is the same at a fraction of the cost.
#[inline(always)]
pub(super) fn in_forty_bits<F: Float, const K: usize>(all: &[[F; 3]; K]) -> Option<[[i64; 3]; K]> {
    // Added to a short integer, it leaves the integer in the last bits.
    const SHIFTER: f64 = 1.5 * (1_u64 << 52) as f64;
    const TWO_TO_39: f64 = (1_u64 << 39) as f64;

    let largest: f64 =
        all.as_flattened().iter().fold(F::ZERO, |most, &x| greatest(most, x.magnitude())).into();
    if !<f64 as Number>::in_range(largest) {
        return None;
    }
    let unit = largest.power_of_two_below() / TWO_TO_39;
    let inverse = 1.0 / unit;
    let (mut whole, mut is_exact) = ([[0; 3]; K], true);
    for (to, &x) in whole.as_flattened_mut().iter_mut().zip(all.as_flattened()) {
        let x: f64 = x.into();
        let shifted = x * inverse + SHIFTER;
        *to = shifted.to_bits().wrapping_sub(SHIFTER.to_bits()) as i64;
        // Compared in the unit, because a small number times the inverse may be zero.
        is_exact &= (shifted - SHIFTER) * unit == x;
    }
    is_exact.then_some(whole)
}

/// Floats as integer multiples of one power of two, if 60 bits hold each. That covers grids,
/// and most scenes that were once in a coarser format. One is among them on request, or as a
/// coordinate, because the unit is the scene's and not the scalar's.
impl<F: Float, const LARGE: bool> Embeds<F> for Int64<LARGE> {
    type OfAreas = Window;

    fn holds<const K: usize>(coordinates: &[[F; 3]; K]) -> bool {
        is_short(bits(coordinates))
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[i64; 3]; K] {
        let Bits { low, .. } = bits(coordinates);
        convert(coordinates, 0, |x| x.parts().in_units(low))
    }

    fn embed<const K: usize>(coordinates: &[[F; 3]; K]) -> Option<[[i64; 3]; K]> {
        let bits = bits(coordinates);
        is_short(bits).then(|| convert(coordinates, 0, |x| x.parts().in_units(bits.low)))
    }

    fn embed_with_one<const K: usize>(coordinates: &[[F; 3]; K]) -> Option<([[i64; 3]; K], i128)> {
        let one = F::from(1).parts();
        let bits = bits(coordinates).with(one);
        let all = || convert(coordinates, 0, |x| x.parts().in_units(bits.low));
        is_short(bits).then(|| (all(), one.in_units(bits.low).into()))
    }

    const DIVIDES: bool = true;

    fn quotient_of_lengths(num: i64, den: i64) -> F {
        quotient(I256::from(i128::from(num)).limbs(), I256::from(i128::from(den)).limbs())
    }

    fn quotients([a, b, c]: [I256; 3], den: I256, _: [I256; 2]) -> ([F; 3], bool) {
        let of = |num: I256| quotient(num.limbs(), den.limbs());
        ([of(a), of(b), of(c)], true)
    }

    fn coordinate(num: BigInt<6>, den: BigInt<6>, _: [BigInt<6>; 2]) -> Option<F> {
        Some(quotient(num.sign_magnitude(), den.sign_magnitude()))
    }

    // Times are not in the scene's unit.
    fn compare_quotient(_: I256, _: I256, _: [I256; 2], _: F) -> Option<Ordering> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::in_forty_bits;

    fn are_short(x: [f64; 3]) -> bool {
        in_forty_bits(&[x]).is_some()
    }

    #[test]
    fn only_whole_multiples_of_forty_bits_are_short() {
        assert_eq!(in_forty_bits(&[[1.0_f32, -0.5, 0.0]]), Some([[1 << 39, -1 << 38, 0]]));
        let least = 2.0_f64.powi(-39);
        assert_eq!(in_forty_bits(&[[2.0 - least, -least, -0.0]]), Some([[(1 << 40) - 1, -1, 0]]));
        assert!(!are_short([1.0, 0.0, least / 2.0]) && !are_short([1.0, -1.5 * least, 0.0]));
        assert!(!are_short([2.0_f64.powi(300), f64::from_bits(1), 0.0]));
        // Zeros have no unit, and neither have numbers that may overflow or underflow.
        assert!(!are_short([0.0; 3]) && !are_short([f64::MAX, 0.0, 0.0]));
        assert!(!are_short([f64::MIN_POSITIVE, 0.0, 0.0]));
    }
}
