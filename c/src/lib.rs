//! septum for C: exact overlap and ray queries for triangles and boxes.
//!
//! Each function has the numbers it takes in its name: `i8f8` and `i16f16` are fixed point as
//! raw bits (a number times 2⁸ or 2¹⁶), `f32` is `float`. Shapes are plain structures of
//! numbers, checked at each call: a bad one, or a null pointer, is an error and never a
//! crash. A mesh is in the caller's memory, and looked through once. All shapes are closed sets:
//! touching is overlap. Nothing allocates, keeps a state or panics.

#![cfg_attr(target_os = "none", no_std)]

mod mesh;
mod number;
mod queries;
mod shapes;

pub use mesh::*;
pub use queries::*;
pub use shapes::{Aabb, Answer, Hit, Obb, Ray, Triangle};

/// A linked program has none of it, if it does not panic.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
