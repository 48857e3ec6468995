//! Capsule against oriented box.

use super::{Between, all_beyond, meets_box};
use crate::arithmetic::{Arithmetic, Embeds, three, turn, two};
use crate::query::Overlaps;
use crate::query::orientation::from;
use crate::query::sphere::{Ball, Beyond, Corners, Reach, corners};
use crate::robust::{Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Obb};

/// Whether the edges of a box lie beyond the reach of a segment, and the box beyond that of both
/// ends; `None` in doubt.
fn lies_beyond<M: Arithmetic>(corners: &Corners<M>, reach: &Reach<M>) -> Option<bool> {
    if corners.is_apart(reach) {
        return Some(true);
    }
    let [a, b] = &corners.d;
    let e = from::<M>(b, a);
    // An edge along an axis: bits 0 and 1 of k choose its line.
    let from_edge = |axis: usize, k: usize| {
        let (i, j, l) = turn(axis);
        let start = (k & 1) << j | (k >> 1 & 1) << l;
        let ends = two(|point| {
            two(|end| {
                let way = corners.way_from_corner(point, start | end << i);
                three(|i| -way[i])
            })
        });
        Between { ends, along: [e, corners.edge(i)] }.is_beyond(reach, corners.slack)
    };
    all_beyond((0..14).map(|k| match k {
        0 | 1 => corners.lies_beyond(k, reach),
        _ => from_edge((k - 2) / 4, k - 2),
    }))
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Capsule<S>, Obb<S>> {
    type Answer = bool;
    // As with a sphere.
    const PROFILE: Profile = Profile::AREAS;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let radius = self.round.radius();
        let (corners, reach) = corners::<S, N>(self.ends(), self.shape, radius, self.ball)?;
        lies_beyond(&corners, &reach)
    }
}

impl<S: Scalar> Overlaps<Obb<S>> for Capsule<S> {
    /// Do a capsule and an oriented box have a point in common?
    ///
    /// *Geometry*: closed sets, the box namely the parallelepiped that its numbers describe. The
    /// radius may be zero, the ends of the capsule may coincide, the box may be flat.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [sphere](crate::Sphere#impl-Overlaps<Obb<S>>-for-Sphere<S>).
    ///
    /// *Panics*: never. *Cost*: 15 multiplications if a coordinate separates. Otherwise two spheres
    /// at the ends and twelve segments along the edges, until one is near enough, and if none is a
    /// [segment and a box](crate::Segment#impl-Overlaps<Obb<S>>-for-Segment<S>).
    ///
    /// ```
    /// use septum::{Capsule, Obb};
    ///
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([10.0, 0.0, 0.0], axes, [2.0, 1.0, 0.5])?;
    /// assert!(Capsule::new([10.0, 0.0, 2.5], [99.0, 0.0, 2.5], 2.0)?.overlaps(&tool)); // touches
    /// assert!(!Capsule::new([10.0, 0.0, 2.500_001], [99.0, 0.0, 2.6], 2.0)?.overlaps(&tool));
    /// assert!(Capsule::new([0.0, 0.0, 0.0], [99.0, 0.0, 0.0], 0.0)?.overlaps(&tool)); // passes through
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        meets_box(self, obb, Ball::Closed)
    }
}
