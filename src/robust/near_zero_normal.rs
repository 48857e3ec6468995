//! The nearly zero normal.
//!
//! # What goes wrong
//!
//! The normal of a triangle is n = e0 × e1, and each component is a difference of two products. In
//! a sliver the two are nearly equal, and their difference is mostly rounding error: the normal has
//! a random direction. The plane test of the 2001 paper then asks whether the box lies to one side
//! of an unrelated plane, and often it does. The triangle is dropped although it pierces the box.
//! In `f32` this happens to 3 slivers in 100 (`docs/experiments/accuracy.txt`).
//!
//! # The meaning of a normal of zero
//!
//! The three vertices lie on one line: the triangle is a segment or a point. Everything projects to
//! zero on a zero normal, so that axis never separates; the remaining twelve suffice. For a segment
//! the axes are the box's face normals and their cross products with the segment; for a point they
//! are the face normals.
//!
//! # Why no epsilon
//!
//! A threshold on |n| would have to be an area, and there is no area below which a triangle is a
//! segment: the same mesh must get the same answers in millimetres and in kilometres. A threshold
//! relative to the edges fails too. A sliver with almost parallel sides still has one plane, and a
//! box can lie just off it on either side. Skipping the plane test there finds overlaps that do not
//! exist, and keeping it loses overlaps that do.
//!
//! # The remedy
//!
//! The plane test counts only if its value exceeds the error that its operands allow
//! (`query/triangle_aabb/error_bound.rs`). That error does not shrink with n, so a noisy normal
//! never decides. A doubtful sign escalates ([`super::cascade`]) to wider numbers and at last to
//! exact integers, in which n is exact, zero included. There is no third case.
