//! Voxelization: which voxels of a grid a triangle, a closed mesh or a line meets, exactly.
//!
//! A [`Grid`] is a box of voxels.
//!
//! * [`Grid::rows`] returns the voxels that a triangle meets, as ranges along x, without a test
//!   for each voxel (surface voxelization). [`Bits`] sets their bits in the caller's memory, and
//!   is a set of voxels to iterate and to combine with another. The [`Rule`] says which voxels
//!   count: closed (conservative), half-open or thin (6-separating).
//! * [`Solid`] fills closed meshes by the even-odd rule (solid voxelization).
//! * [`Grid::walk_segment`] and [`Grid::walk_ray`] return the voxels along a line in order, as a
//!   3D digital differential analyzer (DDA) does.
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

// The page of `Grid` shows methods in the order of modules: its constructors come first.
mod grid;

mod bits;
mod block;
mod few;
mod four_rows;
mod line;
mod pass;
mod place;
mod placed;
mod rows;
mod sets;
mod sign;
mod slabs;
mod solid;
mod view;
mod walk;
mod word;

pub use bits::{Bits, TooFewWords};
pub use grid::{Grid, GridError};
pub use rows::{Row, Rows};
pub use sets::{DifferentGrids, Voxels};
pub use solid::Solid;
pub use walk::Walk;
pub use word::Word;

/// Which voxels does a triangle or a line mark?
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Rule {
    /// The voxels that it meets as closed boxes: those for which
    /// [`overlaps`](crate::Overlaps::overlaps) holds with [`Grid::voxel`] (conservative
    /// voxelization). A face on a plane of the grid marks the layers on both sides. No path
    /// through free voxels, by faces, edges or corners, crosses the triangle (26-separating).
    #[default]
    Closed,
    /// The voxels that hold a point of it, where each point of space is in exactly one voxel. A
    /// voxel includes its least planes and excludes its greatest planes.
    HalfOpen,
    /// The voxels whose cross it meets. The cross is three segments through the centre of the
    /// voxel, from face to face, each with its lesser end and without its greater end. No path
    /// through free voxels, by faces, crosses the triangle (6-separating). For walks see
    /// [`Grid::walk_segment`].
    ///
    /// For planes these are the thin voxels of Schwarz and Seidel 2010, and of Huang and others
    /// 1998; the cross as the target is S. Laine's, "A Topological Approach to Voxelization",
    /// *Computer Graphics Forum* 32(4), 2013.
    Thin,
}
