//! Constructors of oriented boxes from a rotation.

use super::{Obb, ShapeError, Vec3, finite};
use crate::arithmetic::Each;
use crate::scalar::Scalar;

impl<S: Scalar> Obb<S> {
    /// A box around `center`, rotated by a unit quaternion: x, y, z and then w, the scalar part.
    /// Its axes are the rotated coordinate axes.
    ///
    /// *Geometry*: only the direction of the quaternion counts. Its length, which rounding changes,
    /// has no effect: the axes are the axes of the rotation, rounded. A quaternion whose length
    /// drifts in a simulation does not skew the box.
    ///
    /// *Numerics*: in fixed point each component is the nearest number of the type, computed in
    /// integers. In `f32` a component is off by at most half a unit in its last place plus 2⁻⁵⁰, in
    /// `f64` by at most 2⁻⁵⁰. With h the greatest of these errors, each axis is within √3·h of
    /// length one, and the dot product of two axes is within 2√3·h + 3·h² of zero. In I16F16 h is
    /// 2⁻¹⁷.
    ///
    /// A fixed-point type with one integer bit has no number 1, and takes its greatest number
    /// instead.
    ///
    /// # Errors
    /// * [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`].
    /// * [`ShapeError::NotUnitQuaternion`] if x² + y² + z² + w² differs from 1 by more than a
    ///   quarter, which is more than rounding to 4 fraction bits explains. This check is only
    ///   against mistakes; in fixed point it is exact.
    /// * [`ShapeError::NoUnitLength`] if the scalar has no integer bits.
    /// * [`ShapeError::NotOrthonormal`] in types of fewer than 4 fraction bits, if the rounded axes
    ///   fail the check of [`new`](Self::new).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 10 multiplications and 9 quotients. In fixed point the quotients are computed bit by
    /// bit, and link no division.
    ///
    /// *Source*: the matrix of K. Shoemake, "Animating Rotation with Quaternion Curves", *SIGGRAPH*
    /// 1985, divided by the square of the quaternion's length.
    ///
    /// ```
    /// use septum::{Obb, ShapeError, Vec3};
    ///
    /// // A third of a turn about the diagonal takes x to y, y to z and z to x.
    /// let tool = Obb::from_quaternion([0.0, 0.0, 9.0_f32], [0.5; 4], [2.0, 1.0, 0.5])?;
    /// assert_eq!(tool.axes()[0], Vec3::new(0.0, 1.0, 0.0));
    ///
    /// let twice = Obb::from_quaternion([0.0, 0.0, 9.0_f32], [1.0; 4], [2.0, 1.0, 0.5]);
    /// assert_eq!(twice, Err(ShapeError::NotUnitQuaternion));
    /// # Ok::<(), ShapeError>(())
    /// ```
    pub fn from_quaternion(
        center: impl Into<Vec3<S>>,
        quaternion: [S; 4],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        if let Some(i) = quaternion.iter().position(|x| !x.is_finite()) {
            return Err(ShapeError::NotFinite { argument: "quaternion", index: Some(i) });
        }
        Self::rotated(center, half_extents, || {
            S::by_quaternion(quaternion).ok_or(ShapeError::NotUnitQuaternion)
        })
    }

    /// A box around `center`, rotated about the x axis, then about y, then about z. Angles are in
    /// turns: 1 is 360°.
    ///
    /// *Geometry*: all three rotations are about the fixed coordinate axes. A positive turn about z
    /// takes x to y, about x y to z, about y z to x. To rotate about a single axis, set the other
    /// two turns to zero.
    ///
    /// *Numerics*: the result is the same bits on every machine: fixed point is computed in
    /// integers, and floats by operations that IEEE 754 rounds correctly. Quarter and whole turns
    /// are exact. Elsewhere a component is off by at most half a unit in its last place, plus 2⁻²⁵
    /// in types of up to 16 fraction bits, 2⁻⁵⁷ in other fixed point, 2⁻⁴⁸ in `f32`; in `f64` by at
    /// most 2⁻⁴⁸ in all. The error of lengths and right angles follows as for
    /// [`from_quaternion`](Self::from_quaternion).
    ///
    /// *Range*: any number of turns; whole turns are removed without an error.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], [`ShapeError::NoUnitLength`]
    /// if the scalar has no integer bits, and in types of fewer than 4 fraction bits
    /// [`ShapeError::NotOrthonormal`] if the rounded axes fail the check of [`new`](Self::new).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: about 50 multiplications, in 32-bit words for types of up to 16 fraction bits.
    ///
    #[cfg_attr(feature = "fixed", doc = "```")]
    #[cfg_attr(not(feature = "fixed"), doc = "```ignore")]
    /// use fixed::types::I16F16;
    /// use septum::{Obb, Vec3};
    ///
    /// let at = |p: [f32; 3]| p.map(I16F16::from_num);
    /// let quarter = Obb::from_turns(at([0.0; 3]), at([0.0, 0.0, 0.25]), at([2.0, 1.0, 0.5]))?;
    /// assert_eq!(quarter.axes()[0], Vec3::from(at([0.0, 1.0, 0.0])));
    ///
    /// // 60°: a sixth of a turn, to 16 bits.
    /// let sixth = Obb::from_turns(at([0.0; 3]), at([1.0 / 6.0, 0.0, 0.0]), at([2.0, 1.0, 0.5]))?;
    /// assert!(sixth.axes()[1].y.abs_diff(I16F16::from_num(0.5)) <= 4 * I16F16::DELTA);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn from_turns(
        center: impl Into<Vec3<S>>,
        turns: impl Into<Vec3<S>>,
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let turns = finite("turns", turns)?.to_array();
        Self::rotated(center, half_extents, || Ok(S::by_turns(turns)))
    }

    fn rotated(
        center: impl Into<Vec3<S>>,
        half_extents: impl Into<Vec3<S>>,
        axes: impl FnOnce() -> Result<[[S; 3]; 3], ShapeError>,
    ) -> Result<Self, ShapeError> {
        let none = [[S::ZERO; 3]; 3];
        let made = Self::checked(center, none, half_extents)?;
        if !S::HAS_UNIT_VECTORS {
            return Err(ShapeError::NoUnitLength);
        }
        let axes = axes()?;
        if !S::KEEPS_FRAMES && S::are_orthonormal(&axes) != Some(true) {
            return Err(ShapeError::NotOrthonormal);
        }
        Ok(Self { axes: axes.each(Vec3::from), ..made })
    }
}
