//! Spheres against other shapes: a case, and the oracle.
//!
//! The squared distance to a segment or a triangle is the least over all its features: for each set
//! of one, two or three vertices, the distance to their affine hull, if the nearest point of that
//! has no negative weight. Weights and distance are quotients of Gram determinants (F. R.
//! Gantmacher, *The Theory of Matrices*, 1959, chapter IX). Over a box it is the least over both
//! faces and the interior of each axis. The crate decides first which feature is nearest, and
//! compares cross products. A ray is a segment to a point beyond the foot of the sphere's centre.

mod answers;
mod capsules;
mod closest;
mod contacts;
mod moving;
mod oriented;
mod range;
mod sets;

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use septum::{Capsule, Closest, Ray, Segment, Sphere, Triangle};

pub use answers::Answers;
pub use capsules::CapsuleCase;
pub use contacts::Found;
pub use moving::{Part, SphereSweep};
pub use sets::SphereSet;

use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;
use crate::{BoxNumbers, Each, Given, three};

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
    /// A capsule by its ends and its radius.
    Capsule([Point<S>; 2], S),
    /// A plane by its normal.
    Plane(Point<S>, Given<S>),
    /// An oriented box by its centre, its axes and its half-extents.
    Obb(Point<S>, [Point<S>; 3], Point<S>),
    /// A ray by its origin and its direction, and the range of t.
    Ray([Point<S>; 2], [Option<S>; 2]),
}

impl<S: Copy> Other<S> {
    /// The same shape in other numbers.
    fn map<T>(self, f: impl Fn(S) -> T + Copy) -> Other<T> {
        let row = |p: Point<S>| p.each(f);
        match self {
            Self::Triangle(t) => Other::Triangle(t.each(row)),
            Self::Ends(ends) => Other::Ends(ends.each(row)),
            Self::Center(c, h) => Other::Center(row(c), row(h)),
            Self::Box(numbers) => Other::Box(numbers.map(f)),
            Self::Point(p) => Other::Point(row(p)),
            Self::Sphere(c, r) => Other::Sphere(row(c), f(r)),
            Self::Capsule(ends, r) => Other::Capsule(ends.each(row), f(r)),
            Self::Plane(n, Given::Point(p)) => Other::Plane(row(n), Given::Point(row(p))),
            Self::Plane(n, Given::Offset(d)) => Other::Plane(row(n), Given::Offset(f(d))),
            Self::Obb(c, axes, half) => Other::Obb(row(c), axes.each(row), row(half)),
            Self::Ray(ray, range) => Other::Ray(ray.each(row), range.each(|t| t.map(f))),
        }
    }

    /// The radius of the shape itself, if it is a sphere or a capsule.
    pub fn radius(&self) -> Option<S> {
        match *self {
            Self::Sphere(_, r) | Self::Capsule(_, r) => Some(r),
            _ => None,
        }
    }
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
    three(|i: usize| &a[i] - &b[i])
}

/// A fraction, whose divisor is above zero.
type Fraction = (IBig, IBig);

/// The squared distance of the origin from the points' hull, unless that contains it, and the closest
/// point as fractions with one divisor.
///
/// By Carathéodory's theorem that is the least distance from a hull of up to three of the points: from
/// the foot of the origin on their plane or line, if it lies between them.
fn from_hull(points: &[[IBig; 3]]) -> (Fraction, ([IBig; 3], IBig)) {
    // The points' products. Those of edges are sums of them.
    let products: Vec<Vec<IBig>> =
        points.iter().map(|p| points.iter().map(|q| dot(p, q)).collect()).collect();
    let product = |i: usize, j: usize| &products[i][j];
    // (q − p)·(r − p)
    let edges = |p, q, r| product(q, r) - product(p, q) - product(p, r) + product(p, p);
    let mut best: Option<(Fraction, Vec<(usize, IBig)>)> = None;
    let mut add = |num: IBig, den: IBig, weights: &[(usize, &IBig)]| {
        if best.as_ref().is_none_or(|((n, d), _)| &num * d < n * &den) {
            let weights = weights.iter().map(|&(i, weight)| (i, weight.clone())).collect();
            best = Some(((num, den), weights));
        }
    };
    for p in 0..points.len() {
        let pp = product(p, p);
        add(pp.clone(), IBig::ONE, &[(p, &IBig::ONE)]);
        for q in 0..p {
            let (ee, pe) = (edges(p, q, q), product(p, q) - pp);
            let (of_p, of_q) = (&ee + &pe, -&pe);
            if ee > IBig::ZERO && of_p >= IBig::ZERO && of_q >= IBig::ZERO {
                add(pp * &ee - &pe * &pe, ee.clone(), &[(p, &of_p), (q, &of_q)]);
            }
            for r in 0..q {
                let (ef, ff, pf) = (edges(p, q, r), edges(p, r, r), product(p, r) - pp);
                let of_q = &ef * &pf - &ff * &pe;
                if of_q < IBig::ZERO {
                    continue;
                }
                let of_r = &ef * &pe - &ee * &pf;
                if of_r < IBig::ZERO {
                    continue;
                }
                let gram = &ee * &ff - &ef * &ef;
                let of_p = &gram - &of_q - &of_r;
                if gram > IBig::ZERO && of_p >= IBig::ZERO {
                    let num = pp * &gram + &of_q * &pe + &of_r * &pf;
                    add(num, gram, &[(p, &of_p), (q, &of_q), (r, &of_r)]);
                }
            }
        }
    }
    let ((num, den), weights) = best.expect("a point");
    let at = [0, 1, 2]
        .each(|k: usize| weights.iter().map(|(i, weight)| weight * &points[*i][k]).sum::<IBig>());
    ((num, den.clone()), (at, den))
}

/// The points whose hull is a shape, in units of 2^unit. `None` for a box or a plane, and a ray must
/// be cut off.
fn hull(other: Other<Parts>, unit: i32) -> Option<Vec<[IBig; 3]>> {
    let row = |p: [Parts; 3]| p.each(|x| whole(x, unit));
    match other {
        Other::Triangle(t) => Some(t.each(row).to_vec()),
        Other::Ends(ends) | Other::Capsule(ends, _) => Some(ends.each(row).to_vec()),
        Other::Center(c, h) => {
            let (c, h) = (row(c), row(h));
            Some(vec![minus(&c, &h), three(|i: usize| &c[i] + &h[i])])
        }
        Other::Point(p) | Other::Sphere(p, _) => Some(vec![row(p)]),
        Other::Obb(c, axes, half) => Some(oriented::corners(row(c), axes, half, unit)),
        Other::Box(_) | Other::Plane(..) | Other::Ray(..) => None,
    }
}

/// All numbers of a shape, but radii and values of t.
fn numbers(other: Other<Parts>) -> Vec<Parts> {
    let rows = match other {
        Other::Triangle(t) => t.to_vec(),
        Other::Ends(two) | Other::Capsule(two, _) | Other::Ray(two, _) => two.to_vec(),
        Other::Center(a, b)
        | Other::Box(BoxNumbers::Center(a, b) | BoxNumbers::Corners(a, b))
        | Other::Plane(a, Given::Point(b)) => vec![a, b],
        Other::Plane(n, Given::Offset(d)) => vec![n, [d; 3]],
        Other::Obb(c, axes, half) => {
            vec![c, [(1, oriented::units(&axes, &half).iter().sum()); 3]]
        }
        Other::Point(p) | Other::Sphere(p, _) => vec![p],
    };
    rows.concat()
}

/// The least and the greatest coordinate of a box on an axis.
fn faces(numbers: BoxNumbers<Parts>, i: usize, unit: i32) -> [IBig; 2] {
    let [a, b] = match numbers {
        BoxNumbers::Center(a, b) | BoxNumbers::Corners(a, b) => [a[i], b[i]],
    }
    .each(|x| whole(x, unit));
    match numbers {
        BoxNumbers::Center(..) => [&a - &b, a + b],
        BoxNumbers::Corners(..) => [a, b],
    }
}

/// The squared distance of the hull of points from a ray, which is a segment that ends beyond the
/// feet of all points.
fn from_ray(points: &[[Parts; 3]], ray: [[Parts; 3]; 2], range: [Option<Parts>; 2]) -> Squared {
    let unit = least_exponent(ray.iter().chain(points).flatten());
    let of_t = least_exponent(range.iter().flatten()).min(0);
    let row = |p: [Parts; 3]| p.each(|x| whole(x, unit));
    let [o, d] = ray.each(row);
    let range = range.each(|t| t.map(|t| whole(t, of_t)));
    let magnitude = |x: &IBig| if *x < IBig::ZERO { -x } else { x.clone() };
    let ways: Vec<_> = points.iter().map(|p| minus(&row(*p), &o)).collect();
    let feet: IBig = ways.iter().map(|m| magnitude(&dot(m, &d))).sum();
    let far = (feet << -of_t as usize) + range.iter().flatten().map(magnitude).sum::<IBig>();
    let [from, to] = [-far.clone(), far];
    let ends = [range[0].clone().unwrap_or(from), range[1].clone().unwrap_or(to)];
    let vertex = |t: &IBig, m: &[IBig; 3]| three(|i: usize| t * &d[i] - (&m[i] << -of_t as usize));
    let all: Vec<_> = ends.iter().flat_map(|t| ways.iter().map(|m| vertex(t, m))).collect();
    let (num, den) = capsules::from_all(&all);
    Squared { num, den, unit: unit + of_t }
}

fn ray<S: Sample>([o, d]: [Point<S>; 2], [from, to]: [Option<S>; 2]) -> Ray<S> {
    Ray::new(o, d).and_then(|ray| ray.with_range(from, to)).expect("a ray")
}

/// The squared distance of a point from a shape.
fn squared(point: [Parts; 3], other: Other<Parts>) -> Squared {
    let numbers = match other {
        Other::Plane(n, given) => return capsules::from_plane([point; 2], n, given),
        Other::Ray(ray, range) => return from_ray(&[point], ray, range),
        Other::Box(numbers) => numbers,
        _ => {
            let unit = least_exponent(numbers(other).iter().chain(&point));
            let point = point.each(|x| whole(x, unit));
            let points = hull(other, unit).expect("no box");
            let points: Vec<_> = points.iter().map(|p| minus(p, &point)).collect();
            let (num, den) = capsules::from_all(&points);
            return Squared { num, den, unit };
        }
    };
    let unit = least_exponent(self::numbers(other).iter().chain(&point));
    let axis = |i: usize| {
        let x = whole(point[i], unit);
        let [low, high] = faces(numbers, i, unit).each(|face| face - &x);
        let is_inside = low <= IBig::ZERO && high >= IBig::ZERO;
        let faces = (&low * &low).min(&high * &high);
        if is_inside { IBig::ZERO } else { faces }
    };
    Squared { num: axis(0) + axis(1) + axis(2), den: IBig::ONE, unit }
}

impl<S: Sample> SphereCase<S> {
    /// The squared distance of the centre from the other shape, of a sphere from its centre.
    pub fn squared(&self) -> Squared {
        let parts = S::mantissa_exponent;
        squared(self.center.each(parts), self.other.map(parts))
    }

    /// How the distance of the shapes' centres compares with the radius, or with both radii:
    /// equal if they touch, greater if they are apart.
    pub fn truth(&self) -> Ordering {
        let more = self.other.radius().unwrap_or(S::ZERO);
        self.squared().compare(&[self.radius, more].each(S::mantissa_exponent))
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

    /// The numbers between which the crate says that this distance lies, and whether it does, with
    /// at most one number between them.
    pub fn distance_squared_range(&self) -> Option<((S, S), bool)> {
        let found = match self.other {
            Other::Triangle([a, b, c]) => {
                Triangle::new(a, b, c).ok()?.distance_squared_range(self.center)
            }
            Other::Ends([a, b]) => Segment::new(a, b).ok()?.distance_squared_range(self.center),
            Other::Center(c, h) => {
                Segment::from_center_half_vector(c, h).ok()?.distance_squared_range(self.center)
            }
            Other::Box(numbers) => numbers.shape().ok()?.distance_squared_range(self.center),
            _ => return None,
        };
        let (low, high) = found.expect("a finite point");
        let Squared { num, den, unit } = self.squared();
        let is_narrow = low.moved(2) >= high || high > S::GREATEST && low.moved(2) >= S::GREATEST;
        let is_right = closest::is_between([low, high], &num, &den, 2 * unit) && is_narrow;
        Some(((low, high), is_right))
    }

    /// The crate's answers to every query about the pair.
    pub fn answers(&self) -> Answers {
        let sphere = Sphere::new(self.center, self.radius).expect("a sphere");
        let both = [&sphere; 2];
        match self.other {
            Other::Triangle([a, b, c]) => {
                Answers::of(both, &Triangle::new(a, b, c).expect("finite vertices"))
            }
            Other::Ends([a, b]) => Answers::of(both, &Segment::new(a, b).expect("finite ends")),
            Other::Center(c, h) => {
                let segment = Segment::from_center_half_vector(c, h).expect("finite vectors");
                Answers::of(both, &segment)
            }
            Other::Box(numbers) => Answers::of(both, &numbers.shape().expect("a box")),
            Other::Point(p) => Answers::of_point(vec![sphere.contains(p)]),
            Other::Sphere(c, r) => Answers::of(both, &Sphere::new(c, r).expect("a sphere")),
            Other::Capsule([a, b], r) => {
                Answers::of(both, &Capsule::new(a, b, r).expect("a capsule"))
            }
            Other::Plane(n, given) => Answers::of(both, &given.plane(n).expect("a plane")),
            Other::Obb(c, axes, half) => Answers::of(both, &oriented::obb(c, axes, half)),
            Other::Ray(numbers, range) => Answers::of(both, &ray(numbers, range)),
        }
    }
}
