//! An OBJ file of cubes, in the mesh's units: the faces between a set voxel and one that is not.

use std::io::{self, Write};

use crate::volume::Volume;

/// Writes quads, counterclockwise seen from outside. Cubes share their corners.
pub(crate) fn write(volume: &Volume<'_>, to: &mut impl Write) -> io::Result<()> {
    let [nx, ny, nz] = volume.size();
    let mut corners = Corners::new(volume);
    for z in 0..nz {
        for y in 0..ny {
            for x in (0..nx).filter(|x| volume.row(y, z)[x / 64] >> (x % 64) & 1 == 1) {
                let voxel = [x, y, z];
                for (axis, side) in (0..6).map(|face| (face / 2, face % 2)) {
                    let mut beside = voxel.map(Some);
                    beside[axis] =
                        if side == 1 { Some(voxel[axis] + 1) } else { voxel[axis].checked_sub(1) };
                    if !volume.get(beside) {
                        let quad = face(voxel, axis, side);
                        let [a, b, c, d] = [
                            corners.index(quad[0], to)?,
                            corners.index(quad[1], to)?,
                            corners.index(quad[2], to)?,
                            corners.index(quad[3], to)?,
                        ];
                        writeln!(to, "f {a} {b} {c} {d}")?;
                    }
                }
            }
        }
        corners.next_layer();
    }
    Ok(())
}

/// The corners of a face of a voxel.
fn face(voxel: [usize; 3], axis: usize, side: usize) -> [[usize; 3]; 4] {
    let around = if side == 1 { [0, 1, 3, 2] } else { [0, 2, 3, 1] };
    around.map(|corner| {
        let mut at = voxel;
        at[axis] += side;
        at[(axis + 1) % 3] += corner & 1;
        at[(axis + 2) % 3] += corner >> 1;
        at
    })
}

/// The numbers of the corners that were written, in the two planes of a layer of voxels.
struct Corners<'a> {
    volume: &'a Volume<'a>,
    /// In the plane of an even z, and of an odd one. The numbers of OBJ begin at 1.
    planes: [Vec<usize>; 2],
    written: usize,
    layer: usize,
}

impl<'a> Corners<'a> {
    fn new(volume: &'a Volume<'a>) -> Self {
        let [nx, ny, _] = volume.size();
        let plane = vec![0; (nx + 1) * (ny + 1)];
        Self { volume, planes: [plane.clone(), plane], written: 0, layer: 0 }
    }

    /// The number of a corner, which is written before it is used.
    fn index(&mut self, at: [usize; 3], to: &mut impl Write) -> io::Result<usize> {
        let Volume { origin, edge, .. } = *self.volume;
        let place = at[0] + at[1] * (self.volume.size()[0] + 1);
        let number = &mut self.planes[at[2] % 2][place];
        if *number == 0 {
            self.written += 1;
            *number = self.written;
            let [x, y, z] = [0, 1, 2].map(|i| origin[i] + edge * at[i] as f64);
            writeln!(to, "v {x} {y} {z}")?;
        }
        Ok(*number)
    }

    /// The lower plane of this layer becomes the upper plane of the next.
    fn next_layer(&mut self) {
        self.planes[self.layer % 2].fill(0);
        self.layer += 1;
    }
}
