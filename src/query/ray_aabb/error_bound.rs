//! The errors of the values of t of a prepared ray.
//!
//! n is the greatest t of entry and f the least t of exit, both as computed; u is the unit
//! roundoff. If n and f are farther apart than their errors together, their order is the true one,
//! and it decides whether the ray meets the box.
//!
//! # No underflow, no overflow
//!
//! Every t is in units of 1/scale. In `f32` the scale is 2⁶⁴, and a ray is prepared if the
//! components of its direction are zero or between 2⁻⁴⁰ and 2⁴⁰. A reciprocal, scale/d, is
//! therefore between 2²⁴ and 2¹⁰⁴. A difference of coordinates is zero or at least 2⁻¹⁴⁹, so a t is
//! exactly zero or at least 2⁻¹²⁵, and does not underflow. In `f64` the limits are 2⁵¹², 2⁻⁴⁰⁰ and
//! 2⁴⁰⁰, and a t of at least 2⁻⁹⁶². Integers have no smaller difference than one.
//!
//! If a t overflows, in the difference or in the product, the true t is beyond every finite t too,
//! and the sign is right. A t of entry of −∞ or a t of exit of +∞ excludes nothing, which is
//! correct: an open range ends at the greatest number. If n is +∞, the true f is certainly less if
//! the computed f is clear of the greatest number. The same holds for f = −∞ with n ≥ 0. In all
//! other cases both comparisons are false, and the query is in doubt. For a box given by its centre
//! the bound contains every t, and is infinite if one overflows.
//!
//! # By corners
//!
//! A t is the product of a difference and a reciprocal. In floats a difference, a division and a
//! product round: 3u of itself. Integers of up to 32 bits have an exact difference; differences of
//! 64 bits round it and the direction: 4u. `error_bound.g` proves that f > n·(1 + 9u) is certain
//! for n ≥ 0. A unit in the last place of n is more than u·n, so [`CORNERS`] units suffice. The
//! same holds with f and n exchanged, and a negative f is certainly less.
//!
//! For any sign of n the bound is added, as n + [`CORNERS`]·u·|n|. The sum errs by u of itself.
//! In `f32` the bound may be subnormal; it is then at least 10·2⁻¹⁴⁹ and errs by 2⁻¹⁵⁰, which is
//! half of one u. So 8.5u of the bound remain, and the errors with second orders are less.
//!
//! # By centre
//!
//! With p the difference from origin to centre, h the half-extent and r the reciprocal, the values
//! of t are p·r ∓ h·|r|. `error_bound.g` proves that [`CENTER`] roundoffs of the greatest |p·r| +
//! h·|r| cover the errors of n and f and of the sum with the bound. If n is the beginning of the
//! range and more than twice that size, the ray begins past the box by more than all of these
//! errors.

/// Units in the last place, or roundoffs, of n or f, for a box given by its corners.
pub(super) const CORNERS: u16 = 10;

/// Roundoffs, of the greatest |p·r| + h·|r|, for a box given by its centre.
pub(super) const CENTER: u16 = 14;
