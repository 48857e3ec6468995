//! Triangles, segments and points against triangles, by the signs of volumes.
//!
//! O. Devillers, P. Guigue, "Faster Triangle-Triangle Intersection Tests", INRIA RR-4488, 2002:
//! every decision is the side of a plane through three points on which a fourth point lies. No sign
//! has a degree above three, and no point or line is constructed. Here triangles may also be
//! segments or points, and shapes in one plane are decided by separating axes in the coordinate
//! planes.
//!
//! A segment is a triangle with two equal vertices, and a point a triangle with three, so
//! [`relation`] serves all these pairs. The common case has a faster kernel beside each pair;
//! shapes in one plane and degenerate shapes come here.

mod sides;

use core::cmp::Ordering;

use self::sides::{FIRST, SECOND, Whole, share_a_point};
use super::relation::{Asked, Relation};
use crate::arithmetic::{
    Arithmetic, Each, Int64Narrow, Number, REGISTERS_ARE_WIDE, pick, three, turn,
};

pub(crate) use self::sides::{Vector, from};
pub(super) use self::sides::{are_apart, sides, size};

/// The relation of the two shapes.
#[inline(never)]
pub(super) fn relation<N: Arithmetic>(points: &Whole<N>) -> Relation {
    let [x, y, z] = three(|axis| points.along_axis(axis));
    let so_far = x.min(y).min(z);
    if so_far == Relation::Disjoint {
        return so_far;
    }
    let (first, second) = (points.sides(SECOND, FIRST), points.sides(FIRST, SECOND));
    let so_far = so_far.min(along(first, &[])).min(along(second, &[]));
    if so_far == Relation::Disjoint {
        return so_far;
    }
    // If all signs are zero, the shape lies in the plane of the other shape, or the other shape is
    // degenerate and has no plane.
    let is_zero = |signs: [Ordering; 3]| signs == [Ordering::Equal; 3];
    so_far.min(match (is_zero(first), is_zero(second)) {
        (false, false) => crossing(points, first, second),
        (false, true) => piercing(points, FIRST, first, SECOND),
        (true, false) => piercing(points, SECOND, second, FIRST),
        (true, true) => in_plane(points),
    })
}

/// The relation of two shapes that a kernel left in doubt because they lie in one plane, or are
/// degenerate. In a number system with errors, decides only two cases: a common vertex, and a
/// coordinate that separates.
#[inline(never)]
pub(super) fn in_doubt<N: Arithmetic>(
    first: &[Vector<N>; 3],
    second: &[Vector<N>; 3],
    asked: Asked,
) -> Option<Relation> {
    if N::CERTAIN {
        let ([a, b, c], [d, e, f]) = (*first, *second);
        Some(relation(&Whole::<N>([a, b, c, d, e, f])))
    } else if asked != Asked::Relation && share_a_point(first, second) {
        Some(Relation::Touching)
    } else if are_apart(first, second) {
        Some(Relation::Disjoint)
    } else if REGISTERS_ARE_WIDE && asked != Asked::MayOverlap {
        let ([a, b, c], [d, e, f]) = (*first, *second);
        let points = N::in_forty_bits(&[a, b, c, d, e, f])?;
        Some(relation(&Whole::<Int64Narrow>(points)))
    } else {
        None
    }
}

/// The nearest relation that one axis allows. `sides` are the signs of one shape's vertices
/// relative to a point of the axis; `back` are the signs of the other shape's vertices that are not
/// at the point. Overlapping if the point does not separate, or if all vertices are at it;
/// otherwise touching if a vertex in `sides` is at the point, else disjoint.
fn along(sides: [Ordering; 3], back: &[Ordering]) -> Relation {
    let all = || sides.into_iter().chain(back.iter().map(|side| side.reverse()));
    let (above, below) = (all().any(Ordering::is_gt), all().any(Ordering::is_lt));
    if above == below {
        Relation::Overlapping
    } else if sides.contains(&Ordering::Equal) {
        Relation::Touching
    } else {
        Relation::Disjoint
    }
}

/// The relation of two triangles whose planes cross, neither triangle beyond the plane of the
/// other. Each triangle cuts an interval out of the common line of both planes; do these meet?
fn crossing<N: Arithmetic>(
    points: &Whole<N>,
    first: [Ordering; 3],
    second: [Ordering; 3],
) -> Relation {
    let (i, is_first_above) = apex(first.each(|sign| sign as i8));
    let (k, is_second_above) = apex(second.each(|sign| sign as i8));
    let order = |of: [usize; 3], k: usize, is_in_order: bool| {
        let (a, b, c) = turn(k);
        if is_in_order { [of[a], of[b], of[c]] } else { [of[a], of[c], of[b]] }
    };
    // Each triangle in the order that puts its partner's apex above its plane.
    let [a, b, c] = order(FIRST, i, is_second_above);
    let [d, e, f] = order(SECOND, k, is_first_above);
    let at = |sign: Ordering| match sign {
        Ordering::Less => Relation::Overlapping,
        Ordering::Equal => Relation::Touching,
        Ordering::Greater => Relation::Disjoint,
    };
    at(points.volume([a, b, d, e])).min(at(points.volume([a, c, f, d])))
}

/// The apex of a triangle that straddles or touches a plane, from the signs of its vertices: the
/// vertex alone on its side, or the vertex on the plane if the rest lie on one side. Also returns
/// whether the apex is above the rest. The signs are not all equal.
///
/// By a table: the signs are random, and a mispredicted branch costs more than all the rest.
#[inline(always)]
pub(super) fn apex([a, b, c]: [i8; 3]) -> (usize, bool) {
    let at = (9 * a + 3 * b + c + 13) as usize;
    APEXES.get(at).map_or((0, false), |&(k, is_above)| (k.into(), is_above))
}

const APEXES: [(u8, bool); 27] = {
    let mut apexes = [(0, false); 27];
    let mut at = 0;
    while at < 27 {
        let (a, b, c) = (at / 9, at / 3 % 3, at % 3);
        apexes[at] = if a > b && a > c {
            (0, true)
        } else if b > a && b > c {
            (1, true)
        } else if c > a && c > b {
            (2, true)
        } else if a < b && a < c {
            (0, false)
        } else if b < c {
            (1, false)
        } else {
            (2, false)
        };
        at += 1;
    }
    apexes
};

/// The relation of a triangle and a segment that meets its plane in one point, given the signs of
/// the segment's vertices. They meet if the line passes all edges on one side.
fn piercing<N: Arithmetic>(
    points: &Whole<N>,
    segment: [usize; 3],
    signs: [Ordering; 3],
    triangle: [usize; 3],
) -> Relation {
    let k = if signs[0] == signs[1] { 1 } else { 0 };
    let (a, b) = (segment[k], segment[k + 1]);
    let sides = FIRST.each(|k| {
        let (k, next, _) = turn(k);
        points.volume([a, b, triangle[k], triangle[next]])
    });
    passing(sides)
}

/// The relation of a triangle and a line across its plane, from the sides on which the line passes
/// the edges.
fn passing(sides: [Ordering; 3]) -> Relation {
    if sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater) {
        Relation::Disjoint
    } else if sides.contains(&Ordering::Equal) {
        Relation::Touching
    } else {
        Relation::Overlapping
    }
}

/// The relation of two triangles in one plane, of a triangle and a segment or point in its plane,
/// or of two segments or points: separating axes in the coordinate planes.
///
/// If two sets of one plane meet, so do their projections onto each coordinate plane. The converse
/// holds for a coordinate plane onto which the plane projects one-to-one, such as any in which one
/// of the triangles has an area. In a coordinate plane the candidate axes are the normals of all
/// edges; on a line they are the coordinates themselves.
#[inline(never)]
fn in_plane<N: Arithmetic>(points: &Whole<N>) -> Relation {
    let has_area = |axis: usize| {
        points.area(axis, FIRST) != Ordering::Equal || points.area(axis, SECOND) != Ordering::Equal
    };
    if let Some(axis) = (0..3).find(|&axis| has_area(axis)) {
        return seen_along(points, axis);
    }
    // Two segments, not necessarily in one plane.
    for i in 0..2 {
        for k in 0..2 {
            let (a, b) = (FIRST[i], SECOND[k]);
            if points.volume([a, a + 1, b, b + 1]) != Ordering::Equal {
                return Relation::Disjoint;
            }
        }
    }
    let [x, y, z] = three(|axis| seen_along(points, axis));
    x.min(y).min(z)
}

/// The nearest relation that the normals of the edges allow, in the projection along an axis.
fn seen_along<N: Arithmetic>(points: &Whole<N>, axis: usize) -> Relation {
    let mut so_far = Relation::Overlapping;
    for (one, other) in [(FIRST, SECOND), (SECOND, FIRST)] {
        for k in 0..3 {
            let (k, next, opposite) = turn(k);
            let [a, b, c] = [k, next, opposite].each(|k| *pick(&one, k));
            let sides = points.sides_of_line(axis, [a, b], other);
            so_far = so_far.min(along(sides, &[points.area(axis, [a, b, c])]));
            if so_far == Relation::Disjoint {
                return so_far;
            }
        }
    }
    so_far
}

// The error of a computed volume (a × b)·c.
//
// a, b and c are differences of points, and A, B and C bound the magnitudes of their components. A
// difference takes one rounding. For a segment given by its centre it takes two, (p − q) ± h, and
// its size is the size of p − q plus the size of h. The volume is a sum of 6 terms, each within
// A·B·C, and at most 11 roundings touch a term. `error_bound.g` proves [`VOLUME`] roundoffs of
// A·B·C, second orders and underflow included.

/// Roundoffs in a volume.
const VOLUME: u16 = 70;

/// The bound for vectors of these sizes; `None` if a size is out of range.
#[inline(always)]
pub(in crate::query) fn error_bound<N: Arithmetic>([a, b, c]: [N::Length; 3]) -> Option<N::Volume> {
    if N::CERTAIN {
        return Some(N::Volume::ZERO);
    }
    let is_known = a.in_range() & b.in_range() & c.in_range();
    is_known.then(|| N::volume(N::area(a, b), c).error(VOLUME))
}
