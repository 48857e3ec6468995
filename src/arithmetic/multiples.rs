//! Floats as whole multiples of one power of two.

use core::cmp::Ordering;

use super::float::{Float, quotient};
use super::integer::Int64;
use super::parts::Bits;
use super::system::{Embeds, convert};
use super::wide::I256;

/// The bits of all coordinates.
fn bits<F: Float>(all: &[[F; 3]]) -> Bits {
    all.as_flattened().iter().fold(Bits::NONE, |bits, x| bits.with(x.parts()))
}

/// Whether 60 bits hold all.
fn is_short(bits: Bits) -> bool {
    bits.width() <= 60
}

/// Floats as whole multiples of one power of two, if 60 bits hold them all:
/// grids, and most scenes that were once in a coarser format. One is among them only where it
/// is asked for: the unit is the scene's, not the scalar's.
impl<F: Float> Embeds<F> for Int64 {
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
        quotient(I256::from(i128::from(num)).into(), I256::from(i128::from(den)).into())
    }

    fn quotients([a, b, c]: [I256; 3], den: I256, _: [I256; 2]) -> ([F; 3], bool) {
        let of = |num: I256| quotient(num.into(), den.into());
        ([of(a), of(b), of(c)], true)
    }

    // Times are not in the scene's unit.
    fn compare_quotient(_: I256, _: I256, _: [I256; 2], _: F) -> Option<Ordering> {
        None
    }
}
