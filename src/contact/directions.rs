//! The directions along which shapes may be separated, and which of them are superfluous before any is
//! measured.

use super::body::Body;
use crate::arithmetic::{Each, Number, REGISTERS_ARE_WIDE, three, turn, two};
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

/// Which directions are certainly zero, or equal to an earlier one.
pub(super) struct Axes {
    are_triangles: [bool; 2],
    /// The axes of each box that equal one of the opposite box, as bits 3·shape + k. In one number: two bytes
    /// that are read together wait for their stores.
    shared: u8,
    /// The coordinates of each side that are not zero, as bits.
    nonzero: [[u8; 3]; 2],
    /// The axis of the first box that equals each axis of the second, if there is one.
    pub(super) same: [Option<usize>; 3],
}

impl Axes {
    /// The facts, given the sides of both shapes in one unit. `are_exact` means that different sides have
    /// different numbers.
    pub(super) fn new<T: Number>(
        sides: [&[[T; 3]; 3]; 2],
        are_triangles: [bool; 2],
        are_exact: bool,
    ) -> Self {
        let [first, second] = sides;
        let mut same = [None; 3];
        if are_exact && are_triangles == [false; 2] {
            for (same, v) in same.iter_mut().zip(second) {
                let is_along = |u: &[T; 3]| (0..3).all(|i| u[i] == v[i]);
                let is_against = |u: &[T; 3]| (0..3).all(|i| u[i] == -v[i]);
                *same = first.iter().position(|u| is_along(u) || is_against(u));
            }
        }
        let mut shared = 0;
        for (j, same) in same.iter().enumerate() {
            if let Some(i) = same {
                shared |= 1 << i | 8 << j;
            }
        }
        let bit = |x: &T, i: usize| u8::from(!x.is_zero()) << i;
        let bits = |[x, y, z]: &[T; 3]| bit(x, 0) | bit(y, 1) | bit(z, 2);
        let are_clear = |sides: &[[T; 3]; 3]| !sides.as_flattened().iter().any(T::is_zero);
        // As hosts mostly find them.
        let nonzero = if REGISTERS_ARE_WIDE && are_clear(first) && are_clear(second) {
            [[7; 3]; 2]
        } else {
            two(|n| three(|k| bits(&sides[n][k])))
        };
        Self { are_triangles, shared, nonzero, same }
    }

    /// Whether a direction of two boxes is zero, or equal to an earlier one, because of axes that
    /// the boxes share.
    #[inline]
    fn is_shared(&self, [x, y]: [u8; 2]) -> bool {
        let own = 1 << x | 1 << y;
        match (x >= 3, y >= 3) {
            // A face of the first box.
            (_, false) => false,
            // A face of the second box.
            (true, true) => self.shared & own == own,
            // If v_j equals an axis of the first box, u_i × v_j is zero or a face normal of the
            // first box. If u_i equals an axis of the second box, it is zero or a face normal of
            // the second box.
            (false, true) => self.shared & own != 0,
        }
    }

    /// Whether both are boxes, with the same axes.
    pub(super) fn are_alike(&self) -> bool {
        self.shared == 63
    }

    /// The coordinate axis along which a direction is, if it is one, by the numbers of its sides: the only
    /// coordinate that neither of them has. `None` too if a box has that coordinate in several axes.
    #[inline]
    pub(super) fn axis(&self, numbers: [u8; 2]) -> Option<usize> {
        let [x, y] = numbers.each(|n| self.nonzero[usize::from(n >= 3)][usize::from(n % 3)]);
        let none = !(x | y) & 7;
        let is_upright = |(sides, &is_triangle): (&[u8; 3], &bool)| {
            is_triangle || sides.iter().filter(|&bits| bits & none != 0).count() == 1
        };
        let are_upright =
            none.is_power_of_two() && self.nonzero.iter().zip(&self.are_triangles).all(is_upright);
        are_upright.then(|| none.trailing_zeros() as usize % 3)
    }

    /// The directions that are not certainly zero or equal to an earlier one, as bits.
    /// `is_clear` says whether coordinate `axis`, the only one of a direction that may differ from zero,
    /// certainly does.
    pub(super) fn needed(
        &self,
        all: &[Direction],
        is_clear: impl Fn([u8; 2], usize) -> bool,
    ) -> u16 {
        if self.are_alike() {
            // The faces of the first box.
            return 7;
        }
        if self.shared == 0 && self.nonzero == [[7; 3]; 2] {
            return u16::MAX >> (16 - all.len() as u32 % 16);
        }
        let ([a, b, c], [d, e, f]) = (self.nonzero[0], self.nonzero[1]);
        let nonzero = [a, b, c, d, e, f, f, f];
        let products = |sides: [u8; 2]| {
            let [x, y] = sides.each(|side| nonzero[usize::from(side & 7)]);
            PRODUCTS[usize::from(x << 3 | y) & 63]
        };
        let all_sides = sides_of_all(self.are_triangles);
        // As bits, without a branch: the directions that are not certainly zero, and those with a single coordinate.
        let (mut needed, mut single) = (0, 0);
        for (n, &sides) in all_sides.iter().enumerate().take(all.len()) {
            let products = products(sides);
            needed |= u16::from(products != 0) << n;
            single |= u16::from(products >> 3) << n;
        }
        if self.shared != 0 {
            for (n, &sides) in all_sides.iter().enumerate() {
                needed &= !(u16::from(self.is_shared(sides)) << n);
            }
        }
        // Coordinate axes that have occurred, as directions that are not zero.
        let (mut left, mut seen) = (needed & single, 0);
        while left != 0 {
            let (n, rest) = (left.trailing_zeros() as usize % 16, left & (left - 1));
            let axis = products(all_sides[n]) & 7;
            if seen & axis != 0 {
                needed ^= left ^ rest;
            } else if is_clear(all_sides[n], axis.trailing_zeros() as usize % 3) {
                seen |= axis;
            }
            left = rest;
        }
        needed
    }
}

/// The coordinates of a cross product that have products which are not zero, underflow apart, as bits, by those of
/// its sides that are not zero. The fourth bit says that it is one.
const PRODUCTS: [u8; 64] = {
    let (mut all, mut n) = ([0; 64], 0);
    while n < 64 {
        let (x, y) = (n as u8 >> 3, n as u8 & 7);
        // Bit i of the first has coordinate i + 1, and of the second i + 2, modulo three.
        let ([x1, x2], [y1, y2]) =
            ([x >> 1 | x << 2, x >> 2 | x << 1], [y >> 1 | y << 2, y >> 2 | y << 1]);
        let products = (x1 & y2 | x2 & y1) & 7;
        all[n] = products | (products.is_power_of_two() as u8) << 3;
        n += 1;
    }
    all
};
