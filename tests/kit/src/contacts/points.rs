//! The points of a contact against the shapes in integers: whether they lie on the parts named, how
//! far the two of each point are from each other, and whether they span what touches.

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use septum::contact::{Contact, Part};

use super::hull::{Hull, Point};
use super::plane::{intersection, off_hull};
use super::{ContactCase, holds_zero};
use crate::exact::{least_exponent, whole};
use crate::sample::Sample;
use crate::{Each, lattice::Ring, three};

/// How far a point may be off its part, in parts of the size of both shapes, beside one unit in the
/// last place.
const OFF_PART: f64 = 1.0 / (1_u64 << 47) as f64;
/// The same between the two places of a point, and between what touches and the points.
const OFF_PAIR: f64 = 1.0 / (1_u64 << 42) as f64;

/// The greatest errors seen, each in parts of what is allowed.
#[derive(Clone, Copy, Debug, Default)]
pub struct PointErrors {
    /// From a point to the part named.
    pub part: f64,
    /// From one place of a point to the other, less the depth along the normal.
    pub pair: f64,
    /// From what touches to the hull of the points.
    pub span: f64,
}

impl PointErrors {
    /// The greater of each.
    pub fn or(self, other: Self) -> Self {
        let [part, pair, span] =
            [(self.part, other.part), (self.pair, other.pair), (self.span, other.span)]
                .each(|(a, b)| a.max(b));
        Self { part, pair, span }
    }
}

impl Hull {
    /// The vertices of a part, in turn.
    fn part(&self, part: Part) -> Option<Vec<&Point>> {
        let of = |list: &[usize]| list.iter().map(|&k| self.points.get(k)).collect();
        let bit = |i: usize, is_upper: bool| usize::from(is_upper) << (i % 3);
        match (part, self.is_triangle) {
            (Part::Vertex(k), _) => of(&[k.into()]),
            (Part::Edge(k), true) => of(&[k.into(), (usize::from(k) + 1) % 3]),
            (Part::Face(k), true) => {
                if k == 0 {
                    of(&[0, 1, 2])
                } else {
                    None
                }
            }
            (Part::Edge(k), false) => {
                let i = usize::from(k / 4);
                let base = bit(i + 1, k & 1 != 0) | bit(i + 2, k & 2 != 0);
                of(&[base, base | bit(i, true)])
            }
            (Part::Face(k), false) => {
                let i = usize::from(k / 2);
                let (base, j, l) = (bit(i, k & 1 != 0), bit(i + 1, true), bit(i + 2, true));
                of(&[base, base | j, base | j | l, base | l])
            }
        }
    }

    /// The vertices that lie farthest along a direction, in turn where they are a face.
    fn support(&self, a: &Point) -> Vec<&Point> {
        let [_, end] = self.ends(a);
        let order = if self.is_triangle { &[0, 1, 2][..] } else { &[0, 1, 3, 2, 6, 7, 5, 4][..] };
        let all = order.iter().map(|&k| &self.points[k]);
        all.filter(|p| IBig::dot(p, a) == end).collect()
    }

    /// The side along edge k.
    pub(super) fn side(&self, k: u8) -> &Point {
        &self.sides[usize::from(if self.is_triangle { k } else { k / 4 })]
    }
}

/// A vector of numbers in `unit`, and the directions and sizes that tolerances are made of.
struct Scale {
    shift: usize,
    size: f64,
    unit: i32,
}

impl Scale {
    /// In parts of the size of the shapes.
    fn part(&self, x: &IBig) -> f64 {
        (x >> self.shift).to_f64().value() / self.size
    }

    fn vector(&self, v: &Point) -> [f64; 3] {
        v.each_ref().each(|x| self.part(x))
    }

    /// One unit in the last place.
    fn unit_of<S: Sample>(&self, x: S) -> f64 {
        let exponent = x.mantissa_exponent().1 - (2 * self.unit - 1) - self.shift as i32;
        2_f64.powi(exponent) / self.size
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The greatest extent of both along an axis.
fn extent(hulls: &[Hull; 2]) -> IBig {
    let corners = || hulls.iter().flat_map(|h| &h.points);
    let extent = |i: usize| {
        let along = || corners().map(|p| &p[i]);
        along().max().expect("corners") - along().min().expect("corners")
    };
    (0..3).map(extent).max().expect("three")
}

/// A number is as far off as the greatest part of a tolerance that a coordinate takes.
fn ratio(off: [f64; 3], allowed: [f64; 3]) -> f64 {
    (0..3).map(|i| off[i].abs() / allowed[i]).fold(0.0, f64::max)
}

impl<S: Sample> ContactCase<S> {
    /// Checks the points of a contact. Returns nothing if a number lies at the end of the range,
    /// where it may be cut off.
    ///
    /// # Errors
    /// What is wrong.
    pub fn check_points(&self, found: &Contact<S>) -> Option<Result<PointErrors, &'static str>> {
        let points = found.points();
        let t = found.translation;
        let mut places = Vec::new();
        for p in points {
            places.extend([p.on_first, p.on_second].each(|p| p.to_array()).as_flattened());
        }
        let on_parts = places.len();
        places.extend(points.iter().map(|p| p.depth));
        places.extend(t.vector.to_array());
        if !places.iter().all(|x| *x > S::LEAST && *x < S::GREATEST) {
            return None;
        }
        let mut numbers = [self.first.numbers(), self.second.numbers()].concat();
        numbers.extend(places.iter().map(|x| x.mantissa_exponent()));
        let unit = least_exponent(&numbers).min(0);
        let hulls = [self.first.hull(unit), self.second.hull(unit)];
        let size = extent(&hulls);
        let shift = size.bit_len().saturating_sub(900);
        let scale = Scale { shift, size: (&size >> shift).to_f64().value(), unit };
        let length = |x: S| whole(x.mantissa_exponent(), unit) << (1 - unit) as usize;

        let a = self.direction(t.features, &hulls);
        let vector = t.vector.to_array().each(length);
        let a = if IBig::dot(&a, &vector) < IBig::ZERO { a.each(|x| -x) } else { a };
        let long = a.iter().map(BitTest::bit_len).max().unwrap_or(0).saturating_sub(200);
        let n = a.each_ref().each(|x| (x >> long).to_f64().value());
        let n = n.each(|x| x / dot(n, n).sqrt());

        if points.is_empty() || points.len() > 8 {
            return Some(Err("number of points"));
        }
        let mut errors = PointErrors::default();
        for point in points {
            let both = [point.on_first, point.on_second].each(|p| p.to_array());
            let exact = both.each(|p| p.each(length));
            let units = both.each(|p| p.each(|x| scale.unit_of(x)));
            for k in 0..2 {
                let allowed = units[k].each(|unit| OFF_PART + unit);
                let Some(part) = hulls[k].part(point.parts[k]) else {
                    return Some(Err("no such part"));
                };
                let off = off_part(&scale, &part, &exact[k], allowed);
                if off > 1.0
                    && !is_on_part(&part, &exact[k], allowed.each(|x| x * scale.size), shift)
                {
                    return Some(Err("off its part"));
                }
                errors.part = errors.part.max(off.min(1.0));
            }
            if point.depth < S::ZERO {
                return Some(Err("depth below zero"));
            }
            let between = scale.vector(&IBig::difference(&exact[1], &exact[0]));
            let depth = scale.part(&length(point.depth));
            let unit = scale.unit_of(point.depth);
            let allowed = three(|i: usize| OFF_PAIR + units[0][i] + units[1][i] + unit);
            errors.pair = errors.pair.max(ratio(minus(between, n.each(|x| x * depth)), allowed));
        }
        if errors.pair > 1.0 {
            return Some(Err("not apart by the depth along the normal"));
        }

        // What touches, seen along the normal from the first point.
        let origin = points[0].on_first.to_array().each(length);
        let relative = |p: &Point| scale.vector(&IBig::difference(p, &origin));
        let least = (0..3).min_by(|&i, &j| n[i].abs().total_cmp(&n[j].abs())).expect("three");
        let mut e = [0.0; 3];
        e[least] = 1.0;
        let u = minus(e, n.each(|x| x * n[least]));
        let u = u.each(|x| x / dot(u, u).sqrt());
        let v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]];
        let flat = |p: [f64; 3]| [dot(p, u), dot(p, v)];
        let all_units: f64 = places[..on_parts]
            .iter()
            .map(|&x| scale.unit_of(x))
            .fold(scale.unit_of(t.depth), f64::max);
        let allowed = OFF_PAIR + 4.0 * all_units;
        let depths = || points.iter().map(|p| scale.part(&length(p.depth)));
        let deepest = depths().fold(0.0, f64::max);
        if found.is_held {
            return Some(Ok(errors));
        }
        if t.depth < S::GREATEST {
            let off = (scale.part(&length(t.depth)) - deepest).abs() / allowed;
            if off > 1.0 {
                return Some(Err("not as deep as the translation"));
            }
            errors.span = errors.span.max(off);
        }
        let back = a.each_ref().each(|x| -x);
        let supports = [hulls[0].support(&back), hulls[1].support(&a)]
            .each(|s| s.into_iter().map(|p| flat(relative(p))).collect::<Vec<_>>());
        let deep: Vec<[f64; 2]> = points
            .iter()
            .zip(depths())
            .filter(|(_, depth)| *depth >= deepest - 2.0 * allowed)
            .map(|(p, _)| flat(relative(&p.on_first.to_array().each(length))))
            .collect();
        let [first, second] = &supports;
        for touch in intersection(first, second, allowed) {
            errors.span = errors.span.max(off_hull(&deep, touch) / allowed);
        }
        Some(if errors.span > 1.0 { Err("does not span what touches") } else { Ok(errors) })
    }
}

/// How far a point is off a part at most, in parts of what is allowed: by the nearest point of it in
/// floats.
fn off_part(scale: &Scale, part: &[&Point], at: &Point, allowed: [f64; 3]) -> f64 {
    let scaled = |v: &Point| {
        let from = scale.vector(&IBig::difference(v, at));
        three(|i: usize| from[i] / allowed[i])
    };
    let at = part.iter().map(|v| scaled(v)).collect::<Vec<_>>();
    let ratio = |off: [f64; 3]| off.iter().fold(0.0, |most, x| x.abs().max(most));
    let mut off = at.iter().map(|&v| ratio(v)).fold(f64::INFINITY, f64::min);
    for k in 0..at.len() {
        let (p, q) = (at[k], at[(k + 1) % at.len()]);
        let e = minus(q, p);
        let t = (-dot(p, e) / dot(e, e)).clamp(0.0, 1.0);
        if t.is_finite() {
            off = off.min(ratio(three(|i: usize| p[i] + t * e[i])));
        }
    }
    if at.len() > 2 {
        let (p, e, f) = (at[0], minus(at[1], at[0]), minus(at[at.len() - 1], at[0]));
        // Across e, so that little is lost where the two are nearly parallel.
        let along = dot(e, f) / dot(e, e);
        let g = three(|i: usize| f[i] - along * e[i]);
        let t = -dot(p, g) / dot(g, g);
        let p2 = three(|i: usize| p[i] + t * f[i]);
        let s = -dot(p2, e) / dot(e, e);
        let is_within =
            s >= 0.0 && t >= 0.0 && if at.len() == 3 { s + t <= 1.0 } else { s <= 1.0 && t <= 1.0 };
        if is_within {
            off = off.min(ratio(three(|i: usize| p2[i] + s * e[i])));
        }
    }
    off
}

/// The same, yes or no, by linear programming: whether a box around the point and the part have a
/// point in common.
fn is_on_part(part: &[&Point], at: &Point, allowed: [f64; 3], shift: usize) -> bool {
    let half = allowed.each(|x| {
        let x = x * 2_f64.powi(60);
        (IBig::try_from(x.ceil().min(1e300)).unwrap_or(IBig::ZERO) << shift) >> 60
    });
    let mut differences = Vec::new();
    for v in part {
        let from = IBig::difference(v, at);
        for k in 0..8 {
            differences.push(three(|i: usize| {
                if k >> i & 1 == 1 { &from[i] + &half[i] } else { &from[i] - &half[i] }
            }));
        }
    }
    holds_zero(&differences)
}
