//! Voxelizes triangle meshes, the surface or also the inside, and draws the result.
//!
//! ```text
//! cargo run --release --example voxelize
//! cargo run --release --example voxelize -- cow.obj --resolution 256 --scalar i16f16 --vox cow.vox
//! cargo run --release --example voxelize -- --solid --cut
//! cargo run --release --example voxelize -- --method rows --compare published --scalar i16f16
//! cargo run --release --example voxelize -- --no-picture   # a fraction of a second
//! cargo run --release --example voxelize -- --help
//! ```

mod camera;
#[allow(dead_code, reason = "shared with other examples")]
#[path = "../shared/cli.rs"]
mod cli;
mod color;
mod fill;
mod gltf;
mod grid;
mod light;
mod march;
mod mesh;
mod options;
mod per_voxel;
mod picture;
mod placement;
mod progress;
mod vox;

use std::error::Error;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use fill::Task;
use grid::Grid;
use indicatif::HumanCount;
use mesh::Mesh;
use options::{Method, Options, RuleName, ScalarType, Up};
use picture::View;
use placement::Placed;
use progress::Progress;

fn main() -> ExitCode {
    match run(&cli::read()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    check_resolution(options.resolution, options.scalar)?;
    let reading = Progress::of_unknown_length("Reading");
    let mesh = Mesh::load(&options.meshes, options.up)?;
    let reading = reading.finish();
    let placed = placement::place(&mesh.triangles, options.resolution)?;
    if options.vox.is_some() {
        vox::check_size(placed.size)?;
    }
    // Opens the output files before the work begins.
    let place = || options.output.clone().unwrap_or_else(|| default(&mesh));
    let picture = (!options.no_picture).then(|| Output::open(options, place())).transpose()?;
    let model = options.vox.clone().map(|path| Output::open(options, path)).transpose()?;
    if let (Some(picture), Some(model)) = (&picture, &model) {
        if model.is_same(picture) {
            let path = picture.path.display();
            return Err(format!("{path}: both the picture and the model").into());
        }
    }

    let task = task(options, picture.is_some() || model.is_some())?;
    let filled = fill::fill(&placed, &task)?;
    say(&report(options, &mesh, reading, &placed, &filled))?;
    let grid = filled.grid.as_ref();
    let other = match options.compare {
        Some(method) => fill::fill(&placed, &Task { method, ..task })?.grid,
        None => None,
    };
    if let (Some(grid), Some(other)) = (grid, &other) {
        say(&compared(options, grid, other))?;
    }
    if let (Some(picture), Some(grid)) = (picture, grid) {
        let start = Instant::now();
        let views = views(options, grid, other.as_ref());
        picture.write("picture", |file| Ok(picture::write(&views, file)?))?;
        say(&line("drawing", &format!("{}, without it: --no-picture", spent(start.elapsed()))))?;
    }
    if let (Some(model), Some(grid)) = (model, grid) {
        model.write("model", |file| Ok(vox::write(grid, file)?))?;
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

fn check_resolution(resolution: u32, scalar: ScalarType) -> Result<(), String> {
    if resolution == 0 {
        return Err("--resolution 0: a grid needs at least one voxel".into());
    }
    let holds = |s: ScalarType| u64::from(resolution) <= s.finest_grid();
    if holds(scalar) {
        return Ok(());
    }
    let (name, finest) = (scalar.name(), scalar.finest_grid());
    let others = [ScalarType::I16F16, ScalarType::I32F32, ScalarType::F32, ScalarType::F64];
    let wide: Vec<_> = others.into_iter().filter(|&s| holds(s)).map(ScalarType::name).collect();
    Err(format!(
        "--resolution {resolution}: --scalar {name} can hold at most {finest}; {} can hold it",
        wide.join(", ")
    ))
}

fn default(mesh: &Mesh) -> PathBuf {
    Path::new("out").join(format!("{}.png", mesh.name))
}

/// A file to write, opened before the work begins.
struct Output {
    path: PathBuf,
    file: File,
}

impl Output {
    fn open(options: &Options, path: PathBuf) -> Result<Self, Box<dyn Error>> {
        let in_file = |e: std::io::Error| format!("{}: cannot be written: {e}", path.display());
        let place = |path: &Path| path.canonicalize().ok();
        let mut meshes = options.meshes.iter().filter_map(|mesh| place(mesh));
        if meshes.any(|mesh| Some(mesh) == place(&path)) {
            return Err(format!("{}: is the mesh itself", path.display()).into());
        }
        if let Some(directory) = path.parent() {
            fs::create_dir_all(directory).map_err(in_file)?;
        }
        let file = File::create(&path).map_err(in_file)?;
        Ok(Self { path, file })
    }

    fn is_same(&self, other: &Self) -> bool {
        let place = |output: &Self| output.path.canonicalize().ok();
        place(self).is_some() && place(self) == place(other)
    }

    fn write(
        self,
        what: &str,
        content: impl FnOnce(&mut BufWriter<File>) -> Result<(), Box<dyn Error>>,
    ) -> Result<(), Box<dyn Error>> {
        let mut file = BufWriter::new(self.file);
        content(&mut file)
            .and_then(|()| Ok(file.flush()?))
            .map_err(|e| format!("{}: cannot be written: {e}", self.path.display()))?;
        say(&line(what, &self.path.display().to_string()))
    }
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
        Some(0) => lines.push(("inside", "of a closed mesh".into())),
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

/// Prints. A closed pipe is no error.
fn say(text: &str) -> Result<(), Box<dyn Error>> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}
