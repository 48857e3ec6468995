//! What lies in one plane, or on one line: separating axes in the planes of two coordinates.
//!
//! Two sets in one plane meet exactly if what they leave in each plane of two coordinates
//! meets: on one of these the plane is left as it is, and where sets meet, what they leave
//! does. One on which a triangle has an area is such a one, and enough. In a plane of two
//! coordinates the axes are the normals of all edges, and for what is on one line the
//! coordinates themselves.

use core::cmp::Ordering;

use super::{FIRST, Points, Relation, SECOND, along};
use crate::arithmetic::{each, pick, turn};

/// What the three coordinates say at most.
pub(super) fn boxes(points: &impl Points) -> Relation {
    let mut so_far = Relation::Overlapping;
    for axis in 0..3 {
        // Every point of the one with every point of the other.
        let rows = each(FIRST, |a| each(SECOND, |b| points.compare(axis, [a, b])));
        let all = || rows.as_flattened().iter();
        let (above, below) = (all().any(|x| x.is_gt()), all().any(|x| x.is_lt()));
        if above != below {
            let meets = all().any(|x| x.is_eq());
            so_far = so_far.min(if meets { Relation::Touching } else { Relation::Disjoint });
        }
    }
    so_far
}

/// Two triangles in one plane, or a segment or point in that of a triangle, or two of those.
#[inline(never)]
pub(super) fn in_plane(points: &impl Points) -> Relation {
    // Two segments need not be in one plane.
    for i in 0..2 {
        for k in 0..2 {
            let (a, b) = (FIRST[i], SECOND[k]);
            if points.volume([a, a + 1, b, b + 1]) != Ordering::Equal {
                return Relation::Disjoint;
            }
        }
    }
    let mut so_far = Relation::Overlapping;
    for axis in 0..3 {
        let mut has_area = false;
        for (one, other) in [(FIRST, SECOND), (SECOND, FIRST)] {
            for k in 0..3 {
                let (k, next, opposite) = turn(k);
                let side = |x: usize| points.area(axis, [*pick(&one, k), *pick(&one, next), x]);
                let back = side(*pick(&one, opposite));
                so_far = so_far.min(along(each(other, side), &[back]));
                has_area |= back != Ordering::Equal;
            }
        }
        if has_area || so_far == Relation::Disjoint {
            break;
        }
    }
    so_far
}
