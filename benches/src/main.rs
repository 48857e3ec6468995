//! The speed of our tests, in every mode and scalar, beside their peers.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

use septum_benches::session::Session;
use septum_benches::{
    line_obb, obb_obb, obj, polygon_aabb, ray_aabb, ray_tree, ray_triangle, triangle_aabb,
    triangle_triangle,
};

/// Times septum's tests beside their peers.
///
/// Candidates take turns in one process with a yardstick: triangle/box with the
/// test as published in 2001, polygon/box with that of Green and Hatch, triangle/triangle with the
/// 11 axes, ray/triangle with Möller–Trumbore, all in f32; ray/box, rays down a tree and oriented
/// boxes with parry3d. A ratio says how many times as fast as the yardstick a
/// candidate is: by the best times of all rounds, and as the median, least and
/// greatest of the rounds. Before the clock starts, every answer is compared with
/// the exact one.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Rounds per group of candidates; fewer where a scene has more than 400,000 pairs
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// A tenth of the rounds
    #[arg(long)]
    quick: bool,
    /// Only scalars and peers whose name contains this, as f32, I16F16 or parry3d
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Only scenes whose name contains this, as Voxel, or ray/box for all ray/box scenes
    #[arg(long, value_name = "NAME")]
    scene: Option<String>,
    /// The voxels of this mesh too, an OBJ file; may be given more than once
    #[arg(long = "mesh", value_name = "FILE")]
    meshes: Vec<PathBuf>,
    /// Write all figures to this file too
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let options = Options::parse();
    let rounds = if options.quick { options.rounds.div_ceil(10) } else { options.rounds };
    let named = |path: &PathBuf| {
        // By its whole path: another mesh may have the same name.
        obj::open(path).map(|(_, triangles)| (path.display().to_string(), triangles))
    };
    let meshes = options.meshes.iter().map(named).collect::<Result<Vec<_>, _>>()?;
    let mut session = Session::new(rounds as usize, options.only, options.scene);

    println!("speed: how many times as fast as the yardstick; higher is faster. time: 1 / speed.");
    println!("wrong −/+: overlaps missed / overlaps that are none.\n");
    triangle_aabb::run_meshes(&mut session, &meshes);
    ray_tree::run(&mut session);
    triangle_aabb::run(&mut session);
    ray_triangle::run(&mut session);
    ray_aabb::run(&mut session);
    polygon_aabb::run(&mut session);
    triangle_triangle::run(&mut session);
    obb_obb::run(&mut session);
    line_obb::run(&mut session);

    if let Some(path) = &options.csv {
        session.write_csv(path).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    if !session.is_honest() {
        eprintln!("A test broke its promise: see the last column.");
        return Ok(ExitCode::FAILURE);
    }
    Ok(ExitCode::SUCCESS)
}
