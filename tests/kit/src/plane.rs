//! Planes against boxes. The oracle evaluates the plane at all eight corners, in integers; the
//! crate evaluates two.

use crate::Each;
use dashu_int::IBig;
use septum::{Plane, ShapeError, Side};

use super::case::BoxNumbers;
use super::exact::{Parts, least_exponent, whole};
use super::lattice::Ring;
use super::sample::Sample;

/// The form in which the plane was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given<S> {
    Point([S; 3]),
    Offset(S),
}

impl<S: Sample> Given<S> {
    /// The plane with this normal.
    pub fn plane(self, normal: [S; 3]) -> Result<Plane<S>, ShapeError> {
        match self {
            Self::Point(p) => Plane::from_point_normal(p, normal),
            Self::Offset(d) => Plane::from_equation(normal, d),
        }
    }
}

/// The side, from all corners.
pub fn side<S: Sample>(normal: [S; 3], given: Given<S>, aabb: BoxNumbers<S>) -> Side {
    let parts = S::mantissa_exponent;
    let (point, offset) = match given {
        Given::Point(point) => (point, S::ZERO),
        Given::Offset(d) => ([S::ZERO; 3], d),
    };
    side_of_parts(normal.each(parts), point.each(parts), parts(offset), aabb.map(parts))
}

fn side_of_parts(
    normal: [Parts; 3],
    point: [Parts; 3],
    offset: Parts,
    aabb: BoxNumbers<Parts>,
) -> Side {
    let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = aabb;
    let unit = least_exponent([normal, p, q, point, [offset; 3]].as_flattened()).min(0);
    let whole = |x: Parts| whole(x, unit);
    let one = IBig::ONE << (-unit) as usize;
    let corner = |i: usize, upper: bool| match aabb {
        BoxNumbers::Center(c, h) if upper => whole(c[i]) + whole(h[i]),
        BoxNumbers::Center(c, h) => whole(c[i]) - whole(h[i]),
        BoxNumbers::Corners(min, max) => whole(if upper { max[i] } else { min[i] }),
    };
    let signs: Vec<i32> = (0..8)
        .map(|bits| {
            let from = |i: usize| corner(i, bits >> i & 1 == 1) - whole(point[i]);
            let sum: IBig = (0..3).map(|i| whole(normal[i]) * from(i)).sum();
            Ring::sign(&(sum + whole(offset) * &one))
        })
        .collect();
    if signs.iter().all(|&s| s > 0) {
        Side::Front
    } else if signs.iter().all(|&s| s < 0) {
        Side::Back
    } else {
        Side::Both
    }
}
