//! A page where one drags a triangle and a box, and sees whether they overlap, which
//! axis separates them, and where rounding gets it wrong; and, in `mesh/`, one that shows
//! a mesh in voxels. The crate as a plain WebAssembly module: no bindings, no framework.
//!
//! ```text
//! rustup target add wasm32-unknown-unknown
//! cargo web
//! ```
//!
//! builds the module, 82 kB by the profile `web` and the feature `small`, and serves
//! the page with it, by node. Without node:
//!
//! ```text
//! cargo build --profile web --features small --example web --target wasm32-unknown-unknown
//! python3 -m http.server
//! ```
//!
//! or any other server of files on this folder, and a browser at `/examples/web/`. The
//! page and `web.wasm` in one folder do anywhere. `.ci/web` tests it all.
//!
//! The module imports nothing. Whoever asks writes 15 words to `numbers()`, three
//! vertices, the box's centre and its half-extents, and calls `answers(scalar)`. What it
//! exports about meshes, mesh.rs says.
#![cfg_attr(target_family = "wasm", no_std, no_main)]

#[cfg(test)]
mod golden;
#[cfg(target_family = "wasm")]
mod mesh;
#[cfg(target_family = "wasm")]
mod module;
#[cfg(any(target_family = "wasm", test))]
mod voxels;

#[cfg(not(target_family = "wasm"))]
fn main() {
    println!("This is for a browser: `cargo web` builds it and serves the page.");
}
