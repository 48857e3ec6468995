//! Sets of cases for a sphere and another shape, mostly near contact.

use super::{Other, Point, SphereCase};
use crate::BoxNumbers;
use crate::rng::Rng;
use crate::sample::Sample;

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
            return touch(rng);
        }
        let [center, a, b, c, [radius, more, _]] = self.points::<S>(rng);
        let size = |x: S| if x < S::ZERO { S::ZERO.moved(x.ordinal().saturating_neg()) } else { x };
        let other = match rng.below(10) {
            0..=4 => Other::Triangle([a, if rng.one_in(24) { a } else { b }, {
                if rng.one_in(24) { b } else { c }
            }]),
            5 => Other::Ends([a, b]),
            6 => Other::Center(a, b),
            7 if rng.one_in(2) => Other::Box(BoxNumbers::Center(a, b.map(size))),
            7 => {
                let order = |i: usize| if a[i] < b[i] { (a[i], b[i]) } else { (b[i], a[i]) };
                let [min, max] = [[0, 1, 2].map(|i| order(i).0), [0, 1, 2].map(|i| order(i).1)];
                Other::Box(BoxNumbers::Corners(min, max))
            }
            8 => Other::Point(a),
            _ => Other::Sphere(a, size(more)),
        };
        let mut case = SphereCase { center, radius: size(radius), other };
        if rng.one_in(2) {
            let distance = case.squared().root();
            let more = if let Other::Sphere(_, r) = other { r.approximate() } else { 0.0 };
            let near = S::nearest((distance - more).max(0.0)).moved(rng.whole(-1, 1));
            case.radius = if near < S::ZERO { S::ZERO } else { near };
        }
        case
    }

    fn points<S: Sample>(self, rng: &mut Rng) -> [Point<S>; 5] {
        let mut every = |one: fn(&mut Rng) -> S| [(); 5].map(|()| rng.triple(one));
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
                    [0, 1, 2].map(|i: usize| S::nearest(o[i] + t * d[i]).moved(rng.whole(-1, 1)))
                };
                let vertices = [near(), near(), near()];
                let [a, b, c] = vertices;
                let anywhere = [(); 2].map(|()| rng.triple(|rng| S::nearest(rng.real(-1.0, 1.0))));
                [anywhere[0], a, b, c, anywhere[1]]
            }
            Self::Far => {
                let most = S::GREATEST.approximate().min(1e6);
                let origin = rng.triple(|rng| rng.real(-0.9, 0.9) * most);
                let mut near = || {
                    let offset = rng.triple(|rng| rng.real(-1.0, 1.0));
                    [0, 1, 2].map(|i: usize| S::nearest(origin[i] + offset[i]))
                };
                let [a, b, c, d] = [near(), near(), near(), near()];
                [a, b, c, d, rng.triple(|rng| S::nearest(rng.real(0.0, 1.0)))]
            }
        }
    }
}

type Whole = [i64; 3];

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

/// A sphere that touches a vertex, an edge or the face of a triangle, or another shape there.
fn touch<S: Sample>(rng: &mut Rng) -> SphereCase<S> {
    loop {
        let bits = rng.whole(0, i64::from(S::WHOLE_BITS.min(40) / 4 - 1)) as u32;
        if let Some(case) = touch_within(rng, 1 << bits) {
            return case;
        }
    }
}

/// The same with numbers up to about `most`³, if the type has them.
fn touch_within<S: Sample>(rng: &mut Rng, most: i64) -> Option<SphereCase<S>> {
    let turn = 1 + rng.whole(0, 3).min(most);
    let ([u, v, w], n) = frame(rng, turn);
    let o = rng.triple(|rng| rng.whole(-most, most));
    let at = |[a, b, c]: Whole| [0, 1, 2].map(|i: usize| o[i] + a * u[i] + b * v[i] + c * w[i]);
    let mut quadruple = QUADRUPLES[rng.below(8)];
    quadruple[..3].rotate_left(rng.below(3));
    let scale = rng.whole(1, most.min(9));
    let [a, b, c, d] = quadruple.map(|x| x * scale);
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
    let mut rows = [at(to), at(vertices[0]), at(vertices[1]), at(vertices[2]), [radius; 3]];
    rows[1..4].rotate_left(rng.below(3));
    let most = 1_i64 << (S::WHOLE_BITS - 1);
    if rows.iter().flatten().any(|x| x.abs() >= most) {
        return None;
    }
    let mut rows = rows.map(|row| row.map(S::whole));
    if rng.one_in(2) {
        let x = &mut rows[rng.below(5)][rng.below(3)];
        *x = x.moved(rng.whole(-1, 1));
    }
    let [center, p, q, r, [radius, ..]] = rows;
    let other = match rng.below(8) {
        0 => Other::Ends([p, q]),
        1 => Other::Point(p),
        _ => Other::Triangle([p, q, r]),
    };
    (radius >= S::ZERO).then_some(SphereCase { center, radius, other })
}
