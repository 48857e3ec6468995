//! A NumPy array: `numpy.load(file)[x, y, z]` is true where a voxel is set.
//!
//! *Source*: the format, version 1.0, in NumPy's manual, `numpy.lib.format`.

use std::io::{self, Write};

use crate::volume::Volume;

/// A byte for each voxel, x fastest.
pub(crate) fn write(volume: &Volume<'_>, to: &mut impl Write) -> io::Result<()> {
    let [nx, ny, nz] = volume.size();
    let header =
        format!("{{'descr': '|b1', 'fortran_order': True, 'shape': ({nx}, {ny}, {nz}), }}");
    // The data begins at a multiple of 64 bytes, after a newline.
    let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
    to.write_all(b"\x93NUMPY\x01\x00")?;
    to.write_all(&(length as u16).to_le_bytes())?;
    writeln!(to, "{header:<width$}", width = length - 1)?;
    for row in volume.rows() {
        let bytes: Vec<u8> = (0..nx).map(|x| (row[x / 64] >> (x % 64) & 1) as u8).collect();
        to.write_all(&bytes)?;
    }
    Ok(())
}
