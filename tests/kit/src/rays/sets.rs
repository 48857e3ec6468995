//! The sets of rays and triangles on which accuracy is measured, each from a seed.

use super::{RayCase, crossing};
use crate::{Each, Rng, Sample, three};

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RaySet {
    /// All in a cube of side 4; the ray aimed at the triangle or past it.
    Random,
    /// Aimed at a point of an edge or at a vertex, within rounding.
    Edges,
    /// Nearly in the plane of the triangle, down to an angle of one last place.
    Parallel,
    /// One vertex within three units in the last place of the line through the other two; the ray
    /// aims at that line.
    Slivers,
    /// As random or at edges, 10⁴ from the origin.
    Far,
    /// The same 10⁶ from it.
    Farther,
    /// On a grid: exactly through edges and vertices, exactly in the plane.
    Ties,
    /// At the ends of the scalar's range, the extremes themselves included.
    Huge,
    /// As random or at edges, times 2⁻¹⁴.
    Small,
    /// The range of t ends at the hit, or one number before or after it.
    Ranges,
    /// The crossing lies behind the origin, and t may be negative or not.
    Behind,
}

impl RaySet {
    /// All sets.
    pub const ALL: [Self; 11] = [
        Self::Random,
        Self::Edges,
        Self::Parallel,
        Self::Slivers,
        Self::Far,
        Self::Farther,
        Self::Ties,
        Self::Huge,
        Self::Small,
        Self::Ranges,
        Self::Behind,
    ];

    /// The name of the set.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Edges => "edges",
            Self::Parallel => "parallel",
            Self::Slivers => "slivers",
            Self::Far => "far 10⁴",
            Self::Farther => "far 10⁶",
            Self::Ties => "ties",
            Self::Huge => "huge",
            Self::Small => "small",
            Self::Ranges => "ranges",
            Self::Behind => "behind",
        }
    }

    /// Why the scalar cannot hold this set, if it cannot.
    pub fn misfit<S: Sample>(self) -> Option<&'static str> {
        let ends_before = |x: f64| S::nearest(x).approximate() != x;
        match self {
            Self::Far if ends_before(2e4) => Some("ends before 10⁴"),
            Self::Farther if ends_before(2e6) => Some("ends before 10⁶"),
            Self::Small if S::nearest(SMALL) == S::ZERO => Some("rounds 2⁻¹⁴ to zero"),
            _ => None,
        }
    }

    /// `count` cases, the same for the same seed; none if the scalar has too small a range.
    pub fn cases<S: Sample>(self, seed: u64, count: usize) -> Vec<RayCase<S>> {
        if self.misfit::<S>().is_some() {
            return Vec::new();
        }
        let rng = &mut Rng::new(seed ^ (self as u64 + 64) << 56);
        let mut cases = Vec::with_capacity(count);
        while cases.len() < count {
            let case: RayCase<S> = match self {
                Self::Random => random(rng, [0.0; 3], 1.0),
                Self::Edges => at_edge(rng, [0.0; 3], 1.0),
                Self::Parallel => parallel(rng),
                Self::Slivers => sliver(rng),
                Self::Far => elsewhere(rng, 1e4, 1.0),
                Self::Farther => elsewhere(rng, 1e6, 1.0),
                Self::Ties => tie(rng),
                Self::Huge => huge(rng),
                Self::Small => elsewhere(rng, 0.0, SMALL),
                Self::Ranges => range(rng),
                Self::Behind => behind(rng),
            };
            if case.is_valid() {
                cases.push(case);
            }
        }
        cases
    }
}

const SMALL: f64 = 1.0 / 16384.0;

type Point = [f64; 3];

fn nearest<S: Sample>(v: Point) -> [S; 3] {
    v.each(S::nearest)
}

fn approximate<S: Sample>(v: [S; 3]) -> Point {
    v.each(S::approximate)
}

fn along(from: Point, to: Point, part: f64) -> Point {
    three(|i| from[i] + part * (to[i] - from[i]))
}

fn near(rng: &mut Rng, center: Point, radius: f64) -> Point {
    let offset = rng.triple(|rng| rng.real(-radius, radius));
    three(|i| center[i] + offset[i])
}

/// A ray from the origin toward the target, with t = `1 / length` there.
fn aimed<S: Sample>(
    origin: Point,
    target: Point,
    length: f64,
    vertices: [[S; 3]; 3],
) -> RayCase<S> {
    let origin: [S; 3] = nearest(origin);
    let from = approximate(origin);
    let direction = three(|i| S::nearest((target[i] - from[i]) * length));
    RayCase::new(origin, direction, vertices)
}

fn triangle<S: Sample>(rng: &mut Rng, center: Point, scale: f64) -> [[S; 3]; 3] {
    [(); 3].each(|()| nearest(near(rng, center, 2.0 * scale)))
}

/// A point of the triangle's plane, in about half of the cases inside the triangle.
fn on_plane<S: Sample>(rng: &mut Rng, vertices: &[[S; 3]; 3]) -> Point {
    let [a, b, c] = vertices.each(approximate);
    let (u, v) = (rng.real(-0.2, 1.0), rng.real(-0.2, 1.0));
    three(|i| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]))
}

/// Approximately a point of an edge, or a vertex.
fn on_edge<S: Sample>(rng: &mut Rng, vertices: &[[S; 3]; 3]) -> Point {
    let k = rng.below(3);
    let part = if rng.one_in(4) { 0.0 } else { rng.real(0.0, 1.0) };
    along(approximate(vertices[k]), approximate(vertices[(k + 1) % 3]), part)
}

fn random<S: Sample>(rng: &mut Rng, center: Point, scale: f64) -> RayCase<S> {
    let vertices = triangle(rng, center, scale);
    let (origin, target) = (near(rng, center, 2.0 * scale), on_plane(rng, &vertices));
    aimed(origin, target, rng.real(0.25, 1.5), vertices)
}

fn at_edge<S: Sample>(rng: &mut Rng, center: Point, scale: f64) -> RayCase<S> {
    let vertices = triangle(rng, center, scale);
    let (origin, target) = (near(rng, center, 2.0 * scale), on_edge(rng, &vertices));
    aimed(origin, target, rng.real(0.25, 1.5), vertices)
}

/// A case of either set, at another place and scale.
fn elsewhere<S: Sample>(rng: &mut Rng, distance: f64, scale: f64) -> RayCase<S> {
    let center = rng.triple(|rng| {
        let far = distance * rng.real(1.0, 1.5);
        if rng.one_in(2) { -far } else { far }
    });
    if rng.one_in(2) { random(rng, center, scale) } else { at_edge(rng, center, scale) }
}

fn parallel<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let vertices: [[S; 3]; 3] = triangle(rng, [0.0; 3], 1.0);
    let [a, b, c] = vertices.each(approximate);
    let (e, f): (Point, Point) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
    let normal = [(1, 2), (2, 0), (0, 1)].each(|(j, k)| e[j] * f[k] - e[k] * f[j]);
    let area = normal.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);

    let last_place = S::nearest(1.0).moved(1).approximate() - 1.0;
    let angle = 10_f64.powf(rng.real(last_place.log10(), -1.0));
    let (p, q) = (rng.real(-1.0, 1.0), rng.real(-1.0, 1.0));
    let up = if rng.one_in(2) { angle } else { -angle } / area;
    let direction = three(|i| p * e[i] + q * f[i] + up * normal[i]);
    let target = if rng.one_in(2) { on_edge(rng, &vertices) } else { on_plane(rng, &vertices) };
    let back = rng.real(0.0, 1.0);
    let origin = three(|i| target[i] - back * direction[i]);
    RayCase::new(nearest(origin), nearest(direction), vertices)
}

fn sliver<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let (a, b) = (near(rng, [0.0; 3], 2.0), near(rng, [0.0; 3], 2.0));
    let (c, target) = (along(a, b, rng.real(-0.5, 1.5)), along(a, b, rng.real(-0.2, 1.2)));
    let width = rng.whole(0, 3);
    let c = c.each(|x| S::nearest(x).moved(rng.whole(-width, width)));
    let mut vertices = [nearest(a), nearest(b), c];
    vertices.rotate_left(rng.below(3));
    let mut case = aimed(near(rng, [0.0; 3], 2.0), target, 1.0, vertices);
    case.direction = case.direction.each(|x| x.moved(rng.whole(-2, 2)));
    case
}

/// Vertices and origin in halves, targets in eighths.
fn tie<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let halves = |rng: &mut Rng| rng.triple(|rng| rng.whole(-4, 4) as f64 / 2.0);
    let points = [halves(rng), halves(rng), halves(rng)];
    let (vertices, origin) = (points.each(nearest), halves(rng));
    let mut case = match rng.below(4) {
        0 => {
            let direction = nearest(halves(rng));
            RayCase::new(nearest(origin), direction, vertices)
        }
        // From the plane of the triangle, or from the triangle itself.
        1 => {
            let k = rng.below(3);
            let origin = along(points[k], points[(k + 1) % 3], rng.whole(-1, 3) as f64 / 2.0);
            RayCase::new(nearest(origin), nearest(halves(rng)), vertices)
        }
        _ => {
            let k = rng.below(3);
            let target = along(points[k], points[(k + 1) % 3], rng.whole(0, 4) as f64 / 4.0);
            aimed(origin, target, 1.0, vertices)
        }
    };
    if rng.one_in(4) {
        case = case.line();
    }
    case
}

fn huge<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let number = |rng: &mut Rng| {
        let (end, inward) = if rng.one_in(2) { (S::GREATEST, -1) } else { (S::LEAST, 1) };
        match rng.below(8) {
            0 => end,
            1 => S::ZERO,
            2 => end.moved(inward * rng.whole(0, 2)),
            _ => S::nearest(end.approximate() * rng.real(0.0, 1.0)),
        }
    };
    let point = |rng: &mut Rng| [number(rng), number(rng), number(rng)];
    let vertices = [point(rng), point(rng), point(rng)];
    let (origin, mut direction) = (point(rng), point(rng));
    if !rng.one_in(3) {
        let [a, b, c] = vertices.each(approximate);
        let (u, v) = (rng.real(0.0, 0.55), rng.real(0.0, 0.55));
        // Half the distance, because the whole may exceed the scalar's range.
        let half = |i: usize| ((1.0 - u - v) * a[i] + u * b[i] + v * c[i]) / 2.0;
        direction = three(|i| S::nearest(half(i) - origin[i].approximate() / 2.0));
    }
    RayCase::new(origin, direction, vertices)
}

fn range<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let case = if rng.one_in(2) { exactly_at(rng) } else { random(rng, [0.0; 3], 1.0) };
    let Some(truth) = crossing(&case.line()) else { return case };
    let t = S::nearest(truth.t.approximate()).moved(rng.whole(-1, 1));
    match rng.below(4) {
        0 => RayCase { t_min: Some(t), ..case },
        1 => RayCase { t_min: Some(t), t_max: Some(t), ..case },
        2 => RayCase { t_max: Some(t), ..case },
        _ => RayCase { t_min: None, t_max: Some(t), ..case },
    }
}

/// A crossing at an integer t, in the middle of the triangle.
fn exactly_at<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let bits = S::WHOLE_BITS.min(30);
    let most = 1 << (bits - 4);
    let t = rng.whole(-3, 3);
    let whole = |rng: &mut Rng, most: i64| rng.triple(|rng| rng.whole(-most, most));
    let (target, e, f) = (whole(rng, most), whole(rng, most), whole(rng, most));
    let step = whole(rng, most / 2);
    let at = |offset: [i64; 3]| three(|i| S::whole(target[i] + offset[i]));
    let opposite = three(|i| -e[i] - f[i]);
    let origin = step.each(|x| -t * x);
    RayCase::new(at(origin), step.each(S::whole), [at(e), at(f), at(opposite)])
}

fn behind<S: Sample>(rng: &mut Rng) -> RayCase<S> {
    let case: RayCase<S> =
        if rng.one_in(2) { random(rng, [0.0; 3], 1.0) } else { at_edge(rng, [0.0; 3], 1.0) };
    let reversed = case.direction.each(|x| S::from_ordinal(x.ordinal().saturating_neg()));
    let case = RayCase { direction: reversed, ..case };
    match rng.below(4) {
        0 => case,
        1 => RayCase { t_min: Some(S::nearest(rng.real(-3.0, 0.0))), ..case },
        2 => RayCase { t_max: Some(S::nearest(rng.real(-3.0, 0.0))), ..case.line() },
        _ => case.line(),
    }
}
