//! Exact numbers for all finite floats.

use crate::arithmetic::Each;
use core::cmp::Ordering;

use super::big_int::BigInt;
use super::float::{Float, quotient};
use super::number::Number;
use super::system::{Arithmetic, Embeds};
use super::window::Limbwise;

mod terms;

pub use terms::Terms;

/// Exact numbers for all finite `f32`: coordinates below 2^277 units.
pub type FullF32 = Limbwise<Terms<925, 5>, 9, 14, 18, 27, Limbwise<BigInt<9>, 18, 27, 36, 54>>;
/// Exact numbers for all finite `f64`: coordinates below 2^2098 units, corners of oriented boxes below
/// 2^4199, and squares of volumes of these below 2^25200.
pub type FullF64 =
    Limbwise<Terms<0, 33>, 66, 99, 132, 197, Limbwise<BigInt<66>, 132, 198, 264, 396>>;

/// Floats as lengths; one loop for any number of points.
#[inline(never)]
fn embed<F: Float, const UNIT: u16, const A: usize>(floats: &[F], lengths: &mut [Terms<UNIT, A>]) {
    for (length, &x) in lengths.iter_mut().zip(floats) {
        *length = Terms::of(x.into());
    }
}

impl<
    F: Float,
    const UNIT: u16,
    const A: usize,
    const B: usize,
    const C: usize,
    const D: usize,
    const E: usize,
    W: Arithmetic<Length = BigInt<B>>,
> Embeds<F> for Limbwise<Terms<UNIT, A>, B, C, D, E, W>
{
    type OfAreas = W;

    fn holds<const K: usize>(_: &[[F; 3]; K]) -> bool {
        true
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[Self::Length; 3]; K] {
        let mut lengths = [[Number::ZERO; 3]; K];
        embed(coordinates.as_flattened(), lengths.as_flattened_mut());
        lengths
    }

    fn one() -> Option<BigInt<D>> {
        Some(Terms::<UNIT, A>::of(1.0).added_up())
    }

    fn times_one(d: Self::Length) -> Option<BigInt<B>> {
        Some(Self::area(d + d, Terms::of(1.0)))
    }

    const DIVIDES: bool = true;

    fn quotient_of_lengths(num: Self::Length, den: Self::Length) -> F {
        let [num, den] = [num, den].each(|x| x.added_up::<A>().sign_magnitude());
        quotient(num, den)
    }

    fn quotients([a, b, c]: [BigInt<C>; 3], den: BigInt<C>, _: [BigInt<C>; 2]) -> ([F; 3], bool) {
        let den = den.sign_magnitude();
        ([a, b, c].each(|x| quotient(x.sign_magnitude(), den)), true)
    }

    fn coordinate(num: BigInt<E>, den: BigInt<E>, _: [BigInt<E>; 2]) -> Option<F> {
        Some(quotient(num.sign_magnitude(), den.sign_magnitude()))
    }

    fn compare_quotient(
        num: BigInt<C>,
        den: BigInt<C>,
        _: [BigInt<C>; 2],
        t: F,
    ) -> Option<Ordering> {
        // num − t·den, in the unit of a product of four.
        let mut difference = BigInt([0; D]);
        for one in Terms::<UNIT, A>::of(1.0).terms() {
            difference.add_multiple(&num, one.magnitude, one.shift, false);
        }
        for t in Terms::<UNIT, A>::of(t.into()).terms() {
            difference.add_multiple(&den, t.magnitude, t.shift, !t.negative);
        }
        Some(difference.sign())
    }
}

#[cfg(test)]
mod tests;
