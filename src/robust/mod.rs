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
//! never its value. Unit tests count how often questions escalate.
//!
//! # The nearly zero normal
//!
//! ## What goes wrong
//!
//! The normal of a triangle is n = e0 × e1, and each component is a difference of two products. In
//! a sliver the two are nearly equal, and their difference is mostly rounding error: the normal has
//! a random direction. The plane test of the 2001 paper then asks whether the box lies to one side
//! of an unrelated plane, and often it does. The triangle is dropped although it pierces the box.
//! In `f32` this happens to 3 slivers in 100 (`docs/experiments/accuracy.txt`).
//!
//! ## The meaning of a normal of zero
//!
//! The three vertices lie on one line: the triangle is a segment or a point. Everything projects to
//! zero on a zero normal, so that axis never separates; the remaining twelve suffice. For a segment
//! the axes are the box's face normals and their cross products with the segment; for a point they
//! are the face normals.
//!
//! ## Why no epsilon
//!
//! A threshold on |n| would have to be an area, and there is no area below which a triangle is a
//! segment: the same mesh must get the same answers in millimetres and in kilometres. A threshold
//! relative to the edges fails too. A sliver with almost parallel sides still has one plane, and a
//! box can lie just off it on either side. Skipping the plane test there finds overlaps that do not
//! exist, and keeping it loses overlaps that do.
//!
//! ## The remedy
//!
//! The plane test counts only if its value exceeds the error that its operands allow
//! (`query/triangle_aabb/error_bound.rs`). That error does not shrink with n, so a noisy normal
//! never decides. A doubtful sign escalates ([`cascade`]) to wider numbers and at last to
//! exact integers, in which n is exact, zero included. There is no third case.

mod cascade;
mod determinant;
mod exact_sum;
mod predicate;
mod uncertain;

#[cfg(all(test, feature = "fixed"))]
pub(crate) use cascade::escalations;
pub(crate) use cascade::{
    Stage, exact_stage, in_cut_floats, in_floats, in_quads, integer_stage, note, noted,
    numeric_stage, refined_stage,
};
#[cfg(feature = "fixed")]
pub(crate) use cascade::{only_stage, stage};
pub(crate) use determinant::{
    Linear, Vector, add_area, add_determinant, add_minor, along_axis, difference, differences,
    minor_sign, side, sign, single, singles,
};
pub use exact_sum::ExactSum;
pub(crate) use exact_sum::Sum;
pub(crate) use predicate::{Backend, FixedBackend, in_exact_numbers};
pub use predicate::{Clue, FloatFormat, Numeric, Predicate, Profile, WordKernel};
pub(crate) use uncertain::{Uncertain, certain_sign};
