//! Constructors for `const` tables in flash, one for each family of scalars and each index type, as
//! for the shapes. Only the version for `f32` and `u16` appears in the documentation.

use super::{Index, Mesh, MeshError};
use crate::shape::{ShapeError, Vec3};

macro_rules! const_new {
    ($(#[$attr:meta])* [$($generic:tt)*] $scalar:ty, $index:ty) => {
        $(#[$attr])*
        impl<'a, $($generic)*> Mesh<'a, $scalar, $index> {
            /// [`Mesh::new`] for a `const` or a `static`, such as a table in flash.
            ///
            /// It exists for every scalar and both index types, which have to be named:
            /// `Mesh::<I16F16, u16>::const_new`. [`MeshError::unwrap`] turns a refused mesh into a
            /// compile error.
            ///
            /// # Errors
            /// As [`Mesh::new`].
            ///
            /// ```
            /// use septum::Vec3;
            /// use septum::mesh::{Mesh, MeshError};
            ///
            /// static CORNERS: [Vec3<f32>; 3] =
            ///     [Vec3::new(0.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0)];
            /// static FACES: [[u16; 3]; 1] = [[0, 1, 2]];
            /// static MESH: Mesh<'_, f32, u16> =
            ///     MeshError::unwrap(Mesh::<f32, u16>::const_new(&CORNERS, &FACES));
            /// assert_eq!(Ok(MESH), Mesh::new(&CORNERS, &FACES));
            ///
            /// let bad = Mesh::<f32, u16>::const_new(&CORNERS, &[[0, 1, 3]]);
            /// assert_eq!(bad, Err(MeshError::NoSuchVertex { triangle: 0 }));
            /// ```
            pub const fn const_new(
                vertices: &'a [Vec3<$scalar>],
                triangles: &'a [[$index; 3]],
            ) -> Result<Self, MeshError> {
                let vertices_are_finite =
                    Vec3::<$scalar>::const_list_is_finite("vertices", vertices);
                if let Err(ShapeError::NotFinite { index: Some(vertex), .. }) = vertices_are_finite {
                    return Err(MeshError::NotFinite { vertex });
                }
                let mut triangle = 0;
                while triangle < triangles.len() {
                    let mut k = 0;
                    while k < 3 {
                        if triangles[triangle][k] as usize >= vertices.len() {
                            return Err(MeshError::NoSuchVertex { triangle });
                        }
                        k += 1;
                    }
                    triangle += 1;
                }
                if triangles.len() as u64 > <$index as Index>::COUNT {
                    return Err(MeshError::TooManyTriangles);
                }
                Ok(Self { vertices, triangles })
            }
        }
    };
}

const_new!([] f32, u16);
const_new!(#[doc(hidden)] [] f32, u32);
const_new!(#[doc(hidden)] [] f64, u16);
const_new!(#[doc(hidden)] [] f64, u32);

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::*;

    const_new!(#[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, u16);
    const_new!(#[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, u32);
    const_new!(#[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, u16);
    const_new!(#[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, u32);
    const_new!(#[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, u16);
    const_new!(#[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, u32);
    const_new!(#[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, u16);
    const_new!(#[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, u32);
}
