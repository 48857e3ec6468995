//! Unsigned integers of any size, and their long division.

use core::cmp::Ordering;

/// An unsigned integer for long division and roots.
pub trait Wide: Copy + Ord {
    /// Subtracts another number, which is not greater.
    fn subtract(&mut self, other: &Self);
    /// Twice the number, which fits.
    fn double(&mut self);
    /// How many binary places the number has.
    fn width(&self) -> u32;
    /// Times two to the power `places`, which fits.
    fn shift_up(&mut self, places: u32);
}

macro_rules! wide {
    ($($t:ty)*) => {$(
        impl Wide for $t {
            #[inline(always)]
            fn subtract(&mut self, other: &Self) {
                *self -= *other;
            }
            #[inline(always)]
            fn double(&mut self) {
                *self <<= 1;
            }
            #[inline(always)]
            fn width(&self) -> u32 {
                Self::BITS - self.leading_zeros()
            }
            #[inline(always)]
            fn shift_up(&mut self, places: u32) {
                *self <<= places;
            }
        }
    )*};
}
wide! { u128 }
#[cfg(feature = "fixed")]
wide! { u64 }

/// An unsigned integer of L limbs, the least first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limbs<const L: usize>(pub(crate) [u64; L]);

impl<const L: usize> Limbs<L> {
    /// The magnitude of a number in two's complement, and whether it is below zero.
    // Negated in place. If one of two branches negates a copy by value, optimized builds of rustc 1.95
    // to 1.97 read the sign from the negated number.
    #[inline(always)]
    pub(crate) fn magnitude(mut limbs: [u64; L]) -> (bool, Self) {
        let is_negative = limbs.last().is_some_and(|top| top >> 63 != 0);
        if is_negative {
            let mut carry = true;
            for limb in &mut limbs {
                (*limb, carry) = (!*limb).overflowing_add(carry.into());
            }
        }
        (is_negative, Self(limbs))
    }
}

impl<const L: usize> Ord for Limbs<L> {
    #[inline(always)]
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.iter().rev().cmp(other.0.iter().rev())
    }
}

impl<const L: usize> PartialOrd for Limbs<L> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

// Loops over indices, and in place: iterators over two arrays, or limbs of `u128`, took three to
// six times as long, and new arrays of many limbs twice.
impl<const L: usize> Wide for Limbs<L> {
    #[inline(always)]
    fn subtract(&mut self, other: &Self) {
        let mut borrow = false;
        for k in 0..L {
            let (rest, under) = self.0[k].overflowing_sub(other.0[k]);
            let (rest, under_too) = rest.overflowing_sub(borrow.into());
            (self.0[k], borrow) = (rest, under | under_too);
        }
    }
    #[inline(always)]
    fn double(&mut self) {
        let mut carry = 0;
        for k in 0..L {
            (self.0[k], carry) = (self.0[k] << 1 | carry, self.0[k] >> 63);
        }
    }
    #[inline(always)]
    fn width(&self) -> u32 {
        let top = self.0.iter().rposition(|&limb| limb != 0).unwrap_or(0);
        64 * top as u32 + self.0.get(top).map_or(0, |limb| 64 - limb.leading_zeros())
    }
    #[inline(always)]
    fn shift_up(&mut self, places: u32) {
        for _ in 0..places / 64 {
            self.0.rotate_right(1);
        }
        (0..places % 64).for_each(|_| self.double());
    }
}

/// The first `count` binary places of num/den, beginning with the ones, by long division; and the
/// doubled remainder in units of the last place. `num` is below twice `den`, which can be doubled.
#[inline(always)]
pub(super) fn divided_by_places<W: Wide>(num: W, den: &W, count: u32) -> (u64, W) {
    let (mut quotient, mut rest) = (0, num);
    for _ in 0..count {
        quotient <<= 1;
        if rest >= *den {
            rest.subtract(den);
            quotient |= 1;
        }
        rest.double();
    }
    (quotient, rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::Each;

    #[test]
    fn limbs_carry() {
        let all = Limbs([u64::MAX, u64::MAX, u64::MAX, 0]);
        let one = Limbs([1, 0, 0, 0]);
        let next = Limbs([0, 0, 0, 1]);
        let with = |mut x: Limbs<4>, change: fn(&mut Limbs<4>)| {
            change(&mut x);
            x
        };
        assert!(Limbs([0; 4]) < one && one < all && all < next);
        assert_eq!(with(next, |x| x.subtract(&Limbs([1, 0, 0, 0]))), all);
        assert_eq!(with(all, Wide::double), Limbs([u64::MAX - 1, u64::MAX, u64::MAX, 1]));
        assert_eq!([Limbs([0; 4]), one, all, next].each(|x| x.width()), [0, 1, 192, 193]);
        assert_eq!(with(one, |x| x.shift_up(192)), next);
        assert_eq!(with(one, |x| x.shift_up(65)), Limbs([0, 2, 0, 0]));
        assert_eq!(Limbs::magnitude([u64::MAX; 4]), (true, one));
        assert_eq!(Limbs::magnitude([0, 0, 0, u64::MAX]), (true, next));
        assert_eq!(Limbs::magnitude(all.0), (false, all));
    }

    #[test]
    fn places_are_those_of_division() {
        for den in 1..=40_u128 {
            for num in 0..2 * den {
                for count in 0..20 {
                    let quotient = ((num << count) / (2 * den)) as u64;
                    let rest = (num << count) % (2 * den);
                    assert_eq!(divided_by_places(num, &den, count), (quotient, rest));
                    let limbs = |x: u128| Limbs([0, x as u64, 0]);
                    let places = divided_by_places(limbs(num), &limbs(den), count);
                    assert_eq!(places, (quotient, limbs(rest)));
                }
            }
        }
    }
}
