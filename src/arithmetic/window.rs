//! Exact integers for coordinates that span up to 120 bits, or up to 32, and for areas of these.

use core::cmp::Ordering;
use core::marker::PhantomData;

use super::big_int::BigInt;
use super::float::{Float, quotient};
use super::full::product;
use super::multiples::bits;
use super::number::Number;
use super::system::{Arithmetic, Embeds, convert};

/// Exact integers, from lengths of `N` limbs, in a word `L`, to products of six lengths of `E`; areas
/// have `A`, volumes `V`, and products of four `Q`.
#[derive(Clone, Copy, Debug)]
pub struct Limbwise<
    L,
    const N: usize,
    const A: usize,
    const V: usize,
    const Q: usize,
    const E: usize,
>(PhantomData<L>);

/// Exact integers for coordinates within 120 bits.
///
/// It holds fixed point of every type, and serves types of 64 bits. It holds floats if the highest and
/// the lowest bit of all coordinates are at most 120 places apart, as in nearly every scene. The unit
/// of floats is the place of the lowest bit, so each call of [`embed`](Embeds::embed) has its own:
/// embed all coordinates of a question in one call. One as an operand,
/// [`embed_with_one`](Embeds::embed_with_one), is in the same unit; without it, axes of an oriented
/// box cannot be compared with lengths.
///
/// With coordinates below 2^120 the table in `integer` gives frames below 2^122, areas below
/// 2^245, volumes below 2^368 and, for oriented boxes, sums of 30 products of four below 2^489.
/// Without the frame, squares of volumes are below 2^732.
pub type Window = Limbwise<i128, 2, 4, 6, 8, 12>;

/// The same for coordinates within 32 bits: frames are below 2^34, areas below 2^69, volumes below
/// 2^104, sums of 30 products of four below 2^137, and squares of volumes below 2^204.
#[cfg(feature = "fixed")]
pub type ShortWindow = Limbwise<i64, 1, 2, 2, 3, 4>;

/// The number of bits for the coordinates of a [`Window`].
const BITS: i32 = 120;

impl<L, const N: usize, const A: usize, const V: usize, const Q: usize, const E: usize> Arithmetic
    for Limbwise<L, N, A, V, Q, E>
where
    L: Number + Into<i128> + 'static,
{
    type Length = L;
    type Area = BigInt<A>;
    type Volume = BigInt<V>;
    type Quartic = BigInt<Q>;
    type Sextic = BigInt<E>;
    type Product = BigInt<Q>;
    type Narrow = Self;

    const CERTAIN: bool = true;
    const LARGE: bool = true;
    const DOUBLED: bool = true;
    const CORNER_FORM_ONLY: bool = true;

    // Products are out of line, so that all kernels share one copy of each.
    #[inline(never)]
    fn area(a: L, b: L) -> BigInt<A> {
        BigInt::<N>::from(a.into()).times(&BigInt::<N>::from(b.into()))
    }
    #[inline(never)]
    fn volume(a: BigInt<A>, b: L) -> BigInt<V> {
        a.times(&BigInt::<N>::from(b.into()))
    }
    #[inline(never)]
    fn minor([a, b]: [L; 2], [c, d]: [L; 2]) -> BigInt<A> {
        Self::area(a, b) - Self::area(c, d)
    }
    #[inline(never)]
    fn dot(a: &[BigInt<A>; 3], b: &[L; 3]) -> BigInt<V> {
        Self::volume(a[0], b[0]) + Self::volume(a[1], b[1]) + Self::volume(a[2], b[2])
    }
    #[inline(never)]
    fn quartic(a: BigInt<A>, b: BigInt<A>) -> BigInt<Q> {
        a.times(&b)
    }
    #[inline(never)]
    fn sextic(a: BigInt<V>, b: BigInt<V>) -> BigInt<E> {
        a.times(&b)
    }
    #[inline(never)]
    fn sextic_of_areas(a: BigInt<Q>, b: BigInt<A>) -> BigInt<E> {
        a.times(&b)
    }
    fn operand(a: L) -> BigInt<Q> {
        a.into().into()
    }
    fn widened(narrow: BigInt<V>) -> BigInt<V> {
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

/// Exact numbers whose lengths are areas of others: lengths of `A` limbs, areas of `B`, volumes of `C`, products of four of `D`, and of six of `E`.
///
/// In a window an area in the frame is below 2^242, and a corner of an oriented box below 2^243. So
/// an area of these is below 2^488, a volume below 2^732, and a square of a volume below 2^1465. In
/// the full range of `f64`, corners are below 2^4199, and squares of volumes below 2^25200.
#[derive(Clone, Copy, Debug)]
pub struct OfLimbs<const A: usize, const B: usize, const C: usize, const D: usize, const E: usize>;

/// For areas of a [`Window`].
pub(super) type Limbs4 = OfLimbs<4, 8, 12, 16, 24>;

/// For areas of a [`ShortWindow`]: corners of an oriented box are below 2^70, so
/// areas of these below 2^142, volumes below 2^213, and squares of volumes below 2^427.
#[cfg(feature = "fixed")]
pub(super) type Limbs2 = OfLimbs<2, 3, 4, 5, 7>;

impl<const A: usize, const B: usize, const C: usize, const D: usize, const E: usize> Arithmetic
    for OfLimbs<A, B, C, D, E>
{
    type Length = BigInt<A>;
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

    fn area(a: BigInt<A>, b: BigInt<A>) -> BigInt<B> {
        product(&a, &b)
    }
    fn volume(a: BigInt<B>, b: BigInt<A>) -> BigInt<C> {
        product(&a, &b)
    }
    fn quartic(a: BigInt<B>, b: BigInt<B>) -> BigInt<D> {
        product(&a, &b)
    }
    fn sextic(a: BigInt<C>, b: BigInt<C>) -> BigInt<E> {
        product(&a, &b)
    }
    fn sextic_of_areas(a: BigInt<D>, b: BigInt<B>) -> BigInt<E> {
        product(&a, &b)
    }
    fn operand(a: BigInt<A>) -> BigInt<D> {
        a.resized()
    }
    fn widened(narrow: BigInt<C>) -> BigInt<C> {
        narrow
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests;
