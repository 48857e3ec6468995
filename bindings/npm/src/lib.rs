//! The WebAssembly module of septum's npm package: plain exports, which `js/` calls.
//!
//! Meshes and grids are in slots, and a handle is the number of a slot. JavaScript writes arrays to
//! addresses that the module returns, and nothing refers to them meanwhile. It checks its arguments
//! itself, to name them in an error; what it lets through and the crate refuses has a negative
//! code.
#![cfg_attr(target_family = "wasm", no_std)]
#![cfg(target_family = "wasm")]
#![allow(clippy::too_many_arguments, reason = "numbers are passed in registers")]

#[cfg(feature = "mesh")]
extern crate alloc;

#[cfg(feature = "mesh")]
mod closed;
#[cfg(feature = "mesh")]
mod closest;
#[cfg(feature = "mesh")]
mod contacts;
#[cfg(feature = "mesh")]
mod memory;
#[cfg(feature = "mesh")]
mod mesh;
#[cfg(feature = "pairs")]
mod pairs;
#[cfg(any(feature = "mesh", feature = "pairs"))]
mod part;
#[cfg(feature = "mesh")]
mod query;
#[cfg(feature = "mesh")]
mod voxels;

/// Tables and lists are few and large: first fit is fast, and free neighbours become one.
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
