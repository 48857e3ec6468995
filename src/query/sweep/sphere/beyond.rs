//! Whether a shape lies farther from a way than a radius.
//!
//! The vectors to the end of the way are sums of the vectors to its start and of the way, and err by
//! a roundoff of each and of themselves: the slack is the sum of these sizes.

use super::Passing;
use crate::arithmetic::{Arithmetic, Embeds, Number, largest, pick, three, two};
use crate::query::capsule::{box_lies_beyond, triangle_lies_beyond};
use crate::query::orientation::{Vector, from};
use crate::query::sphere::{Ball, Reach, around, largest_of, to_corners};
use crate::robust::{Numeric, Predicate, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Roundoffs of a component less the radius, of slack and radius. To first order 4: 2 of the
/// component, and 2 of the difference. `beyond.g` proves it.
const ASIDE: u16 = 8;

/// The question whether the boundary of a shape lies farther from the way of a sphere's centre than
/// its radius.
pub(super) struct Beyond<'a, S, T> {
    pub(super) passing: Passing<'a, S, T>,
    pub(super) ball: Ball,
}

/// Whether a coordinate alone keeps all points to which these vectors go beyond the radius.
#[inline(always)]
fn lie_aside<N: Arithmetic, const K: usize>(
    vectors: [&[Vector<N>; K]; 2],
    radius: N::Length,
    slack: N::Length,
) -> bool {
    let error = (slack + radius).error(ASIDE);
    let is_above = |sign: fn(N::Length) -> N::Length| {
        three(|i| {
            let of = |v: &Vector<N>| sign(*pick(v, i)) - radius;
            vectors.iter().copied().flatten().all(|v| Uncertain::above(of(v), error).certain)
        })
    };
    is_above(|x| x).contains(&true) || is_above(|x| -x).contains(&true)
}

impl<S: Scalar> Predicate<S> for Beyond<'_, S, Triangle<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let ([center, radius, start, end], [a, b, c]) =
            (self.passing.way(), self.passing.shape.points());
        let [center, [r, ..], start, end, a, b, c] =
            N::embed(&[center, radius, start, end, a, b, c])?;
        let d = from::<N>(&end, &start);
        let [to_start, edges] = around::<N>(&center, &[a, b, c]);
        let to_end = three(|k| three(|i| to_start[k][i] + d[i]));
        let slack =
            if N::CERTAIN { N::Length::ZERO } else { largest_of::<N, 3>(&to_start) + largest(&d) };
        if lie_aside::<N, 3>([&to_start, &to_end], r, slack) {
            return Some(true);
        }
        let reach = Reach::<N>::new(r, self.ball);
        triangle_lies_beyond::<N>(&reach, [&to_start, &to_end], &edges, &d, slack)
    }
}

impl<S: Scalar> Predicate<S> for Beyond<'_, S, Aabb<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (p, q, is_by_center) = self.passing.shape.numbers();
        let [center, radius, start, end] = self.passing.way();
        let [center, [r, ..], start, end, p, q] = N::embed(&[center, radius, start, end, p, q])?;
        let (d, to_p) = (from::<N>(&end, &start), from::<N>(&p, &center));
        // From each end to both extreme corners.
        let at_start = to_corners::<N>(&center, [&p, &q], is_by_center);
        let extents = if is_by_center { three(|i| q[i] + q[i]) } else { from::<N>(&q, &p) };
        let at_end = two(|k| from::<N>(&at_start[k], &d));
        let slack = if N::CERTAIN {
            N::Length::ZERO
        } else {
            largest(&to_p) + largest_of::<N, 2>(&at_start) + largest(&d)
        };
        if lie_aside::<N, 2>([&at_start, &at_end], r, slack) {
            return Some(true);
        }
        let reach = Reach::<N>::new(r, self.ball);
        box_lies_beyond::<N>(&reach, &[at_start, at_end], &extents, &d, slack)
    }
}

impl<S, T> Numeric<S> for Beyond<'_, S, T> where Self: Predicate<S> {}
