//! Raw bits: a header of text lines, then a bit for each voxel.
//!
//! ```text
//! voxels 1
//! size 128 62 80
//! origin -3 0 -2
//! edge 0.05
//! row_bytes 16
//! data
//! ```
//!
//! `origin` is the least corner of the grid, and `edge` that of a voxel, in the mesh's units. Rows
//! go along x, the least bit of a byte first; the rows of y follow each other, then those of z.

use std::io::{self, Write};

use crate::volume::Volume;

pub(crate) fn write(volume: &Volume<'_>, to: &mut impl Write) -> io::Result<()> {
    let ([nx, ny, nz], [x, y, z]) = (volume.size(), volume.origin);
    let row_bytes = 8 * nx.div_ceil(64);
    write!(to, "voxels 1\nsize {nx} {ny} {nz}\norigin {x} {y} {z}\n")?;
    write!(to, "edge {}\nrow_bytes {row_bytes}\ndata\n", volume.edge)?;
    volume.rows().flatten().try_for_each(|word| to.write_all(&word.to_le_bytes()))
}
