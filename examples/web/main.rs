//! A page of two views: in one a triangle and a box are dragged, and one sees whether they
//! overlap, which axis separates them, and where rounding gets it wrong; in the other, `mesh/`, a
//! mesh is shown in voxels. The crate as plain WebAssembly: no bindings, no framework, and a
//! module for each view. This is the first one's; that of the meshes is the example `web_mesh`.
//!
//! ```text
//! rustup target add wasm32-unknown-unknown
//! cargo web
//! ```
//!
//! builds both, 24 and 58 kB by the profile `web` and the feature `small`, and serves the page
//! with them, by node. Without node:
//!
//! ```text
//! cargo build --profile web --features small --example web --example web_mesh --target wasm32-unknown-unknown
//! python3 -m http.server
//! ```
//!
//! or any other server of files on this folder, and a browser at `/examples/web/`. The page with
//! `web.wasm` and `web_mesh.wasm` beside it does anywhere. `.ci/web` tests it all.
//!
//! The module imports nothing. Whoever asks writes 15 words to `numbers()`, three vertices, the
//! box's centre and its half-extents, and calls `answers(scalar)`.
#![cfg_attr(target_family = "wasm", no_std, no_main)]

#[cfg(target_family = "wasm")]
mod module;
#[cfg(target_family = "wasm")]
mod numbers;

#[cfg(not(target_family = "wasm"))]
fn main() {
    println!("This is for a browser: `cargo web` builds it and serves the page.");
}
