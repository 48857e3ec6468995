//! Triangles, segments and points against triangles, by the signs of volumes.
//!
//! O. Devillers, P. Guigue, "Faster Triangle-Triangle Intersection Tests", INRIA RR-4488,
//! 2002: everything is decided by the sides on which points lie of planes through three
//! others. No sign is of a degree above three, and no point or line is constructed. Here
//! triangles may be segments or points too, and what lies in one plane is decided by
//! separating axes in the planes of two coordinates.
//!
//! A segment is a triangle two of whose vertices are one, a point one of which all three are.
//! So [`relation`] serves all these pairs. The number systems have kernels of their own for
//! the common case, beside each pair; they come here with what is in one plane, or degenerate.

mod error_bound;
mod exact;
mod in_plane;
mod sides;
mod whole;

use core::cmp::Ordering;

pub(super) use self::error_bound::error_bound;
pub(super) use self::exact::ExactPoints;
use self::in_plane::in_plane;
use self::sides::share_a_point;
pub(super) use self::sides::{Vector, are_apart, from, larger, sides, sign, size};
use self::whole::Whole;
use super::relation::{Asked, Relation};
use crate::arithmetic::{Arithmetic, Int64Narrow, REGISTERS_ARE_WIDE, each, three, turn};

/// Six points: the vertices of one shape, and those of the other.
pub(super) trait Points {
    /// On which side of the plane through a, b and c the point d lies: the sign of
    /// ((b − a) × (c − a))·(d − a).
    fn volume(&self, points: [usize; 4]) -> Ordering;

    /// The sign of component `axis` of (b − a) × (c − a).
    fn area(&self, axis: usize, points: [usize; 3]) -> Ordering;

    /// How coordinate `axis` of one point compares with that of another.
    fn compare(&self, axis: usize, points: [usize; 2]) -> Ordering;

    /// On which sides of the plane through three points these lie.
    fn sides(&self, [a, b, c]: [usize; 3], of: [usize; 3]) -> [Ordering; 3] {
        each(of, |d| self.volume([a, b, c, d]))
    }

    /// Seen along `axis`, on which sides of the line through two points these lie.
    fn sides_of_line(&self, axis: usize, [a, b]: [usize; 2], of: [usize; 3]) -> [Ordering; 3] {
        each(of, |c| self.area(axis, [a, b, c]))
    }

    /// What coordinate `axis` says at most: nothing if all are one.
    fn along_axis(&self, axis: usize) -> Relation {
        // Every point of the one with every point of the other.
        let rows = each(FIRST, |a| each(SECOND, |b| self.compare(axis, [a, b])));
        let all = || rows.as_flattened().iter();
        let (above, below) = (all().any(|x| x.is_gt()), all().any(|x| x.is_lt()));
        if above == below {
            Relation::Overlapping
        } else if all().any(|x| x.is_eq()) {
            Relation::Touching
        } else {
            Relation::Disjoint
        }
    }
}

/// The first shape, and the second.
const FIRST: [usize; 3] = [0, 1, 2];
const SECOND: [usize; 3] = [3, 4, 5];

/// How the two shapes lie to each other.
#[inline(never)]
pub(super) fn relation(points: &impl Points) -> Relation {
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
    // Where all signs are zero, the one shape is in the plane of the other, or the other has
    // none.
    let is_zero = |signs: [Ordering; 3]| signs == [Ordering::Equal; 3];
    so_far.min(match (is_zero(first), is_zero(second)) {
        (false, false) => crossing(points, first, second),
        (false, true) => piercing(points, FIRST, first, SECOND),
        (true, false) => piercing(points, SECOND, second, FIRST),
        (true, true) => in_plane(points),
    })
}

/// How two shapes lie to each other of which a kernel leaves in doubt what is in one plane, or
/// degenerate. Where that is not certain: whether they have a vertex in common or a coordinate
/// tells them apart.
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

/// What an axis says at most, on which one shape lies on these sides of a point, and the
/// other, but for that point, on the other sides of `back`: disjoint if all of the one are
/// beyond the point and none of the other is, touching if none is but some of either are
/// not at it.
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

/// Two triangles in planes that cross, neither beyond that of the other: whether the
/// intervals meet in which they meet the line that both planes have in common.
fn crossing(points: &impl Points, first: [Ordering; 3], second: [Ordering; 3]) -> Relation {
    let (i, is_first_above) = apex(each(first, |sign| sign as i8));
    let (k, is_second_above) = apex(each(second, |sign| sign as i8));
    let order = |of: [usize; 3], k: usize, is_in_order: bool| {
        let (a, b, c) = turn(k);
        if is_in_order { [of[a], of[b], of[c]] } else { [of[a], of[c], of[b]] }
    };
    // Each in such an order that the apex of the other is above its plane.
    let [a, b, c] = order(FIRST, i, is_second_above);
    let [d, e, f] = order(SECOND, k, is_first_above);
    let at = |sign: Ordering| match sign {
        Ordering::Less => Relation::Overlapping,
        Ordering::Equal => Relation::Touching,
        Ordering::Greater => Relation::Disjoint,
    };
    at(points.volume([a, b, d, e])).min(at(points.volume([a, c, f, d])))
}

/// Of three signs that are not all zero, nor all above or all below, the one that stands
/// alone, or is zero with the others on one side; and whether it is above the others.
#[inline(always)]
pub(super) fn apex([a, b, c]: [i8; 3]) -> (usize, bool) {
    if a > b && a > c {
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
    }
}

/// A segment that meets the plane of a triangle in one point, given the signs of its
/// vertices: whether that is in the triangle. Its line passes all edges on one side.
fn piercing(
    points: &impl Points,
    segment: [usize; 3],
    signs: [Ordering; 3],
    triangle: [usize; 3],
) -> Relation {
    let k = if signs[0] == signs[1] { 1 } else { 0 };
    let (a, b) = (segment[k], segment[k + 1]);
    let sides = each(FIRST, |k| {
        let (k, next, _) = turn(k);
        points.volume([a, b, triangle[k], triangle[next]])
    });
    passing(sides)
}

/// A line that crosses a plane passes the edges of a triangle there on these sides.
fn passing(sides: [Ordering; 3]) -> Relation {
    if sides.contains(&Ordering::Less) && sides.contains(&Ordering::Greater) {
        Relation::Disjoint
    } else if sides.contains(&Ordering::Equal) {
        Relation::Touching
    } else {
        Relation::Overlapping
    }
}
