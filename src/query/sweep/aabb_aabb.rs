//! A box that moves past another. Each slab bounds the motion as it does a line, and the slab's
//! ends are sums of up to four numbers.

use core::cmp::Ordering;

use super::latest::Latest;
use super::{FirstContact, Motion, Sweep};
use crate::arithmetic::{Embeds, Number, Parts, pick, three};
use crate::query::Axis;
use crate::query::aabb_aabb::{Apart, GAP};
use crate::query::line_aabb::Slabs;
use crate::robust::{ExactSum, Predicate};
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// The box that stands, and the box that moves.
struct Passing<S> {
    boxes: Apart<S>,
    way: [[S; 3]; 2],
}

impl<S: Scalar> Passing<S> {
    #[inline(always)]
    fn new(moving: &Aabb<S>, motion: &Motion<S>, other: &Aabb<S>) -> Self {
        let way = [motion.from().to_array(), motion.to().to_array()];
        Self { boxes: Apart::new(other.form(), moving.form()), way }
    }

    /// The slabs within which the moving box meets the standing box.
    #[inline(always)]
    fn slabs<N: Embeds<S>>(&self) -> Option<Slabs<N>> {
        let Self { boxes: Apart { a, b }, way: [from, to] } = self;
        let all = [a.low, a.high, a.grown, b.low, b.high, b.grown, *from, *to];
        let [a_low, a_high, a_grown, b_low, b_high, b_grown, from, to] = N::embed(&all)?;
        Some(Slabs::of_intervals(|i| {
            let grown = a_grown[i] + b_grown[i];
            (a_low[i] - b_high[i], a_high[i] - b_low[i], grown, to[i] - from[i])
        }))
    }
}

/// Does the moving box miss the standing box?
struct Misses<S>(Passing<S>);

impl<S: Scalar> Predicate<S> for Misses<S> {
    type Answer = bool;
    const HAS_VOLUMES: bool = false;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let line = self.0.slabs::<N>()?;
        line.lies_before().or(line.lies_beyond_one()).or(line.line_misses()).verdict()
    }

    fn exact(&self) -> bool {
        let slabs = self.0.exactly();
        let is_below = |x: &[Parts], y: &[Parts]| {
            let mut sum = S::SeptumSum::new();
            add(&mut sum, x, &[Parts::UNIT], true);
            add(&mut sum, y, &[Parts::UNIT], false);
            sum.sign() == Ordering::Greater
        };
        let beside = |slab: &Slab| is_below(&slab.far, &[]) || is_below(&slab.speed, &slab.near);
        slabs.iter().any(beside)
            || [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)].into_iter().any(|(i, j)| {
                let (a, b): (&Slab, &Slab) = (pick(&slabs, i), pick(&slabs, j));
                let mut sum = S::SeptumSum::new();
                add(&mut sum, &a.near, &b.speed, false);
                add(&mut sum, &b.far, &a.speed, true);
                sum.sign() == Ordering::Greater
            })
    }
}

/// When do these boxes meet, given that they do?
struct Meets<S>(Passing<S>);

impl<S: Scalar> Predicate<S> for Meets<S> {
    type Answer = FirstContact<S>;
    const HAS_VOLUMES: bool = false;

    fn filter<N: Embeds<S>>(&self) -> Option<FirstContact<S>> {
        if !N::HAS_QUOTIENTS {
            return None;
        }
        let Slabs { near, m, spread, .. } = self.0.slabs::<N>()?;
        let mut latest = Latest::NONE;
        for i in 0..3 {
            let size = spread.map_or(near[i].magnitude(), |spread| spread[i]);
            latest.add(Axis::Face(i as u8), [near[i], size.error(GAP)], [m[i], m[i].error(2)]);
        }
        latest.known()
    }

    fn exact(&self) -> FirstContact<S> {
        let mut latest = Latest::NONE;
        for (i, slab) in self.0.exactly().iter().enumerate() {
            let [mut near, mut speed] = [S::SeptumSum::new(), S::SeptumSum::new()];
            add(&mut near, &slab.near, &[Parts::UNIT], false);
            add(&mut speed, &slab.speed, &[Parts::UNIT], false);
            if near.sign() == Ordering::Greater {
                latest.set(Axis::Face(i as u8), S::at_most(near.portion(&speed)));
            }
        }
        latest.known().unwrap_or_default()
    }
}

/// A slab as sums of numbers, mirrored where the motion goes down.
struct Slab {
    near: [Parts; 4],
    far: [Parts; 4],
    speed: [Parts; 2],
}

impl<S: Scalar> Passing<S> {
    fn exactly(&self) -> [Slab; 3] {
        let Self { boxes: Apart { a, b }, way: [from, to] } = self;
        three(|i| {
            let minus = |x: S| x.parts().negated();
            let grown = [a.grown[i], b.grown[i]];
            let [g, h] = grown.map(S::parts);
            let low = [a.low[i].parts(), minus(b.high[i]), g.negated(), h.negated()];
            let high = [a.high[i].parts(), minus(b.low[i]), g, h];
            if to[i] < from[i] {
                let speed = [from[i].parts(), minus(to[i])];
                Slab { near: high.map(Parts::negated), far: low.map(Parts::negated), speed }
            } else {
                Slab { near: low, far: high, speed: [to[i].parts(), minus(from[i])] }
            }
        })
    }
}

/// Adds or subtracts the product of two sums of numbers.
fn add<T: ExactSum>(sum: &mut T, x: &[Parts], y: &[Parts], minus: bool) {
    for &x in x {
        let x = if minus { x.negated() } else { x };
        y.iter().for_each(|&y| sum.add(&[x, y]));
    }
}

impl<S: Scalar> Sweep<Aabb<S>> for Aabb<S> {
    type Scalar = S;

    #[inline]
    fn meets_along(&self, motion: &Motion<S>, other: &Aabb<S>) -> bool {
        !S::evaluate(&Misses(Passing::new(self, motion, other)))
    }

    #[inline]
    fn first_contact(&self, motion: &Motion<S>, other: &Aabb<S>) -> Option<FirstContact<S>> {
        let meet = || S::evaluate_numeric(&Meets(Passing::new(self, motion, other)));
        self.meets_along(motion, other).then(meet)
    }
}
