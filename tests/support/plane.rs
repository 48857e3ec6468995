//! Planes against boxes: an oracle that evaluates the plane at all eight corners,
//! in whole numbers; the crate looks at two.

use dashu_int::IBig;
use septum::{Plane, ShapeError, Side};

use super::case::BoxNumbers;
use super::lattice::Ring;
use super::scalar::Sample;

/// How the plane was given.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Given<S> {
    Point([S; 3]),
    Offset(S),
}

impl<S: Sample> Given<S> {
    /// The plane with this normal.
    pub(crate) fn plane(self, normal: [S; 3]) -> Result<Plane<S>, ShapeError> {
        match self {
            Self::Point(p) => Plane::from_point_normal(p, normal),
            Self::Offset(d) => Plane::from_equation(normal, d),
        }
    }
}

/// The side, from all corners.
pub(crate) fn side<S: Sample>(normal: [S; 3], given: Given<S>, aabb: BoxNumbers<S>) -> Side {
    let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = aabb;
    let (point, offset) = match given {
        Given::Point(point) => (point, S::ZERO),
        Given::Offset(d) => ([S::ZERO; 3], d),
    };
    let all = [normal, p, q, point, [offset; 3]].concat();
    let parts = all.iter().map(|x| x.mantissa_exponent());
    let unit = parts.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0).min(0);
    let whole = |x: S| {
        let (m, e) = x.mantissa_exponent();
        if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
    };
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
