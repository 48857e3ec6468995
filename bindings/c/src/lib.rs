//! septum for C: exact overlap and ray queries for triangles and boxes.
//!
//! The name of each function ends in the type of its numbers: `i8f8` and `i16f16` are fixed point
//! as raw bits (a number times 2⁸ or 2¹⁶), `f32` is `float`. Shapes are plain structures of
//! numbers, checked at each call: an invalid shape or a null pointer returns an error, and never
//! crashes. A mesh stays in the caller's memory, and is checked once, when it is opened. All shapes
//! are closed sets: touching is overlap. Nothing allocates, keeps state or panics.

#![cfg_attr(target_os = "none", no_std)]

mod mesh;
mod number;
mod queries;
mod shapes;

pub use mesh::*;
pub use queries::*;
pub use shapes::{Aabb, Answer, Hit, Obb, Ray, Triangle};

/// The linker drops it from a program that cannot panic.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
