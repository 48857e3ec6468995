//! Exact numbers for all finite floats.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::big_int::BigInt;
use super::float::{Float, quotient};
use super::limbs::Limbs;
use super::number::Number;
use super::portion::divided_limbs;
use super::soft::Soft;
use super::system::{Arithmetic, Embeds, convert};

/// Exact numbers for all finite floats. A length is a sum of a few floats, not added up. An area is
/// an integer of `B` limbs, a volume one of `C`, a product of four lengths one of `D`, and one of
/// six `E`. Added up, a length takes `A` limbs. The unit of length is the least float above zero:
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
>;

/// For `f32`: coordinates below 2^277 units.
pub type FullF32 = Full<925, 5, 9, 14, 18, 27>;
/// For `f64`: coordinates below 2^2098 units.
pub type FullF64 = Full<0, 33, 66, 99, 132, 197>;

/// A sum of up to six floats, each as the bits of an `f64`, or zero. Their exponents may exceed the
/// greatest of a finite number by one, so that every number can be doubled.
#[derive(Clone, Copy, Debug)]
pub struct Terms<const UNIT: u16, const A: usize>([u64; 6]);

const SIGN: u64 = 1 << 63;
const HIDDEN: u64 = 1 << 52;

/// A nonzero float as sign, odd magnitude and power of two.
#[derive(Clone, Copy)]
struct Term {
    negative: bool,
    magnitude: u64,
    shift: usize,
}

/// Twice the number, if its exponent has room.
fn doubled(bits: u64) -> Option<u64> {
    let magnitude = bits & !SIGN;
    if magnitude < HIDDEN {
        // In a subnormal number the carry becomes the exponent.
        Some(bits & SIGN | magnitude << 1)
    } else {
        (bits.wrapping_add(HIDDEN) & SIGN == bits & SIGN).then_some(bits.wrapping_add(HIDDEN))
    }
}

impl<const UNIT: u16, const A: usize> Terms<UNIT, A> {
    fn of(x: f64) -> Self {
        let bits = x.to_bits();
        Self([if bits == SIGN { 0 } else { bits }, 0, 0, 0, 0, 0])
    }

    /// Adds a float by its bits. Opposite terms cancel, and equal terms become one doubled term, so
    /// that the sums of all kernels have room. An example is twice a vertex minus both corners of a
    /// box.
    fn push(&mut self, mut term: u64) {
        while let Some(same) = self.0.iter_mut().find(|x| **x << 1 == term << 1) {
            if *same != term {
                *same = 0;
                return;
            }
            let Some(twice) = doubled(term) else { break };
            *same = 0;
            term = twice;
        }
        let free = self.0.iter_mut().find(|x| **x == 0);
        debug_assert!(free.is_some());
        if let Some(free) = free {
            *free = term;
        }
    }

    fn terms(&self) -> impl Iterator<Item = Term> + '_ {
        self.0.iter().filter(|&&bits| bits != 0).map(|&bits| {
            let exponent = (bits & !SIGN) >> 52;
            let hidden = if exponent == 0 { 0 } else { HIDDEN };
            let magnitude = hidden | bits & (HIDDEN - 1);
            let zeros = magnitude.trailing_zeros();
            let shift = exponent.saturating_sub(1) as u16 + zeros as u16 - UNIT;
            Term { negative: bits & SIGN != 0, magnitude: magnitude >> zeros, shift: shift.into() }
        })
    }

    /// The sum, which `L` limbs hold.
    fn added_up<const L: usize>(&self) -> BigInt<L> {
        let mut sum = BigInt([0; L]);
        for x in self.terms() {
            sum.accumulate([x.magnitude].into_iter(), x.shift, x.negative);
        }
        sum
    }

    #[inline(never)]
    fn sign(&self) -> Ordering {
        let mut terms = self.0.iter().copied().filter(|&bits| bits != 0);
        let (first, second, third) = (terms.next(), terms.next(), terms.next());
        let sign = |bits: u64| if bits & SIGN == 0 { Ordering::Greater } else { Ordering::Less };
        match (first, second, third) {
            (None, ..) => Ordering::Equal,
            (Some(a), None, _) => sign(a),
            // The bits of magnitudes compare like the magnitudes, and they are not equal.
            (Some(a), Some(b), None) => sign(if a << 1 > b << 1 { a } else { b }),
            _ => self.added_up::<A>().sign(),
        }
    }

    /// How two lengths compare. Together they may have more terms than one length has room for.
    fn compare(&self, other: &Self) -> Ordering {
        let count = |x: &Self| x.0.iter().filter(|&&bits| bits != 0).count();
        if count(self) + count(other) > self.0.len() {
            return (self.added_up::<A>() - other.added_up()).sign();
        }
        (*self - *other).sign()
    }

    /// Adds the product of two lengths to an area, or subtracts it.
    #[inline(never)]
    fn add_product<const B: usize>(&self, other: &Self, sum: &mut BigInt<B>, is_minus: bool) {
        for x in self.terms() {
            for y in other.terms() {
                let product = u128::from(x.magnitude) * u128::from(y.magnitude);
                let words = [product as u64, (product >> 64) as u64];
                let negative = x.negative != y.negative;
                sum.accumulate(words.into_iter(), x.shift + y.shift, negative != is_minus);
            }
        }
    }

    /// Adds the product of an area and the length to a volume.
    fn add_multiple<const B: usize, const C: usize>(&self, area: &BigInt<B>, sum: &mut BigInt<C>) {
        for x in self.terms() {
            sum.add_multiple(area, x.magnitude, x.shift, x.negative);
        }
    }
}

impl<const UNIT: u16, const A: usize> Add for Terms<UNIT, A> {
    type Output = Self;
    #[inline(never)]
    fn add(mut self, other: Self) -> Self {
        for bits in other.0 {
            if bits != 0 {
                self.push(bits);
            }
        }
        self
    }
}

impl<const UNIT: u16, const A: usize> Neg for Terms<UNIT, A> {
    type Output = Self;
    fn neg(mut self) -> Self {
        for bits in &mut self.0 {
            *bits ^= if *bits == 0 { 0 } else { SIGN };
        }
        self
    }
}

impl<const UNIT: u16, const A: usize> Sub for Terms<UNIT, A> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const UNIT: u16, const A: usize> PartialEq for Terms<UNIT, A> {
    fn eq(&self, other: &Self) -> bool {
        self.compare(other) == Ordering::Equal
    }
}

impl<const UNIT: u16, const A: usize> PartialOrd for Terms<UNIT, A> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.compare(other))
    }
}

impl<const UNIT: u16, const A: usize> Number for Terms<UNIT, A> {
    const ZERO: Self = Self([0; 6]);
    fn magnitude(self) -> Self {
        if self.sign() == Ordering::Less { -self } else { self }
    }
    /// Odd multiples of the least float round toward zero. No kernel halves these numbers, because
    /// the frame of a box is doubled.
    fn half(mut self) -> Self {
        for bits in &mut self.0 {
            let magnitude = *bits & !SIGN;
            let half =
                if magnitude >> 53 == 0 { magnitude >> 1 } else { magnitude.wrapping_sub(HIDDEN) };
            *bits = if half == 0 { 0 } else { *bits & SIGN | half };
        }
        self
    }
    fn portion(self, den: Self, _: [Self; 2]) -> [Soft; 2] {
        let [num, den] = [self, den].map(|x| Limbs(x.added_up::<A>().0));
        [divided_limbs(num, &den); 2]
    }
}

/// a·b, a limb of b at a time: unrolled loops over both would be a block too large for compilers.
#[inline(never)]
fn product<const L: usize, const M: usize, const R: usize>(
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
> Arithmetic for Full<UNIT, A, B, C, D, E>
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

    fn area(a: Self::Length, b: Self::Length) -> BigInt<B> {
        let mut sum = BigInt([0; B]);
        a.add_product(&b, &mut sum, false);
        sum
    }
    fn volume(a: BigInt<B>, b: Self::Length) -> BigInt<C> {
        let mut sum = BigInt([0; C]);
        b.add_multiple(&a, &mut sum);
        sum
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
    // In one sum, so that numbers of a kilobyte are not copied.
    #[inline(never)]
    fn minor([a, b]: [Self::Length; 2], [c, d]: [Self::Length; 2]) -> BigInt<B> {
        let mut sum = BigInt([0; B]);
        a.add_product(&b, &mut sum, false);
        c.add_product(&d, &mut sum, true);
        sum
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
> Embeds<F> for Full<UNIT, A, B, C, D, E>
where
    F: Float,
{
    fn holds<const K: usize>(_: &[[F; 3]; K]) -> bool {
        true
    }

    fn embed_held<const K: usize>(coordinates: &[[F; 3]; K]) -> [[Self::Length; 3]; K] {
        convert(coordinates, Number::ZERO, |x| Terms::of(x.into()))
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
