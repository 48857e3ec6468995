//! Sets of lines and boxes, from a seed.

use septum::Ray;

use super::{Line, LineBox};
use crate::{BoxNumbers, Each, Rng, Sample, three};

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineSet {
    Random,
    /// Integers from −3 to 3: contact, zeros and flat boxes are frequent.
    Grid,
    /// Through a point of a face, an edge or a corner, in integers; then one number is moved by one
    /// unit in the last place, or not.
    Grazing,
    /// As random, 10⁴ to 10⁶ from the origin.
    Far,
    Small,
    /// At the ends of the scalar's range.
    Huge,
    /// Every magnitude, distributed evenly by bits.
    Bits,
    /// One or two components of the direction are zero or nearly zero.
    Axial,
}

impl LineSet {
    pub const ALL: [Self; 8] = [
        Self::Random,
        Self::Grid,
        Self::Grazing,
        Self::Far,
        Self::Small,
        Self::Huge,
        Self::Bits,
        Self::Axial,
    ];

    /// One case.
    pub fn case<S: Sample>(self, rng: &mut Rng) -> LineBox<S> {
        let size = (S::GREATEST.approximate() / 4.0).min(4.0);
        let far = (S::GREATEST.approximate() / 2.0).min(1e6);
        loop {
            let found = match self {
                Self::Random => made(rng, &|rng| S::nearest(rng.real(-size, size))),
                Self::Grid => made(rng, &|rng| S::nearest(rng.whole(-3, 3) as f64)),
                Self::Grazing => grazing(rng),
                Self::Far => {
                    let at = rng.real(far / 100.0, far);
                    let case = made(rng, &|rng| S::nearest(rng.real(-size, size)));
                    case.map(|case| shifted(case, at))
                }
                Self::Small => made(rng, &|rng| S::nearest(rng.real(-size, size) / 16384.0)),
                Self::Huge => made(rng, &|rng| {
                    let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
                    if rng.one_in(3) {
                        return S::nearest(S::GREATEST.approximate() * rng.real(-1.0, 1.0));
                    }
                    end.moved(rng.whole(-2, 2))
                }),
                Self::Bits => made(rng, &|rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64))),
                Self::Axial => {
                    let case = made(rng, &|rng| S::nearest(rng.real(-size, size)));
                    case.map(|case| axial(case, rng))
                }
            };
            if let Some(found) = found.filter(is_ray_or_segment) {
                return found;
            }
        }
    }
}

fn is_ray_or_segment<S: Sample>(case: &LineBox<S>) -> bool {
    match case.line {
        Line::Ray(o, d, [from, to]) => Ray::new(o, d).is_ok_and(|r| r.with_range(from, to).is_ok()),
        _ => true,
    }
}

/// A line and a box of numbers from `pick`; `None` if they are invalid.
fn made<S: Sample>(rng: &mut Rng, pick: &dyn Fn(&mut Rng) -> S) -> Option<LineBox<S>> {
    let row = |rng: &mut Rng| rng.triple(pick);
    let (a, b, p, q, t) = (row(rng), row(rng), row(rng), row(rng), row(rng));
    let ordered = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
    let aabb = if rng.one_in(2) {
        let half = q.each(|x| if x < S::ZERO { S::from_ordinal(-x.moved(1).ordinal()) } else { x });
        BoxNumbers::Center(p, half)
    } else {
        BoxNumbers::Corners(three(|i| ordered(i).0), three(|i| ordered(i).1))
    };
    let line = match rng.below(4) {
        0 => Line::Ends(a, b),
        1 => Line::Center(a, b),
        _ => Line::Ray(a, b, some_range(rng, t)),
    };
    Some(LineBox { line, aabb })
}

fn some_range<S: Sample>(rng: &mut Rng, t: [S; 3]) -> [Option<S>; 2] {
    let (low, high) = if t[0] < t[1] { (t[0], t[1]) } else { (t[1], t[0]) };
    match rng.below(8) {
        0 => [None, None],
        1 => [None, Some(t[0])],
        2 => [Some(t[0]), None],
        3 => [Some(low), Some(high)],
        4 => [Some(S::ZERO), Some(if t[0] < S::ZERO { S::ZERO } else { t[0] })],
        _ => [Some(S::ZERO), None],
    }
}

fn shifted<S: Sample>(mut case: LineBox<S>, at: f64) -> LineBox<S> {
    let shift = |v: &mut [S; 3]| *v = v.each(|x| S::nearest(x.approximate() + at));
    match &mut case.line {
        Line::Ray(o, ..) => shift(o),
        Line::Ends(a, b) => {
            shift(a);
            shift(b);
        }
        Line::Center(c, _) => shift(c),
    }
    match &mut case.aabb {
        BoxNumbers::Center(c, _) => shift(c),
        BoxNumbers::Corners(a, b) => {
            shift(a);
            shift(b);
        }
    }
    case
}

fn axial<S: Sample>(mut case: LineBox<S>, rng: &mut Rng) -> LineBox<S> {
    let (BoxNumbers::Center(p, _) | BoxNumbers::Corners(p, _)) = case.aabb;
    for _ in 0..2 {
        let (i, few) = (rng.below(3), S::ZERO.moved(rng.whole(-1, 1)));
        let (from, to, is_direction) = match &mut case.line {
            Line::Ray(o, d, _) | Line::Center(o, d) => (o, d, true),
            Line::Ends(a, b) => (a, b, false),
        };
        // Often in the plane of a face.
        if rng.one_in(2) {
            from[i] = p[i];
        }
        to[i] = if is_direction { few } else { from[i].moved(rng.whole(-1, 1)) };
    }
    case
}

/// A line through a point of the surface of a box, in integers.
fn grazing<S: Sample>(rng: &mut Rng) -> Option<LineBox<S>> {
    let bits = S::WHOLE_BITS.min(rng.whole(7, 24) as u32);
    let most = 1_i64 << (bits - 3);
    let center = rng.triple(|rng| rng.whole(-most, most));
    let half = rng.triple(|rng| rng.whole(0, most));
    let mut point = rng.triple(|_| 0);
    for i in 0..3 {
        point[i] = center[i] + [-half[i], half[i], rng.whole(-half[i], half[i])][rng.below(3)];
    }
    // The origin is an integer number of steps away. If an end is out of range, the case is not a
    // contact.
    let step = rng.triple(|rng| rng.whole(-most / 2, most / 2) * i64::from(!rng.one_in(4)));
    let (back, on) = (rng.whole(0, 2), rng.whole(0, 2));
    let at = |times: i64| three(|i| S::whole_clamped(point[i] + times * step[i]));
    let whole = |v: [i64; 3]| v.each(S::whole_clamped);
    let line = match rng.below(3) {
        0 => Line::Ends(at(-back), at(on)),
        1 => Line::Center(at(on - back), whole(step)),
        _ => Line::Ray(at(-back), whole(step), [Some(S::ZERO), None]),
    };
    let corner = |sign: i64| three(|i| S::whole_clamped(center[i] + sign * half[i]));
    let aabb = if rng.one_in(2) {
        BoxNumbers::Center(whole(center), whole(half))
    } else {
        BoxNumbers::Corners(corner(-1), corner(1))
    };
    let mut case = LineBox { line, aabb };
    let (i, steps) = (rng.below(3), rng.whole(-1, 1));
    match &mut case.line {
        Line::Ray(a, b, _) | Line::Ends(a, b) | Line::Center(a, b) => {
            let row = if rng.one_in(2) { a } else { b };
            row[i] = row[i].moved(steps);
        }
    }
    Some(case)
}

/// Integers clamped to the range of the type.
trait WholeClamped: Sample {
    fn whole_clamped(n: i64) -> Self {
        let most = (1_i64 << Self::WHOLE_BITS.min(60)) - 1;
        Self::whole(n.clamp(-most, most))
    }
}
impl<S: Sample> WholeClamped for S {}
