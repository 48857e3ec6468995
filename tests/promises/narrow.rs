//! The promises that depend on features and on kernels for 32-bit registers, as a separate crate.
//! `.ci/run` tests them in such a build too, where compiling takes most of the time. Meshes, which ask
//! the same kernels, are asked about on narrow cores by the hashes.
//!
//!     RUSTC_WORKSPACE_WRAPPER=$PWD/.ci/narrow cargo test --test narrow

mod bounded;
mod every_size;
mod exact_oracle;
mod extremes;
mod interop;
mod line_obb;
mod logging;
mod near_miss;
mod obb;
mod ray_rounding;
mod ray_triangle;
mod relations;
mod unit_normal;
