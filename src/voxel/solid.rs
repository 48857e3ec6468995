use super::bits::{Bits, TooFewWords};
use super::grid::Grid;
use super::place::{Marks, Place};
use super::placed::{Near, Placed, Plane};
use super::slabs::{Edge, rising};
use super::word::Word;
use crate::arithmetic::{Each, three};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// Solid voxelization: which voxels have their centres inside a closed mesh, by the even-odd rule.
///
/// *Geometry*: each row of voxels has a line through their centres. A centre is inside if an odd
/// number of triangles crosses the line before it (even-odd rule, parity). The orientation of
/// triangles does not matter. The space that two closed meshes both enclose is outside of their
/// union.
///
/// *Contact*: a centre on a triangle, or a line through an edge or a vertex, is treated as if moved
/// by (ε, ε², ε³). All lines and centres are moved alike. Therefore each line crosses a closed mesh
/// an even number of times, and each centre is in exactly one of two solids that share a face.
///
/// *Numerics*: exact for every mesh and grid, in every scalar. The order of triangles and vertices
/// and the cut of a grid into parts change no bit.
///
/// If a line crosses the mesh an odd number of times, the mesh is open there. The row then has no
/// inside, and [`open_rows`](Self::open_rows) returns it.
///
/// ```
/// use septum::voxel::{Grid, Solid};
/// use septum::Triangle;
///
/// // A tetrahedron.
/// let [o, x, y, z] = [[0.0; 3], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0]];
/// let mesh = [[o, y, x], [o, x, z], [o, z, y], [x, y, z]];
///
/// let grid = Grid::new([0.0; 3], [1.0; 3], [8, 8, 8])?;
/// let mut words = vec![0_u64; grid.words::<u64>()];
/// let mut lines = vec![0_u64; grid.line_words::<u64>()];
/// let mut solid = Solid::new(&grid, &mut words, &mut lines)?;
/// for [a, b, c] in mesh {
///     solid.cross(&Triangle::new(a, b, c)?);
/// }
/// solid.finish();
/// assert_eq!(solid.open_rows().count(), 0);
/// let inside = solid.bits();
/// assert!(inside.contains([0, 0, 0]) && inside.contains([1, 2, 3]) && !inside.contains([3, 3, 3]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Solid<'a, S, W> {
    bits: Bits<'a, S, W>,
    /// A bit for each row: y rises within the words of a layer.
    lines: &'a mut [W],
}

impl<S: Copy> Grid<S> {
    /// Returns the number of words for one bit per row of the grid, which [`Solid`] needs.
    #[must_use]
    pub const fn line_words<W: Word>(&self) -> usize {
        let [_, y, z] = self.resolution();
        (y.div_ceil(W::BITS) as usize).saturating_mul(z as usize)
    }
}

impl<'a, S: Scalar, W: Word> Solid<'a, S, W> {
    /// Makes an empty solid in the first of these words, and clears these words.
    ///
    /// # Errors
    /// [`TooFewWords`] if there are fewer words than [`Grid::words`], or fewer lines than
    /// [`Grid::line_words`].
    ///
    /// *Panics*: never.
    pub fn new(
        grid: &Grid<S>,
        words: &'a mut [W],
        lines: &'a mut [W],
    ) -> Result<Self, TooFewWords> {
        let mut solid = Self::resume(grid, words, lines)?;
        solid.bits.clear();
        solid.lines.fill(W::ZERO);
        Ok(solid)
    }

    /// Continues a solid that these words and lines hold, as another `Solid` left them. A program
    /// that adds triangles over several calls or frames so keeps the memory alone.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// *Panics*: never.
    pub fn resume(
        grid: &Grid<S>,
        words: &'a mut [W],
        lines: &'a mut [W],
    ) -> Result<Self, TooFewWords> {
        let needed = grid.line_words::<W>();
        let lines = lines.get_mut(..needed).ok_or(TooFewWords { needed })?;
        Ok(Self { bits: Bits::new(grid, words)?, lines })
    }

    /// Adds a triangle: marks where the lines of rows cross it.
    ///
    /// *Panics*: never. *Cost*: two multiplications and two additions for each line that crosses
    /// the triangle, and for each of its layers.
    pub fn cross(&mut self, triangle: &Triangle<S>) {
        let grid = *self.bits.grid();
        let line_words = grid.resolution()[1].div_ceil(W::BITS) as usize;
        let [nx, ..] = grid.resolution();
        crossings(&grid, triangle, |[y, z], x| {
            if x < nx {
                self.bits.flip([x, y, z]);
            }
            let line = self.lines.get_mut(z as usize * line_words + (y / W::BITS) as usize);
            if let Some(line) = line {
                *line ^= W::ONE << (y % W::BITS);
            }
        });
    }

    /// Turns the crossings into the inside, once all triangles are added. Add no triangle after
    /// that, and do not call it again.
    pub fn finish(&mut self) {
        let [_, ny, nz] = self.bits.grid().resolution();
        for z in 0..nz {
            for y in 0..ny {
                let is_open = self.is_open(y, z);
                self.bits.fill_between(y, z, is_open);
            }
        }
    }

    /// Where is the mesh open? Returns the rows (y, z) whose lines cross it an odd number of times;
    /// these rows have no inside. A closed mesh has none.
    ///
    /// *Cost*: one bit is read for each row of the grid.
    pub fn open_rows(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let [_, ny, nz] = self.bits.grid().resolution();
        (0..nz).flat_map(move |z| (0..ny).map(move |y| [y, z])).filter(|&[y, z]| self.is_open(y, z))
    }

    /// Returns the voxels inside the mesh, after [`finish`](Self::finish).
    #[must_use]
    pub const fn bits(&self) -> &Bits<'a, S, W> {
        &self.bits
    }

    fn is_open(&self, y: u32, z: u32) -> bool {
        let line_words = self.bits.grid().resolution()[1].div_ceil(W::BITS) as usize;
        let line = self.lines.get(z as usize * line_words + (y / W::BITS) as usize);
        line.is_some_and(|&line| line >> (y % W::BITS) & W::ONE == W::ONE)
    }
}

/// For each row whose line crosses the triangle, calls `cross` with the first voxel whose centre is
/// behind the crossing.
///
/// A line is moved by (ε², ε³) in y and z. An edge crosses it in z exactly if one end has z ≤ the
/// line's z and the other end a greater z; a crossing at the line's own y counts as before the
/// line. A centre moved by ε in x is behind a crossing at its own x.
#[inline(always)]
fn crossings<S: Scalar>(
    grid: &Grid<S>,
    triangle: &Triangle<S>,
    mut cross: impl FnMut([u32; 2], u32),
) {
    let placed = Placed::new(&Near::new(triangle, grid), grid, [Marks::Center; 3]);
    let [nx, ny, nz] = grid.resolution().each(|n| n as i32);
    let (first, last) = (placed.least[2].at.max(0), placed.greatest[2].at.min(nz));
    if first >= last || placed.least[1].at >= ny || placed.greatest[1].at <= 0 {
        return;
    }
    // A triangle parallel to x crosses no line.
    let Some(plane) = Plane::new(&placed) else { return };
    let edges = three(|k| {
        let ends = rising(&placed, 2, k);
        (ends.each(|k| placed.at[k][2].at), Edge::new(&placed, [1, 2], ends))
    });
    let (low, high) = (placed.least[0], placed.greatest[0]);
    for z in first..last {
        let mut span = [i32::MAX, i32::MIN];
        for ([from, to], edge) in &edges {
            if (*from..*to).contains(&z) {
                let y = edge.place(&placed, grid, [1, 2], z).at;
                span = [span[0].min(y), span[1].max(y)];
            }
        }
        for y in span[0].max(0)..span[1].min(ny) {
            let lines = [y, z].each(|k| Marks::Center.limit(k));
            let Place { at, .. } = plane.place(&placed, grid, lines, low, high);
            cross([y as u32, z as u32], at.min(nx) as u32);
        }
    }
}
