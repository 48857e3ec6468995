//! Oriented boxes by a rotation.

use super::{Obb, ShapeError, Vec3, finite};
use crate::scalar::Scalar;

impl<S: Scalar> Obb<S> {
    /// The box around `center` whose axes are those of space, rotated by a unit
    /// quaternion: x, y, z and then w, the scalar part.
    ///
    /// *Geometry*: only the direction of the quaternion counts. It is a rotation whatever
    /// rounding did to the length, and the axes are those of that rotation, rounded. So axes
    /// do not drift out of right angles where a simulation's quaternion drifts in length.
    ///
    /// *Numerics*: in fixed point each component is the nearest number of the type,
    /// by integers alone. In `f32` a component is off by half a unit in its last
    /// place and 2⁻⁵⁰ more, in `f64` by 2⁻⁵⁰. So each axis is within √3·h of length one, and
    /// dot products of two are within 2√3·h + 3·h² of zero, h being the greatest of these errors:
    /// 2⁻¹⁷ in I16F16.
    ///
    /// A fixed-point type without a number 1, which has one integer bit, takes its greatest
    /// number instead.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], and
    /// [`ShapeError::NotUnitQuaternion`] where x² + y² + z² + w² is farther than a quarter from 1:
    /// rounding to 4 fraction bits does not take it there. As the length has no part in the axes,
    /// the check is against mistakes only. In fixed point it is exact.
    /// [`ShapeError::NoUnitLength`] where the scalar has no integer bits. In types of fewer
    /// than 4 fraction bits [`ShapeError::NotOrthonormal`] where rounding leaves no frame, as
    /// [`new`](Self::new) would say.
    ///
    /// *Panics*: never. *Cost*: 10 multiplications and 9 quotients; in fixed point these are
    /// bit by bit, and link no division.
    ///
    /// *Source*: the matrix of K. Shoemake, "Animating Rotation with Quaternion Curves",
    /// *SIGGRAPH* 1985, over the square of the quaternion.
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
        if !quaternion.iter().all(|x| x.is_finite()) {
            return Err(ShapeError::NotFinite);
        }
        Self::rotated(center, half_extents, || {
            S::by_quaternion(quaternion).ok_or(ShapeError::NotUnitQuaternion)
        })
    }

    /// The box around `center` whose axes are those of space, turned about x, then about
    /// y, then about z: by so many turns each, 360° being one.
    ///
    /// *Geometry*: the axes of rotation stay those of space. A positive turn about z takes x
    /// to y, about x y to z, about y z to x. For one axis alone the other two turns are zero.
    ///
    /// *Numerics*: by integers alone in fixed point, and by operations that IEEE 754 rounds in
    /// floats: the same bits on every machine. Whole turns and quarters leave no error. Else a
    /// component is off by half a unit in its last place, and 2⁻²⁵ more in types of up to 16
    /// fraction bits, 2⁻⁵⁷ in other fixed point, 2⁻⁴⁸ in `f32`; in `f64` by 2⁻⁴⁸ altogether.
    /// How far axes may be from length one and from right angles follows as with
    /// [`from_quaternion`](Self::from_quaternion).
    ///
    /// *Range*: any number of turns; whole ones are left out without an error.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`],
    /// [`ShapeError::NoUnitLength`] where the scalar has no integer bits, and in types of fewer
    /// than 4 fraction bits [`ShapeError::NotOrthonormal`] where rounding leaves no frame.
    ///
    /// *Panics*: never. *Cost*: some 50 multiplications, in words of 32 bits for types of up to
    /// 16 fraction bits.
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
        let turns = finite(turns)?.to_array();
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
        Ok(Self { axes: axes.map(Vec3::from), ..made })
    }
}
