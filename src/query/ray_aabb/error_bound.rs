//! How far the values of t of a prepared ray may be from the truth.
//!
//! Let n be the greatest t of entry, f the least of exit, both as computed, and u the unit
//! roundoff. Where n and f are farther apart than they can both err, their order is the true
//! one, and it says whether the ray meets the box.
//!
//! # No underflow, no overflow
//!
//! Every t is in units of 1/scale. For `f32` the scale is 2⁶⁴, and the components of the
//! direction that a ray is prepared for are between 2⁻⁴⁰ and 2⁴⁰ or zero. So a reciprocal,
//! scale/d, is between 2²⁴ and 2¹⁰⁴. A difference of coordinates is zero or at least 2⁻¹⁴⁹,
//! so a t is zero, and exactly so, or at least 2⁻¹²⁵: it does not underflow. `f64` has 2⁵¹²,
//! 2⁻⁴⁰⁰ and 2⁴⁰⁰, and a t of at least 2⁻⁹⁶². Integers have no smaller difference than one.
//!
//! A t that overflows, be it in the difference or in the product, is beyond every finite t in
//! truth as well, and its sign is right. A t of entry of −∞ or a t of exit of +∞ constrains
//! nothing, as it should: where the range is open it ends at the greatest number. If n is +∞,
//! then f is certain to be less in truth where f as computed is clear of the greatest number;
//! and so for f = −∞ where n ≥ 0. In every other case both comparisons are false, and the
//! question is in doubt. For a box given by its centre the bound contains every t, and is
//! infinite where one overflows.
//!
//! # By corners
//!
//! A t is the product of a difference and a reciprocal. In floats a difference, a division
//! and a product round: 3u of itself. Integers of up to 32 bits have no rounding in the
//! difference; those of 64 have it there and where the direction is converted: 4u. Maximum
//! and minimum are of numbers as computed, and the ends of the range are exact, so n errs by
//! at most 4u·|n| and f by 4u·|f|. If n ≥ 0, then n < f is certain from f > n·(1 + 9u) on:
//! (1 + 9u)·(1 − 4u) > 1 + 4u, second orders included. A unit in the last place of n is more
//! than u·n, so ten units are enough: [`CORNERS`] = 10. Likewise for f < n, and a negative
//! f is certain to be less.
//!
//! For n of either sign the bound is added: n + 10u·|n|. The sum errs by u of itself, and the
//! bound, which in `f32` may be a subnormal number of at least 10·2⁻¹⁴⁹, by 2⁻¹⁵⁰: half of one
//! u. 8.5u are left of ten, where 8u and second orders are needed.
//!
//! # By centre
//!
//! With p the difference from origin to centre, h the half-extent and r the reciprocal, the
//! values of t are p·r ∓ h·|r|. p·r errs by 3u of itself, in 64 bits by 4u, as above; h·|r|
//! by 2u, in 64 bits by 4u; their sum and difference by u of itself: together 5u of
//! |p·r| + h·|r|, and n and f by 10u of the greatest of those sums, M. The sum of n and the
//! bound errs by another u·M, a subnormal bound by u·M/2. [`CENTER`] = 14 leaves two for
//! second orders. Where n is the beginning of the range, and beyond 2M, the ray is past the
//! box by more than all of these.

use crate::arithmetic::Span;

/// Units in the last place, or roundoffs, of n or f.
pub(super) const CORNERS: u16 = 10;

/// Roundoffs, of the greatest |p·r| + h·|r|.
const CENTER: u16 = 14;

/// The bound for a box given by its corners, for |n| or |f|.
#[inline(always)]
pub(super) fn by_corners<F: Span>(size: F) -> F {
    size.error(CORNERS)
}

/// The bound for a box given by its centre, for the greatest |p·r| + h·|r|.
#[inline(always)]
pub(super) fn by_center<F: Span>(size: F) -> F {
    size.error(CENTER)
}
