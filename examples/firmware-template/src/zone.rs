// The zone in I16F16, made by `quantise`.

use fixed::types::I16F16;
use septum::{Vec3, mesh::Node};

const fn v(x: i32, y: i32, z: i32) -> Vec3<I16F16> {
    Vec3::new(I16F16::from_bits(x), I16F16::from_bits(y), I16F16::from_bits(z))
}

const fn n(bits: [[u16; 4]; 6]) -> Node {
    Node::from_bits(bits)
}

pub(crate) static VERTICES: [Vec3<I16F16>; 6] = [
    v(1310720, 0, 0), v(0, 1310720, 0), v(0, 0, 1310720), v(-1310720, 0, 0),
    v(0, -1310720, 0), v(0, 0, -1310720),
];

pub(crate) static FACES: [[u16; 3]; 8] = [
    [1, 3, 2], [3, 4, 2], [3, 1, 5], [4, 3, 5], [0, 1, 2], [4, 0, 2], [1, 0, 5], [0, 4, 5],
];

// The tree over all faces, in whose order the faces are.
pub(crate) static NODES: [Node; 1] = [
    n([[0, 20480, 65535, 65535], [0, 0, 65535, 65535], [0, 0, 65535, 65535], [20480, 40960, 0, 0], [40960, 40960, 0, 0], [40960, 40960, 0, 0]]),
];
