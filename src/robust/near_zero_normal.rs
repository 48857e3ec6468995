//! The normal that is nearly nought.
//!
//! # What goes wrong
//!
//! The normal of a triangle is n = e0 × e1, and each component a difference of
//! two products. For a sliver the two are nearly equal, and rounding leaves of
//! the difference little but noise: a direction at random. The plane test of
//! the 2001 paper then asks whether the box lies to one side of a plane that has
//! nothing to do with the triangle, and often it does. The triangle is dropped
//! although it pierces the box. In `f32` this befalls three slivers in a hundred.
//!
//! # What a normal of nought means
//!
//! That the three vertices lie on one line, and nothing else: the triangle is a
//! segment or a point. It lies in many planes and defines none, so the normal
//! axis has no say: everything projects to nought on it and it never separates.
//! The other twelve suffice then. For a segment, the box's face normals and the
//! cross products with the segment's direction are all the axes there are; for a
//! point the face normals are.
//!
//! # Why no epsilon
//!
//! A threshold on |n| must be an area, and there is no area below which a
//! triangle is a segment: the same mesh in millimetres and in kilometres must
//! get the same answer. A threshold relative to the edges is no better. A sliver
//! whose sides are all but parallel still has one plane, and a box can lie just
//! off it, on either side. To skip the plane test there finds overlaps that are
//! none; to keep it loses overlaps that are.
//!
//! # What is done instead
//!
//! The plane test is believed only where its value exceeds the error that the
//! operands allow ([`super::bounds`]). That error does not shrink with n, so a
//! noisy normal is never believed. What is left goes to integers, where n is
//! what it is, nought included. There is no third case.

use core::cmp::Ordering;

use super::ExactTriangle;
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<S: Scalar> Triangle<S> {
    /// Whether the three vertices lie on one line, or in one point.
    ///
    /// *Numerics*: exact for every input; a sliver of any proportions is none.
    ///
    /// *Contact*: no query needs this to be asked first. Degenerate triangles
    /// are segments and points, and are answered exactly as such.
    ///
    /// *Panics*: never. *Cost*: three sums of eight products, by long
    /// accumulation; meant for checking a mesh, not for an inner loop.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// // In f32 the cross product of these edges rounds to nought.
    /// let (b, c) = ([1.000122, 1.0, 0.0], [2.000122, 1.999878, 0.0]);
    /// let sliver = Triangle::new([0.0_f32; 3], b, c)?;
    /// assert!(!sliver.is_degenerate());
    /// let segment = Triangle::new([0.0_f32; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0])?;
    /// assert!(segment.is_degenerate());
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn is_degenerate(&self) -> bool {
        let exact = ExactTriangle::new(&self.points());
        (0..3).all(|i| exact.normal_sign::<S>(i) == Ordering::Equal)
    }
}
