//! Capsule against axis-aligned and oriented box.

use super::{Between, all_beyond, meets_box};
use crate::arithmetic::{Arithmetic, Each, Embeds, Number, greatest, largest, three, turn, two};
use crate::query::Overlaps;
use crate::query::orientation::{Vector, from};
use crate::query::sphere::{Ball, Beyond, Corners, Reach, corners, to_corners};
use crate::robust::{Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule, Obb};

/// Roundoffs in a coordinate of the vector to a corner, of the greatest difference to the centre and
/// half-extent: 1 of the difference, 2 of its sum with the half-extent, and what the bound loses to underflow.
/// `boxes.g` proves it.
const APART: u16 = 5;

impl<S: Scalar> Predicate<S> for Beyond<'_, Capsule<S>, Aabb<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (p, q, is_by_center) = self.shape.numbers();
        let [a, b] = self.ends();
        let all = [a, b, p, q, [self.round.radius(); 3]];
        let [a, b, p, q, [r, ..]] = N::embed(&all)?;
        let reach = Reach::<N>::new(r, self.ball);
        // From each end to both extreme corners, and the extents.
        let to = [a, b].each(|end| to_corners::<N>(&end, [&p, &q], is_by_center));
        let (extents, slack) = if is_by_center {
            let d = greatest(largest(&from::<N>(&p, &a)), largest(&from::<N>(&p, &b)));
            (three(|i| q[i] + q[i]), greatest(d, largest(&q)))
        } else {
            (from::<N>(&q, &p), N::Length::ZERO)
        };
        let [[low, high], [low_b, high_b]] = to;
        let margin = slack.error(APART);
        if reach.is_beyond_by(&[low, high, low_b, high_b], margin) {
            return Some(true);
        }
        box_lies_beyond(&reach, &to, &extents, &from::<N>(&b, &a), slack)
    }
}

/// Whether the ends of a segment along `e` lie farther from a box than the radius, and the segment
/// from its edges; with vectors from both ends to both extreme corners. The vectors err as
/// `Reach::excludes` says.
#[inline(always)]
pub(in crate::query) fn box_lies_beyond<N: Arithmetic>(
    reach: &Reach<N>,
    to: &[[Vector<N>; 2]; 2],
    extents: &Vector<N>,
    e: &Vector<N>,
    slack: N::Length,
) -> Option<bool> {
    let from_end = |[low, high]: &[Vector<N>; 2]| {
        let d = three(|i| greatest(greatest(low[i], -high[i]), N::Length::ZERO));
        reach.excludes_if_in_range(&d, slack)
    };
    // An edge along an axis: bits 0 and 1 of k choose its line.
    let from_edge = |axis: usize, k: usize| {
        let ends = two(|point| {
            let [low, high] = &to[point];
            two(|end| {
                three(|i| {
                    let bit = usize::from(i == (axis + 2) % 3);
                    let is_high = if i == axis { end == 1 } else { k >> bit & 1 == 1 };
                    if is_high { high[i] } else { low[i] }
                })
            })
        });
        let along = three(|i| if i == axis { extents[i] } else { N::Length::ZERO });
        Between { ends, along: [*e, along] }.is_beyond(reach, slack)
    };
    all_beyond((0..14).map(|k| match k {
        0 => from_end(&to[0]),
        1 => from_end(&to[1]),
        _ => from_edge((k - 2) / 4, k - 2),
    }))
}

impl<S: Scalar> Overlaps<Aabb<S>> for Capsule<S> {
    /// Do a capsule and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets, the box in the form in which it was given. The radius may be zero,
    /// the ends of the capsule may coincide, the box may be flat or a point.
    ///
    /// *Contact*, *Numerics* and *Range*: as for a
    /// [triangle](Capsule#impl-Overlaps<Triangle<S>>-for-Capsule<S>).
    ///
    /// *Panics*: never. *Cost*: 12 comparisons if a coordinate separates; otherwise a
    /// [segment and a box](crate::Segment#impl-Overlaps<Aabb<S>>-for-Segment<S>), then two spheres
    /// at the ends and twelve segments along the edges, until one is near enough.
    ///
    /// ```
    /// use septum::{Aabb, Capsule};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let past_edge = Capsule::new([4.0, 5.0, -9.0], [4.0, 5.0, 9.0], 5.0)?;
    /// assert!(past_edge.overlaps(&cell)); // 3² + 4² = 5²
    /// let past_edge = Capsule::new([4.000_001, 5.0, -9.0], [4.0, 5.000_001, 9.0], 5.0)?;
    /// assert!(!past_edge.overlaps(&cell));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        meets_box(self, aabb, Ball::Closed)
    }
}

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
        let between = Between::<M> { ends, along: [e, corners.edge(i)] };
        between.as_face(|vectors, edges| corners.excludes_face(reach, vectors, edges))
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
