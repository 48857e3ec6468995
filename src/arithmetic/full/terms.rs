//! Lengths that are not added up.

use crate::arithmetic::Each;
use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

use super::super::big_int::BigInt;
use super::super::limbs::Limbs;
use super::super::number::Number;
use super::super::portion::divided_limbs;
use super::super::soft::Soft;
use super::super::window::Exact;

/// A sum of up to six floats, each as the bits of an `f64`, or zero. Their exponents may exceed the
/// greatest of a finite number by one, so that every number can be doubled. The unit is the least float
/// above zero, 2^`UNIT` times the least `f64`, and added up the sum takes `A` limbs.
///
/// It stays short, so that frames take little stack: two floats whose exponents are far apart take two words,
/// where their sum takes up to 33 limbs.
#[derive(Clone, Copy, Debug)]
pub struct Terms<const UNIT: u16, const A: usize>([u64; 6]);

const SIGN: u64 = 1 << 63;
const HIDDEN: u64 = 1 << 52;

/// A nonzero float as sign, odd magnitude and power of two.
#[derive(Clone, Copy)]
pub(super) struct Term {
    pub(super) negative: bool,
    pub(super) magnitude: u64,
    pub(super) shift: usize,
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
    pub(super) fn of(x: f64) -> Self {
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

    pub(super) fn terms(&self) -> impl Iterator<Item = Term> + '_ {
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
    pub(super) fn added_up<const L: usize>(&self) -> BigInt<L> {
        let mut sum = BigInt([0; L]);
        for x in self.terms() {
            sum.accumulate([x.magnitude].into_iter(), x.shift, x.negative);
        }
        sum
    }

    /// The sum, or the difference.
    #[inline(never)]
    fn plus(&self, other: &Self, is_minus: bool) -> Self {
        let sign = if is_minus { SIGN } else { 0 };
        let mut sum = *self;
        for bits in other.0 {
            if bits != 0 {
                sum.push(bits ^ sign);
            }
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
    fn add_multiple<const B: usize, const R: usize>(&self, area: &BigInt<B>, sum: &mut BigInt<R>) {
        for x in self.terms() {
            sum.add_multiple(area, x.magnitude, x.shift, x.negative);
        }
    }
}

// Inlined down to calls by reference: a caller would copy each operand first.
impl<const UNIT: u16, const A: usize> Exact for Terms<UNIT, A> {
    #[inline(always)]
    fn whole<const R: usize>(self) -> BigInt<R> {
        self.added_up()
    }
    #[inline(always)]
    fn by_length<const R: usize>(self, other: Self) -> BigInt<R> {
        area(&self, &other)
    }
    #[inline(always)]
    fn by_area<const B: usize, const R: usize>(self, area: BigInt<B>) -> BigInt<R> {
        volume(&self, &area)
    }
    #[inline(always)]
    fn minor<const R: usize>([a, b]: [Self; 2], [c, d]: [Self; 2]) -> BigInt<R> {
        minor([&a, &b], [&c, &d])
    }
    #[inline(always)]
    fn dot<const B: usize, const R: usize>(a: &[BigInt<B>; 3], b: &[Self; 3]) -> BigInt<R> {
        dot(a, b)
    }
}

#[inline(never)]
fn area<const UNIT: u16, const A: usize, const R: usize>(
    a: &Terms<UNIT, A>,
    b: &Terms<UNIT, A>,
) -> BigInt<R> {
    let mut sum = BigInt([0; R]);
    a.add_product(b, &mut sum, false);
    sum
}

/// a·b − c·d, in one sum, so that numbers of a kilobyte are not copied.
#[inline(never)]
fn minor<const UNIT: u16, const A: usize, const R: usize>(
    [a, b]: [&Terms<UNIT, A>; 2],
    [c, d]: [&Terms<UNIT, A>; 2],
) -> BigInt<R> {
    let mut sum = BigInt([0; R]);
    a.add_product(b, &mut sum, false);
    c.add_product(d, &mut sum, true);
    sum
}

#[inline(never)]
fn volume<const UNIT: u16, const A: usize, const B: usize, const R: usize>(
    length: &Terms<UNIT, A>,
    area: &BigInt<B>,
) -> BigInt<R> {
    let mut sum = BigInt([0; R]);
    length.add_multiple(area, &mut sum);
    sum
}

#[inline(never)]
fn dot<const UNIT: u16, const A: usize, const B: usize, const R: usize>(
    areas: &[BigInt<B>; 3],
    lengths: &[Terms<UNIT, A>; 3],
) -> BigInt<R> {
    let mut sum = BigInt([0; R]);
    for (length, area) in lengths.iter().zip(areas) {
        length.add_multiple(area, &mut sum);
    }
    sum
}

impl<const UNIT: u16, const A: usize> Add for Terms<UNIT, A> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.plus(&other, false)
    }
}

impl<const UNIT: u16, const A: usize> Neg for Terms<UNIT, A> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::ZERO.plus(&self, true)
    }
}

impl<const UNIT: u16, const A: usize> Sub for Terms<UNIT, A> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.plus(&other, true)
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
        let [num, den] = [self, den].each(|x| Limbs(x.added_up::<A>().0));
        [divided_limbs(num, &den); 2]
    }
    fn sign_and_size(self) -> Option<(Ordering, Soft)> {
        self.added_up::<A>().sign_and_size()
    }
}
