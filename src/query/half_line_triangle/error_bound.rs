//! How far the area and the volume of a point and a triangle may be from the truth, to first
//! order in u, the unit roundoff.
//!
//! * The area is a difference of two products a and b of two differences each: 2 roundings for
//!   the differences, 1 for the product, and 1 for the last difference, of at most |a| + |b|.
//!   In all 4 of |a| + |b|; [`TURN`] = 6, for second orders and for the roundings of the bound.
//!   What underflow takes is below the least normal number, which is added.
//! * The volume, in units of u·R³, with R the greatest component of the three corners seen from
//!   the point: 6 terms, each a product of three differences and so at most R³. 8 roundings
//!   touch a term: 3 differences, 2 products, 1 difference of products, 2 sums. 6·8 = 48;
//!   [`VOLUME`] = 50. R is within [`Float::RANGE`](crate::arithmetic::Float::RANGE), so
//!   underflow does not matter.
//!
//! In integers for coordinates below 2^k (see `arithmetic::integer`) a difference is below
//! 2^(k+1), the area below 2^(2k+3), the volume below 6·2^(3k+3), and by size below 6·2^(3m):
//! no more than what boxes take.
//!
//! `error_bound.g` proves both bounds, second orders and underflow included.

/// Roundoffs in the area, per sum of its products.
pub(super) const TURN: u16 = 6;

/// Roundoffs in the volume, per cube of its size.
pub(super) const VOLUME: u16 = 50;
