//! Sets of polygons and boxes, mostly near contact.

use super::{PlanePolygon, PolygonCase};
use crate::case::{BoxNumbers, Case};
use crate::sample::Sample;
use crate::sets::Set;
use crate::{Each, rng::Rng, three};

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolygonSet {
    /// A set of triangles with additional vertices: duplicates, on an edge or nearly, opposite one,
    /// or from another triangle.
    More(Set),
    /// Rounded vertices on an ellipse; the box is around one of its points, or not.
    Round,
    /// Convex and exactly planar, or with one number moved by a unit in the last place.
    Plane,
    /// Any bits.
    Bits,
}

impl PolygonSet {
    /// All sets.
    pub fn all() -> impl Iterator<Item = Self> {
        Set::ALL.map(Self::More).into_iter().chain([Self::Round, Self::Plane, Self::Bits])
    }

    /// `count` cases, the same for the same seed.
    pub fn cases<S: Sample>(self, seed: u64, count: usize) -> Vec<PolygonCase<S>> {
        let rng = &mut Rng::new(seed);
        match self {
            Self::More(set) => {
                let triangles = set.cases::<S>(seed, count);
                let from = |k: usize| &triangles[k % triangles.len()];
                (0..count).map(|k| more(rng, from(k), from(k + 1))).collect()
            }
            Self::Round => (0..count).map(|_| round(rng)).collect(),
            Self::Plane => (0..count).map(|_| plane(rng)).collect(),
            Self::Bits => (0..count).map(|_| bits(rng)).collect(),
        }
    }
}

fn more<S: Sample>(rng: &mut Rng, case: &Case<S>, other: &Case<S>) -> PolygonCase<S> {
    let mut vertices = case.vertices.to_vec();
    for _ in 0..rng.below(6) {
        let at = rng.below(vertices.len());
        let [a, b, c] = three(|k| vertices[(at + k) % vertices.len()]);
        let new = match rng.below(4) {
            0 => a,
            1 => three(|i: usize| a[i].between(b[i])),
            2 => three(|i: usize| {
                S::nearest(b[i].approximate() - a[i].approximate() + c[i].approximate())
            }),
            _ => other.vertices[rng.below(3)],
        };
        vertices.insert(at + 1, new);
    }
    PolygonCase { vertices, aabb: case.aabb }
}

fn round<S: Sample>(rng: &mut Rng) -> PolygonCase<S> {
    let mut vector = || rng.triple(|rng| rng.real(-1.0, 1.0));
    let (o, u, v, offset) = (vector(), vector(), vector(), vector());
    let count = 4 + rng.below(9);
    let from = rng.real(0.0, 1.0);
    let at = |k: f64, part: f64| {
        let (sin, cos) = ((k + from) / count as f64 * std::f64::consts::TAU).sin_cos();
        three(|i: usize| o[i] + part * (cos * u[i] + sin * v[i]))
    };
    let vertices = (0..count).map(|k| at(k as f64, 1.0).each(S::nearest)).collect();
    // Seldom far away, because most boxes would miss it.
    let (k, part) = (rng.real(0.0, count as f64), rng.real(0.0, 1.2));
    let near = at(k, part);
    let off = if rng.one_in(2) { 0.3 } else { 0.0 };
    let center = three(|i: usize| S::nearest(near[i] + off * offset[i]));
    let half = rng.triple(|rng| S::nearest(rng.real(0.0, 0.3)));
    PolygonCase { vertices, aabb: BoxNumbers::Center(center, half) }
}

fn plane<S: Sample>(rng: &mut Rng) -> PolygonCase<S> {
    let mut case: PolygonCase<S> = PlanePolygon::random::<S>(rng).case(rng.one_in(2));
    if rng.one_in(2) {
        let k = rng.below(case.vertices.len());
        let x = &mut case.vertices[k][rng.below(3)];
        *x = x.moved(rng.whole(-1, 1));
    }
    case
}

fn bits<S: Sample>(rng: &mut Rng) -> PolygonCase<S> {
    let mut point = || rng.triple(|rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64)));
    let (p, q) = (point(), point());
    let mut vertices: Vec<_> = [(); 3].each(|()| point()).into();
    while vertices.len() < 8 && rng.one_in(2) {
        vertices.push(rng.triple(|rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64))));
    }
    let order = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
    let [x, y, z] = three(order);
    PolygonCase { vertices, aabb: BoxNumbers::Corners([x.0, y.0, z.0], [x.1, y.1, z.1]) }
}
