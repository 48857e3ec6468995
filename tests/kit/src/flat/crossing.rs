//! The segment in which two triangles cross, in fractions.
//!
//! The crate compares volumes to choose the ends. This oracle computes where the edges of each
//! triangle cross the other plane, and compares these points along the common line.

use dashu_int::IBig;

use super::Point;
use crate::exact::{Parts, least_exponent, whole};
use crate::rays::Fraction;
use crate::{Each, lattice::Ring, three};

type Vector = [IBig; 3];

/// A point of the common line: its place along the line, and its coordinates.
struct Place {
    along: Fraction,
    at: [Fraction; 3],
}

/// The ends of the segment in which two triangles in different planes meet, along the cross product
/// of their normals.
pub(super) fn crossing(triangles: [[Point<Parts>; 3]; 2]) -> Option<[[Fraction; 3]; 2]> {
    let unit = least_exponent(triangles.as_flattened().as_flattened());
    let [first, second] = triangles.each(|t| t.each(|p| p.each(|x| whole(x, unit))));
    let normal = |[a, b, c]: &[Vector; 3]| IBig::cross(&from(b, a), &from(c, a));
    let (m, n) = (normal(&first), normal(&second));
    let line = IBig::cross(&m, &n);
    if line.iter().all(|x| *x == IBig::ZERO) {
        return None;
    }
    let [p, q] = interval(&first, (&n, &second[0]), &line, unit)?;
    let [r, s] = interval(&second, (&m, &first[0]), &line, unit)?;
    let from = if p.along.compare_with(&r.along).is_lt() { r } else { p };
    let to = if q.along.compare_with(&s.along).is_gt() { s } else { q };
    from.along.compare_with(&to.along).is_lt().then_some([from.at, to.at])
}

fn from(p: &Vector, origin: &Vector) -> Vector {
    IBig::difference(p, origin)
}

/// The first and the last point, along the line, of the triangle in the plane.
fn interval(
    triangle: &[Vector; 3],
    (normal, base): (&Vector, &Vector),
    line: &Vector,
    unit: i32,
) -> Option<[Place; 2]> {
    let heights = triangle.each_ref().each(|p| IBig::dot(normal, &from(p, base)));
    let mut places = Vec::new();
    // From an end above the plane or in it to one below or in it, also of the edge of no length.
    for (p, h) in triangle.iter().zip(&heights).filter(|(_, h)| **h >= IBig::ZERO) {
        for (q, k) in triangle.iter().zip(&heights).filter(|(_, k)| **k <= IBig::ZERO) {
            let is_vertex = h == k;
            let den = if is_vertex { IBig::ONE } else { h - k };
            let mean = |p: &IBig, q: &IBig| if is_vertex { p.clone() } else { h * q - k * p };
            let along = mean(&IBig::dot(line, p), &IBig::dot(line, q));
            places.push(Place {
                along: Fraction::new(along, den.clone(), 0),
                at: three(|i| Fraction::new(mean(&p[i], &q[i]), den.clone(), unit)),
            });
        }
    }
    places.sort_by(|a, b| a.along.compare_with(&b.along));
    let last = places.pop()?;
    Some([places.into_iter().next()?, last])
}
