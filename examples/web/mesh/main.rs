//! The module of the page's second view, which shows a mesh in voxels; `../main.rs` says how to
//! build and serve it. It is independent of the first view, imports nothing, and is useful without
//! the page: see `docs/web.md`. `module.rs` documents its exports.
#![cfg_attr(target_family = "wasm", no_std, no_main)]

#[cfg(test)]
mod golden;
#[cfg(target_family = "wasm")]
mod module;
#[cfg(target_family = "wasm")]
#[path = "../numbers.rs"]
mod numbers;
#[cfg(any(target_family = "wasm", test))]
mod voxels;

#[cfg(not(target_family = "wasm"))]
fn main() {
    println!("This is for a browser: `cargo web` builds it and serves the page.");
}
