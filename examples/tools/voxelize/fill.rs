//! Voxelization: finds the voxels that the mesh meets. It works slab by slab, so that threads share
//! the work, and a large grid takes little memory if only the count is needed.

use std::error::Error;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use fixed::types::{I8F8, I16F16, I32F32};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use septum::voxel::{self, Bits, Rule, Solid};
use septum::{Scalar, Triangle};

use crate::grid::{self, Grid};
use crate::options::{Method, ScalarType};
use crate::per_voxel::PerVoxel;
use crate::placement::{Placed, check_memory};
use crate::progress::Progress;

/// The most memory of a slab for each thread, in words of 64 bits: 4 MiB.
const SLAB_WORDS: usize = 1 << 19;

/// The task.
#[derive(Clone, Copy)]
pub(crate) struct Task {
    pub(crate) scalar: ScalarType,
    pub(crate) method: Method,
    pub(crate) rule: Rule,
    /// Whether the voxels inside are set too.
    pub(crate) solid: bool,
    /// The number of threads; `None` for one on each core.
    pub(crate) threads: usize,
    /// Whether to keep the voxels, or only their number.
    pub(crate) keep: bool,
}

/// The voxels that the mesh meets, and the cost of finding them.
pub(crate) struct Filled {
    /// The voxels, if they are kept.
    pub(crate) grid: Option<Grid>,
    /// The number of set voxels.
    pub(crate) set: u64,
    /// The number of overlap tests, for methods that test each voxel.
    pub(crate) tests: Option<u64>,
    /// The number of rows in which the mesh is not closed, if the inside was requested.
    pub(crate) open_rows: Option<u64>,
    /// The time of finding them.
    pub(crate) time: Duration,
    /// The greatest change of a coordinate by rounding to the scalar, in voxels.
    pub(crate) moved: f64,
}

/// Sets every voxel that overlaps a triangle, according to the method.
pub(crate) fn fill(mesh: &Placed, task: &Task) -> Result<Filled, Box<dyn Error>> {
    match task.scalar {
        ScalarType::F32 => in_scalar(mesh, task, |x| x as f32, f64::from),
        ScalarType::F64 => in_scalar(mesh, task, |x| x, |x| x),
        ScalarType::I8F8 => in_scalar(mesh, task, I8F8::from_num, I8F8::to_num),
        ScalarType::I16F16 => in_scalar(mesh, task, I16F16::from_num, I16F16::to_num),
        ScalarType::I32F32 => in_scalar(mesh, task, I32F32::from_num, I32F32::to_num),
    }
}

/// A triangle, and the layers of voxels that it may touch.
struct Part<S> {
    triangle: Triangle<S>,
    layers: Range<u32>,
}

fn in_scalar<S: Scalar>(
    mesh: &Placed,
    task: &Task,
    nearest: impl Fn(f64) -> S,
    value: impl Fn(S) -> f64,
) -> Result<Filled, Box<dyn Error>> {
    let size = mesh.size.map(|n| n as u32);
    let origin = [0, 1, 2].map(|axis| nearest(mesh.start(axis)));
    let grid = voxel::Grid::new(origin, [nearest(1.0); 3], size)?;
    let (parts, moved) = rounded(mesh, nearest, &value)?;
    let work = Work { grid, parts, task, per_voxel: PerVoxel::new(&grid, task.method) };

    let layer_words = grid.row_words::<u64>() * mesh.size[1];
    let threads = rayon::ThreadPoolBuilder::new().num_threads(task.threads).build()?;
    // Several slabs for each thread, because the mesh is not evenly distributed.
    let few = mesh.size[2].div_ceil(4 * threads.current_num_threads());
    let layers = if threads.current_num_threads() == 1 { mesh.size[2] } else { few };
    let layers = layers.min((SLAB_WORDS / layer_words.max(1)).max(1));
    let slabs = mesh.size[2].div_ceil(layers);
    if !task.keep {
        let at_once = threads.current_num_threads().min(slabs) * layers;
        check_memory([mesh.size[0], mesh.size[1], at_once])?;
    }
    let progress = Progress::new("Voxelizing", slabs as u64);
    let slab = |k: usize, words: &mut [u64]| {
        let from = (k * layers) as u32;
        let sum = work.slab(from..(from + layers as u32).min(size[2]), words);
        progress.add(1);
        sum
    };
    let mut kept = task.keep.then(|| Grid::new(mesh.size));
    let sums = threads.install(|| match &mut kept {
        Some(kept) => kept
            .words_mut()
            .par_chunks_mut(layers * layer_words)
            .enumerate()
            .map(|(k, words)| slab(k, words))
            .reduce(Sums::default, Sums::plus),
        None => (0..slabs)
            .into_par_iter()
            .map_init(|| vec![0; layers * layer_words], |words, k| slab(k, words))
            .reduce(Sums::default, Sums::plus),
    });
    Ok(Filled {
        grid: kept,
        set: sums.set,
        tests: work.per_voxel.is_some().then(|| work.tests()),
        open_rows: task.solid.then_some(sums.open_rows),
        time: progress.finish(),
        moved,
    })
}

/// The mesh rounded to the scalar. All verdicts are about this mesh.
fn rounded<S: Scalar>(
    mesh: &Placed,
    nearest: impl Fn(f64) -> S,
    value: impl Fn(S) -> f64,
) -> Result<(Vec<Part<S>>, f64), septum::ShapeError> {
    let mut moved = 0_f64;
    let mut parts = Vec::with_capacity(mesh.triangles.len());
    for points in &mesh.triangles {
        let [a, b, c] = points.map(|p| p.map(&nearest));
        let values = [a, b, c].map(|p| p.map(&value));
        for (x, y) in points.as_flattened().iter().zip(values.as_flattened()) {
            moved = moved.max((x - y).abs());
        }
        let touched = mesh.touched(2, values.map(|p| p[2]));
        let layers = *touched.start() as u32..*touched.end() as u32 + 1;
        parts.push(Part { triangle: Triangle::new(a, b, c)?, layers });
    }
    Ok((parts, moved))
}

/// The sums over slabs.
#[derive(Default)]
struct Sums {
    set: u64,
    open_rows: u64,
}

impl Sums {
    fn plus(self, other: Self) -> Self {
        Self { set: self.set + other.set, open_rows: self.open_rows + other.open_rows }
    }
}

struct Work<'a, S> {
    grid: voxel::Grid<S>,
    parts: Vec<Part<S>>,
    task: &'a Task,
    /// For methods that test one voxel at a time.
    per_voxel: Option<PerVoxel<S>>,
}

impl<S: Scalar> Work<'_, S> {
    /// Fills the words of a slab, and counts the set voxels.
    fn slab(&self, layers: Range<u32>, words: &mut [u64]) -> Sums {
        let [nx, ny, _] = self.grid.resolution();
        let slab = self.grid.part([0..nx, 0..ny, layers.clone()]).expect("a slab of the grid");
        let words = &mut words[..slab.words::<u64>()];
        let in_slab = || {
            let meets =
                |part: &&Part<S>| part.layers.start < layers.end && part.layers.end > layers.start;
            self.parts.iter().filter(meets).map(|part| &part.triangle)
        };
        let mut open_rows = 0;
        if self.task.solid {
            let mut lines = vec![0_u64; slab.line_words::<u64>()];
            let mut solid = Solid::new(&slab, words, &mut lines).expect("enough words");
            in_slab().for_each(|triangle| solid.cross(triangle));
            solid.finish();
            open_rows = solid.open_rows().count() as u64;
        } else {
            words.fill(0);
        }
        match &self.per_voxel {
            Some(per_voxel) => in_slab().for_each(|t| per_voxel.fill(t, layers.clone(), words)),
            None => {
                let mut bits = Bits::new(&slab, words).expect("enough words");
                in_slab().for_each(|triangle| bits.fill(triangle, self.task.rule));
            }
        }
        Sums { set: grid::count(words), open_rows }
    }

    /// The number of tests, with one for each voxel.
    fn tests(&self) -> u64 {
        let tests = AtomicU64::new(0);
        if let Some(per_voxel) = &self.per_voxel {
            for part in &self.parts {
                tests.fetch_add(per_voxel.candidates(&part.triangle), Ordering::Relaxed);
            }
        }
        tests.into_inner()
    }
}
