//! Two axis-aligned boxes, or a box and a point. The oracle compares two intervals on each axis, in
//! integers of any size.

use dashu_int::IBig;
use septum::relation::Relate;

use crate::exact::{Parts, least_exponent, whole};
use crate::flat::Truth;
use crate::rng::Rng;
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

/// Two boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AabbPair<S> {
    pub boxes: [BoxNumbers<S>; 2],
}

/// The distribution of the numbers of two boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AabbSet {
    Grid,
    Near,
    Far,
    Tiny,
    /// At the ends of the type and anywhere between them: sums and differences of floats overflow.
    Extreme,
    /// Any bits.
    Any,
}

fn rows<S: Copy>(aabb: &BoxNumbers<S>) -> [[S; 3]; 2] {
    let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = *aabb;
    [p, q]
}

/// The exponent of a power of two that divides all numbers of the boxes.
fn unit(boxes: [&BoxNumbers<Parts>; 2]) -> i32 {
    least_exponent(boxes.each(rows).as_flattened().as_flattened())
}

/// The two ends of a box on an axis.
fn ends(aabb: &BoxNumbers<Parts>, unit: i32, axis: usize) -> [IBig; 2] {
    let [p, q] = rows(aabb).each(|row| whole(row[axis], unit));
    match aabb {
        BoxNumbers::Center(..) => [&p - &q, p + q],
        BoxNumbers::Corners(..) => [p, q],
    }
}

/// How two intervals lie to each other.
fn intervals([a, b]: &[IBig; 2], [c, d]: &[IBig; 2]) -> Truth {
    let is_inside = |p: &IBig, a: &IBig, b: &IBig| a < p && p < b || a == b && p == a;
    let interiors_meet = match (a == b, c == d) {
        (true, _) => is_inside(a, c, d),
        (_, true) => is_inside(c, a, b),
        _ => a.max(c) < b.min(d),
    };
    if a.max(c) > b.min(d) {
        Truth::Apart
    } else if interiors_meet {
        Truth::Overlapping
    } else {
        Truth::Touching
    }
}

/// The ends of a box on an axis, approximately.
pub fn ends_of<S: Sample>(aabb: &BoxNumbers<S>, axis: usize) -> [f64; 2] {
    let aabb = aabb.map(S::mantissa_exponent);
    let unit = unit([&aabb; 2]);
    ends(&aabb, unit, axis).each(|x| x.to_f64().value() * 2_f64.powi(unit))
}

impl<S: Sample> AabbPair<S> {
    /// How the two lie to each other: apart if one axis separates them, touching if they touch on
    /// an axis.
    pub fn truth(&self) -> Truth {
        let [a, b] = self.boxes.each(|aabb| aabb.map(S::mantissa_exponent));
        let unit = unit([&a, &b]);
        let on_axis = |i| intervals(&ends(&a, unit, i), &ends(&b, unit, i));
        (0..3).map(on_axis).min_by_key(|truth| *truth as u8).expect("three axes")
    }

    /// Checks every answer about the pair, in either order, and returns the truth.
    ///
    /// # Panics
    /// Where an answer is wrong.
    pub fn check(&self) -> Truth {
        let [a, b] = self.boxes.each(|aabb| aabb.shape().expect("a box"));
        let truth = self.truth();
        let meets = truth != Truth::Apart;
        assert_eq!([a.overlaps(&b), b.overlaps(&a)], [meets; 2], "{} {self:?}", S::name());
        assert!(!meets || a.may_overlap(&b), "{} {self:?}", S::name());
        let relations = [a.relation(&b), b.relation(&a)];
        assert_eq!(relations, [truth.relation(); 2], "{} {self:?}", S::name());
        truth
    }
}

impl AabbSet {
    pub const ALL: [Self; 6] =
        [Self::Grid, Self::Near, Self::Far, Self::Tiny, Self::Extreme, Self::Any];

    pub fn case<S: Sample>(self, rng: &mut Rng) -> AabbPair<S> {
        AabbPair { boxes: [self.aabb(rng), self.aabb(rng)] }
    }

    pub fn number<S: Sample>(self, rng: &mut Rng) -> S {
        match self {
            Self::Grid => S::whole(rng.whole(-4, 4)),
            Self::Near => S::nearest(rng.real(-2.0, 2.0)),
            Self::Far => S::nearest(1e5 + rng.real(-2.0, 2.0)).moved(rng.whole(-9, 9)),
            Self::Tiny => S::from_ordinal(rng.whole(-9, 9)),
            Self::Extreme => match rng.below(4) {
                0 => S::LEAST.moved(rng.whole(0, 3)),
                1 => S::GREATEST.moved(-rng.whole(0, 3)),
                2 => S::nearest(rng.real(-1.0, 1.0)),
                _ => S::nearest(rng.real(-1.0, 1.0) * S::GREATEST.approximate()),
            },
            Self::Any => {
                let greatest = S::GREATEST.ordinal();
                S::from_ordinal(rng.whole(-greatest, greatest))
            }
        }
    }

    pub fn aabb<S: Sample>(self, rng: &mut Rng) -> BoxNumbers<S> {
        let p = rng.triple(|rng| self.number::<S>(rng));
        if rng.one_in(2) {
            // Half-extents of far boxes are near.
            let small = if self == Self::Far { Self::Near } else { self };
            let magnitude = |x: S| S::from_ordinal(x.ordinal().saturating_abs());
            return BoxNumbers::Center(p, rng.triple(|rng| magnitude(small.number(rng))));
        }
        let q = rng.triple(|rng| self.number::<S>(rng));
        let ordered = |i: usize| if p[i] <= q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
        let all = three(ordered);
        BoxNumbers::Corners(all.each(|x| x.0), all.each(|x| x.1))
    }
}
