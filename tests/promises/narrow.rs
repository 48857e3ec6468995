//! The promises that depend on kernels for 32-bit registers, as a separate crate. `.ci/run` tests
//! them in such a build too, where compiling takes most of the time. Meshes, which ask the same
//! kernels, are asked about on narrow cores by the hashes.
//!
//!     RUSTC_WORKSPACE_WRAPPER=$PWD/.ci/narrow cargo test --test narrow

mod any_bits;
mod every_size;
mod exact_oracle;
mod extremes;
mod line_obb;
mod near_miss;
mod obb;
mod ray_rounding;
mod ray_triangle;
mod relations;
mod sweep;
mod unit_normal;
