//! The options of the command line.

use std::num::NonZeroU32;
use std::path::PathBuf;

use clap::{Parser, ValueEnum};
use septum_tools::cli::{any, valid};

/// Recommends a number type for a scene, and shows what each type costs.
///
/// The scene is a mesh, and boxes on a grid: every triangle is tested against every box around it,
/// as in a voxelizer, or against every box that passes it, or that overlaps it.
#[derive(Parser)]
#[command(name = "advise")]
pub(crate) struct Options {
    /// The mesh, an OBJ, STL, PLY or glTF file, in its own coordinates; without it, the
    /// bundled teapot
    pub(crate) mesh: Option<PathBuf>,

    /// The size of the boxes, which have their corners at multiples of it
    /// [default: a power of two, 64 to 128 of which make the mesh's longest side]
    #[arg(long, value_name = "SIZE", allow_negative_numbers = true,
        value_parser = valid("a number above zero", |&x: &f64| x.is_finite() && x > 0.0))]
    pub(crate) cell: Option<f64>,

    /// The question about a triangle and a box
    #[arg(long, value_enum, ignore_case = true, default_value_t = Ask::Overlap)]
    pub(crate) ask: Ask,

    /// How far the boxes of a sweep move between two looks, along x, y and z
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = way)]
    pub(crate) way: Option<[f64; 3]>,

    /// How far rounding may move a vertex, a corner of a box, or an end of its way
    /// [default: a hundredth of the cell]
    #[arg(long, value_name = "T", allow_negative_numbers = true,
        value_parser = valid("a number, zero or above", |&x: &f64| x.is_finite() && x >= 0.0))]
    pub(crate) tolerance: Option<f64>,

    /// The machine that the queries will run on
    #[arg(long, value_enum, ignore_case = true, default_value_t = Target::Host)]
    pub(crate) target: Target,

    /// Recommend no type with more bits
    #[arg(long, value_name = "BITS", default_value_t = 64, allow_negative_numbers = true,
        value_parser = valid("a whole number from 8 to 64", |n: &u32| (8..=64).contains(n)))]
    pub(crate) bits: u32,

    /// How many queries are asked in every type
    #[arg(long, value_name = "N", default_value = "20000", allow_negative_numbers = true,
        value_parser = any::<NonZeroU32>("a whole number of 32 bits above zero"))]
    pub(crate) sample: NonZeroU32,

    /// Compare the verdicts of all queries too, and hold the prediction against them
    #[arg(long)]
    pub(crate) full: bool,
}

/// The question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Ask {
    /// Whether they overlap
    Overlap,
    /// Whether the box, turned about its middle, overlaps it: an oriented box
    Turned,
    /// Whether the triangle through three corners of the box overlaps it
    Triangle,
    /// Whether the box overlaps it, asked of a polygon
    Polygon,
    /// Whether the box, turned about its middle, overlaps the bounding box of the triangle
    Boxes,
    /// When the box, on its way, first meets the triangle
    Sweep,
    /// How the box gets out of the triangle
    Contact,
    /// Whether the largest sphere in the box overlaps it
    Sphere,
    /// Whether a capsule in the box overlaps it, half as long as the box and a quarter as wide
    Capsule,
    /// Which of its points is closest to the middle of the box
    Closest,
}

/// Three numbers, not all zero.
fn way(text: &str) -> Result<[f64; 3], String> {
    let numbers = text.split(',').map(|x| x.trim().parse().ok().filter(|x: &f64| x.is_finite()));
    let numbers: Option<Vec<f64>> = numbers.collect();
    let way = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    way.filter(|way| *way != [0.0; 3])
        .ok_or_else(|| "not three numbers with commas between, such as 0,-2,0, not all zero".into())
}

/// The machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// This one; times are measured
    Host,
    /// Cortex-M0; instructions come from a table
    M0,
    /// Cortex-M4F; instructions come from a table
    M4f,
    /// RV32IMC, as ESP32-C3 and CH32V; instructions come from a table
    Rv32,
}
