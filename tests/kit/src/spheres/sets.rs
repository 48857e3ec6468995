//! Sets of cases for a sphere and another shape, mostly near contact.

use super::{CapsuleCase, Other, Point, SphereCase, oriented};
use crate::rng::Rng;
use crate::sample::Sample;
use crate::{BoxNumbers, Each, Given, three};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereSet {
    /// Anywhere.
    Random,
    /// Integers from −4 to 4.
    Grid,
    /// Triangles whose vertices nearly lie on a line.
    Slivers,
    /// Far from the origin.
    Far,
    /// Tiny.
    Small,
    /// Any bits.
    Bits,
    /// At the ends of the type.
    Huge,
    /// Touching by Pythagorean triples and quadruples in a turned frame, or off by one unit in the
    /// last place.
    Touch,
}

/// a² + b² + c² = d².
const QUADRUPLES: [[i64; 4]; 8] = [
    [1, 2, 2, 3],
    [2, 3, 6, 7],
    [4, 4, 7, 9],
    [1, 4, 8, 9],
    [2, 6, 9, 11],
    [3, 4, 12, 13],
    [0, 3, 4, 5],
    [0, 0, 1, 1],
];

impl SphereSet {
    pub const ALL: [Self; 8] = [
        Self::Random,
        Self::Grid,
        Self::Slivers,
        Self::Far,
        Self::Small,
        Self::Bits,
        Self::Huge,
        Self::Touch,
    ];

    /// A case of this set. In half of them the radius is the distance, rounded, or a number next to
    /// that.
    pub fn case<S: Sample>(self, rng: &mut Rng) -> SphereCase<S> {
        if self == Self::Touch {
            let ([center, _], radius, other) = touch(rng, false);
            return SphereCase { center, radius, other };
        }
        let [center, a, b, c, d, [radius, more, _]] = self.points::<S>(rng);
        let other = match rng.below(13) {
            12 => oriented::any(rng, a, [b, c, d], [radius, more, d[0]].each(size)),
            10 if a != [S::ZERO; 3] => plane(rng, a, b),
            11 if a != [S::ZERO; 3] => ray(rng, [d, a], b),
            k => any(rng, k.min(9), [a, b, c, d], size(more)),
        };
        let mut case = SphereCase { center, radius: size(radius), other };
        if rng.one_in(2) {
            case.radius = near_to(rng, case.squared().root(), other);
        }
        case
    }

    /// A case of this set with a capsule, likewise.
    pub fn capsule<S: Sample>(self, rng: &mut Rng) -> CapsuleCase<S> {
        if self == Self::Touch {
            let (ends, radius, other) = touch(rng, true);
            return CapsuleCase { ends, radius, other };
        }
        let [a, b, c, d, e, [radius, more, _]] = self.points::<S>(rng);
        let last = if rng.one_in(2) { a } else { b };
        let other = match rng.below(13) {
            // Few, because their oracle is slow.
            12 if rng.one_in(4) => {
                oriented::any(rng, c, [b, d, e], [radius, more, a[1]].each(size))
            }
            10 if c != [S::ZERO; 3] => plane(rng, c, d),
            11 if c != [S::ZERO; 3] => ray(rng, [d, c], e),
            k => any(rng, k.min(9), [c, d, e, last], size(more)),
        };
        let ends = [a, if rng.one_in(16) { a } else { b }];
        let mut case = CapsuleCase { ends, radius: size(radius), other };
        if rng.one_in(2) {
            case.radius = near_to(rng, case.squared().root(), other);
        }
        case
    }

    fn points<S: Sample>(self, rng: &mut Rng) -> [Point<S>; 6] {
        let mut every = |one: fn(&mut Rng) -> S| [(); 6].map(|()| rng.triple(one));
        match self {
            Self::Random => every(|rng| S::nearest(rng.real(-1.0, 1.0))),
            Self::Grid | Self::Touch => every(|rng| S::nearest(rng.whole(-4, 4) as f64)),
            Self::Small if S::nearest(1.0 / 16384.0) == S::ZERO => {
                every(|rng| S::ZERO.moved(rng.whole(-9, 9)))
            }
            Self::Small => every(|rng| S::nearest(rng.real(-1.0, 1.0) / 16384.0)),
            Self::Bits => every(|rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64))),
            Self::Huge => every(|rng| {
                let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
                end.moved(rng.whole(-2, 2))
            }),
            Self::Slivers => {
                let o = rng.triple(|rng| rng.real(-0.5, 0.5));
                let d = rng.triple(|rng| rng.real(-0.5, 0.5));
                let mut near = || {
                    let t = rng.real(-1.0, 1.0);
                    three(|i: usize| S::nearest(o[i] + t * d[i]).moved(rng.whole(-1, 1)))
                };
                let [a, b, c, d] = [near(), near(), near(), near()];
                let anywhere = [(); 2].each(|()| rng.triple(|rng| S::nearest(rng.real(-1.0, 1.0))));
                [anywhere[0], a, b, c, d, anywhere[1]]
            }
            Self::Far => {
                let most = S::GREATEST.approximate().min(1e6);
                let origin = rng.triple(|rng| rng.real(-0.9, 0.9) * most);
                let mut near = || {
                    let offset = rng.triple(|rng| rng.real(-1.0, 1.0));
                    three(|i: usize| S::nearest(origin[i] + offset[i]))
                };
                let [a, b, c, d, e] = [near(), near(), near(), near(), near()];
                [a, b, c, d, e, rng.triple(|rng| S::nearest(rng.real(0.0, 1.0)))]
            }
        }
    }
}

/// A number that is not negative.
fn size<S: Sample>(x: S) -> S {
    if x < S::ZERO { S::ZERO.moved(x.ordinal().saturating_neg()) } else { x }
}

/// A radius near to a distance, less that of the other shape itself.
fn near_to<S: Sample>(rng: &mut Rng, distance: f64, other: Other<S>) -> S {
    let more = other.radius().map_or(0.0, S::approximate);
    let near = S::nearest((distance - more).max(0.0)).moved(rng.whole(-1, 1));
    if near < S::ZERO { S::ZERO } else { near }
}

fn plane<S: Sample>(rng: &mut Rng, n: Point<S>, p: Point<S>) -> Other<S> {
    Other::Plane(n, if rng.one_in(2) { Given::Point(p) } else { Given::Offset(p[0]) })
}

/// A ray, half of the time from its origin without an end, with a range of any two of `ends` or a
/// tiny one.
fn ray<S: Sample>(rng: &mut Rng, numbers: [Point<S>; 2], ends: Point<S>) -> Other<S> {
    let [x, y, _] = if rng.one_in(2) { ends } else { [S::ZERO.moved(1), S::ZERO, S::ZERO] };
    let range = match rng.below(4) {
        0 | 1 => [Some(S::ZERO), None],
        2 => [Some(if x < y { x } else { y }), Some(if x < y { y } else { x })],
        _ => [[None, Some(x)], [Some(x), None], [None; 2]][rng.below(3)],
    };
    Other::Ray(numbers, range)
}

/// A shape of kind 0 to 9 from these points.
fn any<S: Sample>(rng: &mut Rng, kind: usize, [a, b, c, d]: [Point<S>; 4], more: S) -> Other<S> {
    match kind {
        0..=3 => Other::Triangle([a, if rng.one_in(24) { a } else { b }, {
            if rng.one_in(24) { b } else { c }
        }]),
        4 => Other::Capsule([a, d], more),
        5 => Other::Ends([a, b]),
        6 => Other::Center(a, b),
        7 if rng.one_in(2) => Other::Box(BoxNumbers::Center(a, b.each(size))),
        7 => {
            let order = |i: usize| if a[i] < b[i] { (a[i], b[i]) } else { (b[i], a[i]) };
            let [min, max] = [three(|i| order(i).0), three(|i| order(i).1)];
            Other::Box(BoxNumbers::Corners(min, max))
        }
        8 => Other::Point(a),
        _ => Other::Sphere(a, more),
    }
}

type Whole = [i64; 3];

/// Two ends, a radius, and a shape.
type Touching<S> = ([Point<S>; 2], S, Other<S>);

/// Three vectors of integers at right angles, each of the same length, and that length.
fn frame(rng: &mut Rng, most: i64) -> ([Whole; 3], i64) {
    let [x, y, z] = rng.triple(|rng| rng.whole(-most, most));
    let w = rng.whole(0, most);
    let n = w * w + x * x + y * y + z * z;
    if n == 0 {
        return ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1);
    }
    let axes = [
        [w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)],
        [2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)],
        [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z],
    ];
    (axes, n)
}

/// A sphere that touches a vertex, an edge or the face of a triangle, or another shape there; or a
/// capsule whose segment passes the sphere's centre and stays as far away.
fn touch<S: Sample>(rng: &mut Rng, is_capsule: bool) -> Touching<S> {
    loop {
        let bits = rng.whole(0, i64::from(S::WHOLE_BITS.min(40) / 4 - 1)) as u32;
        if let Some(case) = touch_within(rng, 1 << bits, is_capsule) {
            return case;
        }
    }
}

/// The same with numbers up to about `most`³, if the type has them.
fn touch_within<S: Sample>(rng: &mut Rng, most: i64, is_capsule: bool) -> Option<Touching<S>> {
    let turn = 1 + rng.whole(0, 3).min(most);
    let ([u, v, w], n) = frame(rng, turn);
    let o = rng.triple(|rng| rng.whole(-most, most));
    let at = |[a, b, c]: Whole| three(|i: usize| o[i] + a * u[i] + b * v[i] + c * w[i]);
    let mut quadruple = QUADRUPLES[rng.below(8)];
    quadruple[..3].rotate_left(rng.below(3));
    let scale = rng.whole(1, most.min(9));
    let [a, b, c, d] = quadruple.each(|x| x * scale);
    let mut some = || rng.whole(1, most);
    // The nearest point of the shape is the origin of the frame.
    let (to, reach, vertices) = match some() % 3 {
        0 => ([0, 0, some()], None, [[some(), -some(), 0], [-some(), -some(), 0], [0, some(), 0]]),
        1 => (
            [0, 3 * scale, 4 * scale],
            Some(5 * scale),
            [[some(), 0, 0], [-some(), 0, 0], [some(), -some(), 0]],
        ),
        _ => ([a, b, c], Some(d), [[0, 0, 0], [-some(), -some(), -some()], [-some(), -some(), 0]]),
    };
    let radius = n * reach.unwrap_or(to[2]);
    // At right angles to the way from the shape, in both directions, or one; or away from it too.
    let [x, y, z] = to;
    let across = [[0, z, -y], [z, 0, -x], [y, -x, 0], [z, z, -x - y]][rng.below(4)];
    let [back, forth, away] = match is_capsule {
        true => [rng.whole(0, most), rng.whole(-1, most), rng.whole(0, most) * rng.whole(0, 1)],
        false => [0; 3],
    };
    let along = |k: i64, away: i64| at(three(|i: usize| to[i] * (1 + away) + across[i] * k));
    let ends = [along(-back, 0), along(forth, away)];
    // A box behind the face, the edge or the vertex.
    let half = rng.triple(|rng| rng.whole(1, most));
    let center = at(three(|i: usize| if to[i] == 0 { 0 } else { -half[i] }));
    let mut rows =
        [ends[0], at(vertices[0]), at(vertices[1]), at(vertices[2]), [radius; 3], ends[1]];
    rows[1..4].rotate_left(rng.below(3));
    let most = 1_i64 << (S::WHOLE_BITS - 1);
    let fits = |rows: &[Whole]| rows.iter().flatten().all(|x| x.abs() < most);
    if !fits(&rows) {
        return None;
    }
    let direction = three(|i: usize| rows[2][i] - rows[1][i]);
    let mut rows = rows.map(|row| row.each(S::whole));
    if rng.one_in(2) {
        let x = &mut rows[rng.below(5)][rng.below(3)];
        *x = x.moved(rng.whole(-1, 1));
    }
    let [a, p, q, r, [radius, ..], b] = rows;
    let other = match rng.below(11) {
        9.. if fits(&[center, u, v, w, half]) => {
            let [center, u, v, w, half] = [center, u, v, w, half].map(|row| row.each(S::whole));
            Other::Obb(center, [u, v, w], half)
        }
        8 if direction != [0; 3] && fits(&[direction]) => {
            Other::Ray([p, direction.each(S::whole)], [Some(S::ZERO), None])
        }
        0 => Other::Ends([p, q]),
        1 => Other::Point(p),
        2 => Other::Capsule([p, q], S::ZERO),
        _ => Other::Triangle([p, q, r]),
    };
    (radius >= S::ZERO).then_some(([a, b], radius, other))
}
