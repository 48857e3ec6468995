//! A page with two views. In the first, the user drags a triangle and a box, and sees whether they
//! overlap, which axis separates them, and where rounding gets it wrong. The second, in `mesh/`,
//! shows a mesh in voxels. This is the module of the first view: the crate as plain WebAssembly,
//! without bindings or a framework. The second view uses the package of `bindings/npm/`.
//!
//! ```text
//! rustup target add wasm32-unknown-unknown
//! cargo web
//! ```
//!
//! builds the module, 33 kB with the profile `web` and the feature `small`, and the package, and
//! serves the page with node. Without `cargo web`:
//!
//! ```text
//! cargo build --profile web --features small --example web --target wasm32-unknown-unknown
//! bindings/npm/build
//! python3 -m http.server
//! ```
//!
//! or any other server of static files in the repository, and a browser at `/examples/web/`.
//! `.ci/web` tests all of this.
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
