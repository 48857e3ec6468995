//! The zone to keep out of, in flash: an octahedron of 40 mm. Replace it by a mesh of your
//! own: the example `quantise` of septum's repository makes such tables from OBJ files.

use fixed::types::I16F16;
use septum::Vec3;

/// Millimetres.
const fn corner(x: i16, y: i16, z: i16) -> Vec3<I16F16> {
    const fn mm(x: i16) -> I16F16 {
        I16F16::from_bits((x as i32) << 16)
    }
    Vec3::new(mm(x), mm(y), mm(z))
}

pub static CORNERS: [Vec3<I16F16>; 6] = [
    corner(20, 0, 0),
    corner(-20, 0, 0),
    corner(0, 20, 0),
    corner(0, -20, 0),
    corner(0, 0, 20),
    corner(0, 0, -20),
];

pub static FACES: [[u16; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
