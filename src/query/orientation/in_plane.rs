//! What lies in one plane, or on one line: separating axes in the planes of two coordinates.
//!
//! Two sets in one plane meet exactly if what they leave in each plane of two coordinates
//! meets: on one of these the plane is left as it is, and where sets meet, what they leave
//! does. One on which a triangle has an area is such a one, and enough. In a plane of two
//! coordinates the axes are the normals of all edges, and for what is on one line the
//! coordinates themselves.

use core::cmp::Ordering;

use super::{FIRST, Points, Relation, SECOND, along};
use crate::arithmetic::{each, pick, three, turn};

/// Two triangles in one plane, or a segment or point in that of a triangle, or two of those.
#[inline(never)]
pub(super) fn in_plane(points: &impl Points) -> Relation {
    let has_area = |axis: usize| {
        points.area(axis, FIRST) != Ordering::Equal || points.area(axis, SECOND) != Ordering::Equal
    };
    if let Some(axis) = (0..3).find(|&axis| has_area(axis)) {
        return seen_along(points, axis);
    }
    // Two segments, which need not be in one plane.
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

/// What the normals of edges say at most, seen along an axis.
fn seen_along(points: &impl Points, axis: usize) -> Relation {
    let mut so_far = Relation::Overlapping;
    for (one, other) in [(FIRST, SECOND), (SECOND, FIRST)] {
        for k in 0..3 {
            let (k, next, opposite) = turn(k);
            let [a, b, c] = each([k, next, opposite], |k| *pick(&one, k));
            let sides = points.sides_of_line(axis, [a, b], other);
            so_far = so_far.min(along(sides, &[points.area(axis, [a, b, c])]));
            if so_far == Relation::Disjoint {
                return so_far;
            }
        }
    }
    so_far
}
