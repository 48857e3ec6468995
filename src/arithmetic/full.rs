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

// Lengths, areas and volumes of both exact systems against integers of any size.
#[cfg(test)]
mod tests {
    extern crate std;

    use core::cmp::Ordering;
    use core::ops::{Add, Neg, Sub};

    use dashu_int::IBig;

    use super::super::{Arithmetic, Embeds, Limbed, Number, Parts, Window, compare, cross, dot};
    use super::{FullF32, FullF64};
    use crate::arithmetic::{Each, Float};
    use crate::random::Random;

    fn of_limbs(limbs: &[u64]) -> IBig {
        let unsigned =
            limbs.iter().rev().fold(IBig::ZERO, |sum, limb| (sum << 64) + IBig::from(*limb));
        let is_negative = limbs.last().is_some_and(|top| top >> 63 != 0);
        if is_negative { unsigned - (IBig::ONE << (64 * limbs.len())) } else { unsigned }
    }

    /// A float in units of the least number of its type.
    fn whole<F: Float>(x: F) -> IBig {
        let Parts { negative, magnitude, shift } = x.parts();
        let magnitude = IBig::from(magnitude) << usize::from(shift);
        if negative { -magnitude } else { magnitude }
    }

    /// The lengths that kernels compute from up to six coordinates.
    fn lengths<L>(all: [[L; 3]; 2]) -> [[L; 3]; 3]
    where
        L: Clone + Add<Output = L> + Sub<Output = L> + Neg<Output = L>,
    {
        let [[a, b, c], [d, e, f]] = all.each(|row| row.each(|x| move || x.clone()));
        [
            [a(), b() - a(), (d() - b()) + (d() - c())],
            [
                ((a() - c()) + (a() - d())) + (c() - d()),
                (e() + e()) - (f() + f()) - (d() + d()),
                e() - (d() - f()) + (c() - b()),
            ],
            [
                -((e() - f()) - d()) - (b() - a()),
                (a() - b()) + (b() - a()),
                (f() + f()) + (f() + f()) - e(),
            ],
        ]
    }

    /// Whether `N` holds these coordinates; if it does, it must agree with integers of any size.
    fn agrees<F: Float, N: Embeds<F, Area: Limbed, Volume: Limbed, Product: Limbed>>(
        x: &[[F; 3]; 2],
        is_windowed: bool,
    ) -> bool {
        let Some(held) = N::embed(x) else { return false };
        let big = x.each(|row| row.each(whole));
        let low = big.as_flattened().iter().filter_map(IBig::trailing_zeros).min().unwrap_or(0);
        let low = if is_windowed { low } else { 0 };
        let big = big.each(|row| row.each(|x| x >> low));

        let (few, many) = (lengths(held), lengths(big));
        let product = |x: N::Length| of_limbs(N::operand(x).limbs());
        for (x, y) in few.as_flattened().iter().zip(many.as_flattened()) {
            assert_eq!(product(*x), *y);
            assert_eq!(compare(*x, N::Length::ZERO), y.cmp(&IBig::ZERO));
            let magnitude = if *y < IBig::ZERO { -y } else { y.clone() };
            assert_eq!(product(x.magnitude()), magnitude);
            for (z, w) in few.as_flattened().iter().zip(many.as_flattened()) {
                assert_eq!(x.partial_cmp(z), y.partial_cmp(w));
                assert_eq!(of_limbs(N::area(*x, *z).limbs()), y * w);
            }
        }
        let n = cross::<N>(&few[0], &few[1]);
        let [a, b, _] = &many;
        let m = [(1, 2), (2, 0), (0, 1)].each(|(j, k)| &a[j] * &b[k] - &a[k] * &b[j]);
        for i in 0..3 {
            assert_eq!(of_limbs(n[i].limbs()), m[i]);
            assert_eq!(of_limbs(N::volume(n[i], few[2][i]).limbs()), &m[i] * &many[2][i]);
            let fourfold = N::operand(few[0][0]) * N::operand(few[1][i]);
            let fourfold = fourfold * (N::operand(few[1][1]) * N::operand(few[2][i]));
            let expected = &many[0][0] * &many[1][i] * &many[1][1] * &many[2][i];
            assert_eq!(of_limbs(fourfold.limbs()), expected);
        }
        let expected = &m[0] * &many[2][0] + &m[1] * &many[2][1] + &m[2] * &many[2][2];
        assert_eq!(of_limbs(dot::<N>(&n, &few[2]).limbs()), expected);
        true
    }

    /// Coordinates with exponents in a range; some are equal, opposite, or at an end of the type.
    fn some<F: Float>(
        random: &mut Random,
        ends: &[F],
        of: fn(u64, i32) -> F,
        span: i32,
    ) -> [[F; 3]; 2] {
        let mut last = F::ZERO;
        let mut next = || {
            let bits = random.bits();
            last = match bits >> 60 {
                0 => ends[bits as usize % ends.len()],
                1 => -last,
                2 => last,
                3 => F::from(bits as u16),
                _ => of(bits, (bits >> 20) as i32 % span),
            };
            last
        };
        [[0; 3]; 2].each(|row| row.each(|_| next()))
    }

    fn all_agree<F: Float, N>(ends: &[F], of: fn(u64, i32) -> F, widest: i32)
    where
        N: Embeds<F, Area: Limbed, Volume: Limbed, Product: Limbed>,
    {
        let random = &mut Random(17);
        let (mut held, cases) = (0, 2000);
        for case in 0..cases {
            let span = if case % 2 == 0 { 60 } else { widest };
            // A window cannot hold both ends of the type.
            let ends = if case % 2 == 0 { &ends[..2] } else { ends };
            let x = some(random, ends, of, span);
            assert!(agrees::<F, N>(&x, false));
            held += u32::from(agrees::<F, Window>(&x, true));
        }
        assert!(held > cases / 6 && held < cases, "{held}");
    }

    #[test]
    fn f64_agrees_with_integers_of_any_size() {
        let of = |bits: u64, e: i32| {
            f64::from_bits(
                bits & (1 << 63 | ((1 << 52) - 1)) | ((1023 + e).clamp(0, 2046) as u64) << 52,
            )
        };
        let ends = [0.0, -0.0, f64::MAX, f64::MIN, f64::from_bits(1), f64::MIN_POSITIVE];
        all_agree::<f64, FullF64>(&ends, of, 1024);
    }

    #[test]
    fn f32_agrees_with_integers_of_any_size() {
        let of = |bits: u64, e: i32| {
            let bits = bits as u32 & (1 << 31 | ((1 << 23) - 1));
            f32::from_bits(bits | ((127 + e).clamp(0, 254) as u32) << 23)
        };
        let ends = [0.0, -0.0, f32::MAX, f32::MIN, f32::from_bits(1), f32::MIN_POSITIVE];
        all_agree::<f32, FullF32>(&ends, of, 128);
    }

    /// Both ends of the range, in all places of a length at once.
    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        let ends = [f64::MAX, f64::MIN, f64::from_bits(1), -f64::from_bits(1)];
        for k in 0..4_usize.pow(6) {
            let x = |i: u32| ends[k / 4_usize.pow(i) % 4];
            let all = [[x(0), x(1), x(2)], [x(3), x(4), x(5)]];
            let [held, _] = <FullF64 as Embeds<f64>>::embed_held(&all);
            let [a, b, c] = held;
            let [big_a, big_b, big_c] = all[0].each(whole);
            let length = (a - b) + (a - c);
            let expected = (&big_a - &big_b) + (&big_a - &big_c);
            assert_eq!(length.partial_cmp(&Number::ZERO), Some(expected.cmp(&IBig::ZERO)));
            if k % 7 == 0 {
                assert!(agrees::<f64, FullF64>(&all, false));
            }
        }
    }

    /// t, in the form that is compared with a quotient.
    #[test]
    fn quotients_compare_as_products_do() {
        let random = &mut Random(3);
        let of = |bits: u64, e: i32| f64::from_bits(bits >> 12 | ((523 + e) as u64) << 52);
        let mut equal = 0;
        for case in 0..3000 {
            let mut next = || (random.bits(), random.bits() as i32 & 511);
            let [num, den, t] = [next(), next(), next()].each(|(bits, e)| of(bits, e));
            // In a third of the cases the quotient is t.
            let (num, den) = if case % 3 == 0 { (t, 1.0) } else { (num, den) };
            let [[a, b, one], _] =
                <FullF64 as Embeds<f64>>::embed_held(&[[num, den, 1.0], [0.0; 3]]);
            let volume = |x| FullF64::volume(FullF64::area(x, one), one);
            let zero = [Number::ZERO; 2];
            let found = <FullF64 as Embeds<f64>>::compare_quotient(volume(a), volume(b), zero, t);
            let expected = (whole(num) * whole(1.0)).cmp(&(whole(t) * whole(den)));
            assert_eq!(found, Some(expected));
            equal += u32::from(expected == Ordering::Equal);
        }
        assert!(equal >= 1000);
    }
}
