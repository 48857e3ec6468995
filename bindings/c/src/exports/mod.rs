//! The functions for C.

#[cfg(not(target_os = "none"))]
mod mesh32_f32;
#[cfg(not(target_os = "none"))]
mod mesh32_f64;
mod mesh_f32;
#[cfg(not(target_os = "none"))]
mod mesh_f64;
mod mesh_i16f16;
mod mesh_i8f8;
mod pairs_f32;
#[cfg(not(target_os = "none"))]
mod pairs_f64;
mod pairs_i16f16;
mod pairs_i8f8;

pub use self::{
    mesh_f32::*, mesh_i8f8::*, mesh_i16f16::*, pairs_f32::*, pairs_i8f8::*, pairs_i16f16::*,
};
#[cfg(not(target_os = "none"))]
pub use self::{mesh_f64::*, mesh32_f32::*, mesh32_f64::*, pairs_f64::*};
