//! Those of the promises in which features and kernels for 32-bit registers have a part, as a crate
//! of their own: `.ci/run` asks them once more so built, and most of the time goes into compiling.
//!
//!     RUSTC_WORKSPACE_WRAPPER=$PWD/.ci/narrow cargo test --test narrow

mod bounded;
mod every_size;
mod exact_oracle;
mod extremes;
mod interop;
mod logging;
mod mesh;
mod near_miss;
mod obb;
mod ray_rounding;
mod ray_triangle;
mod unit_normal;

/// What a module above needs.
mod examples {
    #[rustfmt::skip]
    #[allow(dead_code, reason = "its tree is for others")]
    #[path = "../../../examples/assets/teapot.rs"]
    pub(crate) mod teapot;
}
