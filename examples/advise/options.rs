//! What can be said on the command line.

use std::num::NonZeroU32;
use std::path::PathBuf;

use clap::{Parser, ValueEnum};

/// Says which number type a scene needs, and what it costs.
///
/// The scene is a mesh, and boxes on a grid that are asked about: every triangle
/// against every box around it, as a voxelizer asks.
#[derive(Parser)]
#[command(name = "advise")]
pub(crate) struct Options {
    /// The mesh, an .obj or .stl file, in its own coordinates; without it, the
    /// bundled teapot
    pub(crate) mesh: Option<PathBuf>,

    /// The size of the boxes, which have their corners at multiples of it
    /// [default: a power of two, 64 to 128 of which make the mesh's longest side]
    #[arg(long, value_name = "SIZE", value_parser = size, allow_negative_numbers = true)]
    pub(crate) cell: Option<f64>,

    /// How far rounding may move a vertex or a corner of a box
    /// [default: a hundredth of the cell]
    #[arg(long, value_name = "T", value_parser = distance, allow_negative_numbers = true)]
    pub(crate) tolerance: Option<f64>,

    /// What it is to run on
    #[arg(long, value_enum, default_value_t = Target::Host)]
    pub(crate) target: Target,

    /// Recommend nothing wider
    #[arg(long, value_name = "BITS", default_value_t = 64)]
    pub(crate) bits: u32,

    /// How many queries the verdicts are compared on
    #[arg(long, value_name = "N", default_value = "20000")]
    pub(crate) sample: NonZeroU32,

    /// Compare the verdicts of all queries too, and hold the prediction against them
    #[arg(long)]
    pub(crate) full: bool,
}

fn distance(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(x) if f64::is_finite(x) && x >= 0.0 => Ok(x),
        _ => Err("a number, not below nought".into()),
    }
}

fn size(text: &str) -> Result<f64, String> {
    distance(text).ok().filter(|&x| x > 0.0).ok_or("a number above nought".into())
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
}

/// The axis of a mesh that points up. Here meshes stay as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Up {
    Y,
    Z,
}
