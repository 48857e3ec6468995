//! Bounds on the overlap along each direction in words of 32 bits: for cores where floats are
//! functions, and scalars that are integers of a few words.

use super::axes::Axes;
use super::directions::Direction;
use super::integers::{COORDINATE, Words};
use super::whole::Shapes;
use crate::arithmetic::{Number, greatest, pick, three, turn};

/// The numbers of two shapes, cut to 26 bits and a sign: twice the places from the second shape's
/// origin, and what extends from them.
pub(super) struct Cut {
    are_triangles: [bool; 2],
    /// The sides, as they are.
    sides: [[[i64; 3]; 3]; 2],
    at: [[[i32; 3]; 3]; 2],
    reach: [[[i32; 3]; 3]; 2],
}

/// The bits that are kept of a place.
const PLACE: i32 = 26;

/// How far an overlap may be from the truth, in its unit.
///
/// A number that is cut is too low by less than one. Two places and at most six reaches are within
/// 2^26 each and multiplied by three coordinates of at most 2^30: 8·3·2^30. The coordinates are
/// multiplied by at most 8·2^26 each: 3·2^29. In units of 2^30 that is 25.5, and the overlap is cut
/// once more: `cut.g`.
const ERROR: i32 = 27;

/// A direction, cut.
pub(super) struct Measured {
    /// The overlaps against the direction and along it, in units of its length.
    overlaps: [i32; 2],
    /// Its square over 2^50. The true square less this number is in [-1, 2).
    ///
    /// The greatest coordinate, over 2^15, is at least 2^14, and too low by less than one and 2^-15. The sum
    /// of squares errs by less than 2^-12 of itself, and the result, at most 3072, by less than one.
    square: u32,
}

/// A square of a depth, as m·2^exponent/square.
#[derive(Clone, Copy)]
pub(super) struct Depth {
    m: u32,
    exponent: i32,
    square: u32,
}

impl Depth {
    /// Whether it is at most another; perhaps also if it is above that by a unit of m·square. That only
    /// keeps more directions.
    pub(super) fn is_at_most(&self, other: &Self) -> bool {
        // Below 2^20·3074 each.
        let (here, there) = (self.m * other.square, other.m * self.square);
        let up = self.exponent - other.exponent;
        if up >= 0 {
            here <= there.checked_shr(up as u32).unwrap_or(0)
        } else {
            here.checked_shr(up.unsigned_abs()).unwrap_or(0) <= there
        }
    }
}

/// A number above or equal to zero to ten bits, as m·2^exponent, rounded down.
fn ten_bits(x: i32) -> (u32, i32) {
    let x = x.unsigned_abs();
    let exponent = 22 - x.leading_zeros() as i32;
    (if exponent < 0 { x << -exponent } else { x >> exponent }, exponent)
}

impl Measured {
    /// Whether the shapes are certainly apart.
    pub(super) fn are_apart(&self) -> bool {
        self.overlaps.iter().any(|&overlap| overlap < -ERROR)
    }

    /// The least that the depth may be on one side.
    pub(super) fn least(&self, is_along: bool) -> Depth {
        let overlap = self.overlaps[usize::from(is_along)];
        let (m, exponent) = ten_bits(greatest(overlap - ERROR, 0));
        Depth { m: m * m, exponent: 2 * exponent, square: self.square + 2 }
    }

    /// The most that it may be on the side where it is less.
    pub(super) fn most(&self) -> Depth {
        let [against, along] = self.overlaps;
        let (m, exponent) = ten_bits(greatest(against.min(along) + ERROR, 0));
        Depth { m: (m + 1) * (m + 1), exponent: 2 * exponent, square: self.square - 1 }
    }
}

impl Cut {
    pub(super) fn new<N: Words>(shapes: &Shapes<N>, are_triangles: [bool; 2]) -> Self {
        let [first, second] = &shapes.shapes;
        let origin = second.ends[0];
        let at = [first, second].map(|shape| three(|k| three(|i| shape.ends[k][i] - origin[i])));
        let reach = [&first.reach, &second.reach].map(|reach| reach.as_flattened());
        let ends = at.as_flattened().as_flattened();
        let down = N::bits(ends.iter().chain(reach[0]).chain(reach[1])) - PLACE;
        let cut = |v: &[[N::Area; 3]; 3]| three(|k| three(|i| N::cut(v[k][i], down)));
        let whole = |v: &[[N::Length; 3]; 3]| v.map(|v| v.map(N::Length::into));
        Self {
            are_triangles,
            sides: [whole(&first.sides), whole(&second.sides)],
            at: [cut(&at[0]), cut(&at[1])],
            reach: [cut(&first.reach), cut(&second.reach)],
        }
    }

    /// Where a shape begins and ends along a direction.
    fn ends(&self, shape: usize, a: &[i32; 3]) -> [i64; 2] {
        let along = |v: &[i32; 3]| {
            let terms = a.iter().zip(v).filter(|(_, x)| **x != 0);
            terms.map(|(a, x)| i64::from(*a) * i64::from(*x)).sum::<i64>()
        };
        let [p, q, r] = &self.at[shape % 2];
        let p = along(p);
        if self.are_triangles[shape % 2] {
            let (q, r) = (along(q), along(r));
            return [p.min(q).min(r), p.max(q).max(r)];
        }
        let reach = self.reach[shape % 2].iter().map(|v| along(v).magnitude()).sum::<i64>();
        [p - reach, p + reach]
    }

    /// The directions that are not certainly zero or equal to an earlier one, as bits.
    pub(super) fn needed(&self, all: &[Direction]) -> u16 {
        let sides = self.sides.each_ref();
        Axes::new(sides, self.are_triangles, true).needed(all, |direction, axis| {
            let [x, y] =
                direction.sides(self.are_triangles).map(|(shape, k)| pick(sides[shape % 2], k));
            let (_, j, k) = turn(axis);
            let product = |j, k| i128::from(*pick(x, j)) * i128::from(*pick(y, k));
            let (p, q) = (product(j, k), product(k, j));
            // As floats do.
            (p - q).abs() > p.abs().max(q.abs()) >> 20
        })
    }

    /// The overlaps along a direction.
    pub(super) fn measured(&self, a: &[i32; 3]) -> Measured {
        let ([a0, a1], [b0, b1]) = (self.ends(0, a), self.ends(1, a));
        let squares = a.iter().map(|x| (x >> 15).unsigned_abs().pow(2));
        Measured {
            overlaps: [a1 - b0, b1 - a0].map(|overlap| (overlap >> COORDINATE) as i32),
            square: squares.sum::<u32>() >> 20,
        }
    }
}
