//! A page with two views. In the first, the user drags a triangle and a box, and sees whether they
//! overlap, which axis separates them, and where rounding gets it wrong. The second, in `mesh/`,
//! shows a mesh in voxels. The crate is plain WebAssembly, without bindings or a framework, with a
//! module for each view. This is the module of the first view; the example `web_mesh` is the
//! second.
//!
//! ```text
//! rustup target add wasm32-unknown-unknown
//! cargo web
//! ```
//!
//! builds both, 33 and 80 kB with the profile `web` and the feature `small`, and serves the page
//! with node. Without node:
//!
//! ```text
//! cargo build --profile web --features small,alloc --example web --example web_mesh --target wasm32-unknown-unknown
//! python3 -m http.server
//! ```
//!
//! or any other server of static files in this folder, and a browser at `/examples/web/`. The page
//! also works anywhere with `web.wasm` and `web_mesh.wasm` beside it. `.ci/web` tests all of this.
//!
//! The module imports nothing. The caller writes 15 words to `numbers()`, three vertices, the box's
//! centre and its half-extents, and calls `answers(scalar)`.
#![cfg_attr(target_family = "wasm", no_std, no_main)]

#[cfg(target_family = "wasm")]
mod module;
#[cfg(target_family = "wasm")]
mod numbers;

#[cfg(not(target_family = "wasm"))]
fn main() {
    println!("This is for a browser: `cargo web` builds it and serves the page.");
}
