//! Integers with a fixed number of limbs.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use super::limbs::Limbs;
use super::number::{Limbed, Number, signed};
use super::portion::divided_limbs;
use super::soft::Soft;

/// An integer in two's complement, least limb first. Its types are chosen so that no result
/// overflows; see [`Window`](super::Window) and [`FullF32`](super::FullF32).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BigInt<const L: usize>(pub(crate) [u64; L]);

impl<const L: usize> BigInt<L> {
    #[inline(always)]
    pub(crate) fn is_negative(&self) -> bool {
        self.0.last().is_some_and(|top| top >> 63 != 0)
    }

    /// How the number compares with zero.
    pub(crate) fn sign(&self) -> Ordering {
        if self.is_negative() {
            Ordering::Less
        } else if self.0.iter().any(|&limb| limb != 0) {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    /// Whether the number is below zero, and the limbs of its magnitude.
    pub(crate) fn sign_magnitude(&self) -> (bool, [u64; L]) {
        let (is_negative, Limbs(magnitude)) = Limbs::magnitude(self.0);
        (is_negative, magnitude)
    }

    /// The first limbs of the number, filled up with copies of its sign.
    #[inline(always)]
    pub(crate) fn resized<const R: usize>(&self) -> BigInt<R> {
        let fill = if self.is_negative() { u64::MAX } else { 0 };
        let mut limbs = [fill; R];
        for (to, &limb) in limbs.iter_mut().zip(&self.0) {
            *to = limb;
        }
        BigInt(limbs)
    }

    /// x·2^up.
    pub(crate) fn shifted_up(&self, up: usize) -> Self {
        let (limbs, bits) = (up / 64, (up % 64) as u32);
        let mut shifted = Self([0; L]);
        let mut below = 0_u64;
        for (to, &limb) in shifted.0.iter_mut().skip(limbs).zip(&self.0) {
            // In two steps, for a shift of 64 is none.
            *to = limb << bits | below >> 1 >> (63 - bits);
            below = limb;
        }
        shifted
    }

    /// Adds `words`, the least first, shifted up by `shift` bits, or subtracts them.
    #[inline(always)]
    pub(crate) fn accumulate(
        &mut self,
        mut words: impl Iterator<Item = u64>,
        shift: usize,
        negative: bool,
    ) {
        let bit = (shift % 64) as u32;
        let mut below = 0_u64;
        let mut carry = negative; // To subtract is to add the complement, and one.
        for limb in self.0.iter_mut().skip(shift / 64) {
            let next = words.next();
            // Every word has been added. The rest of the sum would only be given zeros, or ones and
            // a carry.
            if next.is_none() && (bit == 0 || below == 0) && carry == negative {
                break;
            }
            let word = next.unwrap_or(0);
            let shifted = word.wrapping_shl(bit) | if bit == 0 { 0 } else { below >> (64 - bit) };
            below = word;
            let addend = if negative { !shifted } else { shifted };
            let (sum, over) = limb.overflowing_add(addend);
            let (sum, over_too) = sum.overflowing_add(carry.into());
            *limb = sum;
            carry = over | over_too;
        }
    }

    /// Adds `x`·`factor`·2^`shift`, or subtracts it.
    #[inline(never)]
    pub(crate) fn add_multiple<const M: usize>(
        &mut self,
        x: &BigInt<M>,
        factor: u64,
        shift: usize,
        negative: bool,
    ) {
        let is_negative = x.is_negative();
        let (first, end) = x.occupied();
        let (mut carry, mut borrow) = (0_u64, is_negative);
        let limbs = x.0.iter().skip(first).take(end.saturating_sub(first)).copied();
        // One more word, for the carry.
        let words = limbs.chain([if is_negative { u64::MAX } else { 0 }]).map(|limb| {
            let limb = if is_negative {
                let (limb, over) = (!limb).overflowing_add(borrow.into());
                borrow = over;
                limb
            } else {
                limb
            };
            let wide = u128::from(limb) * u128::from(factor) + u128::from(carry);
            carry = (wide >> 64) as u64;
            wide as u64
        });
        self.accumulate(words, 64 * first + shift, negative != is_negative);
    }

    /// All limbs below the first index are zero, and all from the second on repeat the sign.
    #[inline(always)]
    fn occupied(&self) -> (usize, usize) {
        let fill = if self.is_negative() { u64::MAX } else { 0 };
        let first = self.0.iter().position(|&limb| limb != 0).unwrap_or(L);
        let end = self.0.iter().rposition(|&limb| limb != fill).map_or(0, |k| k + 1);
        // The magnitude of a negative power of 2^64 has a limb that the number does not have.
        (first, if end > first { end } else { (first + 1).min(L) })
    }

    /// The product, modulo 2^(64·R).
    pub(crate) fn times<const M: usize, const R: usize>(&self, other: &BigInt<M>) -> BigInt<R> {
        let ((is_negative, Limbs(a)), (is_other_negative, Limbs(b))) =
            (Limbs::magnitude(self.0), Limbs::magnitude(other.0));
        let mut product = [0_u64; R];
        for (i, &a) in a.iter().enumerate() {
            if L > 4 && a == 0 {
                continue;
            }
            let mut carry = 0_u64;
            // One limb more, for the carry.
            for (to, j) in product.iter_mut().skip(i).zip(0..=M) {
                let b = b.get(j).copied().unwrap_or(0);
                let wide = u128::from(a) * u128::from(b) + u128::from(*to) + u128::from(carry);
                *to = wide as u64;
                carry = (wide >> 64) as u64;
            }
        }
        let product = BigInt(product);
        if is_negative == is_other_negative { product } else { -product }
    }

    /// The same out of line, with one copy for all kernels. Of long numbers, a limb of `other` at a time:
    /// unrolled loops over both would be a block too large for compilers.
    #[inline(never)]
    pub(crate) fn product<const M: usize, const R: usize>(&self, other: &BigInt<M>) -> BigInt<R> {
        if L <= 8 {
            return self.times(other);
        }
        let (is_negative, limbs) = other.sign_magnitude();
        let mut sum = BigInt([0; R]);
        for (k, &limb) in limbs.iter().enumerate().filter(|(_, limb)| **limb != 0) {
            sum.add_multiple(self, limb, 64 * k, is_negative);
        }
        sum
    }
}

impl<const L: usize> From<i128> for BigInt<L> {
    #[inline(always)]
    fn from(x: i128) -> Self {
        BigInt([x as u64, (x >> 64) as u64]).resized()
    }
}

impl<const L: usize> PartialOrd for BigInt<L> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<const L: usize> Ord for BigInt<L> {
    fn cmp(&self, other: &Self) -> Ordering {
        // If the signs are equal, the limbs compare as unsigned integers.
        other
            .is_negative()
            .cmp(&self.is_negative())
            .then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }
}

// Loops over indices, and in place; see `limbs`.
impl<const L: usize> Add for BigInt<L> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        let mut carry = false;
        for k in 0..L {
            let (sum, over) = self.0[k].overflowing_add(other.0[k]);
            let (sum, over_too) = sum.overflowing_add(carry.into());
            (self.0[k], carry) = (sum, over != over_too);
        }
        self
    }
}

impl<const L: usize> Sub for BigInt<L> {
    type Output = Self;
    fn sub(mut self, other: Self) -> Self {
        let mut borrow = false;
        for k in 0..L {
            let (rest, under) = self.0[k].overflowing_sub(other.0[k]);
            let (rest, under_too) = rest.overflowing_sub(borrow.into());
            (self.0[k], borrow) = (rest, under != under_too);
        }
        self
    }
}

impl<const L: usize> Neg for BigInt<L> {
    type Output = Self;
    fn neg(self) -> Self {
        // A chain of carries alone, of the complement, does not compile for a Cortex-M0 (LLVM 22).
        Self([0; L]) - self
    }
}

impl<const L: usize> Mul for BigInt<L> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.times(&other)
    }
}

impl<const L: usize> Limbed for BigInt<L> {
    fn limbs(&self) -> &[u64] {
        &self.0
    }
}

impl<const L: usize> Number for BigInt<L> {
    const ZERO: Self = Self([0; L]);
    fn is_zero(&self) -> bool {
        self.sign() == Ordering::Equal
    }
    fn is_positive(&self) -> bool {
        self.sign() == Ordering::Greater
    }
    fn magnitude(self) -> Self {
        if self.is_negative() { -self } else { self }
    }
    fn half(mut self) -> Self {
        let mut above = self.0.last().map_or(0, |top| top & 1 << 63);
        for limb in self.0.iter_mut().rev() {
            (*limb, above) = (*limb >> 1 | above, *limb << 63);
        }
        self
    }
    fn portion(self, den: Self, _: [Self; 2]) -> [Soft; 2] {
        [divided_limbs(Limbs(self.0), &Limbs(den.0)); 2]
    }
    fn sign_and_size(self) -> Option<(Ordering, Soft)> {
        signed(self.sign_magnitude())
    }
}

#[cfg(test)]
mod tests;
