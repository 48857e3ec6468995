//! Quotients place by place, for cores on which a wide division is a call: a loop with a fixed
//! number of steps takes fewer bytes and no more instructions.

use core::cmp::Ordering;

use crate::arithmetic::number::Number;

/// An integer that can be divided by another, place by place.
pub trait WholeVolume: Number {
    /// self·2^`fraction` / `den` rounded down, and the remainder over 2^`fraction`; `None` if the
    /// quotient has more than `places` places. Neither number is negative, `den` is below half of
    /// the greatest number, and `fraction` ≤ `places` ≤ 32.
    fn places(self, den: Self, fraction: u32, places: u32) -> Option<(u32, Self)>;

    /// The quotient to the nearest, ties to even; the greatest number of 32 places if it has too
    /// many.
    fn nearest(self, den: Self, fraction: u32, places: u32) -> u32 {
        let Some((q, rest)) = self.places(den, fraction, places) else { return u32::MAX };
        let other = den - rest;
        q.saturating_add((rest > other || rest == other && q & 1 == 1).into())
    }

    /// Adds the product with `factor` to a sum. The sum is the upper number times 2^32, or times 2
    /// to half the type's bits, plus the lower number: see [`sign_of`](Self::sign_of).
    ///
    /// In `i64` the lower half of the number has a sign, and so is at most 2^31. A factor up to 2^31 then
    /// makes a lower number up to 2^62, one up to 2^30 adds 2^61, and three up to 2^19 add 3·2^50. With
    /// volumes up to 2^59 their upper numbers are up to 2^58, 2^57 and 3·2^46. `i128` has more room.
    fn product_onto(self, sum: (Self, Self), factor: impl Into<Self>) -> (Self, Self);

    /// How such a sum compares with zero.
    fn sign_of(sum: (Self, Self)) -> Ordering;

    /// How self/den compares with t/2^`fraction`, if `places` hold the magnitude of t.
    fn compare_quotient(self, den: Self, fraction: u32, places: u32, t: i64) -> Ordering {
        let is_negative = self < Self::ZERO;
        if is_negative != (t < 0) {
            return if is_negative { Ordering::Less } else { Ordering::Greater };
        }
        let magnitude = match self.magnitude().places(den, fraction, places) {
            None => Ordering::Greater,
            Some((q, rest)) => {
                let above = if rest == Self::ZERO { Ordering::Equal } else { Ordering::Greater };
                u64::from(q).cmp(&t.unsigned_abs()).then(above)
            }
        };
        if is_negative { magnitude.reverse() } else { magnitude }
    }
}

macro_rules! whole {
    ($($whole:ty)*) => {$(
        impl WholeVolume for $whole {
            #[inline(never)]
            fn places(self, den: Self, fraction: u32, places: u32) -> Option<(u32, Self)> {
                let down = places - fraction;
                let mut rest = self >> down;
                if rest >= den {
                    return None;
                }
                // The bits of the dividend leave at the top, and those of the quotient enter at the
                // bottom.
                let mut bits = if down == 0 { 0 } else { (self as u32) << (32 - down) };
                for _ in 0..places {
                    // By a mask instead of a branch, so that all quotients take the same time.
                    rest = rest + rest + (bits >> 31) as Self - den;
                    let is_negative = rest >> (Self::BITS - 1);
                    rest += den & is_negative;
                    bits = (bits << 1).wrapping_add(is_negative as u32).wrapping_add(1);
                }
                Some((bits, rest))
            }

            fn product_onto(
                self,
                (upper, lower): (Self, Self),
                factor: impl Into<Self>,
            ) -> (Self, Self) {
                let factor = factor.into();
                let half = Self::BITS / 2;
                // A sign where there is no room to spare: it takes a subtraction.
                let below =
                    if half == 32 { self << half >> half } else { self - (self >> half << half) };
                let above = (self - below) >> half;
                (upper + above * factor, lower + below * factor)
            }

            fn sign_of((upper, lower): (Self, Self)) -> Ordering {
                let above = upper + (lower >> (Self::BITS / 2));
                let below = lower << (Self::BITS / 2);
                above.cmp(&0).then(if below == 0 { Ordering::Equal } else { Ordering::Greater })
            }
        }
    )*};
}
whole! { i32 i64 i128 }
