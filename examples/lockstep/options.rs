//! The options of the command line, on hosts.

#[allow(dead_code, reason = "shared with other examples")]
#[path = "../shared/cli.rs"]
mod cli;
#[path = "crowd.rs"]
mod crowd;

use std::sync::LazyLock;

use clap::Parser;
use fixed::types::I16F16;

use self::cli::valid;
use crate::program::Line;
use crate::session::MOST_BACK;
use crate::{ALL, BACK, LAST_IN_F32, LINES, fixed_point, line_in};

/// Lockstep: two peers run the same world from the same inputs.
///
/// Prints hashes of the world, which are the same on every machine; whether two peers that roll
/// back agree, and a sync test; and when the peers notice that one bit of an input was changed.
/// Exits with 1 if a hash differs.
#[derive(Parser)]
struct Options {
    /// Computes in f32 in place of I16F16
    #[arg(long)]
    floats: bool,

    /// Plays 200 boxes for ten seconds, and prints the time of a frame
    #[arg(long)]
    crowd: bool,

    /// The ticks that the sync test goes back and plays again in each tick; without it, 2, in a crowd
    /// 8
    #[arg(long, value_name = "TICKS", allow_negative_numbers = true,
        value_parser = valid("a number from 1 to 8", |back: &usize| (1..=MOST_BACK).contains(back)))]
    back: Option<usize>,
}

static OPTIONS: LazyLock<Options> = LazyLock::new(cli::read);

pub(crate) fn lines() -> usize {
    match *OPTIONS {
        Options { crowd: true, .. } => 1,
        Options { floats: true, .. } => LINES,
        _ => ALL,
    }
}

pub(crate) fn line(k: usize) -> Line {
    let Options { floats, crowd, back } = *OPTIONS;
    if crowd {
        let back = back.unwrap_or(MOST_BACK);
        return if floats { crowd::line::<f32>(back) } else { crowd::line::<I16F16>(back) };
    }
    let back = back.unwrap_or(BACK);
    if floats { line_in::<f32>(k, "f32", LAST_IN_F32, back) } else { fixed_point(k, back) }
}
