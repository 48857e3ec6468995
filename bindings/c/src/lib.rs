//! septum for C: exact queries for triangles, boxes, rays, spheres, capsules and meshes.
//!
//! The name of each function ends in the type of its numbers: `i8f8` and `i16f16` are fixed point
//! as raw bits (a number times 2⁸ or 2¹⁶), `f32` is `float`, `f64` is `double`. Meshes have indices
//! of 16 bits, and with `tree32` and `mesh32` of 32; both that and `f64` are for hosts. Shapes are
//! plain structures of numbers, checked at each call: an invalid shape or a null pointer returns an
//! error, and never crashes. A mesh stays in the caller's memory, and is checked once, when it is
//! opened. All shapes are closed sets: touching is overlap. Nothing allocates, keeps state or
//! panics.

#![cfg_attr(panic = "abort", no_std)]

mod exports;
mod manifolds;
mod mesh;
mod number;
mod queries;
mod shapes;
mod text;

pub use exports::*;
pub use mesh::{Mesh, Tree, septum_node_count};
pub use shapes::{
    Aabb, Answer, Capsule, Closest, Contact, FirstContact, Hit, Obb, Point, Range, Ray, Sphere,
    SphereContact, Triangle,
};
pub use text::*;

/// The linker drops it from a program that cannot panic. Tests, which unwind, have the standard
/// library's.
#[cfg(panic = "abort")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

/// Named by the compiled core, and never called, for nothing unwinds.
#[cfg(all(panic = "abort", not(target_os = "none")))]
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
