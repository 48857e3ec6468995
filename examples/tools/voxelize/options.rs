//! The options of the command line.

use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use septum::voxel::Rule;
use septum_tools::cli::{any, valid};
use septum_tools::mesh::Up;

/// Voxelizes triangle meshes, exactly: the surface, or the inside too. Draws the result, or writes
/// the voxels.
#[derive(Parser)]
#[command(name = "voxelize", version)]
pub(crate) struct Options {
    /// Meshes to voxelize in one grid: OBJ, STL, PLY or glTF files (.glb or .gltf), or `-` for one of
    /// them from standard input. The Utah teapot that comes with the example if none is given
    #[arg(value_name = "MESH")]
    pub(crate) meshes: Vec<PathBuf>,

    /// Voxels along the longest side of all meshes
    #[arg(short, long, value_name = "N", default_value_t = 128,
        value_parser = any::<u32>("a whole number of 32 bits"), allow_negative_numbers = true)]
    pub(crate) resolution: u32,

    /// Number type to compute in, in upper or lower case. Vertices are rounded
    /// to it once; exact verdicts are exact for the rounded mesh
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = ScalarType::F32)]
    pub(crate) scalar: ScalarType,

    /// How to find the voxels
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Method::Rows)]
    pub(crate) method: Method,

    /// Which voxels a triangle marks; all methods but rows know closed ones alone. By other rules the grid has a
    /// layer more, for faces at the greatest coordinates
    #[arg(long, value_enum, ignore_case = true, default_value_t = RuleName::Closed)]
    pub(crate) rule: RuleName,

    /// Also set the voxels whose centres are inside the meshes
    #[arg(long)]
    pub(crate) solid: bool,

    /// Threads; 0 for one for each core
    #[arg(short, long, value_name = "N", default_value_t = 0,
        value_parser = valid::<usize>("a whole number of at most 1024", |&n| n <= 1024),
        allow_negative_numbers = true)]
    pub(crate) threads: usize,

    /// Find the voxels by this method too, and draw both side by side: voxels that only the first
    /// method sets in red, voxels that only this one sets in orange
    #[arg(
        long,
        value_enum,
        ignore_case = true,
        value_name = "METHOD",
        conflicts_with = "no_picture"
    )]
    pub(crate) compare: Option<Method>,

    /// Draw the rest after cutting away the front half
    #[arg(long, conflicts_with = "no_picture")]
    pub(crate) cut: bool,

    /// Axis of the meshes that points up in the picture [default: y, and z for
    /// STL]
    #[arg(short, long, value_enum, ignore_case = true)]
    pub(crate) up: Option<Up>,

    /// File to write, any number of times; its extension says what: a picture (.png), a MagicaVoxel
    /// model of up to 256 voxels a side (.vox), a NumPy array (.npy), raw bits after a header of
    /// text (.bits), or a mesh of cubes (.obj) [default: out/MESH.png]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,

    /// Draw no picture, and without --vox keep no voxels: a grid of 4096 a side takes a few MiB then,
    /// slab by slab
    #[arg(long, conflicts_with = "output")]
    pub(crate) no_picture: bool,

    /// Also write a MagicaVoxel model
    #[arg(long, value_name = "FILE.vox")]
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

/// The methods on offer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Always right: rows of voxels by their ends
    Rows,
    /// Always right: a test for each voxel, each triangle prepared once
    #[value(alias = "exact")]
    PerVoxel,
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
    /// A description of the method, and its function.
    pub(crate) fn description(self) -> &'static str {
        match self {
            Self::Rows => "exact, in rows (voxel::Bits::fill)",
            Self::PerVoxel => "exact, voxel by voxel (PreparedTriangle::overlaps)",
            Self::ExactPairs => "exact, pair by pair (Triangle::overlaps)",
            Self::Conservative => "conservative (Triangle::may_overlap)",
            Self::Published => "as published in 2001 (published::akenine_moller)",
            Self::Rounded => "rounded (published::shared_normal)",
        }
    }
}

/// The rules on offer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RuleName {
    /// All that it touches (26-separating)
    Closed,
    /// All that hold a point of it, each point in one voxel
    HalfOpen,
    /// As few as block every way from face to face (6-separating)
    Thin,
}

impl RuleName {
    pub(crate) fn rule(self) -> Rule {
        match self {
            Self::Closed => Rule::Closed,
            Self::HalfOpen => Rule::HalfOpen,
            Self::Thin => Rule::Thin,
        }
    }

    /// The layers of voxels that a mesh marks beyond its greatest coordinates: a half-open voxel has its
    /// lower sides alone.
    pub(crate) fn layers_beyond(self) -> u32 {
        u32::from(self != Self::Closed)
    }

    /// The name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Closed => "closed",
            Self::HalfOpen => "half-open",
            Self::Thin => "thin",
        }
    }
}
