//! Quotients place by place, for cores on which a division of more than a register is a call:
//! a loop of a fixed number of steps takes fewer bytes and no more instructions.

use core::cmp::Ordering;

use crate::arithmetic::number::Number;

/// A whole number that can be divided by another, place by place.
pub trait WholeVolume: Number {
    /// self·2^`fraction` / `den` rounded down, and what is left of it over 2^`fraction`; `None`
    /// where it has more than `places` places. Neither is negative, `den` is below half of what
    /// the type holds, and `fraction` ≤ `places` ≤ 32.
    fn places(self, den: Self, fraction: u32, places: u32) -> Option<(u32, Self)>;

    /// The same to the nearest, of two the even one; the greatest number of 32 places where it
    /// has too many.
    fn nearest(self, den: Self, fraction: u32, places: u32) -> u32 {
        let Some((q, rest)) = self.places(den, fraction, places) else { return u32::MAX };
        let other = den - rest;
        q.saturating_add((rest > other || rest == other && q & 1 == 1).into())
    }

    /// The product with `factor` added to a sum, which is the upper number times 2^32, or what
    /// half of the type has, and the lower: see [`sign_of`](Self::sign_of).
    ///
    /// In `i64` a factor up to 2^30 makes a lower number below 2^62, and three up to 2^19 another
    /// 3·2^51. Volumes up to 2^59 have upper numbers below 2^58. `i128` has more room.
    fn product_onto(self, sum: (Self, Self), factor: impl Into<Self>) -> (Self, Self);

    /// How such a sum compares with zero.
    fn sign_of(sum: (Self, Self)) -> Ordering;

    /// How self/den compares with t/2^`fraction`, where `places` hold the magnitude of t.
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
                // The bits of the dividend go out at the top, those of the quotient come in
                // below.
                let mut bits = if down == 0 { 0 } else { (self as u32) << (32 - down) };
                for _ in 0..places {
                    // By a mask, not by a branch: all quotients take the same time.
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
                let above = self >> (Self::BITS / 2);
                let below = self - (above << (Self::BITS / 2));
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
