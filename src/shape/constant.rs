//! Constructors for `const` tables in flash.
//!
//! A `const fn` cannot call a trait's methods yet, so the generic constructors
//! cannot be `const`; these are, for each family of scalars, and check the same.

use super::aabb::Form;
use super::{Aabb, ShapeError, Triangle};
use crate::linear::Vec3;

macro_rules! constant {
    ($(#[$cfg:meta])? [$($generic:ident)?] $scalar:ty,
     $finite:expr, |$v:ident| $value:expr) => {
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
                let mut i = 0;
                while i < 3 {
                    let $v = pairs[i].0;
                    let (low, low_finite) = ($value, $finite);
                    let $v = pairs[i].1;
                    let (high, high_finite) = ($value, $finite);
                    if !(low_finite && high_finite) {
                        return Err(ShapeError::NotFinite);
                    }
                    if low > high {
                        return Err(ShapeError::MinAboveMax);
                    }
                    i += 1;
                }
                Ok(Self { form: Form::Corners { min, max } })
            }
        }
    };
}

constant!([] f32, v.is_finite(), |v| v);
constant!([] f64, v.is_finite(), |v| v);
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI8<Frac>, { let _ = v; true }, |v| v.to_bits());
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI16<Frac>, { let _ = v; true }, |v| v.to_bits());
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI32<Frac>, { let _ = v; true }, |v| v.to_bits());
constant!(#[cfg(feature = "fixed")] [Frac] fixed::FixedI64<Frac>, { let _ = v; true }, |v| v.to_bits());
