//! Exact numbers whose lengths are areas of other exact numbers.

use super::big_int::BigInt;
use super::full::product;
use super::system::Arithmetic;

/// Lengths of `A` limbs, areas of `B`, volumes of `C`, products of four of `D`, and of six of `E`.
///
/// In a window an area in the frame is below 2^242, and a corner of an oriented box below 2^243. So
/// an area of these is below 2^488, a volume below 2^732, and a square of a volume below 2^1465. In
/// the full range of `f64`, corners are below 2^4199, and squares of volumes below 2^25200.
#[derive(Clone, Copy, Debug)]
pub struct OfLimbs<const A: usize, const B: usize, const C: usize, const D: usize, const E: usize>;

/// For areas of a [`Window`](super::Window).
pub(super) type Limbs4 = OfLimbs<4, 8, 12, 16, 24>;

/// For areas of a [`ShortWindow`](super::ShortWindow): corners of an oriented box are below 2^70, so
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
