//! How a doubtful sign is decided, and how a nearly zero normal is treated.
//!
//! A question is a [`Predicate`]: it can be evaluated in every number system that can hold its
//! coordinates. A scalar lists the systems to ask, the cheapest first, as its cascade
//! ([`cascade`]). Each stage returns an answer only if it is certain. Integers are certain if they
//! hold the input. Floats compute each axis with a bound on its error, and gather two flags over
//! all axes ([`Uncertain`]): some axis certainly separates, and some axis may separate. If the
//! flags agree, they are the answer; if they differ, the question escalates.
//!
//! The last stage is right for every finite input. It runs the same kernel in exact integers: in
//! [`Window`] if that holds the coordinates, and otherwise in the scalar's `Full` numbers. For some
//! pairs it adds signed products of the given coordinates in one long accumulator ([`ExactSum`]).
//!
//! [`Window`]: crate::arithmetic::Window
//!
//! Each answer is the exact one, so the order and the number of the stages change its time and
//! never its value. Unit tests count how often questions escalate (`stages`).

mod cascade;
mod determinant;
mod exact_sum;
mod near_zero_normal;
mod predicate;
mod stages;
mod uncertain;

pub(crate) use cascade::{
    exact_stage, in_floats, in_quads, integer_stage, numeric_stage, refined_stage,
};
#[cfg(feature = "fixed")]
pub(crate) use cascade::{only_stage, stage};
pub(crate) use determinant::{
    Linear, Vector, add_area, add_determinant, add_scaled_determinant, difference, sign, single,
};
pub use exact_sum::ExactSum;
pub(crate) use exact_sum::Sum;
pub(crate) use predicate::in_exact_numbers;
pub use predicate::{Clue, Numeric, Predicate, Profile, WordKernel};
#[cfg(all(test, feature = "fixed"))]
pub(crate) use stages::escalations;
pub(crate) use stages::{Stage, note, noted};
pub(crate) use uncertain::{Uncertain, certain_sign};
