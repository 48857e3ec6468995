//! Constructors for `const` tables in flash, one for each family of scalars and each index type, as
//! for the shapes. Only the version for `f32` and `u16` appears in the documentation.

use super::{Mesh, MeshError};
use crate::shape::Vec3;

macro_rules! const_new {
    ($(#[$attr:meta])* [$($generic:tt)*] $scalar:ty, $index:ty, $count:literal,
     |$x:ident| $is_finite:expr) => {
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
                let mut vertex = 0;
                while vertex < vertices.len() {
                    let Vec3 { x, y, z } = vertices[vertex];
                    let all = [x, y, z];
                    let mut i = 0;
                    while i < 3 {
                        let $x = all[i];
                        if !$is_finite {
                            return Err(MeshError::NotFinite { vertex });
                        }
                        i += 1;
                    }
                    vertex += 1;
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
                if triangles.len() as u64 > $count {
                    return Err(MeshError::TooManyTriangles);
                }
                Ok(Self { vertices, triangles })
            }
        }
    };
}

const_new!([] f32, u16, 65_536, |x| x.is_finite());
const_new!(#[doc(hidden)] [] f32, u32, 4_294_967_296, |x| x.is_finite());
const_new!(#[doc(hidden)] [] f64, u16, 65_536, |x| x.is_finite());
const_new!(#[doc(hidden)] [] f64, u32, 4_294_967_296, |x| x.is_finite());

#[cfg(feature = "fixed")]
mod fixed_point {
    use fixed::types::extra::{LeEqU8, LeEqU16, LeEqU32, LeEqU64};
    use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

    use super::*;

    const_new!(#[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, u16, 65_536, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU8] FixedI8<Frac>, u32, 4_294_967_296, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, u16, 65_536, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU16] FixedI16<Frac>, u32, 4_294_967_296, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, u16, 65_536, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU32] FixedI32<Frac>, u32, 4_294_967_296, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, u16, 65_536, |_x| true);
    const_new!(#[doc(hidden)] [Frac: LeEqU64] FixedI64<Frac>, u32, 4_294_967_296, |_x| true);
}
