//! Constructors for `const` tables in flash.
//!
//! A `const fn` cannot call trait methods, so the generic constructors cannot be `const`. These
//! constructors exist once for each family of scalars, and make the same checks. Only the `f32`
//! versions appear in the documentation; all are alike.

use super::Vec3;
use super::aabb::Form;
use super::plane::Form as PlaneForm;
use super::segment::Form as SegmentForm;
use super::{Aabb, Obb, Plane, Polygon, Ray, Segment, ShapeError, Triangle};
use crate::scalar::axes::{are_orthonormal_f32, are_orthonormal_f64};

/// Whether a float is finite.
macro_rules! float_is_finite {
    ($x:expr) => {
        $x.is_finite()
    };
}
/// A fixed-point number is always finite.
#[cfg(feature = "fixed")]
macro_rules! fixed_is_finite {
    ($x:expr) => {{
        let _ = $x;
        true
    }};
}
/// A value that a `const fn` can compare.
macro_rules! float_value {
    ($x:expr) => {
        $x
    };
}
#[cfg(feature = "fixed")]
macro_rules! fixed_value {
    ($x:expr) => {
        $x.to_bits()
    };
}

macro_rules! is_finite {
    ($finite:ident, $v:ident) => {
        $finite!($v.x) && $finite!($v.y) && $finite!($v.z)
    };
}
macro_rules! is_zero {
    ($value:ident, $v:ident, $zero:literal) => {
        $value!($v.x) == $zero && $value!($v.y) == $zero && $value!($v.z) == $zero
    };
}
macro_rules! is_any_negative {
    ($value:ident, $v:ident, $zero:literal) => {
        $value!($v.x) < $zero || $value!($v.y) < $zero || $value!($v.z) < $zero
    };
}
/// The constructors for one family. `$zero` is zero as [`float_value`] or `fixed_value` returns it.
macro_rules! const_new {
    ($(#[$attr:meta])* [$($generic:tt)*] $scalar:ty, $finite:ident, $value:ident, $zero:literal,
     $zero_scalar:expr, |$axes:ident| $orthonormal:expr) => {
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
                if is_finite!($finite, a) && is_finite!($finite, b) && is_finite!($finite, c) {
                    Ok(Self { vertices: [a, b, c] })
                } else {
                    Err(ShapeError::NotFinite)
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
                let mut rest = vertices;
                while let [v, others @ ..] = rest {
                    if !(is_finite!($finite, v)) {
                        return Err(ShapeError::NotFinite);
                    }
                    rest = others;
                }
                Ok(Self { vertices })
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
                if !(is_finite!($finite, min) && is_finite!($finite, max)) {
                    return Err(ShapeError::NotFinite);
                }
                if $value!(min.x) > $value!(max.x)
                    || $value!(min.y) > $value!(max.y)
                    || $value!(min.z) > $value!(max.z)
                {
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
                if !(is_finite!($finite, center) && is_finite!($finite, half_extents)) {
                    return Err(ShapeError::NotFinite);
                }
                if is_any_negative!($value, half_extents, $zero) {
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
                if !(is_finite!($finite, center)
                    && is_finite!($finite, half_extents)
                    && is_finite!($finite, u)
                    && is_finite!($finite, v)
                    && is_finite!($finite, w))
                {
                    return Err(ShapeError::NotFinite);
                }
                if is_any_negative!($value, half_extents, $zero) {
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
                if is_finite!($finite, a) && is_finite!($finite, b) {
                    Ok(Self { form: SegmentForm::Ends(a, b) })
                } else {
                    Err(ShapeError::NotFinite)
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
                if !(is_finite!($finite, origin) && is_finite!($finite, direction)) {
                    return Err(ShapeError::NotFinite);
                }
                if is_zero!($value, direction, $zero) {
                    return Err(ShapeError::ZeroDirection);
                }
                Ok(Self { origin, direction, t_min: Some($zero_scalar), t_max: None })
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
                if !(is_finite!($finite, normal) && $finite!(d)) {
                    return Err(ShapeError::NotFinite);
                }
                if is_zero!($value, normal, $zero) {
                    return Err(ShapeError::ZeroNormal);
                }
                Ok(Self { normal, form: PlaneForm::Offset(d) })
            }
        }
    };
}

const_new!([] f32, float_is_finite, float_value, 0.0, 0.0, |axes| are_orthonormal_f32(&axes));
const_new!(#[doc(hidden)] [] f64, float_is_finite, float_value, 0.0, 0.0, |axes| {
    are_orthonormal_f64(&axes)
});

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::*;
    use crate::scalar::axes::fixed_axes_are_orthonormal;

    macro_rules! const_new_fixed {
        ($($fixed:ident, $bound:ident;)*) => {$(
            const_new!(
                #[doc(hidden)] [Frac: $bound] $fixed<Frac>,
                fixed_is_finite, fixed_value, 0, $fixed::from_bits(0),
                |axes| fixed_axes_are_orthonormal!($fixed<Frac>, axes)
            );
        )*};
    }
    const_new_fixed! {
        FixedI8, LeEqU8;
        FixedI16, LeEqU16;
        FixedI32, LeEqU32;
        FixedI64, LeEqU64;
    }
}
