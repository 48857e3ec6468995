//! The directions along which shapes may be separated.

use super::body::Body;
use crate::arithmetic::{Each, turn};
use crate::scalar::Scalar;

/// An axis: the cross product of two sides of the shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// The normal of a face, of the first shape or of the second.
    Face { is_second: bool, k: u8 },
    /// Side i of the first shape across side j of the second.
    Sides(u8, u8),
}

/// A plane separates the shapes.
pub(super) struct Apart;

const BOXES: [Direction; 15] = table([3, 3], false);
const TRIANGLE_AND_BOX: [Direction; 13] = table([1, 3], false);
const BOX_AND_TRIANGLE: [Direction; 13] = table([3, 1], true);
const TRIANGLES: [Direction; 11] = table([1, 1], false);

/// All directions, in the order that decides between equal depths: faces of the first shape, faces
/// of the second, pairs of sides. A triangle's face comes before the faces of a box.
pub(super) fn all<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> &'static [Direction] {
    match bodies.each_ref().each(Body::is_triangle) {
        [false, false] => &BOXES,
        [true, false] => &TRIANGLE_AND_BOX,
        [false, true] => &BOX_AND_TRIANGLE,
        [true, true] => &TRIANGLES,
    }
}

/// The numbers of the sides of all directions, the last one repeated; see [`Direction::numbers`].
pub(super) fn sides_of_all(are_triangles: [bool; 2]) -> &'static [[u8; 2]; 16] {
    const fn numbers<const N: usize>(all: [Direction; N], triangles: [bool; 2]) -> [[u8; 2]; 16] {
        let (mut numbers, mut n) = ([[0; 2]; 16], 0);
        while n < 16 {
            numbers[n] = all[if n < N { n } else { N - 1 }].numbers(triangles);
            n += 1;
        }
        numbers
    }
    const OF: [[[u8; 2]; 16]; 4] = [
        numbers(BOXES, [false, false]),
        numbers(TRIANGLE_AND_BOX, [true, false]),
        numbers(BOX_AND_TRIANGLE, [false, true]),
        numbers(TRIANGLES, [true, true]),
    ];
    &OF[usize::from(are_triangles[0]) + 2 * usize::from(are_triangles[1])]
}

/// The directions of shapes with so many faces of different normals.
const fn table<const N: usize>(faces: [usize; 2], second_is_first: bool) -> [Direction; N] {
    let mut all = [Direction::Sides(0, 0); N];
    let mut n = 0;
    while n < N {
        let begin = faces[second_is_first as usize];
        all[n] = if n < begin {
            Direction::Face { is_second: second_is_first, k: n as u8 }
        } else if n < N - 9 {
            Direction::Face { is_second: !second_is_first, k: (n - begin) as u8 }
        } else {
            let pair = (n + 9 - N) as u8;
            Direction::Sides(pair / 3, pair % 3)
        };
        n += 1;
    }
    all
}

impl Direction {
    /// The two sides of the cross product, each as a shape and the number of its side.
    pub(super) const fn sides(self, is_triangle: [bool; 2]) -> [(usize, usize); 2] {
        match self {
            Self::Face { is_second, k } => {
                let shape = is_second as usize;
                let (_, i, j) = if is_triangle[shape] { (0, 0, 1) } else { turn(k as usize) };
                [(shape, i), (shape, j)]
            }
            Self::Sides(i, j) => [(0, i as usize), (1, j as usize)],
        }
    }

    /// The same as numbers: 3·shape + k.
    // Small cores keep one copy.
    #[cfg_attr(target_pointer_width = "64", inline)]
    pub(super) const fn numbers(self, are_triangles: [bool; 2]) -> [u8; 2] {
        let [(p, i), (q, j)] = self.sides(are_triangles);
        [(3 * p + i) as u8, (3 * q + j) as u8]
    }
}
