//! Constructors for `const` tables in flash.
//!
//! A `const fn` cannot call trait methods, so the generic constructors cannot be `const`. These
//! constructors exist once for each family of scalars, and make the same checks. Only the `f32`
//! versions appear in the documentation; all are alike.

use super::Vec3;
use super::aabb::Form;
use super::plane::Form as PlaneForm;
use super::segment::Form as SegmentForm;
use super::{Aabb, Capsule, Obb, Plane, Polygon, Ray, Segment, ShapeError, Sphere, Triangle};
use crate::scalar::axes::{are_orthonormal_f32, are_orthonormal_f64};

/// The error of the first argument that is not finite.
const fn all_finite<const N: usize>(
    arguments: [(bool, &'static str); N],
) -> Result<(), ShapeError> {
    let mut i = 0;
    while i < N {
        let (is_finite, argument) = arguments[i];
        if !is_finite {
            return Err(ShapeError::NotFinite { argument, index: None });
        }
        i += 1;
    }
    Ok(())
}

/// The constructors for one family: whether a number is finite, and as a value that a `const fn` can
/// compare.
macro_rules! const_new {
    ($(#[$attr:meta])* [$($generic:tt)*] $scalar:ty, $zero:expr, |$x:ident| $is_finite:expr,
     |$y:ident| $value:expr, |$axes:ident| $orthonormal:expr) => {
        impl<$($generic)*> Vec3<$scalar> {
            const CONST_ZERO: Self = Self::new($zero, $zero, $zero);

            const fn const_is_finite(self) -> bool {
                let (all, mut i) = ([self.x, self.y, self.z], 0);
                while i < 3 {
                    let $x = all[i];
                    if !$is_finite {
                        return false;
                    }
                    i += 1;
                }
                true
            }

            /// As `all_finite`, for the elements of one argument.
            const fn const_list_is_finite(
                argument: &'static str,
                list: &[Self],
            ) -> Result<(), ShapeError> {
                let mut i = 0;
                while i < list.len() {
                    if !list[i].const_is_finite() {
                        return Err(ShapeError::NotFinite { argument, index: Some(i) });
                    }
                    i += 1;
                }
                Ok(())
            }

            /// Whether a component exceeds its counterpart in `other`.
            const fn const_exceeds(self, other: Self) -> bool {
                let (a, b) = ([self.x, self.y, self.z], [other.x, other.y, other.z]);
                let mut i = 0;
                while i < 3 {
                    let ($y, b) = (b[i], a[i]);
                    let most = $value;
                    let $y = b;
                    if $value > most {
                        return true;
                    }
                    i += 1;
                }
                false
            }

            const fn const_is_zero(self) -> bool {
                !self.const_exceeds(Self::CONST_ZERO) && !Self::CONST_ZERO.const_exceeds(self)
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Triangle<$scalar> {
            /// [`Triangle::new`] for a `const` or a `static`, such as a table in flash.
            ///
            /// It exists for every scalar, which has to be named: `Triangle::<I16F16>::const_new`.
            /// [`ShapeError::unwrap`] turns a refused shape into a compile error.
            ///
            /// # Errors
            /// As [`Triangle::new`].
            ///
            #[cfg_attr(feature = "fixed", doc = "```")]
            #[cfg_attr(not(feature = "fixed"), doc = "```ignore")]
            /// use fixed::types::I16F16;
            /// use septum::{Aabb, ShapeError, Triangle, Vec3};
            ///
            /// const fn at(x: i16, y: i16, z: i16) -> Vec3<I16F16> {
            ///     Vec3::new(
            ///         I16F16::from_bits((x as i32) << 16),
            ///         I16F16::from_bits((y as i32) << 16),
            ///         I16F16::from_bits((z as i32) << 16),
            ///     )
            /// }
            /// const fn triangle(vertices: [Vec3<I16F16>; 3]) -> Triangle<I16F16> {
            ///     let [a, b, c] = vertices;
            ///     ShapeError::unwrap(Triangle::<I16F16>::const_new(a, b, c))
            /// }
            /// static TABLE: [Triangle<I16F16>; 2] = [
            ///     triangle([at(0, 0, 0), at(1, 0, 0), at(0, 1, 0)]),
            ///     triangle([at(4, 0, 0), at(5, 0, 0), at(4, 1, 9)]),
            /// ];
            ///
            /// let cell = Aabb::from_min_max(at(4, 0, 0), at(9, 9, 9))?;
            /// assert_eq!(TABLE.iter().filter(|t| t.overlaps(&cell)).count(), 1);
            /// # Ok::<(), ShapeError>(())
            /// ```
            pub const fn const_new(
                a: Vec3<$scalar>,
                b: Vec3<$scalar>,
                c: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                match all_finite([
                    (a.const_is_finite(), "a"),
                    (b.const_is_finite(), "b"),
                    (c.const_is_finite(), "c"),
                ]) {
                    Ok(()) => Ok(Self { vertices: [a, b, c] }),
                    Err(error) => Err(error),
                }
            }
        }

        $(#[$attr])*
        impl<'a, $($generic)*> Polygon<'a, $scalar> {
            /// [`Polygon::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Polygon::new`].
            pub const fn const_new(vertices: &'a [Vec3<$scalar>]) -> Result<Self, ShapeError> {
                if vertices.len() < 3 {
                    return Err(ShapeError::TooFewVertices);
                }
                match Vec3::<$scalar>::const_list_is_finite("vertices", vertices) {
                    Ok(()) => Ok(Self { vertices }),
                    Err(error) => Err(error),
                }
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Aabb<$scalar> {
            /// [`Aabb::from_min_max`] for a `const` or a `static`: see
            /// [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Aabb::from_min_max`].
            pub const fn const_new(
                min: Vec3<$scalar>,
                max: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let ends = [(min.const_is_finite(), "min"), (max.const_is_finite(), "max")];
                if let Err(error) = all_finite(ends) {
                    return Err(error);
                }
                if min.const_exceeds(max) {
                    return Err(ShapeError::MinAboveMax);
                }
                Ok(Self { form: Form::Corners { min, max } })
            }

            /// [`Aabb::from_center_half_extents`] for a `const` or a `static`: see
            /// [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Aabb::from_center_half_extents`].
            pub const fn const_from_center_half_extents(
                center: Vec3<$scalar>,
                half_extents: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                if let Err(error) = all_finite([
                    (center.const_is_finite(), "center"),
                    (half_extents.const_is_finite(), "half_extents"),
                ]) {
                    return Err(error);
                }
                if Vec3::<$scalar>::CONST_ZERO.const_exceeds(half_extents) {
                    return Err(ShapeError::NegativeHalfExtent);
                }
                Ok(Self { form: Form::Center { center, half: half_extents } })
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Obb<$scalar> {
            /// [`Obb::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Obb::new`].
            pub const fn const_new(
                center: Vec3<$scalar>,
                axes: [Vec3<$scalar>; 3],
                half_extents: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let [u, v, w] = axes;
                if let Err(error) = all_finite([
                    (center.const_is_finite(), "center"),
                    (half_extents.const_is_finite(), "half_extents"),
                ]) {
                    return Err(error);
                }
                if let Err(error) = Vec3::<$scalar>::const_list_is_finite("axes", &axes) {
                    return Err(error);
                }
                if Vec3::<$scalar>::CONST_ZERO.const_exceeds(half_extents) {
                    return Err(ShapeError::NegativeHalfExtent);
                }
                let $axes = [[u.x, u.y, u.z], [v.x, v.y, v.z], [w.x, w.y, w.z]];
                match $orthonormal {
                    Some(true) => Ok(Self { center, axes, half: half_extents }),
                    Some(false) => Err(ShapeError::NotOrthonormal),
                    None => Err(ShapeError::NoUnitLength),
                }
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Segment<$scalar> {
            /// [`Segment::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Segment::new`].
            pub const fn const_new(
                a: Vec3<$scalar>,
                b: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                match all_finite([(a.const_is_finite(), "a"), (b.const_is_finite(), "b")]) {
                    Ok(()) => Ok(Self { form: SegmentForm::Ends(a, b) }),
                    Err(error) => Err(error),
                }
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Sphere<$scalar> {
            /// [`Sphere::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Sphere::new`].
            pub const fn const_new(
                center: Vec3<$scalar>,
                radius: $scalar,
            ) -> Result<Self, ShapeError> {
                let radii = Vec3::<$scalar>::new(radius, radius, radius);
                if let Err(error) = all_finite([
                    (center.const_is_finite(), "center"),
                    (radii.const_is_finite(), "radius"),
                ]) {
                    return Err(error);
                }
                if Vec3::<$scalar>::CONST_ZERO.const_exceeds(radii) {
                    return Err(ShapeError::NegativeRadius);
                }
                Ok(Self { center, radius })
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Capsule<$scalar> {
            /// [`Capsule::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Capsule::new`].
            pub const fn const_new(
                a: Vec3<$scalar>,
                b: Vec3<$scalar>,
                radius: $scalar,
            ) -> Result<Self, ShapeError> {
                let ends = [(a.const_is_finite(), "a"), (b.const_is_finite(), "b")];
                if let Err(error) = all_finite(ends) {
                    return Err(error);
                }
                match Sphere::<$scalar>::const_new(a, radius) {
                    Ok(sphere) => Ok(Self { a, b, radius: sphere.radius }),
                    Err(error) => Err(error),
                }
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Ray<$scalar> {
            /// [`Ray::new`] for a `const` or a `static`: see [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Ray::new`].
            pub const fn const_new(
                origin: Vec3<$scalar>,
                direction: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                if let Err(error) = all_finite([
                    (origin.const_is_finite(), "origin"),
                    (direction.const_is_finite(), "direction"),
                ]) {
                    return Err(error);
                }
                if direction.const_is_zero() {
                    return Err(ShapeError::ZeroDirection);
                }
                Ok(Self { origin, direction, t_min: Some($zero), t_max: None })
            }
        }

        $(#[$attr])*
        impl<$($generic)*> Plane<$scalar> {
            /// [`Plane::from_equation`] for a `const` or a `static`: see
            /// [`Triangle::const_new`].
            ///
            /// # Errors
            /// As [`Plane::from_equation`].
            pub const fn const_new(
                normal: Vec3<$scalar>,
                d: $scalar,
            ) -> Result<Self, ShapeError> {
                if let Err(error) = all_finite([
                    (Vec3::<$scalar>::new(d, d, d).const_is_finite(), "d"),
                    (normal.const_is_finite(), "normal"),
                ]) {
                    return Err(error);
                }
                if normal.const_is_zero() {
                    return Err(ShapeError::ZeroNormal);
                }
                Ok(Self { normal, form: PlaneForm::Offset(d) })
            }
        }
    };
}

const_new!([] f32, 0.0, |x| x.is_finite(), |x| x, |axes| are_orthonormal_f32(&axes));
const_new!(#[doc(hidden)] [] f64, 0.0, |x| x.is_finite(), |x| x, |axes| are_orthonormal_f64(&axes));

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::*;
    use crate::scalar::axes::fixed_axes_are_orthonormal;

    const_new!(
        #[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, FixedI8::from_bits(0), |_x| true,
        |x| x.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI8<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, FixedI16::from_bits(0), |_x| true,
        |x| x.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI16<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, FixedI32::from_bits(0), |_x| true,
        |x| x.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI32<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, FixedI64::from_bits(0), |_x| true,
        |x| x.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI64<Frac>, axes)
    );
}
