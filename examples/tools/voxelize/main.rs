//! Voxelizes triangle meshes, the surface or also the inside, and draws the result.
//!
//! ```text
//! cargo voxelize
//! cargo voxelize cow.ply --resolution 256 --scalar i16f16 -o cow.vox
//! cargo voxelize - -o cow.npy -o cow.bits < cow.stl
//! cargo voxelize --solid --cut
//! cargo voxelize --method rows --compare published --scalar i16f16
//! cargo voxelize --no-picture   # a fraction of a second
//! cargo voxelize --help
//! ```

mod bits;
mod camera;
mod color;
mod cubes;
mod fill;
mod grid;
mod light;
mod march;
mod npy;
mod options;
mod output;
mod per_voxel;
mod picture;
mod placement;
mod progress;
mod volume;
mod vox;

use std::error::Error;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use fill::Task;
use grid::Grid;
use indicatif::HumanCount;
use options::{Method, Options, RuleName, ScalarType};
use output::{Format, Output};
use picture::View;
use placement::Placed;
use progress::Progress;
use septum_tools::cli;
use septum_tools::mesh::{Mesh, Up};
use volume::Volume;

fn main() -> ExitCode {
    cli::run(run)
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    check_resolution(options)?;
    let reading = Progress::of_unknown_length("Reading");
    let mesh = Mesh::load(&options.meshes, options.up)?;
    let reading = reading.finish();
    let placed =
        placement::place(&mesh.triangles, options.resolution, options.rule.layers_beyond())?;
    let outputs = Output::all(options, &mesh.name)?;
    let task = task(options, !outputs.is_empty())?;
    if task.keep {
        placement::check_memory(placed.size)?;
    }
    if outputs.iter().any(|output| output.format == Format::Vox) {
        vox::check_size(placed.size)?;
    }
    let outputs = Output::open(outputs, &options.meshes)?;

    let filled = fill::fill(&placed, &task)?;
    cli::say(&report(options, &mesh, reading, &placed, &filled))?;
    let Some(grid) = &filled.grid else { return Ok(()) };
    let other = match options.compare {
        Some(method) => fill::fill(&placed, &Task { method, ..task })?.grid,
        None => None,
    };
    if let Some(other) = &other {
        cli::say(&compared(options, grid, other))?;
    }
    let volume = Volume::new(grid, &placed, mesh.up);
    for open in outputs {
        let (format, path) = (open.output.format, open.output.path.display().to_string());
        if format == Format::Picture {
            // The one step that takes long.
            cli::say(&line("drawing", &format!("{path}; without it: --no-picture")))?;
        }
        let start = Instant::now();
        open.write(|file| match format {
            Format::Picture => Ok(picture::write(&views(options, grid, other.as_ref()), file)?),
            Format::Vox => Ok(vox::write(grid, file)?),
            Format::Npy => Ok(npy::write(&volume, file)?),
            Format::Bits => Ok(bits::write(&volume, file)?),
            Format::Cubes => Ok(cubes::write(&volume, file)?),
        })?;
        cli::say(&line(format.name(), &format!("{}, {path}", spent(start.elapsed()))))?;
    }
    Ok(())
}

fn task(options: &Options, keep: bool) -> Result<Task, String> {
    let methods = [Some(options.method), options.compare];
    let only_closed = methods.into_iter().flatten().find(|&m| m != Method::Rows);
    if let (Some(_), true) = (only_closed, options.rule != RuleName::Closed) {
        let rule = options.rule.name();
        return Err(format!("--rule {rule}: only --method rows knows it, all others are closed"));
    }
    Ok(Task {
        scalar: options.scalar,
        method: options.method,
        rule: options.rule.rule(),
        solid: options.solid,
        threads: options.threads,
        keep,
    })
}

/// The views to draw: the voxels, and beside them the voxels of another method, with wrong ones
/// marked.
fn views(options: &Options, grid: &Grid, other: Option<&Grid>) -> Vec<View> {
    let shown = |grid: Grid| if options.cut { grid.cut() } else { grid };
    let view = |all: Grid, missed: Grid, extra: Grid| View {
        all: shown(all),
        missed: shown(missed),
        extra: shown(extra),
    };
    let none = || Grid::new(grid.size());
    let mut views = vec![view(grid.clone(), none(), none())];
    if let Some(other) = other {
        let missed = grid.with(other, |a, b| a & !b);
        views.push(view(grid.with(other, |a, b| a | b), missed, grid.with(other, |a, b| b & !a)));
    }
    views
}

/// How two methods differ.
fn compared(options: &Options, grid: &Grid, other: &Grid) -> String {
    let missed = HumanCount(grid.with(other, |a, b| a & !b).count());
    let extra = HumanCount(grid.with(other, |a, b| b & !a).count());
    let method = options.compare.map_or("", Method::description);
    let what = format!("{method}: {missed} voxels missed (red), {extra} extra (orange)");
    line("compared", &what)
}

fn check_resolution(options: &Options) -> Result<(), String> {
    let (resolution, scalar) = (options.resolution, options.scalar);
    if resolution == 0 {
        return Err("--resolution 0: a grid needs at least one voxel".into());
    }
    let more = options.rule.layers_beyond();
    let most = |s: ScalarType| s.finest_grid() - u64::from(more);
    let holds = |s: ScalarType| u64::from(resolution) <= most(s);
    if holds(scalar) {
        return Ok(());
    }
    let (name, finest) = (scalar.name(), most(scalar));
    let others = [ScalarType::I16F16, ScalarType::I32F32, ScalarType::F32, ScalarType::F64];
    let wide: Vec<_> = others.into_iter().filter(|&s| holds(s)).map(ScalarType::name).collect();
    Err(format!(
        "--resolution {resolution}: --scalar {name} can hold at most {finest}; {} can hold it",
        wide.join(", ")
    ))
}

fn report(
    options: &Options,
    mesh: &Mesh,
    reading: Duration,
    placed: &Placed,
    filled: &fill::Filled,
) -> String {
    let [x, y, z] = placed.size;
    // The report has the order of the file's axes.
    let [x, y, z] = if mesh.up == Up::Z { [x, z, y] } else { [x, y, z] };
    let (set, all) = (filled.set, (x * y * z) as f64);
    let triangles = mesh.triangles.len() as u64;
    let time = filled.time.as_secs_f64();
    let mut lines = vec![
        ("mesh", format!("{}, {} triangles", mesh.name, HumanCount(triangles))),
        ("grid", format!("{x} × {y} × {z} voxels")),
        ("scalar", format!("{}, {}", options.scalar.name(), moved(filled.moved))),
        ("method", options.method.description().into()),
        ("rule", options.rule.name().into()),
    ];
    if let Some(tests) = filled.tests {
        let tests = HumanCount(tests);
        lines.push(("tests", format!("{tests}, one for each triangle and voxel it may meet")));
    }
    let share = 100.0 * set as f64 / all;
    lines.push(("set", format!("{} voxels, {share:.1} % of the grid", HumanCount(set))));
    match filled.open_rows {
        Some(0) => lines.push(("inside", "closed along every row".into())),
        Some(open) => {
            let rows = HumanCount(open);
            lines.push(("inside", format!("the mesh is open: {rows} rows have no inside")));
        }
        None => {}
    }
    lines.push(("reading", spent(reading)));
    let each = match filled.tests {
        Some(tests) => format!("{:.1} ns a test", 1e9 * time / tests as f64),
        None => format!("{:.0} ns a triangle", 1e9 * time / triangles as f64),
    };
    lines.push(("voxelizing", format!("{}, {each}", spent(filled.time))));
    lines.iter().map(|(name, value)| line(name, value)).collect()
}

fn line(name: &str, value: &str) -> String {
    format!("{name:<11}{value}\n")
}

/// A time, in seconds if it is long.
fn spent(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 1.0 { format!("{:.1} ms", 1e3 * seconds) } else { format!("{seconds:.2} s") }
}

fn moved(by: f64) -> String {
    if by == 0.0 {
        return "vertices as they are".into();
    }
    format!("vertices rounded by at most {by:.1e} of a voxel")
}
