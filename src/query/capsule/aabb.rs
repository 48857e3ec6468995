//! Capsule against axis-aligned box.

use super::{Between, all_beyond, meets_box};
use crate::arithmetic::{Arithmetic, Each, Embeds, Number, greatest, largest, three, two};
use crate::query::Overlaps;
use crate::query::orientation::{Vector, from};
use crate::query::sphere::{Ball, Beyond, Reach, to_corners};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule};

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
        if !is_by_center && reach.is_beyond(&[low, high, low_b, high_b]) {
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
