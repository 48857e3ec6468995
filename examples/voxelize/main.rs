//! Voxelizes a triangle mesh with one overlap test for each candidate voxel, and
//! draws the result.
//!
//! ```text
//! cargo run --release --example voxelize
//! cargo run --release --example voxelize -- cow.obj --resolution 256 --scalar i16f16 --vox cow.vox
//! cargo run --release --example voxelize -- --no-picture   # a fraction of a second
//! cargo run --release --example voxelize -- --help
//! ```

#[allow(dead_code, reason = "shared with other examples")]
#[path = "../shared/cli.rs"]
mod cli;
mod color;
mod fill;
mod grid;
mod light;
mod march;
mod mesh;
mod options;
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

use indicatif::HumanCount;
use mesh::Mesh;
use options::{Options, ScalarType, Up};
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
    let mesh = Mesh::load(options.mesh.as_deref(), options.up)?;
    let reading = reading.finish();
    let placed = placement::place(&mesh.triangles, options.resolution)?;
    if options.vox.is_some() {
        vox::check_size(placed.size)?;
    }
    // Whether the results can be written is known before the work is done.
    let place = || options.output.clone().unwrap_or_else(|| default(&mesh));
    let picture = (!options.no_picture).then(|| Output::open(options, place())).transpose()?;
    let model = options.vox.clone().map(|path| Output::open(options, path)).transpose()?;
    if let (Some(picture), Some(model)) = (&picture, &model) {
        if model.is_same(picture) {
            let path = picture.path.display();
            return Err(format!("{path}: both the picture and the model").into());
        }
    }

    let filled = fill::fill(&placed, options.scalar, options.method)?;
    say(&report(options, &mesh, reading, &filled))?;
    if let Some(picture) = picture {
        let start = Instant::now();
        picture.write("picture", |file| Ok(picture::write(&filled.grid, file)?))?;
        say(&line("drawing", &format!("{}, without it: --no-picture", spent(start.elapsed()))))?;
    }
    if let Some(model) = model {
        model.write("model", |file| Ok(vox::write(&filled.grid, file)?))?;
    }
    Ok(())
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
        let mesh = options.mesh.as_deref().and_then(place);
        if mesh.is_some() && mesh == place(&path) {
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

fn report(options: &Options, mesh: &Mesh, reading: Duration, filled: &fill::Filled) -> String {
    let [x, y, z] = filled.grid.size();
    // The report has the order of the file's axes.
    let [x, y, z] = if mesh.up == Up::Z { [x, z, y] } else { [x, y, z] };
    let (set, all) = (filled.grid.count(), (x * y * z) as f64);
    let triangles = mesh.triangles.len() as u64;
    let each = 1e9 * filled.time.as_secs_f64() / filled.tests as f64;
    let tests = HumanCount(filled.tests);
    [
        ("mesh", format!("{}, {} triangles", mesh.name, HumanCount(triangles))),
        ("grid", format!("{x} × {y} × {z} voxels")),
        ("scalar", format!("{}, {}", options.scalar.name(), moved(filled.moved))),
        ("method", options.method.description().into()),
        ("tests", format!("{tests}, one for each triangle and voxel it may meet")),
        (
            "set",
            format!("{} voxels, {:.1} % of the grid", HumanCount(set), 100.0 * set as f64 / all),
        ),
        ("reading", spent(reading)),
        ("testing", format!("{}, {each:.1} ns a test", spent(filled.time))),
    ]
    .map(|(name, value)| line(name, &value))
    .concat()
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
