//! Exact integers for coordinates that span up to 120 bits.

use core::cmp::Ordering;

use super::big_int::BigInt;
use super::float::{Float, quotient};
use super::limbs_of_areas::Limbs4;
use super::multiples::bits;
use super::system::{Arithmetic, Embeds, convert};

/// Exact integers for coordinates within 120 bits: lengths in 2 limbs, areas in 4, volumes in 6,
/// products of four in 8, of six in 12.
///
/// It holds fixed point of every type. It holds floats if the highest and the lowest bit of all
/// coordinates are at most 120 places apart, as in nearly every scene. The unit of floats is the
/// place of the lowest bit, so each call of [`embed`](Embeds::embed) has its own: embed all
/// coordinates of a question in one call. One as an operand,
/// [`embed_with_one`](Embeds::embed_with_one), is in the same unit; without it, axes of an oriented
/// box cannot be compared with lengths.
///
/// With coordinates below 2^120 the table in `integer` gives frames below 2^122, areas below
/// 2^245, volumes below 2^368 and, for oriented boxes, sums of 30 products of four below 2^489.
/// Without the frame, squares of volumes are below 2^732.
#[derive(Clone, Copy, Debug)]
pub struct Window;

/// The number of bits for the coordinates of a [`Window`].
const BITS: i32 = 120;

impl Arithmetic for Window {
    type Length = i128;
    type Area = BigInt<4>;
    type Volume = BigInt<6>;
    type Quartic = BigInt<8>;
    type Sextic = BigInt<12>;
    type Product = BigInt<8>;
    type Narrow = Self;

    const CERTAIN: bool = true;
    const LARGE: bool = true;
    const DOUBLED: bool = true;
    const CORNER_FORM_ONLY: bool = true;

    // Products are out of line, so that all kernels share one copy of each.
    #[inline(never)]
    fn area(a: i128, b: i128) -> BigInt<4> {
        BigInt::<2>::from(a).times(&BigInt::<2>::from(b))
    }
    #[inline(never)]
    fn volume(a: BigInt<4>, b: i128) -> BigInt<6> {
        a.times(&BigInt::<2>::from(b))
    }
    #[inline(never)]
    fn minor([a, b]: [i128; 2], [c, d]: [i128; 2]) -> BigInt<4> {
        Self::area(a, b) - Self::area(c, d)
    }
    #[inline(never)]
    fn dot(a: &[BigInt<4>; 3], b: &[i128; 3]) -> BigInt<6> {
        Self::volume(a[0], b[0]) + Self::volume(a[1], b[1]) + Self::volume(a[2], b[2])
    }
    #[inline(never)]
    fn quartic(a: BigInt<4>, b: BigInt<4>) -> BigInt<8> {
        a.times(&b)
    }
    #[inline(never)]
    fn sextic(a: BigInt<6>, b: BigInt<6>) -> BigInt<12> {
        a.times(&b)
    }
    #[inline(never)]
    fn sextic_of_areas(a: BigInt<8>, b: BigInt<4>) -> BigInt<12> {
        a.times(&b)
    }
    fn operand(a: i128) -> BigInt<8> {
        a.into()
    }
    fn widened(narrow: BigInt<6>) -> BigInt<6> {
        narrow
    }
}

impl<F: Float> Embeds<F> for Window {
    type OfAreas = Limbs4;

    fn holds<const K: usize>(coordinates: &[[F; 3]; K]) -> bool {
        bits(coordinates).width() <= BITS
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[i128; 3]; K] {
        let low = bits(coordinates).low;
        convert(coordinates, 0, |x| x.parts().in_wide_units(low))
    }

    fn embed_with_one<const K: usize>(
        coordinates: &[[F; 3]; K],
    ) -> Option<([[i128; 3]; K], BigInt<8>)> {
        let one = F::from(1).parts();
        let bits = bits(coordinates).with(one);
        let all = || convert(coordinates, 0, |x| x.parts().in_wide_units(bits.low));
        (bits.width() <= BITS).then(|| (all(), one.in_wide_units(bits.low).into()))
    }

    const DIVIDES: bool = true;

    fn quotient_of_lengths(num: i128, den: i128) -> F {
        let [num, den] = [num, den].map(|x| BigInt::<2>::from(x).sign_magnitude());
        quotient(num, den)
    }

    fn quotients([a, b, c]: [BigInt<6>; 3], den: BigInt<6>, _: [BigInt<6>; 2]) -> ([F; 3], bool) {
        let den = den.sign_magnitude();
        ([a, b, c].map(|x| quotient(x.sign_magnitude(), den)), true)
    }

    fn coordinate(num: BigInt<12>, den: BigInt<12>, _: [BigInt<12>; 2]) -> Option<F> {
        Some(quotient(num.sign_magnitude(), den.sign_magnitude()))
    }

    // The unit of `t` is one, and coordinates may be too far from it.
    fn compare_quotient(_: BigInt<6>, _: BigInt<6>, _: [BigInt<6>; 2], _: F) -> Option<Ordering> {
        None
    }
}
