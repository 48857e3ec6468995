//! Lines against boxes: an oracle that clips the range of t, slab by slab, in fractions
//! of whole numbers (Y. Liang, B. Barsky, *ACM TOG* 3(1), 1984), where the crate compares
//! slabs in pairs and forms no fraction.

// Each who includes this uses a part of it.
#![allow(dead_code, unused_imports)]

mod line_sets;

use dashu_int::IBig;
use dashu_int::ops::Abs;
use septum::{Aabb, Ray, Segment};

use crate::support::{BoxNumbers, Sample};

pub(crate) use line_sets::LineSet;

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
