//! Contact of a sphere or a capsule with a triangle or an axis-aligned box.
//!
//! A sphere is a point with a radius, and a capsule a segment with one. [`nearest`](super::nearest)
//! has the direction, exactly, and [`depth`](super::depth) the numbers along it.

use super::answer::{Features, Part, Point, Points};
use super::apart::apart;
use super::body::{Flat, Round, dot};
use super::depth::{Out, Units, out, rounded};
use super::mesh::InteriorEdges;
use super::nearest::Pair;
use super::scene::{Scene, Way};
use super::{Contact, Translation};
use crate::arithmetic::{Each, Embeds, Number, greatest, root, three};
use crate::robust::{Numeric, Predicate};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// The question for the least translation.
struct Question<'a, S> {
    flat: Flat<'a, S>,
    round: &'a Round<S>,
    interior: InteriorEdges,
}

/// The answer.
struct Found<S> {
    least: Out,
    /// Whether the segment meets the flat shape.
    is_deep: bool,
    /// Whether the way leads across an interior edge.
    is_across: bool,
    /// Then along the normal of the triangle.
    normal: Option<Out>,
    /// The parts that meet, of the flat shape and of the round one.
    parts: [Part; 2],
    /// The point of the flat shape.
    point: [S; 3],
}

impl<S: Scalar> Question<'_, S> {
    /// The numbers along the normal of a triangle, to the side where the depth is less.
    fn along_normal<N: Embeds<S>>(
        &self,
        scene: &Scene<N>,
        r: N::Length,
        unit: &Units<N>,
    ) -> Option<Out> {
        let n = scene.normal();
        let [front, back] = [n, n.each(|x| -x)]
            .each(|n| out::<S, N>(&Way::Normal { n, overlap: scene.overlap(&n) }, r, unit));
        let (front, back) = (front?, back?);
        let is_less = back.lengths.depth.is_less_than(front.lengths.depth);
        Some(if is_less { back } else { front })
    }
}

impl<S: Scalar> Predicate<S> for Question<'_, S> {
    type Answer = Option<Found<S>>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer> {
        if !N::CERTAIN {
            return None;
        }
        let [a, b] = self.round.ends.each(Vec3::to_array);
        let (points, is_by_center) = match self.flat {
            Flat::Triangle(t) => (t.points(), false),
            Flat::Aabb(aabb) => {
                let (p, q, is_by_center) = aabb.numbers();
                ([p, q, q], is_by_center)
            }
        };
        let [p, q, v] = points;
        let numbers = [self.round.radius, S::UNIT_LENGTH, S::ZERO];
        let [a, b, p, q, v, [r, one, _]] = N::embed(&[a, b, p, q, v, numbers])?;
        let scene = match self.flat {
            Flat::Triangle(_) => Scene::of_triangle(&[p, q, v], [a, b], one),
            Flat::Aabb(_) if is_by_center => {
                let corners = [three(|i| p[i] - q[i]), three(|i| p[i] + q[i])];
                Scene::of_box(&corners, [a, b], one)
            }
            Flat::Aabb(_) => Scene::of_box(&[p, q], [a, b], one),
        };
        let unit = Units::new(one);
        let found = |pair: Pair<N>| {
            let is_across = scene.leads_across(&pair.way, pair.farthest, self.interior);
            let Pair { way, parts, place, .. } = pair;
            let is_deep = matches!(way, Way::Normal { overlap, .. } if overlap >= N::Volume::ZERO);
            Some(Found {
                least: out::<S, N>(&way, r, &unit)?,
                is_deep,
                is_across,
                normal: if is_across { self.along_normal(&scene, r, &unit) } else { None },
                parts,
                point: rounded(&place, &unit)?,
            })
        };
        Some(scene.nearest().and_then(found))
    }
}

impl<S: Scalar> Numeric<S> for Question<'_, S> {}

/// What the direction comes from, given the parts that meet, of the flat shape and of the round one.
fn features(parts: [Part; 2], is_round_first: bool) -> Features {
    match (parts, is_round_first) {
        ([Part::Face(face), _], false) => Features::First(face),
        ([Part::Face(face), _], true) => Features::Second(face),
        ([Part::Edge(i), Part::Edge(k)], false) => Features::Edges(i, k),
        ([Part::Edge(i), Part::Edge(k)], true) => Features::Edges(k, i),
        ([i, k], false) => Features::Nearest(i, k),
        ([i, k], true) => Features::Nearest(k, i),
    }
}

pub(super) fn least_translation<S: Scalar>(
    flat: Flat<'_, S>,
    round: &Round<S>,
    is_round_first: bool,
) -> Option<Translation<S>> {
    if let Some(apart) = apart(flat, round) {
        if let Some(measures) = apart.known.measures(is_round_first) {
            return Some(measures.translation(features(apart.parts, is_round_first)));
        }
    }
    let found = S::evaluate_numeric(&Question { flat, round, interior: InteriorEdges::NONE })?;
    let features = features(found.parts, is_round_first);
    Some(found.least.lengths.measures(is_round_first).translation(features))
}

pub(super) fn contact<S: Scalar>(
    flat: Flat<'_, S>,
    round: &Round<S>,
    is_round_first: bool,
    interior: InteriorEdges,
) -> Option<Contact<S>> {
    match in_floats(flat, round, is_round_first, interior) {
        Some(contact) => contact,
        None => exactly(flat, round, is_round_first, interior),
    }
}

/// The contact, or that there is none; `None` in doubt.
pub(super) fn in_floats<S: Scalar>(
    flat: Flat<'_, S>,
    round: &Round<S>,
    is_round_first: bool,
    interior: InteriorEdges,
) -> Option<Option<Contact<S>>> {
    let apart = apart(flat, round)?;
    if apart.leads_across(interior)? {
        // As in `exactly`.
        return Some(None);
    }
    let measures = apart.known.measures(is_round_first)?;
    let translation = measures.translation(features(apart.parts, is_round_first));
    let (points, depth) = apart.points()?;
    let points = one_point(points, depth, apart.parts, is_round_first);
    Some(Some(Contact { translation, is_held: false, points }))
}

pub(super) fn exactly<S: Scalar>(
    flat: Flat<'_, S>,
    round: &Round<S>,
    is_round_first: bool,
    interior: InteriorEdges,
) -> Option<Contact<S>> {
    let found = S::evaluate_numeric(&Question { flat, round, interior })?;
    let is_held = found.is_across;
    let unit = found.least.lengths.unit(true);
    let distance = found.least.distance;
    let (out, features) = if is_held {
        // The neighbour beyond the edge is nearer than this triangle.
        if !found.is_deep {
            return None;
        }
        (found.normal?, if is_round_first { Features::Second(0) } else { Features::First(0) })
    } else {
        let features = features(found.parts, is_round_first);
        (found.least, features)
    };
    let translation = out.lengths.measures(is_round_first).translation(features);
    let normal = out.lengths.unit(true);
    let depth = if is_held {
        depth_over(distance, round.radius.in_double(), dot(&unit, &normal))
    } else {
        out.lengths.depth_in_double::<S>()
    };
    let point = Vec3::from(found.point);
    let on_round = Vec3::from(three(|i| {
        let x = found.point[i];
        if normal[i] == 0.0 { x } else { x.plus_double(-(depth * normal[i])) }
    }));
    let depth = S::ZERO.plus_double(depth);
    let points = one_point([point, on_round], depth, found.parts, is_round_first);
    Some(Contact { translation, is_held, points })
}

/// A point of the flat shape and one of the round shape.
fn one_point<S: Scalar>(
    [on_first, on_second]: [Vec3<S>; 2],
    depth: S,
    parts: [Part; 2],
    is_round_first: bool,
) -> Points<S> {
    let mut point = Point { on_first, on_second, depth, parts };
    if is_round_first {
        core::mem::swap(&mut point.on_first, &mut point.on_second);
        point.parts.reverse();
    }
    Points::one(point)
}

/// How far below a point a sphere extends, along a direction. The way from the point to its centre
/// has this length, or is the opposite of a way of that length, at an angle with this cosine.
// Not inlined on s390x: see `Body::rough`.
#[cfg_attr(target_arch = "s390x", inline(never))]
fn depth_over(distance: f64, radius: f64, cosine: f64) -> f64 {
    let height = distance * cosine;
    // Negative by rounding alone.
    let across = distance * distance * ((1.0 - cosine) * (1.0 + cosine));
    let square = radius * radius - across;
    let half_chord = if square > f64::MIN_POSITIVE { root(square) } else { 0.0 };
    greatest(half_chord - height, 0.0)
}
