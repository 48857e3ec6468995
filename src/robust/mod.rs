//! How a doubtful sign is settled, and what becomes of a normal that is nearly zero.
//!
//! A question is a [`Predicate`]: it can answer itself in any number system that its
//! coordinates can be brought into. A scalar lists the systems to ask, the cheapest first:
//! its cascade ([`cascade`]). Each stage returns an answer only where it is certain of it.
//! Integers are certain wherever they hold the input. Floats compute each axis with a bound
//! on its error, and gather two flags over all axes ([`Uncertain`]): some axis separates
//! for certain, and some axis may separate. Where the flags agree they are the answer;
//! where they differ the question escalates. The last stage runs the same kernel
//! in exact integers, so it is right for every finite input: in [`Window`] where that holds
//! the coordinates, and in the scalar's `Full` numbers elsewhere. Some pairs add signed products
//! of the coordinates as given in one long accumulator instead ([`ExactSum`]).
//!
//! [`Window`]: crate::arithmetic::Window
//!
//! An answer is given only where it is the exact one. So the order and the number of the
//! stages change its time and never its value. How often questions escalate is counted in
//! unit tests (`stages`).

mod cascade;
mod determinant;
mod exact_sum;
mod near_zero_normal;
mod predicate;
mod stages;
mod uncertain;

pub(crate) use cascade::{
    exact_stage, in_exact_numbers, in_floats, in_quads, integer_stage, multiples_stage,
    numeric_stage, refined_stage,
};
#[cfg(feature = "fixed")]
pub(crate) use cascade::{narrow_stage, only_stage, short_stage, stage, volume_stage};
pub(crate) use determinant::{
    Linear, Vector, add_area, add_determinant, add_scaled_determinant, difference, sign, single,
};
pub use exact_sum::ExactSum;
pub(crate) use exact_sum::Sum;
pub use predicate::{Clue, Predicate};
#[cfg(all(test, feature = "fixed"))]
pub(crate) use stages::escalations;
pub(crate) use stages::{Stage, note};
pub(crate) use uncertain::{Uncertain, certain_sign};
