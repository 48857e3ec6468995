//! Grids of voxels: which voxels a triangle meets, row by row, exactly.
//!
//! A [`Grid`] is a box of voxels. [`Grid::rows`] names the voxels that a triangle meets, as
//! ranges along x, without a test for each voxel. [`Bits`] fills a grid of bits in the caller's
//! memory with them, a word at a time.
//!
//! ```
//! use septum::voxel::{Bits, Grid, Rule};
//! use septum::Triangle;
//!
//! let mesh = [Triangle::new([0.5, 0.5, 0.5], [3.5, 0.5, 0.5], [0.5, 2.5, 1.5])?];
//! let grid = Grid::new([0.0; 3], [1.0; 3], [4, 3, 2])?;
//!
//! let mut words = vec![0_u64; grid.words::<u64>()];
//! let mut voxels = Bits::new(&grid, &mut words)?;
//! for triangle in &mesh {
//!     voxels.fill(triangle, Rule::Closed);
//! }
//! assert!(voxels.contains([3, 0, 0]) && !voxels.contains([3, 1, 0]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bits;
mod block;
mod ends;
mod few;
mod four_rows;
mod grid;
mod line;
mod marks;
mod pass;
mod place;
mod placed;
mod plane;
mod rows;
mod sign;
mod slabs;
mod solid;
mod view;
mod walk;
mod word;

pub use bits::{Bits, TooFewWords};
pub use grid::{Grid, GridError};
pub use rows::{Row, Rows};
pub use solid::Solid;
pub use walk::Walk;
pub use word::Word;

/// Which voxels a triangle marks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Rule {
    /// Those that it meets as closed boxes: what [`overlaps`](crate::Overlaps::overlaps) says of
    /// [`Grid::voxel`]. A face on a plane of the grid marks both layers beside it. No path
    /// through voxels left free, by faces, edges or corners, crosses the triangle
    /// (26-separating).
    #[default]
    Closed,
    /// Those that hold a point of it, where each point of space is in one voxel: the voxel from
    /// its least planes, included, to its greatest, not included.
    HalfOpen,
    /// Those whose cross it meets: the three segments through the middle of a voxel, from face
    /// to face, each with its lesser end and without its greater one. No path from face to face
    /// of voxels left free crosses the triangle (6-separating).
    ///
    /// For planes these are the thin voxels of Schwarz and Seidel 2010, and of Huang and others
    /// 1998; the cross as the target is S. Laine's, "A Topological Approach to Voxelization",
    /// *Computer Graphics Forum* 32(4), 2013.
    Thin,
}
