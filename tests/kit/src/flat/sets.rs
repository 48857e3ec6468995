//! Sets of cases for a triangle and a flat shape, mostly near contact.

use super::{Flat, FlatCase, Point};
use crate::sample::Sample;
use crate::{Each, rng::Rng, three};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlatSet {
    /// Anywhere.
    Random,
    /// Integers from −2 to 2.
    Grid,
    /// All in one plane, or off by one unit in the last place.
    Plane,
    /// In contact, or off by one unit in the last place: a corner or an edge of one triangle on an
    /// edge of the other, or in it.
    Touch,
    /// Slivers that nearly meet.
    Slivers,
    /// Far from the origin.
    Far,
    /// Tiny.
    Small,
    /// Any bits.
    Bits,
    /// At the ends of the type.
    Huge,
}

impl FlatSet {
    pub const ALL: [Self; 9] = [
        Self::Random,
        Self::Grid,
        Self::Plane,
        Self::Touch,
        Self::Slivers,
        Self::Far,
        Self::Small,
        Self::Bits,
        Self::Huge,
    ];

    /// A case of this set: a triangle, and one of the four kinds of shapes.
    pub fn case<S: Sample>(self, rng: &mut Rng) -> FlatCase<S> {
        let [a, b, c, d, e, f] = self.points(rng);
        let flat = match rng.below(8) {
            0..=3 => Flat::Triangle([d, e, if rng.one_in(8) { d } else { f }]),
            4 | 5 => Flat::Ends([d, e]),
            6 => Flat::Center(d, if self == Self::Huge { e } else { half(d, e) }),
            _ => Flat::Point(d),
        };
        FlatCase { flat, triangle: [a, b, if rng.one_in(16) { b } else { c }] }
    }

    fn points<S: Sample>(self, rng: &mut Rng) -> [Point<S>; 6] {
        let mut every = |one: fn(&mut Rng) -> S| [(); 6].map(|()| rng.triple(one));
        match self {
            Self::Random => every(|rng| S::nearest(rng.real(-1.0, 1.0))),
            Self::Grid => every(|rng| S::nearest(rng.whole(-2, 2) as f64)),
            Self::Small => every(|rng| S::nearest(rng.real(-1.0, 1.0) / 16384.0)),
            Self::Bits => every(|rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64))),
            Self::Huge => every(|rng| {
                let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
                end.moved(rng.whole(-2, 2))
            }),
            Self::Plane => in_plane(rng),
            Self::Touch => touch(rng),
            Self::Slivers => slivers(rng),
            Self::Far => {
                let most = S::GREATEST.approximate().min(1e6);
                let origin = rng.triple(|rng| rng.real(-0.9, 0.9) * most);
                let near = |rng: &mut Rng| {
                    let offset = rng.triple(|rng| rng.real(-1.0, 1.0));
                    three(|i: usize| S::nearest(origin[i] + offset[i]))
                };
                [(); 6].map(|()| near(rng))
            }
        }
    }
}

/// The midpoint of two points, or a number near it.
fn half<S: Sample>(a: Point<S>, b: Point<S>) -> Point<S> {
    three(|i: usize| S::nearest(b[i].approximate() / 2.0 - a[i].approximate() / 2.0))
}

type Whole = [i64; 3];

/// o + Σ n·v.
fn sum(o: Whole, terms: &[(i64, Whole)]) -> Whole {
    terms.iter().fold(o, |sum, (n, v)| three(|i: usize| sum[i] + n * v[i]))
}

/// Integer points, with one sometimes moved by a unit in the last place.
fn nudged<S: Sample>(rng: &mut Rng, points: [Whole; 6]) -> [Point<S>; 6] {
    let mut points = points.map(|p| p.each(S::whole));
    if rng.one_in(2) {
        let x = &mut points[rng.below(6)][rng.below(3)];
        *x = x.moved(rng.whole(-1, 1));
    }
    points
}

/// An integer vector with components up to 2^bits.
fn vector(rng: &mut Rng, bits: u32) -> Whole {
    rng.triple(|rng| rng.whole(-1 << bits, 1 << bits))
}

/// A few bits, or as many as fit in sums of ten.
fn some_bits<S: Sample>(rng: &mut Rng) -> u32 {
    rng.whole(1, i64::from(S::WHOLE_BITS.min(40) - 5)) as u32
}

fn in_plane<S: Sample>(rng: &mut Rng) -> [Point<S>; 6] {
    let bits = some_bits::<S>(rng);
    let (o, u, v) = (vector(rng, bits), vector(rng, bits), vector(rng, bits));
    let points = [(); 6].map(|()| {
        let (m, n) = (rng.whole(-4, 4), rng.whole(-4, 4));
        sum(o, &[(m, u), (n, v)])
    });
    nudged(rng, points)
}

/// The origin belongs to both shapes: it is a corner of the first triangle, on an edge, or inside.
fn touch<S: Sample>(rng: &mut Rng) -> [Point<S>; 6] {
    let bits = some_bits::<S>(rng);
    let o = vector(rng, bits);
    let mut corners = || {
        let (u, v) = (vector(rng, bits), vector(rng, bits));
        let (m, n) = (rng.whole(1, 3), rng.whole(1, 3));
        let mut three = match rng.below(4) {
            0 => [o, sum(o, &[(m, u)]), sum(o, &[(n, v)])],
            1 => [sum(o, &[(-m, u)]), sum(o, &[(n, u)]), sum(o, &[(1, v)])],
            _ => [sum(o, &[(1, u)]), sum(o, &[(1, v)]), sum(o, &[(-1, u), (-1, v)])],
        };
        three.rotate_left(rng.below(3));
        three
    };
    let ([a, b, c], [d, e, f]) = (corners(), corners());
    nudged(rng, [a, b, c, d, e, f])
}

/// Two sets of three points near a line, such that the lines nearly meet.
fn slivers<S: Sample>(rng: &mut Rng) -> [Point<S>; 6] {
    let o = rng.triple(|rng| rng.real(-0.5, 0.5));
    let mut three = || {
        let d = rng.triple(|rng| rng.real(-0.5, 0.5));
        [(); 3].each(|()| {
            let t = rng.real(-1.0, 1.0);
            three(|i: usize| S::nearest(o[i] + t * d[i]).moved(rng.whole(-1, 1)))
        })
    };
    let ([a, b, c], [d, e, f]) = (three(), three());
    [a, b, c, d, e, f]
}
