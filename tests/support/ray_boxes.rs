//! Lines against boxes: the sets of cases, and an oracle that clips the range of t,
//! slab by slab, in fractions of whole numbers (Y. Liang, B. Barsky, *ACM TOG* 3(1),
//! 1984), where the crate compares slabs in pairs and forms no fraction.

#![allow(dead_code)]

use dashu_int::IBig;
use dashu_int::ops::Abs;
use septum::{Aabb, Ray, Segment};

use crate::support::{BoxNumbers, Rng, Sample};

/// A line: origin and direction with a range of t, two ends, centre and half-vector.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Line<S> {
    Ray([S; 3], [S; 3], [Option<S>; 2]),
    Ends([S; 3], [S; 3]),
    Center([S; 3], [S; 3]),
}

/// A line and a box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineBox<S> {
    pub(crate) line: Line<S>,
    pub(crate) aabb: BoxNumbers<S>,
}

/// A fraction; the denominator is above nought.
#[derive(Clone, Debug)]
pub(crate) struct Fraction(pub(crate) IBig, pub(crate) IBig);

impl Fraction {
    fn new(num: IBig, den: IBig) -> Self {
        if den < IBig::ZERO { Self(-num, -den) } else { Self(num, den) }
    }
    fn exceeds(&self, other: &Self) -> bool {
        &self.0 * &other.1 > &other.0 * &self.1
    }
    /// Whether it is greater than the scalar.
    pub(crate) fn exceeds_number<S: Sample>(&self, x: S) -> bool {
        let (m, e) = x.mantissa_exponent();
        let (up, down) = (e.max(0) as usize, (-e).max(0) as usize);
        (&self.0 << down) > ((IBig::from(m) * &self.1) << up)
    }
    /// Whether `x` is within n/d units in the last place, on the side where the truth
    /// lies.
    pub(crate) fn is_within<S: Sample>(&self, x: S, (n, d): (i64, i64)) -> bool {
        let value = |x: S| {
            let (m, e) = x.mantissa_exponent();
            IBig::from(m) << (e + 1100) as usize
        };
        let gap = (&self.0 << 1100) - value(x) * &self.1;
        let beside = |steps| (value(x.moved(steps)) - value(x)).abs();
        let (towards, away) = if gap < IBig::ZERO { (-1, 1) } else { (1, -1) };
        // Beyond the last of all numbers there is none.
        let unit = beside(towards);
        let unit = if unit == IBig::ZERO { beside(away) } else { unit };
        gap.abs() * IBig::from(d) <= unit * &self.1 * IBig::from(n)
    }
    /// The nearest value of a fixed-point type, the even one of two, or the extreme.
    pub(crate) fn nearest_fixed<S: Sample>(&self) -> S {
        let places = -S::ZERO.mantissa_exponent().1;
        let double = (&self.0 << (places + 1) as usize) + &self.1;
        let den = &self.1 * IBig::from(2);
        let mut q = &double / &den;
        if &q * &den > double {
            q -= 1; // towards −∞, not nought
        }
        // A tie was rounded up.
        if &q * &den == double && &q % IBig::from(2) != IBig::ZERO {
            q -= 1;
        }
        let end = |x: S| IBig::from(x.ordinal());
        let q = q.clamp(end(S::LEAST), end(S::GREATEST));
        S::from_ordinal(i64::try_from(q).unwrap())
    }
}

impl<S: Sample> LineBox<S> {
    pub(crate) fn aabb(&self) -> Aabb<S> {
        self.aabb.shape().expect("a valid box")
    }

    pub(crate) fn ray(&self) -> Option<Ray<S>> {
        let Line::Ray(o, d, [from, to]) = self.line else { return None };
        Some(Ray::new(o, d).expect("a ray").with_range(from, to).expect("a range"))
    }

    pub(crate) fn segment(&self) -> Option<Segment<S>> {
        match self.line {
            Line::Ray(..) => None,
            Line::Ends(a, b) => Segment::new(a, b).ok(),
            Line::Center(c, w) => Segment::from_center_half_vector(c, w).ok(),
        }
    }

    /// The crate's verdict.
    pub(crate) fn overlaps(&self) -> bool {
        let aabb = self.aabb();
        self.ray().map_or_else(|| self.segment().unwrap().overlaps(&aabb), |r| r.overlaps(&aabb))
    }

    pub(crate) fn may_overlap(&self) -> bool {
        let aabb = self.aabb();
        self.ray()
            .map_or_else(|| self.segment().unwrap().may_overlap(&aabb), |r| r.may_overlap(&aabb))
    }

    fn rows(&self) -> [[S; 3]; 5] {
        let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = self.aabb;
        let or_nought = |t: Option<S>| t.unwrap_or(S::ZERO);
        match self.line {
            Line::Ray(o, d, [from, to]) => [o, d, p, q, [or_nought(from), or_nought(to), S::ZERO]],
            Line::Ends(a, b) | Line::Center(a, b) => [a, b, p, q, [S::ZERO; 3]],
        }
    }

    /// Both ends of what the box leaves of the line, if it leaves anything; an end is
    /// missing where neither bounds it.
    pub(crate) fn clip(&self) -> Option<[Option<Fraction>; 2]> {
        let rows = self.rows();
        let exponents = rows.iter().flatten().map(|x| x.mantissa_exponent());
        let unit = exponents.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0).min(0);
        let whole = |x: S| {
            let (m, e) = x.mantissa_exponent();
            if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
        };
        let one = IBig::ONE << (-unit) as usize;
        let [a, b, p, q, _] = rows.map(|row| row.map(whole));
        let (mut range, d) = match self.line {
            Line::Ray(_, _, ends) => {
                (ends.map(|t| t.map(|t| Fraction(whole(t), one.clone()))), b.clone())
            }
            Line::Ends(..) => (
                [0, 1].map(|t| Some(Fraction(t.into(), IBig::ONE))),
                [0, 1, 2].map(|i| &b[i] - &a[i]),
            ),
            Line::Center(..) => ([-1, 1].map(|t| Some(Fraction(t.into(), IBig::ONE))), b.clone()),
        };
        for i in 0..3 {
            let (least, greatest) = match self.aabb {
                BoxNumbers::Center(..) => (&p[i] - &q[i], &p[i] + &q[i]),
                BoxNumbers::Corners(..) => (p[i].clone(), q[i].clone()),
            };
            if d[i] == IBig::ZERO {
                if a[i] < least || a[i] > greatest {
                    return None;
                }
                continue;
            }
            let mut crossings = [least, greatest].map(|x| Fraction::new(x - &a[i], d[i].clone()));
            if d[i] < IBig::ZERO {
                crossings.reverse();
            }
            let [enter, leave] = crossings;
            if range[0].as_ref().is_none_or(|from| enter.exceeds(from)) {
                range[0] = Some(enter);
            }
            if range[1].as_ref().is_none_or(|to| to.exceeds(&leave)) {
                range[1] = Some(leave);
            }
            if let [Some(from), Some(to)] = &range {
                if from.exceeds(to) {
                    return None;
                }
            }
        }
        Some(range)
    }

    pub(crate) fn meets(&self) -> bool {
        self.clip().is_some()
    }
}

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineSet {
    Random,
    /// Whole numbers from −3 to 3: contact, noughts, flat boxes, all the time.
    Grid,
    /// Through a point of a face, an edge or a corner, in whole numbers, then one
    /// number moved one place up, down or not at all.
    Grazing,
    /// As random, 10⁴ to 10⁶ from the origin.
    Far,
    Small,
    /// At the ends of the scalar's range.
    Huge,
    /// Every magnitude that there is, evenly by bits.
    Bits,
    /// A component or two of the direction nought or next to it.
    Axial,
}

impl LineSet {
    pub(crate) const ALL: [Self; 8] = [
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
    pub(crate) fn case<S: Sample>(self, rng: &mut Rng) -> LineBox<S> {
        let size = (S::GREATEST.approximate() / 4.0).min(4.0);
        let far = (S::GREATEST.approximate() / 2.0).min(1e6);
        loop {
            let found = match self {
                Self::Random => made(rng, |rng| S::nearest(rng.real(-size, size))),
                Self::Grid => made(rng, |rng| S::nearest(rng.whole(-3, 3) as f64)),
                Self::Grazing => grazing(rng),
                Self::Far => {
                    let at = rng.real(far / 100.0, far);
                    let case = made(rng, |rng| S::nearest(rng.real(-size, size)));
                    case.map(|case| shifted(case, at))
                }
                Self::Small => made(rng, |rng| S::nearest(rng.real(-size, size) / 16384.0)),
                Self::Huge => made(rng, |rng| {
                    let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
                    if rng.one_in(3) {
                        return S::nearest(S::GREATEST.approximate() * rng.real(-1.0, 1.0));
                    }
                    end.moved(rng.whole(-2, 2))
                }),
                Self::Bits => made(rng, |rng| S::from_ordinal(rng.bits() as i64 >> rng.below(64))),
                Self::Axial => {
                    let case = made(rng, |rng| S::nearest(rng.real(-size, size)));
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

/// A line and a box of numbers from `pick`; nothing where they make none.
fn made<S: Sample>(rng: &mut Rng, mut pick: impl FnMut(&mut Rng) -> S) -> Option<LineBox<S>> {
    let mut row = |rng: &mut Rng| rng.triple(&mut pick);
    let (a, b, p, q, t) = (row(rng), row(rng), row(rng), row(rng), row(rng));
    let ordered = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
    let aabb = if rng.one_in(2) {
        let half = q.map(|x| if x < S::ZERO { S::from_ordinal(-x.moved(1).ordinal()) } else { x });
        BoxNumbers::Center(p, half)
    } else {
        BoxNumbers::Corners([0, 1, 2].map(|i| ordered(i).0), [0, 1, 2].map(|i| ordered(i).1))
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
    let shift = |v: &mut [S; 3]| *v = v.map(|x| S::nearest(x.approximate() + at));
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
        // Often on the plane of a slab.
        if rng.one_in(2) {
            from[i] = p[i];
        }
        to[i] = if is_direction { few } else { from[i].moved(rng.whole(-1, 1)) };
    }
    case
}

/// A line through a point of the surface of a box, in whole numbers.
fn grazing<S: Sample>(rng: &mut Rng) -> Option<LineBox<S>> {
    let bits = S::WHOLE_BITS.min(rng.whole(7, 24) as u32);
    let most = 1_i64 << (bits - 3);
    let center = rng.triple(|rng| rng.whole(-most, most));
    let half = rng.triple(|rng| rng.whole(0, most));
    let mut point = rng.triple(|_| 0);
    for i in 0..3 {
        point[i] = center[i] + [-half[i], half[i], rng.whole(-half[i], half[i])][rng.below(3)];
    }
    // The origin is a whole number of steps away; where ends are beyond the type, the
    // case will be one of no contact.
    let step = rng.triple(|rng| rng.whole(-most / 2, most / 2) * i64::from(!rng.one_in(4)));
    let (back, on) = (rng.whole(0, 2), rng.whole(0, 2));
    let at = |times: i64| [0, 1, 2].map(|i| S::whole_clamped(point[i] + times * step[i]));
    let whole = |v: [i64; 3]| v.map(S::whole_clamped);
    let line = match rng.below(3) {
        0 => Line::Ends(at(-back), at(on)),
        1 => Line::Center(at(on - back), whole(step)),
        _ => Line::Ray(at(-back), whole(step), [Some(S::ZERO), None]),
    };
    let corner = |sign: i64| [0, 1, 2].map(|i| S::whole_clamped(center[i] + sign * half[i]));
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

/// Whole numbers that may lie beyond the type.
trait WholeClamped: Sample {
    fn whole_clamped(n: i64) -> Self {
        let most = (1_i64 << Self::WHOLE_BITS.min(60)) - 1;
        Self::whole(n.clamp(-most, most))
    }
}
impl<S: Sample> WholeClamped for S {}
