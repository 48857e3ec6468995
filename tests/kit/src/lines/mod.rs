//! Lines against boxes: an oracle that clips the range of t, slab by slab, in fractions
//! of whole numbers (Y. Liang, B. Barsky, *ACM TOG* 3(1), 1984), where the crate compares
//! slabs in pairs and forms no fraction.

mod oriented;
mod sets;

use dashu_int::IBig;
use dashu_int::ops::Abs;
use septum::{Aabb, Ray, Segment};

use crate::exact::{Parts, least_exponent, whole};
use crate::{BoxNumbers, Sample};

pub use oriented::LineObb;
pub use sets::LineSet;

/// A line: origin and direction with a range of t, two ends, centre and half-vector.
#[derive(Clone, Copy, Debug)]
pub enum Line<S> {
    Ray([S; 3], [S; 3], [Option<S>; 2]),
    Ends([S; 3], [S; 3]),
    Center([S; 3], [S; 3]),
}

/// A line and a box.
#[derive(Clone, Copy, Debug)]
pub struct LineBox<S> {
    pub line: Line<S>,
    pub aabb: BoxNumbers<S>,
}

/// A fraction; the denominator is above zero.
#[derive(Clone, Debug)]
pub struct Fraction(pub IBig, pub IBig);

impl Fraction {
    fn new(num: IBig, den: IBig) -> Self {
        if den < IBig::ZERO { Self(-num, -den) } else { Self(num, den) }
    }
    fn exceeds(&self, other: &Self) -> bool {
        &self.0 * &other.1 > &other.0 * &self.1
    }
    /// Whether it is greater than the scalar.
    pub fn exceeds_number<S: Sample>(&self, x: S) -> bool {
        self.exceeds_parts(x.mantissa_exponent())
    }
    fn exceeds_parts(&self, (m, e): Parts) -> bool {
        let (up, down) = (e.max(0) as usize, (-e).max(0) as usize);
        (&self.0 << down) > ((IBig::from(m) * &self.1) << up)
    }
    /// Whether `x` is within n/d units in the last place, on the side where the truth
    /// lies.
    pub fn is_within<S: Sample>(&self, x: S, bound: (i64, i64)) -> bool {
        self.is_within_parts([-1, 0, 1].map(|steps| x.moved(steps).mantissa_exponent()), bound)
    }
    fn is_within_parts(&self, neighbours: [Parts; 3], (n, d): (i64, i64)) -> bool {
        let [below, x, above] = neighbours.map(|(m, e)| IBig::from(m) << (e + 1100) as usize);
        let gap = (&self.0 << 1100) - &x * &self.1;
        let beside = [(below - &x).abs(), (above - &x).abs()];
        let towards = usize::from(gap >= IBig::ZERO);
        // Beyond the last of all numbers there is none.
        let at_the_end = beside[towards] == IBig::ZERO;
        let unit = &beside[if at_the_end { 1 - towards } else { towards }];
        gap.abs() * IBig::from(d) <= unit * &self.1 * IBig::from(n)
    }
    /// The nearest value of a fixed-point type, the even one of two, or the extreme.
    pub fn nearest_fixed<S: Sample>(&self) -> S {
        let ends = [S::LEAST, S::GREATEST].map(S::ordinal);
        S::from_ordinal(self.nearest_ordinal(-S::ZERO.mantissa_exponent().1, ends))
    }
    fn nearest_ordinal(&self, places: i32, [least, greatest]: [i64; 2]) -> i64 {
        let double = (&self.0 << (places + 1) as usize) + &self.1;
        let den = &self.1 * IBig::from(2);
        let mut q = &double / &den;
        if &q * &den > double {
            q -= 1; // towards −∞, not zero
        }
        // A tie was rounded up.
        if &q * &den == double && &q % IBig::from(2) != IBig::ZERO {
            q -= 1;
        }
        i64::try_from(q.clamp(least.into(), greatest.into())).unwrap()
    }
}

impl<S: Sample> LineBox<S> {
    pub fn aabb(&self) -> Aabb<S> {
        self.aabb.shape().expect("a valid box")
    }

    pub fn ray(&self) -> Option<Ray<S>> {
        let Line::Ray(o, d, [from, to]) = self.line else { return None };
        Some(Ray::new(o, d).expect("a ray").with_range(from, to).expect("a range"))
    }

    pub fn segment(&self) -> Option<Segment<S>> {
        match self.line {
            Line::Ray(..) => None,
            Line::Ends(a, b) => Segment::new(a, b).ok(),
            Line::Center(c, w) => Segment::from_center_half_vector(c, w).ok(),
        }
    }

    /// The crate's verdict.
    pub fn overlaps(&self) -> bool {
        let aabb = self.aabb();
        self.ray().map_or_else(|| self.segment().unwrap().overlaps(&aabb), |r| r.overlaps(&aabb))
    }

    pub fn may_overlap(&self) -> bool {
        let aabb = self.aabb();
        self.ray()
            .map_or_else(|| self.segment().unwrap().may_overlap(&aabb), |r| r.may_overlap(&aabb))
    }

    /// Both ends of what the box leaves of the line, if it leaves anything; an end is
    /// missing where neither bounds it.
    pub fn clip(&self) -> Option<[Option<Fraction>; 2]> {
        let parts = |p: [S; 3]| p.map(S::mantissa_exponent);
        let line = match self.line {
            Line::Ray(o, d, t) => {
                Line::Ray(parts(o), parts(d), t.map(|t| t.map(S::mantissa_exponent)))
            }
            Line::Ends(a, b) => Line::Ends(parts(a), parts(b)),
            Line::Center(c, w) => Line::Center(parts(c), parts(w)),
        };
        LineBox { line, aabb: self.aabb.map(S::mantissa_exponent) }.clip_in_parts()
    }

    pub fn meets(&self) -> bool {
        self.clip().is_some()
    }
}

impl LineBox<Parts> {
    fn rows(&self) -> [[Parts; 3]; 5] {
        let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = self.aabb;
        let or_zero = |t: Option<Parts>| t.unwrap_or((0, 0));
        match self.line {
            Line::Ray(o, d, [from, to]) => [o, d, p, q, [or_zero(from), or_zero(to), (0, 0)]],
            Line::Ends(a, b) | Line::Center(a, b) => [a, b, p, q, [(0, 0); 3]],
        }
    }

    fn clip_in_parts(&self) -> Option<[Option<Fraction>; 2]> {
        let rows = self.rows();
        let unit = least_exponent(rows.as_flattened()).min(0);
        let whole = |x: Parts| whole(x, unit);
        let one = IBig::ONE << (-unit) as usize;
        let [a, b, p, q, _] = rows.map(|row| row.map(whole));
        let (range, d) = match self.line {
            Line::Ray(_, _, ends) => {
                (ends.map(|t| t.map(|t| Fraction(whole(t), one.clone()))), b.clone())
            }
            Line::Ends(..) => (
                [0, 1].map(|t| Some(Fraction(t.into(), IBig::ONE))),
                [0, 1, 2].map(|i| &b[i] - &a[i]),
            ),
            Line::Center(..) => ([-1, 1].map(|t| Some(Fraction(t.into(), IBig::ONE))), b.clone()),
        };
        let faces = [0, 1, 2].map(|i| match self.aabb {
            BoxNumbers::Center(..) => [&p[i] - &q[i], &p[i] + &q[i]],
            BoxNumbers::Corners(..) => [p[i].clone(), q[i].clone()],
        });
        clip(&a, &d, &faces, range)
    }
}

/// Both ends of what the slabs between pairs of faces leave of a line's range.
fn clip(
    origin: &[IBig; 3],
    d: &[IBig; 3],
    faces: &[[IBig; 2]; 3],
    mut range: [Option<Fraction>; 2],
) -> Option<[Option<Fraction>; 2]> {
    for i in 0..3 {
        let [least, greatest] = &faces[i];
        if d[i] == IBig::ZERO {
            if &origin[i] < least || &origin[i] > greatest {
                return None;
            }
            continue;
        }
        let mut crossings = [least, greatest].map(|x| Fraction::new(x - &origin[i], d[i].clone()));
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
