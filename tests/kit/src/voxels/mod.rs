//! Checks of voxelization. They are in this package rather than in the test, so that the crate's
//! part of it is compiled with full optimization.

mod large;
mod oracle;
mod parts;
mod random;
mod scene;
mod solid;
mod walk;

use septum::Triangle;
use septum::voxel::{Bits, Grid, Rule};

pub use scene::{VoxelScene, torus_knot};
pub use solid::Insides;

use crate::{Each, Sample};
use large::{first_rows, rows_under_nothing};
use oracle::{Marks, planes};
use parts::{marks_in_parts, walks_in_parts};
use random::{marks_agree_with_oracle, rows_agree_with_pairs};
use solid::check_solid;
use walk::walks_are_right;

/// The scalar of a check, by name, because the checks are compiled here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum InScalar {
    F32,
    F64,
    I8F8,
    I16F16,
    I32F32,
}

/// Calls a generic function with a scalar given by name.
macro_rules! in_scalar {
    ($scalar:expr, $function:ident($($argument:expr),*)) => {
        match $scalar {
            InScalar::F32 => $function::<f32>($($argument),*),
            InScalar::F64 => $function::<f64>($($argument),*),
            InScalar::I8F8 => $function::<fixed::types::I8F8>($($argument),*),
            InScalar::I16F16 => $function::<fixed::types::I16F16>($($argument),*),
            InScalar::I32F32 => $function::<fixed::types::I32F32>($($argument),*),
        }
    };
}

impl InScalar {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::F32, Self::F64, Self::I8F8, Self::I16F16, Self::I32F32];

    /// Voxelizes the scene and compares with the oracle; `None` if the scene exceeds the scalar's
    /// range.
    pub fn check(self, scene: &VoxelScene, rule: Rule) -> Option<Voxelized> {
        let fits = match self {
            Self::F32 => scene.fits::<f32>(),
            Self::F64 => scene.fits::<f64>(),
            Self::I8F8 => scene.fits::<fixed::types::I8F8>(),
            Self::I16F16 => scene.fits::<fixed::types::I16F16>(),
            Self::I32F32 => scene.fits::<fixed::types::I32F32>(),
        };
        fits.then(|| in_scalar!(self, check(scene, rule)))
    }

    /// [`rows_agree_with_pairs`] in this scalar.
    pub fn rows_agree_with_pairs(self, seed: u64, grids: u32, most: i64) -> u64 {
        in_scalar!(self, rows_agree_with_pairs(seed, grids, most))
    }

    /// [`marks_agree_with_oracle`] in this scalar.
    pub fn marks_agree_with_oracle(self, seed: u64, grids: u32, most: i64) -> u64 {
        in_scalar!(self, marks_agree_with_oracle(seed, grids, most))
    }

    /// Fills the inside of the scene's closed mesh, and compares with the oracle.
    pub fn check_solid(self, scene: &VoxelScene) -> Insides {
        in_scalar!(self, check_solid(scene))
    }

    /// Walks along random lines, and compares with the oracle; returns the number of voxels met.
    pub fn walks_are_right(self, seed: u64, grids: u32) -> u64 {
        in_scalar!(self, walks_are_right(seed, grids))
    }

    /// Walks in every part of small grids, beside the walk in the whole grid.
    pub fn walks_in_parts(self, kind: LineKind, seed: u64, cases: u64) -> Tally {
        in_scalar!(self, walks_in_parts(kind, seed, cases))
    }

    /// Rows, bits and solids in every part of small grids, beside those of the whole grid.
    pub fn marks_in_parts(self, seed: u64, cases: u64) -> Tally {
        in_scalar!(self, marks_in_parts(seed, cases))
    }

    /// The first rows of large triangles in the largest grids, beside the pair.
    pub fn first_rows(self, seed: u64, cases: u64) -> Tally {
        in_scalar!(self, first_rows(seed, cases))
    }

    /// The rows of a large triangle that passes beside the largest grid: by every rule none.
    pub fn rows_under_nothing(self) -> usize {
        in_scalar!(self, rows_under_nothing())
    }

    /// The words of the scene stay the same with triangles and vertices in another order, and when
    /// filled slab by slab along each axis.
    pub fn keeps_order_and_slabs(self, scene: &VoxelScene, rule: Rule) {
        in_scalar!(self, keeps_order_and_slabs(scene, rule));
    }
}

/// Lines to walk along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// Between halves of whole numbers, in unit cells: through corners and along faces.
    HalfIntegerSegments,
    /// From and along halves of whole numbers.
    HalfIntegerRays,
    /// Any segments in any grid.
    RandomSegments,
    /// Any rays in any grid.
    RandomRays,
}

impl LineKind {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::HalfIntegerSegments, Self::HalfIntegerRays, Self::RandomSegments, Self::RandomRays];

    const fn is_segments(self) -> bool {
        matches!(self, Self::HalfIntegerSegments | Self::RandomSegments)
    }
}

/// How many cases there were, and how many came out wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Cases.
    pub cases: u64,
    /// Wrong ones.
    pub wrong: u64,
}

impl Tally {
    fn count(&mut self, is_right: bool) {
        self.cases += 1;
        self.wrong += u64::from(!is_right);
    }
}

/// The result of a check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Voxelized {
    /// Voxels that are set.
    pub set: u64,
    /// Voxels that only the oracle marks.
    pub missed: u64,
    /// Voxels that only the crate sets.
    pub extra: u64,
}

/// The scene in a scalar.
fn rounded<S: Sample>(scene: &VoxelScene) -> (Grid<S>, Vec<Triangle<S>>) {
    let to = |p: [f64; 3]| p.each(S::nearest);
    let grid = Grid::new(to(scene.origin), to(scene.cell), scene.resolution).expect("a grid");
    let triangle =
        |[a, b, c]: &[[f64; 3]; 3]| Triangle::new(to(*a), to(*b), to(*c)).expect("a triangle");
    (grid, scene.triangles.iter().map(triangle).collect())
}

/// The bits of all triangles.
fn filled<S: Sample>(grid: &Grid<S>, triangles: &[Triangle<S>], rule: Rule) -> Vec<u64> {
    let mut words = vec![0; grid.words::<u64>()];
    let mut bits = Bits::new(grid, &mut words).expect("enough words");
    triangles.iter().for_each(|triangle| bits.fill(triangle, rule));
    words
}

/// Fills the scene's triangles, and asks the oracle about every voxel within a voxel of each
/// triangle's bounding box. It compares triangle by triangle, because a voxel that one triangle
/// marks wrongly may be marked rightly by another.
fn check<S: Sample>(scene: &VoxelScene, rule: Rule) -> Voxelized {
    let (grid, triangles) = rounded::<S>(scene);
    let planes = planes(&grid);
    let mut found = Voxelized::default();
    let mut union = vec![0_u64; grid.words::<u64>()];
    let mut one = vec![0_u64; grid.words::<u64>()];
    for triangle in &triangles {
        let vertices = triangle.vertices().each(|v| v.to_array());
        let marks = Marks::new(&vertices, &planes);
        Bits::new(&grid, &mut one).expect("enough words").fill(triangle, rule);
        let bits = Bits::new(&grid, &mut one).expect("enough words");
        let mut seen = 0;
        let range = |axis: usize| {
            let [a, b, c] = vertices.each(|v| v[axis]);
            let least = if a < b { a } else { b };
            let least = if least < c { least } else { c };
            let greatest = if a > b { a } else { b };
            let greatest = if greatest > c { greatest } else { c };
            let from = planes[axis].partition_point(|&p| p < least).saturating_sub(2);
            let to = planes[axis].partition_point(|&p| p <= greatest) + 1;
            from as u32..(to as u32).min(grid.resolution()[axis])
        };
        for z in range(2) {
            for y in range(1) {
                for x in range(0) {
                    let (set, is_marked) = (bits.contains([x, y, z]), marks.has([x, y, z], rule));
                    seen += u64::from(set);
                    found.missed += u64::from(is_marked && !set);
                    found.extra += u64::from(set && !is_marked);
                }
            }
        }
        // Nothing is set elsewhere.
        found.extra += bits.count() - seen;
        for (all, word) in union.iter_mut().zip(&mut one) {
            *all |= std::mem::take(word);
        }
    }
    assert!(union == filled(&grid, &triangles, rule), "{}: all at once", scene.name);
    found.set = union.iter().map(|word| u64::from(word.count_ones())).sum();
    found
}

fn keeps_order_and_slabs<S: Sample>(scene: &VoxelScene, rule: Rule) {
    let (grid, mut triangles) = rounded::<S>(scene);
    let all = filled(&grid, &triangles, rule);
    let [nx, ny, nz] = grid.resolution();
    let middle = |n: u32| n / 3 + 1;
    let in_z = [0..middle(nz), middle(nz)..nz].each(|z| {
        let slab = grid.part([0..nx, 0..ny, z]).expect("a slab");
        filled(&slab, &triangles, rule)
    });
    assert!(all == in_z.concat(), "{}: slabs of z", scene.name);
    let whole = |words: &mut Vec<u64>, grid: &Grid<S>, voxel: [u32; 3]| {
        Bits::new(grid, words).expect("enough words").contains(voxel)
    };
    let mut all_words = all.clone();
    for axis in 0..2 {
        let mut ranges = [0..nx, 0..ny, 0..nz];
        ranges[axis] = middle(ranges[axis].end)..ranges[axis].end;
        let [x, y, z] = ranges.clone();
        let slab = grid.part(ranges.clone()).expect("a slab");
        let mut words = filled(&slab, &triangles, rule);
        for z in z {
            for y in y.clone() {
                for x in x.clone() {
                    let inside = [x - ranges[0].start, y - ranges[1].start, z];
                    let is_same =
                        whole(&mut words, &slab, inside) == whole(&mut all_words, &grid, [x, y, z]);
                    assert!(is_same, "{}: slabs of axis {axis}", scene.name);
                }
            }
        }
    }
    for (i, order) in crate::VERTEX_ORDERS.into_iter().cycle().take(triangles.len()).enumerate() {
        let v = *triangles[i].vertices();
        let [a, b, c] = order.each(|k| v[k]);
        triangles[i] = Triangle::new(a, b, c).expect("a triangle");
    }
    triangles.reverse();
    assert!(all == filled(&grid, &triangles, rule), "{}: another order", scene.name);
}
