//! Constructors for `const` tables in flash.
//!
//! A `const fn` cannot call a trait's methods yet, so the generic constructors
//! cannot be `const`; these are, for each family of scalars, and check the same.

use super::aabb::Form;
use super::plane::Form as PlaneForm;
use super::segment::Form as SegmentForm;
use super::{Aabb, Plane, Ray, Segment, ShapeError, Triangle};
use crate::linear::Vec3;

macro_rules! constant {
    ($(#[$cfg:meta])? [$($generic:ident)?] $scalar:ty,
     $finite:expr, |$v:ident| $value:expr, $zero:literal, $nought:expr) => {
        $(#[$cfg])?
        impl<$($generic)?> Triangle<$scalar> {
            /// [`Triangle::new`] in a `const`.
            ///
            /// # Errors
            /// As [`Triangle::new`].
            pub const fn constant(
                a: Vec3<$scalar>,
                b: Vec3<$scalar>,
                c: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let vertices = [a, b, c];
                let mut i = 0;
                while i < 3 {
                    let $v = vertices[i].x;
                    let x = $finite;
                    let $v = vertices[i].y;
                    let y = $finite;
                    let $v = vertices[i].z;
                    let z = $finite;
                    if !(x && y && z) {
                        return Err(ShapeError::NotFinite);
                    }
                    i += 1;
                }
                Ok(Self { vertices })
            }
        }

        $(#[$cfg])?
        impl<$($generic)?> Aabb<$scalar> {
            /// [`Aabb::from_min_max`] in a `const`: from the least to the greatest
            /// corner.
            ///
            /// # Errors
            /// As [`Aabb::from_min_max`].
            pub const fn constant(
                min: Vec3<$scalar>,
                max: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let pairs = [(min.x, max.x), (min.y, max.y), (min.z, max.z)];
                let (mut above, mut i) = (false, 0);
                while i < 3 {
                    let $v = pairs[i].0;
                    let (low, low_finite) = ($value, $finite);
                    let $v = pairs[i].1;
                    let (high, high_finite) = ($value, $finite);
                    if !(low_finite && high_finite) {
                        return Err(ShapeError::NotFinite);
                    }
                    above |= low > high;
                    i += 1;
                }
                if above {
                    return Err(ShapeError::MinAboveMax);
                }
                Ok(Self { form: Form::Corners { min, max } })
            }

            /// [`Aabb::from_center_half_extents`] in a `const`.
            ///
            /// # Errors
            /// As [`Aabb::from_center_half_extents`].
            pub const fn constant_center_half_extents(
                center: Vec3<$scalar>,
                half: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let pairs = [(center.x, half.x), (center.y, half.y), (center.z, half.z)];
                let (mut negative, mut i) = (false, 0);
                while i < 3 {
                    let $v = pairs[i].0;
                    let center_finite = $finite;
                    let $v = pairs[i].1;
                    let (reach, half_finite) = ($value, $finite);
                    if !(center_finite && half_finite) {
                        return Err(ShapeError::NotFinite);
                    }
                    negative |= reach < $zero;
                    i += 1;
                }
                if negative {
                    return Err(ShapeError::NegativeHalfExtent);
                }
                Ok(Self { form: Form::Center { center, half } })
            }
        }

        $(#[$cfg])?
        impl<$($generic)?> Segment<$scalar> {
            /// [`Segment::new`] in a `const`.
            ///
            /// # Errors
            /// As [`Segment::new`].
            pub const fn constant(
                a: Vec3<$scalar>,
                b: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let numbers = [a.x, a.y, a.z, b.x, b.y, b.z];
                let mut i = 0;
                while i < 6 {
                    let $v = numbers[i];
                    if !$finite {
                        return Err(ShapeError::NotFinite);
                    }
                    i += 1;
                }
                Ok(Self { form: SegmentForm::Ends(a, b) })
            }
        }

        $(#[$cfg])?
        impl<$($generic)?> Ray<$scalar> {
            /// [`Ray::new`] in a `const`.
            ///
            /// # Errors
            /// As [`Ray::new`].
            pub const fn constant(
                origin: Vec3<$scalar>,
                direction: Vec3<$scalar>,
            ) -> Result<Self, ShapeError> {
                let numbers =
                    [origin.x, origin.y, origin.z, direction.x, direction.y, direction.z];
                let (mut nonzero, mut i) = (false, 0);
                while i < 6 {
                    let $v = numbers[i];
                    let (x, finite) = ($value, $finite);
                    if !finite {
                        return Err(ShapeError::NotFinite);
                    }
                    nonzero |= i >= 3 && x != $zero;
                    i += 1;
                }
                if !nonzero {
                    return Err(ShapeError::ZeroDirection);
                }
                Ok(Self { origin, direction, t_min: Some($nought), t_max: None })
            }
        }

        $(#[$cfg])?
        impl<$($generic)?> Plane<$scalar> {
            /// [`Plane::from_equation`] in a `const`.
            ///
            /// # Errors
            /// As [`Plane::from_equation`].
            pub const fn constant(
                normal: Vec3<$scalar>,
                d: $scalar,
            ) -> Result<Self, ShapeError> {
                let numbers = [normal.x, normal.y, normal.z, d];
                let (mut nonzero, mut i) = (false, 0);
                while i < 4 {
                    let $v = numbers[i];
                    let (x, finite) = ($value, $finite);
                    if !finite {
                        return Err(ShapeError::NotFinite);
                    }
                    nonzero |= i < 3 && x != $zero;
                    i += 1;
                }
                if !nonzero {
                    return Err(ShapeError::ZeroNormal);
                }
                Ok(Self { normal, form: PlaneForm::Offset(d) })
            }
        }
    };
}

constant!([] f32, v.is_finite(), |v| v, 0.0, 0.0);
constant!([] f64, v.is_finite(), |v| v, 0.0, 0.0);
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI8<Frac>, { let _ = v; true }, |v| v.to_bits(), 0, fixed::FixedI8::from_bits(0));
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI16<Frac>, { let _ = v; true }, |v| v.to_bits(), 0, fixed::FixedI16::from_bits(0));
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI32<Frac>, { let _ = v; true }, |v| v.to_bits(), 0, fixed::FixedI32::from_bits(0));
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI64<Frac>, { let _ = v; true }, |v| v.to_bits(), 0, fixed::FixedI64::from_bits(0));
