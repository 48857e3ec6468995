use super::bits::{Bits, TooFewWords};
use super::grid::Grid;
use super::marks::Marks;
use super::place::Place;
use super::placed::{Near, Placed};
use super::plane::Plane;
use super::slabs::{Edge, rising};
use super::word::Word;
use crate::arithmetic::three;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// The inside of closed meshes: the voxels whose centres are inside.
///
/// *Geometry*: along each row of voxels runs the line through their centres. A centre is inside if
/// an odd number of triangles crosses the line before it. So the inside of a mesh that is closed
/// is what it encloses, its orientation does not matter, and what two closed meshes both enclose
/// is outside of both together.
///
/// *Contact*: a centre on a triangle, or a line through an edge or a vertex, counts as moved by
/// (ε, ε², ε³). All lines and centres are moved alike, so that each line crosses a closed mesh an
/// even number of times, and each centre is in one of two solids that share a face.
///
/// *Numerics*: exact for every mesh and grid, in every scalar. Each triangle crosses on its own:
/// the order of triangles and vertices, and how a grid is parted, change no bit.
///
/// A line that crosses the mesh an odd number of times shows that the mesh is open there. Its row
/// has no inside, and [`open_rows`](Self::open_rows) names it.
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
    /// For each z, in words of its own, a bit for each y.
    lines: &'a mut [W],
}

impl<S: Copy> Grid<S> {
    /// How many words a bit for each row of the grid takes, for [`Solid`].
    #[must_use]
    pub const fn line_words<W: Word>(&self) -> usize {
        let [_, y, z] = self.resolution();
        (y.div_ceil(W::BITS) as usize).saturating_mul(z as usize)
    }
}

impl<'a, S: Scalar, W: Word> Solid<'a, S, W> {
    /// An empty solid, in the first of these words, which are cleared.
    ///
    /// # Errors
    /// [`TooFewWords`] where there are fewer words than [`Grid::words`], or fewer lines than
    /// [`Grid::line_words`].
    ///
    /// *Panics*: never.
    pub fn new(
        grid: &Grid<S>,
        words: &'a mut [W],
        lines: &'a mut [W],
    ) -> Result<Self, TooFewWords> {
        let needed = grid.line_words::<W>();
        let lines = lines.get_mut(..needed).ok_or(TooFewWords { needed })?;
        let mut bits = Bits::new(grid, words)?;
        bits.clear();
        lines.fill(W::ZERO);
        Ok(Self { bits, lines })
    }

    /// Notes where the lines of rows cross a triangle.
    ///
    /// *Panics*: never. *Cost*: two multiplications and additions for each line that crosses it, and
    /// for each layer of z that it comes to.
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

    /// Makes the inside of the crossings, once all triangles are in. Crossing more triangles
    /// afterwards makes no sense.
    pub fn finish(&mut self) {
        let [_, ny, nz] = self.bits.grid().resolution();
        for z in 0..nz {
            for y in 0..ny {
                let is_open = self.is_open(y, z);
                self.bits.fill_between(y, z, is_open);
            }
        }
    }

    /// The rows (y, z) whose lines cross the mesh an odd number of times, so that nothing is said
    /// to be inside there. None, if the mesh is closed. *Cost*: a look at one bit of each row.
    pub fn open_rows(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let [_, ny, nz] = self.bits.grid().resolution();
        (0..nz).flat_map(move |z| (0..ny).map(move |y| [y, z])).filter(|&[y, z]| self.is_open(y, z))
    }

    /// The voxels that are inside, after [`finish`](Self::finish).
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

/// For each row whose line crosses the triangle, the first voxel whose centre is behind it.
///
/// Of a line moved by (ε², ε³) in y and z: an edge crosses it in z exactly if one end has z at
/// most as great as the line's and the other a greater one, and a crossing at the line's own y is
/// before it. A centre moved by ε in x is behind a crossing at its own x.
#[inline(always)]
fn crossings<S: Scalar>(
    grid: &Grid<S>,
    triangle: &Triangle<S>,
    mut cross: impl FnMut([u32; 2], u32),
) {
    let placed = Placed::new(&Near::new(triangle, grid), grid, [Marks::Center; 3]);
    let [nx, ny, nz] = grid.resolution().map(|n| n as i32);
    let (first, last) = (placed.least[2].at.max(0), placed.greatest[2].at.min(nz));
    if first >= last || placed.least[1].at >= ny || placed.greatest[1].at <= 0 {
        return;
    }
    // Parallel to x it crosses nothing.
    let Some(plane) = Plane::new(&placed) else { return };
    let edges = three(|k| {
        let ends = rising(&placed, 2, k);
        (ends.map(|k| placed.at[k][2].at), Edge::new(&placed, [1, 2], ends))
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
            let lines = [y, z].map(|k| Marks::Center.limit(k));
            let Place { at, .. } = plane.place(&placed, grid, lines, low, high);
            cross([y as u32, z as u32], at.min(nx) as u32);
        }
    }
}
