//! Exact integers for coordinates that span up to 120 bits, or up to 32, and for areas of these.

use crate::arithmetic::Each;
use core::cmp::Ordering;
use core::marker::PhantomData;

use super::big_int::BigInt;
use super::float::{Float, bits, quotient};
use super::number::Number;
use super::system::{Arithmetic, Embeds, convert};

/// A length whose products are integers of a fixed number of limbs.
pub trait Exact: Number + 'static {
    /// The length itself.
    fn whole<const R: usize>(self) -> BigInt<R>;
    fn by_length<const R: usize>(self, other: Self) -> BigInt<R>;
    fn by_area<const A: usize, const R: usize>(self, area: BigInt<A>) -> BigInt<R>;

    /// a·b − c·d.
    fn minor<const R: usize>(a: [Self; 2], b: [Self; 2]) -> BigInt<R>;
    fn dot<const A: usize, const R: usize>(a: &[BigInt<A>; 3], b: &[Self; 3]) -> BigInt<R>;
}

macro_rules! exact {
    ($(#[$inline:meta] [$($generics:tt)*] $length:ty, $limbs:ident, $times:ident, |$x:ident| $whole:expr;)*) => {$(
        impl<$($generics)*> Exact for $length {
            #[inline(always)]
            fn whole<const R: usize>(self) -> BigInt<R> {
                let $x = self;
                $whole
            }
            #[$inline]
            fn by_length<const R: usize>(self, other: Self) -> BigInt<R> {
                self.whole::<$limbs>().$times(&other.whole::<$limbs>())
            }
            #[$inline]
            fn by_area<const A: usize, const R: usize>(self, area: BigInt<A>) -> BigInt<R> {
                area.$times(&self.whole::<$limbs>())
            }
            #[$inline]
            fn minor<const R: usize>([a, b]: [Self; 2], [c, d]: [Self; 2]) -> BigInt<R> {
                a.by_length::<R>(b) - c.by_length(d)
            }
            #[$inline]
            fn dot<const A: usize, const R: usize>(a: &[BigInt<A>; 3], b: &[Self; 3]) -> BigInt<R> {
                b[0].by_area::<A, R>(a[0]) + b[1].by_area(a[1]) + b[2].by_area(a[2])
            }
        }
    )*};
}
const ONE: usize = 1;
const TWO: usize = 2;
exact! {
    // Words in registers; all kernels share one copy of each product.
    #[inline(never)] [] i64, ONE, times, |x| i128::from(x).into();
    #[inline(never)] [] i128, TWO, times, |x| x.into();
    // Inlined down to calls by reference.
    #[inline(always)] [const N: usize] BigInt<N>, N, product, |x| x.resized();
}

/// Exact integers: lengths `L`, areas of `A` limbs, volumes of `V`, products of four lengths of `Q`, and
/// of six of `E`. `W` has areas as lengths.
#[derive(Clone, Copy, Debug)]
pub struct Limbwise<L, const A: usize, const V: usize, const Q: usize, const E: usize, W = ()>(
    PhantomData<(L, W)>,
);

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
pub type Window = Limbwise<i128, 4, 6, 8, 12>;

/// The same for coordinates within 32 bits: frames are below 2^34, areas below 2^69, volumes below
/// 2^104, sums of 30 products of four below 2^137, and squares of volumes below 2^204.
#[cfg(feature = "fixed")]
pub type ShortWindow = Limbwise<i64, 2, 2, 3, 4>;

/// The number of bits for the coordinates of a [`Window`].
const BITS: i32 = 120;

impl<L: Exact, const A: usize, const V: usize, const Q: usize, const E: usize, W: 'static>
    Arithmetic for Limbwise<L, A, V, Q, E, W>
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

    #[inline(always)]
    fn area(a: L, b: L) -> BigInt<A> {
        a.by_length(b)
    }
    #[inline(always)]
    fn volume(a: BigInt<A>, b: L) -> BigInt<V> {
        b.by_area(a)
    }
    #[inline(always)]
    fn minor(a: [L; 2], b: [L; 2]) -> BigInt<A> {
        L::minor(a, b)
    }
    #[inline(always)]
    fn dot(a: &[BigInt<A>; 3], b: &[L; 3]) -> BigInt<V> {
        L::dot(a, b)
    }
    #[inline(always)]
    fn quartic(a: BigInt<A>, b: BigInt<A>) -> BigInt<Q> {
        a.product(&b)
    }
    #[inline(always)]
    fn sextic(a: BigInt<V>, b: BigInt<V>) -> BigInt<E> {
        a.product(&b)
    }
    #[inline(always)]
    fn sextic_of_areas(a: BigInt<Q>, b: BigInt<A>) -> BigInt<E> {
        a.product(&b)
    }
    fn operand(a: L) -> BigInt<Q> {
        a.whole()
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
        let [num, den] = [num, den].each(|x| BigInt::<2>::from(x).sign_magnitude());
        quotient(num, den)
    }

    fn quotients([a, b, c]: [BigInt<6>; 3], den: BigInt<6>, _: [BigInt<6>; 2]) -> ([F; 3], bool) {
        let den = den.sign_magnitude();
        ([a, b, c].each(|x| quotient(x.sign_magnitude(), den)), true)
    }

    fn coordinate(num: BigInt<12>, den: BigInt<12>, _: [BigInt<12>; 2]) -> Option<F> {
        Some(quotient(num.sign_magnitude(), den.sign_magnitude()))
    }

    // The unit of `t` is one, and coordinates may be too far from it.
    fn compare_quotient(_: BigInt<6>, _: BigInt<6>, _: [BigInt<6>; 2], _: F) -> Option<Ordering> {
        None
    }
}

/// For areas of a [`Window`]. An area in the frame is below 2^242, and a corner of an oriented box
/// below 2^243. So an area of these is below 2^488, a volume below 2^732, and a square of a volume
/// below 2^1465.
pub(super) type Limbs4 = Limbwise<BigInt<4>, 8, 12, 16, 24>;

/// For areas of a [`ShortWindow`]: corners of an oriented box are below 2^70, so
/// areas of these below 2^142, volumes below 2^213, and squares of volumes below 2^427.
#[cfg(feature = "fixed")]
pub(super) type Limbs2 = Limbwise<BigInt<2>, 3, 4, 5, 7>;

#[cfg(all(test, feature = "fixed"))]
mod tests {
    //! Products at the ends of 32 bits: short windows and long ones agree. Coordinates as integers.

    use super::super::{Arithmetic, BigInt, Embeds, Int64OfFloats, Limbed, cross, dot};
    use super::{Limbs2, Limbs4};
    use super::{ShortWindow, Window, bits};
    use crate::arithmetic::Each;
    use crate::random::Random;

    /// A number in more limbs.
    fn long(x: &impl Limbed) -> BigInt<24> {
        let limbs = x.limbs();
        let fill = if limbs.last().is_some_and(|top| top >> 63 != 0) { u64::MAX } else { 0 };
        let mut all = [fill; 24];
        for (to, &limb) in all.iter_mut().zip(limbs) {
            *to = limb;
        }
        BigInt(all)
    }

    /// The greatest numbers of each degree that kernels make of three vectors.
    fn products<N>([a, b, c]: [[N::Length; 3]; 3]) -> [BigInt<24>; 5]
    where
        N: Arithmetic<Area: Limbed, Volume: Limbed, Quartic: Limbed, Sextic: Limbed>,
    {
        let n = cross::<N>(&a, &b);
        let volume = dot::<N>(&n, &c);
        let square = |x| N::quartic(x, x);
        let quartic = square(n[0]) + square(n[1]) + square(n[2]);
        let squares =
            N::sextic(volume, volume) + N::sextic(volume, volume) + N::sextic(volume, volume);
        let sextic = N::sextic_of_areas(quartic, n[0]);
        [long(&n[0]), long(&volume), long(&quartic), long(&squares), long(&sextic)]
    }

    /// All vectors whose coordinates are minus the greatest length, the greatest, or one.
    fn vectors() -> impl Iterator<Item = [[i8; 3]; 3]> {
        (0..19_683).map(|k: u32| {
            [0, 1, 2]
                .each(|v| [0, 1, 2].each(|i| [-1, 1, 0][(k / 3_u32.pow(3 * v + i) % 3) as usize]))
        })
    }

    #[test]
    fn short_windows_hold_the_products_of_32_bits() {
        // In the frame, differences are doubled.
        let of = |x: i8| if x == 0 { 1 } else { i64::from(x) << 33 };
        for edges in vectors().map(|all| all.each(|v| v.each(of))) {
            let long = products::<Window>(edges.each(|v| v.each(i128::from)));
            assert_eq!(products::<ShortWindow>(edges), long, "{edges:?}");
        }
    }

    #[test]
    fn short_limbs_hold_the_products_of_areas() {
        // The corners of oriented boxes.
        let of = |x: i8| if x == 0 { 1 } else { i128::from(x) << 70 };
        for edges in vectors().map(|all| all.each(|v| v.each(of))) {
            let long = products::<Limbs4>(edges.each(|v| v.each(BigInt::from)));
            assert_eq!(products::<Limbs2>(edges.each(|v| v.each(BigInt::from))), long, "{edges:?}");
        }
    }

    /// Where loops are in vectors, too.
    #[test]
    fn numbers_side_by_side_are_those_of_each() {
        fn check<const K: usize>(random: &mut Random) {
            for n in 0..1_000 {
                let mut number = |_| {
                    let bits = random.bits();
                    let size = (bits >> (12 + n % 40)) as f64 / 64.0;
                    if bits & 1 == 1 { size } else { -size }
                };
                let points = [(); K].map(|()| [0, 1, 2].each(&mut number));
                let all = <Window as Embeds<f64>>::embed(&points).unwrap();
                let short = <Int64OfFloats as Embeds<f64>>::embed(&points);
                let low = bits(&points).low;
                for (k, p) in points.iter().enumerate() {
                    for i in 0..3 {
                        let expected = p[i] * 2_f64.powi(1074 - low);
                        assert_eq!(all[k][i] as f64, expected, "{K} {k} {i}");
                        assert!(
                            short.is_none_or(|short| short[k][i] as f64 == expected),
                            "{K} {k} {i}"
                        );
                    }
                }
            }
        }
        let mut random = Random(0x519);
        check::<2>(&mut random);
        check::<3>(&mut random);
        check::<4>(&mut random);
        check::<5>(&mut random);
        check::<6>(&mut random);
        check::<8>(&mut random);
    }
}
