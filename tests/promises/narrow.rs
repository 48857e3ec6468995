//! The promises that depend on features and on kernels for 32-bit registers, as a separate crate.
//! `.ci/run` tests them in such a build too, where compiling takes most of the time.
//!
//!     RUSTC_WORKSPACE_WRAPPER=$PWD/.ci/narrow cargo test --test narrow

mod bounded;
mod every_size;
mod exact_oracle;
mod extremes;
mod interop;
mod line_obb;
mod logging;
mod mesh;
mod near_miss;
mod obb;
mod ray_rounding;
mod ray_triangle;
mod relations;
mod unit_normal;

/// A dependency of a module above.
mod examples {
    #[rustfmt::skip]
    #[allow(dead_code, reason = "its tree is for others")]
    #[path = "../../../examples/assets/teapot.rs"]
    pub(crate) mod teapot;
}
