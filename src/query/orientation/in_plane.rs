//! Shapes in one plane, or on one line: separating axes in the coordinate planes.
//!
//! If two sets of one plane meet, so do their projections onto each coordinate plane. The converse
//! holds for a coordinate plane onto which the plane projects one-to-one, such as any in which one
//! of the triangles has an area. In a coordinate plane the candidate axes are the normals of all
//! edges; on a line they are the coordinates themselves.

use core::cmp::Ordering;

use super::{FIRST, Points, Relation, SECOND, along};
use crate::arithmetic::{Each, pick, three, turn};

/// The relation of two triangles in one plane, of a triangle and a segment or point in its plane,
/// or of two segments or points.
#[inline(never)]
pub(super) fn in_plane(points: &impl Points) -> Relation {
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
fn seen_along(points: &impl Points, axis: usize) -> Relation {
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
