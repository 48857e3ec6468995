//! Brings a mesh to fixed point, as a table for flash.
//!
//! ```text
//! cargo quantise MESH --scalar i16f16 > table.rs
//! ```
//!
//! The table holds each vertex once, in raw bits, then the faces as indices, and the nodes of a
//! tree. A closed mesh also gets a table of its parts, each with a tree of its own, or one tree
//! over all parts with `--whole`; only a closed mesh has an inside. A report on rounding, and on
//! whether the mesh is closed, goes to the error stream.

mod options;
mod solid;
mod table;

use std::error::Error;
use std::process::ExitCode;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use options::{Options, Scalar};
use septum_tools::cli;
use septum_tools::mesh::Mesh;

fn main() -> ExitCode {
    cli::run(|options| cli::say(&table(options)?))
}

fn table(options: &Options) -> Result<String, Box<dyn Error>> {
    let mesh = Mesh::load(options.mesh.as_slice(), options.up)?;
    match options.scalar {
        Scalar::I4F4 => table::write::<I4F4>(&mesh, options),
        Scalar::I8F8 => table::write::<I8F8>(&mesh, options),
        Scalar::I16F16 => table::write::<I16F16>(&mesh, options),
        Scalar::I32F32 => table::write::<I32F32>(&mesh, options),
    }
}
