//! Spheres against other shapes: a case, and the oracle.
//!
//! The squared distance to a segment or a triangle is the least over all its features: for each set
//! of one, two or three vertices, the distance to their affine hull, if the nearest point of that
//! has no negative weight. Weights and distance are quotients of Gram determinants (F. R.
//! Gantmacher, *The Theory of Matrices*, 1959, chapter IX). Over a box it is the least over both
//! faces and the interior of each axis. The crate decides first which feature is nearest, and
//! compares cross products.

mod closest;
mod sets;

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use septum::{Closest, Segment, Sphere, Triangle};

pub use sets::SphereSet;

use crate::BoxNumbers;
use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;

pub type Point<S> = [S; 3];

/// The shape that is tested against a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Other<S> {
    Triangle([Point<S>; 3]),
    /// A segment by its ends.
    Ends([Point<S>; 2]),
    /// A segment by its centre and half-vector.
    Center(Point<S>, Point<S>),
    Box(BoxNumbers<S>),
    Point(Point<S>),
    Sphere(Point<S>, S),
}

/// A sphere and another shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereCase<S> {
    pub center: Point<S>,
    pub radius: S,
    pub other: Other<S>,
}

/// A squared distance: a numerator, and a divisor above zero, in squares of 2^unit.
pub struct Squared {
    pub num: IBig,
    pub den: IBig,
    pub unit: i32,
}

impl Squared {
    /// How the distance compares with a sum of numbers, which are not negative.
    pub fn compare(&self, sum: &[Parts]) -> Ordering {
        let unit = least_exponent(sum).min(self.unit);
        let r: IBig = sum.iter().map(|&x| whole(x, unit)).sum();
        let up = 2 * (self.unit - unit) as usize;
        (&self.num << up).cmp(&(&self.den * &r * &r))
    }

    /// How two squared distances compare.
    pub fn compare_squared(&self, other: &Self) -> Ordering {
        let unit = self.unit.min(other.unit);
        let num = |x: &Self| &x.num << (2 * (x.unit - unit) as usize);
        (num(self) * &other.den).cmp(&(num(other) * &self.den))
    }

    /// The distance, approximately.
    pub fn root(&self) -> f64 {
        // An even number of bits cut off, so that the quotient is in the range of `f64`.
        let places = |x: &IBig| (x.clone().into_parts().1.bit_len().saturating_sub(200) / 2) as i32;
        let (p, q) = (places(&self.num), places(&self.den));
        let part = |x: &IBig, cut: i32| (x >> (2 * cut as usize)).to_f64().value();
        let root = (part(&self.num, p) / part(&self.den, q)).sqrt();
        let exponent = self.unit + p - q;
        root * 2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2)
    }
}

fn dot(a: &[IBig; 3], b: &[IBig; 3]) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn minus(a: &[IBig; 3], b: &[IBig; 3]) -> [IBig; 3] {
    [0, 1, 2].map(|i: usize| &a[i] - &b[i])
}

/// A fraction, whose divisor is above zero.
type Fraction = (IBig, IBig);

/// The squared distance of the origin from the points' hull, and the closest point as fractions
/// with one divisor.
fn from_hull(points: &[[IBig; 3]]) -> (Fraction, ([IBig; 3], IBig)) {
    let mut best: Option<(Fraction, ([IBig; 3], IBig))> = None;
    let mut add = |num: IBig, den: IBig, at: [IBig; 3]| {
        if best.as_ref().is_none_or(|((n, d), _)| &num * d < n * &den) {
            best = Some(((num, den.clone()), (at, den)));
        }
    };
    for (i, p) in points.iter().enumerate() {
        add(dot(p, p), IBig::ONE, p.clone());
        for q in &points[..i] {
            let e = minus(q, p);
            let (ee, ep, pp) = (dot(&e, &e), dot(&e, p), dot(p, p));
            // The weight of q is −e·p/e·e.
            if ee > IBig::ZERO && ep <= IBig::ZERO && -&ep <= ee {
                let at = [0, 1, 2].map(|i: usize| &p[i] * &ee - &e[i] * &ep);
                add(&pp * &ee - &ep * &ep, ee, at);
            }
        }
    }
    if let [p, q, r] = points {
        let (e, f) = (minus(q, p), minus(r, p));
        let (ee, ef, ff) = (dot(&e, &e), dot(&e, &f), dot(&f, &f));
        let (pe, pf, pp) = (dot(p, &e), dot(p, &f), dot(p, p));
        let gram = &ee * &ff - &ef * &ef;
        let (u, v) = (&ef * &pf - &ff * &pe, &ef * &pe - &ee * &pf);
        if gram > IBig::ZERO && u >= IBig::ZERO && v >= IBig::ZERO && &u + &v <= gram {
            let num = &pp * &gram + &u * &pe + &v * &pf;
            let at = [0, 1, 2].map(|i: usize| &p[i] * &gram + &e[i] * &u + &f[i] * &v);
            add(num, gram, at);
        }
    }
    best.expect("a point")
}

/// The squared distance of a point from a shape.
fn squared(point: [Parts; 3], other: Other<Parts>) -> Squared {
    let rows = match other {
        Other::Triangle(t) => t.to_vec(),
        Other::Ends(ends) => ends.to_vec(),
        Other::Center(a, b) | Other::Box(BoxNumbers::Center(a, b) | BoxNumbers::Corners(a, b)) => {
            vec![a, b]
        }
        Other::Point(p) | Other::Sphere(p, _) => vec![p],
    };
    let unit = least_exponent(rows.iter().chain([&point]).flatten());
    let row = |p: &[Parts; 3]| p.map(|x| whole(x, unit));
    let (point, rows) = (row(&point), rows.iter().map(row).collect::<Vec<_>>());
    let to = |p: &[IBig; 3]| [0, 1, 2].map(|i: usize| &p[i] - &point[i]);
    let (num, den) = match (other, rows.as_slice()) {
        (Other::Box(numbers), [a, b]) => {
            let axis = |i: usize| {
                let [low, high] = match numbers {
                    BoxNumbers::Center(..) => [&a[i] - &b[i], &a[i] + &b[i]],
                    BoxNumbers::Corners(..) => [a[i].clone(), b[i].clone()],
                };
                let (low, high) = (low - &point[i], high - &point[i]);
                let is_inside = low <= IBig::ZERO && high >= IBig::ZERO;
                let faces = (&low * &low).min(&high * &high);
                if is_inside { IBig::ZERO } else { faces }
            };
            (axis(0) + axis(1) + axis(2), IBig::ONE)
        }
        (Other::Center(..), [c, h]) => {
            let [p, q] = [-IBig::ONE, IBig::ONE]
                .map(|sign| to(&[0, 1, 2].map(|i: usize| &c[i] + &sign * &h[i])));
            from_hull(&[p, q]).0
        }
        (_, points) => from_hull(&points.iter().map(to).collect::<Vec<_>>()).0,
    };
    Squared { num, den, unit }
}

impl<S: Sample> SphereCase<S> {
    /// The squared distance of the centre from the other shape, of a sphere from its centre.
    pub fn squared(&self) -> Squared {
        let parts = S::mantissa_exponent;
        let row = |p: Point<S>| p.map(parts);
        let other = match self.other {
            Other::Triangle(t) => Other::Triangle(t.map(row)),
            Other::Ends(ends) => Other::Ends(ends.map(row)),
            Other::Center(c, h) => Other::Center(row(c), row(h)),
            Other::Box(numbers) => Other::Box(numbers.map(parts)),
            Other::Point(p) => Other::Point(row(p)),
            Other::Sphere(c, r) => Other::Sphere(row(c), parts(r)),
        };
        squared(row(self.center), other)
    }

    /// How the distance of the shapes' centres compares with the radius, or with both radii:
    /// equal if they touch, greater if they are apart.
    pub fn truth(&self) -> Ordering {
        let more = if let Other::Sphere(_, r) = self.other { r } else { S::ZERO };
        self.squared().compare(&[self.radius, more].map(S::mantissa_exponent))
    }

    /// The point of a triangle or of a segment closest to the centre; `None` for other shapes.
    pub fn closest(&self) -> Option<Closest<S>> {
        let found = match self.other {
            Other::Triangle([a, b, c]) => Triangle::new(a, b, c).ok()?.closest_point(self.center),
            Other::Ends([a, b]) => Segment::new(a, b).ok()?.closest_point(self.center),
            Other::Center(c, h) => {
                Segment::from_center_half_vector(c, h).ok()?.closest_point(self.center)
            }
            _ => return None,
        };
        Some(found.expect("a finite point"))
    }

    /// The squared distance of the centre from a triangle, a segment or a box, and whether it is the
    /// nearest number, in floats within 0.51 units in the last place; `None` for other shapes.
    pub fn distance_squared(&self) -> Option<(S, bool)> {
        let found = match self.other {
            Other::Triangle([a, b, c]) => {
                Triangle::new(a, b, c).ok()?.distance_squared(self.center)
            }
            Other::Ends([a, b]) => Segment::new(a, b).ok()?.distance_squared(self.center),
            Other::Center(c, h) => {
                Segment::from_center_half_vector(c, h).ok()?.distance_squared(self.center)
            }
            Other::Box(numbers) => numbers.shape().ok()?.distance_squared(self.center),
            _ => return None,
        };
        let (found, Squared { num, den, unit }) = (found.expect("a finite point"), self.squared());
        Some((found, closest::is_rounded(found, &num, &den, 2 * unit)))
    }

    /// The crate's answers to every query about the pair, which must all agree.
    pub fn answers(&self) -> Vec<bool> {
        let sphere = Sphere::new(self.center, self.radius).expect("a sphere");
        match self.other {
            Other::Triangle([a, b, c]) => {
                let t = Triangle::new(a, b, c).expect("finite vertices");
                vec![sphere.overlaps(&t), t.overlaps(&sphere), sphere.may_overlap(&t)]
            }
            Other::Ends([a, b]) => {
                let s = Segment::new(a, b).expect("finite ends");
                vec![sphere.overlaps(&s), s.overlaps(&sphere)]
            }
            Other::Center(c, h) => {
                let s = Segment::from_center_half_vector(c, h).expect("finite vectors");
                vec![sphere.overlaps(&s), s.overlaps(&sphere)]
            }
            Other::Box(numbers) => {
                let aabb = numbers.shape().expect("a box");
                vec![sphere.overlaps(&aabb), aabb.overlaps(&sphere)]
            }
            Other::Point(p) => vec![sphere.contains(p)],
            Other::Sphere(c, r) => {
                let other = Sphere::new(c, r).expect("a sphere");
                vec![sphere.overlaps(&other), other.overlaps(&sphere)]
            }
        }
    }
}
