//! The options of the command line.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};

use crate::cli::any;

/// Voxelizes a triangle mesh: one overlap test for each voxel that the bounding
/// box of a triangle touches. Writes a picture of the result.
#[derive(Parser)]
#[command(name = "voxelize", version)]
pub(crate) struct Options {
    /// Mesh to voxelize: an OBJ or STL file (binary or ASCII). The Utah teapot
    /// that comes with the example if none is given
    pub(crate) mesh: Option<PathBuf>,

    /// Voxels along the longest side of the mesh
    #[arg(short, long, value_name = "N", default_value_t = 128,
        value_parser = any::<u32>("a whole number of 32 bits"), allow_negative_numbers = true)]
    pub(crate) resolution: u32,

    /// Number type to compute in, in upper or lower case. Vertices are rounded
    /// to it once; exact verdicts are exact for the rounded mesh
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = ScalarType::F32)]
    pub(crate) scalar: ScalarType,

    /// Overlap test to ask
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Method::Exact)]
    pub(crate) method: Method,

    /// Axis of the mesh that points up in the picture [default: y for OBJ, z
    /// for STL]
    #[arg(short, long, value_enum, ignore_case = true)]
    pub(crate) up: Option<Up>,

    /// Picture to write [default: out/MESH.png]
    #[arg(short, long, value_name = "PNG")]
    pub(crate) output: Option<PathBuf>,

    /// Draw no picture: drawing takes far longer than the tests
    #[arg(long, conflicts_with = "output")]
    pub(crate) no_picture: bool,

    /// Also write a MagicaVoxel model, up to 256 voxels a side
    #[arg(long, value_name = "FILE")]
    pub(crate) vox: Option<PathBuf>,
}

/// The number types on offer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "lower")]
pub(crate) enum ScalarType {
    /// IEEE 754, 32 bits
    F32,
    /// IEEE 754, 64 bits
    F64,
    /// Fixed point, 16 bits, 8 of them after the point
    I8F8,
    /// Fixed point, 32 bits, 16 of them after the point
    I16F16,
    /// Fixed point, 64 bits, 32 of them after the point
    I32F32,
}

impl ScalarType {
    /// The finest grid whose coordinates the type can hold, with the origin at
    /// the grid's centre: corners go from -⌈N/2⌉ to ⌊N/2⌋.
    ///
    /// Floats have no such limit. For them it is the finest grid whose voxel centres
    /// are exact.
    pub(crate) fn finest_grid(self) -> u64 {
        match self {
            Self::F32 => 1 << 24,
            Self::F64 => 1 << 53,
            Self::I8F8 => (1 << 8) - 1,
            Self::I16F16 => (1 << 16) - 1,
            Self::I32F32 => (1 << 32) - 1,
        }
    }

    /// The name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I8F8 => "i8f8",
            Self::I16F16 => "i16f16",
            Self::I32F32 => "i32f32",
        }
    }
}

/// The overlap tests on offer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Always right; each triangle is prepared once
    Exact,
    /// The same, each triangle and voxel as they are
    ExactPairs,
    /// Never misses a voxel, may set one too many
    Conservative,
    /// Akenine-Möller 2001, in the scalar's own rounding arithmetic
    Published,
    /// The kernel of the exact test without its error bound
    Rounded,
}

impl Method {
    /// What the method is, and the function that does it.
    pub(crate) fn description(self) -> &'static str {
        match self {
            Self::Exact => "exact (PreparedTriangle::overlaps)",
            Self::ExactPairs => "exact, pair by pair (Triangle::overlaps)",
            Self::Conservative => "conservative (Triangle::may_overlap)",
            Self::Published => "as published in 2001 (published::akenine_moller)",
            Self::Rounded => "rounded (published::shared_normal)",
        }
    }
}

/// The axis of the mesh that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Up {
    /// As most OBJ files have it
    Y,
    /// As most STL files have it
    Z,
}
