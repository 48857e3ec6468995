//! Sets of cases: triangles and boxes with a motion.

use super::{BoxSweep, SweepCase};
use crate::case::{BoxNumbers, Case};
use crate::sample::Sample;
use crate::sets::Set;
use crate::touch::Touch;
use crate::{Each, rng::Rng, three};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepSet {
    /// A triangle and a box of the set, and a motion between two similar points; sometimes along an
    /// axis, and sometimes none.
    Of(Set),
    /// In exact contact at some time, or with one number moved by a unit in the last place.
    Touch,
    /// Grazing contact during the motion: a vertex along an edge of the box, or an edge across a
    /// corner; or with one number moved by a unit in the last place.
    Graze,
    /// A box that falls on a plane of triangles, or slides along it.
    Floor,
}

impl SweepSet {
    pub const ALL: [Self; 12] = [
        Self::Of(Set::Random),
        Self::Of(Set::Grid),
        Self::Of(Set::Slivers),
        Self::Of(Set::Far),
        Self::Of(Set::Degenerate),
        Self::Of(Set::Touch),
        Self::Of(Set::Small),
        Self::Of(Set::Huge),
        Self::Of(Set::Flip),
        Self::Touch,
        Self::Graze,
        Self::Floor,
    ];

    /// `count` cases, the same for the same seed.
    pub fn cases<S: Sample>(self, seed: u64, count: usize) -> Vec<SweepCase<S>> {
        let rng = &mut Rng::new(seed ^ 0x5eeb);
        match self {
            // Another case of the set gives the ends of the motion.
            Self::Of(set) => {
                let shapes = set.cases::<S>(seed, count);
                let places = set.cases::<S>(seed ^ 0x77a7, count);
                shapes.into_iter().zip(places).map(|(case, way)| of_set(rng, case, way)).collect()
            }
            Self::Touch => (0..count).map(|_| touch(rng)).collect(),
            Self::Graze => (0..count).map(|_| graze(rng)).collect(),
            Self::Floor => (0..count).map(|_| floor(rng)).collect(),
        }
    }

    /// The same of two boxes.
    pub fn boxes<S: Sample>(self, seed: u64, count: usize) -> Vec<BoxSweep<S>> {
        let others = self.cases::<S>(seed ^ 0xb0e5, count);
        let sweeps = self.cases::<S>(seed, count).into_iter().zip(others);
        sweeps
            .map(|(SweepCase { case, way }, other)| {
                let [a, b, _] = case.vertices;
                let around =
                    |f: fn(S, S) -> bool| three(|i: usize| if f(a[i], b[i]) { a[i] } else { b[i] });
                let corners = BoxNumbers::Corners(around(|a, b| a < b), around(|a, b| a > b));
                let of_other = matches!(other.case.aabb, BoxNumbers::Center(..));
                let moving = if of_other { other.case.aabb } else { corners };
                BoxSweep { boxes: [moving, case.aabb], way }
            })
            .collect()
    }
}

fn of_set<S: Sample>(rng: &mut Rng, case: Case<S>, other: Case<S>) -> SweepCase<S> {
    let [a, b, _] = case.vertices;
    let [from, mut to, _] = other.vertices;
    let way = match rng.below(8) {
        // From its own place to a nearby one.
        0..=2 => [a, case.box_numbers()[0]],
        3 => [a, b],
        4 => {
            let i = rng.below(3);
            for k in (0..3).filter(|&k| k != i) {
                to[k] = from[k];
            }
            [from, to]
        }
        5 => [from, from.each(|x| x.moved(rng.whole(-1, 1)))],
        6 if rng.one_in(4) => [from, from],
        _ => [from, to],
    };
    SweepCase { case, way }
}

fn touch<S: Sample>(rng: &mut Rng) -> SweepCase<S> {
    let bits = Touch::bits::<S>().min(12);
    let touch = match rng.below(3) {
        0 => Touch::vertex(rng, bits),
        1 => Touch::edge(rng, bits),
        _ => Touch::corner(rng, bits),
    };
    let steps = rng.whole(1, 4);
    let at = rng.whole(0, steps);
    let step = rng.triple(|rng| rng.whole(-1 << (bits - 3), 1 << (bits - 3)));
    let mut case: Case<S> = touch.case(rng.one_in(2));
    let moved = |x: S, by: i64| {
        let unit = S::whole(1).approximate();
        S::nearest(x.approximate() + by as f64 * unit)
    };
    for v in &mut case.vertices {
        *v = three(|i: usize| moved(v[i], -at * step[i]));
    }
    let from = rng.triple(|rng| S::whole(rng.whole(-8, 8)));
    let to = three(|i: usize| moved(from[i], steps * step[i]));
    nudged(rng, SweepCase { case, way: [from, to] })
}

/// In half of the cases moves one number by a unit in the last place, or by none.
fn nudged<S: Sample>(rng: &mut Rng, mut sweep: SweepCase<S>) -> SweepCase<S> {
    if rng.one_in(2) {
        let i = if rng.one_in(2) { rng.below(9) } else { rng.below(21) };
        let up = rng.whole(-1, 1);
        if i >= 15 {
            let x = &mut sweep.way[(i - 15) / 3][i % 3];
            *x = x.moved(up);
        } else {
            let x = sweep.case.numbers()[i].moved(up);
            sweep.case = sweep.case.with_number(i, x).unwrap_or(sweep.case);
        }
    }
    sweep
}

/// A grazing triangle. During the motion a vertex or an edge of it sweeps out the part of a
/// touching triangle that lies in the separating plane; the rest of the triangle is above the
/// plane.
fn graze<S: Sample>(rng: &mut Rng) -> SweepCase<S> {
    let bits = (Touch::bits::<S>() - 1).min(12);
    let by_edge = rng.one_in(2);
    let mut touch = if by_edge { Touch::edge(rng, bits) } else { Touch::corner(rng, bits) };
    let mut vertices = touch.lowest_first();
    let up = (0..3).max_by_key(|&i| touch.normal[i].abs()).unwrap_or(0);
    let above = |rng: &mut Rng, mut p: [i64; 3]| {
        p[up] += touch.normal[up].signum() * rng.whole(0, 1 << (bits - 3));
        p
    };
    let [a, b, c] = vertices;
    let way = if by_edge { [a, b] } else { [a, c] };
    vertices = if by_edge { [a, above(rng, a), c] } else { [a, b, above(rng, a)] };
    vertices.rotate_left(rng.below(3));
    touch.vertices = vertices;
    // Sometimes around zero, so that the last place is far smaller than the rest.
    if rng.one_in(2) {
        let [x, y, z] = &mut touch.vertices;
        for p in [x, y, z, &mut touch.least, &mut touch.greatest] {
            *p = three(|i: usize| p[i] - a[i]);
        }
    }
    let case = touch.case(rng.one_in(2));
    nudged(rng, SweepCase { case, way: way.each(|p| p.each(S::whole)) })
}

fn floor<S: Sample>(rng: &mut Rng) -> SweepCase<S> {
    let up = rng.below(3);
    let height = S::nearest(rng.whole(-2, 2) as f64);
    let mut vertices = [(); 3].each(|()| rng.triple(|rng| S::nearest(rng.real(-3.0, 3.0))));
    for v in &mut vertices {
        v[up] = height;
    }
    let center = rng.triple(|rng| S::nearest(rng.whole(-8, 8) as f64 / 4.0));
    let half = rng.triple(|rng| S::nearest(rng.whole(0, 4) as f64 / 4.0));
    let mut to = rng.triple(|rng| S::nearest(rng.real(-3.0, 3.0)));
    if rng.one_in(2) {
        to[up] = center[up];
    }
    // The box moves, so relative to it the triangle moves the opposite way.
    SweepCase { case: Case { vertices, aabb: BoxNumbers::Center(center, half) }, way: [to, center] }
}
