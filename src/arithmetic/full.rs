//! Exact numbers for all finite floats.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::big_int::BigInt;
use super::float::{Float, quotient};
use super::number::Number;
use super::system::{Arithmetic, Embeds};
use super::window::OfLimbs;

mod terms;

pub use terms::Terms;

/// Exact numbers for all finite floats. A length is a sum of a few floats, not added up. An area is
/// an integer of `B` limbs, a volume one of `C`, a product of four lengths one of `D`, and one of
/// six `E`. `W` has areas as lengths. Added up, a length takes `A` limbs. The unit of length is the least float above zero:
/// 2^`UNIT` times the least `f64`.
///
/// Lengths stay short, so frames take little stack: two floats whose exponents are far apart take
/// two words, where their sum takes up to 33 limbs. An area is the sum of the products of all
/// terms.
#[derive(Clone, Copy, Debug)]
pub struct Full<
    const UNIT: u16,
    const A: usize,
    const B: usize,
    const C: usize,
    const D: usize,
    const E: usize,
    W,
>(PhantomData<W>);

/// For `f32`: coordinates below 2^277 units.
pub type FullF32 = Full<925, 5, 9, 14, 18, 27, OfLimbs<9, 18, 27, 36, 54>>;
/// For `f64`: coordinates below 2^2098 units.
pub type FullF64 = Full<0, 33, 66, 99, 132, 197, OfLimbs<66, 132, 198, 264, 396>>;

/// Floats as lengths; one loop for any number of points.
#[inline(never)]
fn embed<F: Float, const UNIT: u16, const A: usize>(floats: &[F], lengths: &mut [Terms<UNIT, A>]) {
    for (length, &x) in lengths.iter_mut().zip(floats) {
        *length = Terms::of(x.into());
    }
}

/// a·b, a limb of b at a time: unrolled loops over both would be a block too large for compilers.
#[inline(never)]
pub(super) fn product<const L: usize, const M: usize, const R: usize>(
    a: &BigInt<L>,
    b: &BigInt<M>,
) -> BigInt<R> {
    let (is_negative, limbs) = b.sign_magnitude();
    let mut sum = BigInt([0; R]);
    for (k, &limb) in limbs.iter().enumerate().filter(|(_, limb)| **limb != 0) {
        sum.add_multiple(a, limb, 64 * k, is_negative);
    }
    sum
}

impl<
    const UNIT: u16,
    const A: usize,
    const B: usize,
    const C: usize,
    const D: usize,
    const E: usize,
    W: 'static,
> Arithmetic for Full<UNIT, A, B, C, D, E, W>
{
    type Length = Terms<UNIT, A>;
    type Area = BigInt<B>;
    type Volume = BigInt<C>;
    type Quartic = BigInt<D>;
    type Sextic = BigInt<E>;
    type Product = BigInt<D>;
    type Narrow = Self;

    const CERTAIN: bool = true;
    const LARGE: bool = true;
    const DOUBLED: bool = true;
    const CORNER_FORM_ONLY: bool = true;

    #[inline(always)]
    fn area(a: Self::Length, b: Self::Length) -> BigInt<B> {
        Terms::area(&a, &b)
    }
    #[inline(always)]
    fn volume(a: BigInt<B>, b: Self::Length) -> BigInt<C> {
        b.volume(&a)
    }
    #[inline(always)]
    fn quartic(a: BigInt<B>, b: BigInt<B>) -> BigInt<D> {
        product(&a, &b)
    }
    #[inline(always)]
    fn sextic(a: BigInt<C>, b: BigInt<C>) -> BigInt<E> {
        product(&a, &b)
    }
    #[inline(always)]
    fn sextic_of_areas(a: BigInt<D>, b: BigInt<B>) -> BigInt<E> {
        product(&a, &b)
    }
    // Inlined down to calls by reference, as sums of lengths are.
    #[inline(always)]
    fn minor([a, b]: [Self::Length; 2], [c, d]: [Self::Length; 2]) -> BigInt<B> {
        Terms::minor([&a, &b], [&c, &d])
    }
    #[inline(never)]
    fn dot(a: &[BigInt<B>; 3], b: &[Self::Length; 3]) -> BigInt<C> {
        let mut sum = BigInt([0; C]);
        for (a, b) in a.iter().zip(b) {
            b.add_multiple(a, &mut sum);
        }
        sum
    }
    fn operand(a: Self::Length) -> BigInt<D> {
        a.added_up()
    }
    fn widened(narrow: BigInt<C>) -> BigInt<C> {
        narrow
    }
}

impl<
    F,
    const UNIT: u16,
    const A: usize,
    const B: usize,
    const C: usize,
    const D: usize,
    const E: usize,
    W,
> Embeds<F> for Full<UNIT, A, B, C, D, E, W>
where
    F: Float,
    W: Arithmetic<Length = BigInt<B>>,
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
        let [num, den] = [num, den].map(|x| x.added_up::<A>().sign_magnitude());
        quotient(num, den)
    }

    fn quotients([a, b, c]: [BigInt<C>; 3], den: BigInt<C>, _: [BigInt<C>; 2]) -> ([F; 3], bool) {
        let den = den.sign_magnitude();
        ([a, b, c].map(|x| quotient(x.sign_magnitude(), den)), true)
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
