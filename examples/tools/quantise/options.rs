//! The options of the command line.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use septum_tools::cli::valid;
use septum_tools::mesh::Up;

/// Brings a mesh to fixed point, as a table for flash.
///
/// Prints a Rust file: the vertices as raw bits, each once, and the faces as
/// indices, in the order of a tree whose nodes follow. Faces that rounding made degenerate
/// are kept: a query takes them. If the mesh is closed, the faces are sorted by part, PARTS
/// says which are whose, and NODES has a tree for each.
#[derive(Parser)]
pub(crate) struct Options {
    /// The mesh, an .obj, .stl, .ply, .glb or .gltf file, or `-` for one from standard input; without
    /// it, the bundled teapot
    pub(crate) mesh: Option<PathBuf>,

    /// The axis that points up in the file
    #[arg(long, value_name = "AXIS", ignore_case = true)]
    pub(crate) up: Option<Up>,

    /// The type to round to
    #[arg(long, value_name = "TYPE", default_value = "i16f16", ignore_case = true)]
    pub(crate) scalar: Scalar,

    /// Enlarges the mesh so many times before it is rounded
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0,
        value_parser = valid("a number above zero", |&x: &f64| x.is_finite() && x > 0.0),
        allow_negative_numbers = true)]
    pub(crate) scale: f64,

    /// Fills each hole with a fan of triangles, so that the mesh has an inside
    #[arg(long)]
    pub(crate) close: bool,

    /// One tree over all parts: winding numbers then separate inside from outside
    #[arg(long)]
    pub(crate) whole: bool,
}

/// The fixed-point types that there are tables for.
#[derive(Clone, Copy, Debug, ValueEnum)]
#[value(rename_all = "lower")]
pub(crate) enum Scalar {
    I4F4,
    I8F8,
    I16F16,
    I32F32,
}
