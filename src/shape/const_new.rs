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

/// The constructors for one family: whether a number is finite, whether it exceeds another, and
/// whether axes are orthonormal.
macro_rules! const_new {
    ($(#[$attr:meta])* [$($generic:tt)*] $scalar:ty, $zero:expr, |$x:ident| $is_finite:expr,
     |$a:ident, $b:ident| $exceeds:expr, |$axes:ident| $orthonormal:expr) => {
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

            /// The error of the first argument that is not finite.
            const fn const_check<const N: usize>(
                arguments: [(Self, &'static str); N],
            ) -> Result<(), ShapeError> {
                let mut i = 0;
                while i < N {
                    let (vector, argument) = arguments[i];
                    if !vector.const_is_finite() {
                        return Err(ShapeError::NotFinite { argument, index: None });
                    }
                    i += 1;
                }
                Ok(())
            }

            /// The same for the elements of one argument.
            pub(crate) const fn const_list_is_finite(
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
                let pairs = [(self.x, other.x), (self.y, other.y), (self.z, other.z)];
                let mut i = 0;
                while i < 3 {
                    let ($a, $b) = pairs[i];
                    if $exceeds {
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
                match Vec3::<$scalar>::const_check([(a, "a"), (b, "b"), (c, "c")]) {
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
                match Vec3::<$scalar>::const_check([(min, "min"), (max, "max")]) {
                    Err(error) => Err(error),
                    Ok(()) if min.const_exceeds(max) => Err(ShapeError::MinAboveMax),
                    Ok(()) => Ok(Self { form: Form::Corners { min, max } }),
                }
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
                let numbers = [(center, "center"), (half_extents, "half_extents")];
                match Vec3::<$scalar>::const_check(numbers) {
                    Err(error) => Err(error),
                    Ok(()) if Vec3::<$scalar>::CONST_ZERO.const_exceeds(half_extents) => {
                        Err(ShapeError::NegativeHalfExtent)
                    }
                    Ok(()) => Ok(Self { form: Form::Center { center, half: half_extents } }),
                }
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
                let numbers = [(center, "center"), (half_extents, "half_extents")];
                let [u, v, w] = axes;
                let $axes = [[u.x, u.y, u.z], [v.x, v.y, v.z], [w.x, w.y, w.z]];
                match (
                    Vec3::<$scalar>::const_check(numbers),
                    Vec3::<$scalar>::const_list_is_finite("axes", &axes),
                ) {
                    (Err(error), _) | (_, Err(error)) => Err(error),
                    _ if Vec3::<$scalar>::CONST_ZERO.const_exceeds(half_extents) => {
                        Err(ShapeError::NegativeHalfExtent)
                    }
                    _ => match $orthonormal {
                        Some(true) => Ok(Self { center, axes, half: half_extents }),
                        Some(false) => Err(ShapeError::NotOrthonormal),
                        None => Err(ShapeError::NoUnitLength),
                    },
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
                match Vec3::<$scalar>::const_check([(a, "a"), (b, "b")]) {
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
                match Vec3::<$scalar>::const_check([(center, "center"), (radii, "radius")]) {
                    Err(error) => Err(error),
                    Ok(()) if Vec3::<$scalar>::CONST_ZERO.const_exceeds(radii) => {
                        Err(ShapeError::NegativeRadius)
                    }
                    Ok(()) => Ok(Self { center, radius }),
                }
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
                let is_finite = Vec3::<$scalar>::const_check([(a, "a"), (b, "b")]);
                match (is_finite, Sphere::<$scalar>::const_new(a, radius)) {
                    (Err(error), _) | (_, Err(error)) => Err(error),
                    _ => Ok(Self { a, b, radius }),
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
                let numbers = [(origin, "origin"), (direction, "direction")];
                match Vec3::<$scalar>::const_check(numbers) {
                    Err(error) => Err(error),
                    Ok(()) if direction.const_is_zero() => Err(ShapeError::ZeroDirection),
                    Ok(()) => Ok(Self { origin, direction, t_min: Some($zero), t_max: None }),
                }
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
                let numbers = [(Vec3::<$scalar>::new(d, d, d), "d"), (normal, "normal")];
                match Vec3::<$scalar>::const_check(numbers) {
                    Err(error) => Err(error),
                    Ok(()) if normal.const_is_zero() => Err(ShapeError::ZeroNormal),
                    Ok(()) => Ok(Self { normal, form: PlaneForm::Offset(d) }),
                }
            }
        }
    };
}

const_new!([] f32, 0.0, |x| x.is_finite(), |a, b| a > b, |axes| are_orthonormal_f32(&axes));
const_new!(#[doc(hidden)] [] f64, 0.0, |x| x.is_finite(), |a, b| a > b, |axes| are_orthonormal_f64(&axes));

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::*;
    use crate::scalar::axes::fixed_axes_are_orthonormal;

    const_new!(
        #[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, FixedI8::from_bits(0), |_x| true,
        |a, b| a.to_bits() > b.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI8<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, FixedI16::from_bits(0), |_x| true,
        |a, b| a.to_bits() > b.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI16<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, FixedI32::from_bits(0), |_x| true,
        |a, b| a.to_bits() > b.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI32<Frac>, axes)
    );
    const_new!(
        #[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, FixedI64::from_bits(0), |_x| true,
        |a, b| a.to_bits() > b.to_bits(), |axes| fixed_axes_are_orthonormal!(FixedI64<Frac>, axes)
    );
}
