//! The functions for C. build.rs makes those of the other types from the two files of `float`.

mod mesh_f32;
mod pairs_f32;

mod mesh_i8f8 {
    include!(concat!(env!("OUT_DIR"), "/mesh_i8f8.rs"));
}
mod mesh_i16f16 {
    include!(concat!(env!("OUT_DIR"), "/mesh_i16f16.rs"));
}
#[cfg(not(target_os = "none"))]
mod mesh_f64 {
    include!(concat!(env!("OUT_DIR"), "/mesh_f64.rs"));
}
#[cfg(not(target_os = "none"))]
mod mesh32_f32 {
    include!(concat!(env!("OUT_DIR"), "/mesh32_f32.rs"));
}
#[cfg(not(target_os = "none"))]
mod mesh32_f64 {
    include!(concat!(env!("OUT_DIR"), "/mesh32_f64.rs"));
}
mod pairs_i8f8 {
    include!(concat!(env!("OUT_DIR"), "/pairs_i8f8.rs"));
}
mod pairs_i16f16 {
    include!(concat!(env!("OUT_DIR"), "/pairs_i16f16.rs"));
}
#[cfg(not(target_os = "none"))]
mod pairs_f64 {
    include!(concat!(env!("OUT_DIR"), "/pairs_f64.rs"));
}

pub use self::{
    mesh_f32::*, mesh_i8f8::*, mesh_i16f16::*, pairs_f32::*, pairs_i8f8::*, pairs_i16f16::*,
};
#[cfg(not(target_os = "none"))]
pub use self::{mesh_f64::*, mesh32_f32::*, mesh32_f64::*, pairs_f64::*};
