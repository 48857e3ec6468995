//! Capsules against other shapes: a case, and the oracle.
//!
//! Two convex shapes are as far apart as the origin from the hull of the differences of their
//! vertices: as far as from a hull of up to three of these, unless four enclose the origin. From a
//! box, the squared distance of a point that moves along a segment is a parabola between every two
//! planes of faces that it crosses: its least is at a vertex of one, or at a crossing. The crate asks
//! for edges and faces.

use core::cmp::Ordering;

use dashu_int::IBig;
use septum::{Capsule, Segment, Sphere, Triangle};

use super::{
    Answers, Fraction, Other, Point, Squared, dot, faces, from_hull, from_ray, hull, minus,
    numbers, oriented, ray,
};
use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;
use crate::{Each, plane::Given, three};

/// A capsule and another shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CapsuleCase<S> {
    pub ends: [Point<S>; 2],
    pub radius: S,
    pub other: Other<S>,
}

type Whole = [IBig; 3];

/// The squared distance of a plane from a segment: that of the nearer end's foot.
pub(super) fn from_plane(
    ends: [[Parts; 3]; 2],
    normal: [Parts; 3],
    given: Given<Parts>,
) -> Squared {
    let (point, offset) = match given {
        Given::Point(p) => (p, (0, 0)),
        Given::Offset(d) => ([(0, 0); 3], d),
    };
    let all = [normal, point, ends[0], ends[1], [offset; 3]];
    let unit = least_exponent(all.as_flattened()).min(0);
    let row = |p: [Parts; 3]| p.each(|x| whole(x, unit));
    let (n, point) = (row(normal), row(point));
    let offset = whole(offset, unit) << -unit as usize;
    let sides = ends.each(|end| dot(&n, &minus(&row(end), &point)) + &offset);
    if sides.iter().any(|s| *s <= IBig::ZERO) && sides.iter().any(|s| *s >= IBig::ZERO) {
        return Squared { num: IBig::ZERO, den: IBig::ONE, unit };
    }
    // From x to its foot it is −n·s/(n·n).
    let nn = dot(&n, &n);
    let feet = sides.each(|s| three(|i: usize| &n[i] * &s)).each(|v| dot(&v, &v));
    let [a, b] = feet;
    Squared { num: a.min(b), den: &nn * &nn, unit }
}

/// Six times the volume of the origin and three points.
fn volume([a, b, c]: [&Whole; 3]) -> IBig {
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    &a[0] * minor(1, 2) + &a[1] * minor(2, 0) + &a[2] * minor(0, 1)
}

/// Whether four of the points that do not lie in a plane enclose the origin.
fn enclose(points: &[Whole]) -> bool {
    let count = points.len();
    let triple = |a, b, c| volume([&points[a], &points[b], &points[c]]);
    // By the greatest number, then the middle one, then the least.
    let volumes: Vec<Vec<Vec<IBig>>> = (0..count)
        .map(|c| (0..c).map(|b| (0..b).map(|a| triple(a, b, c)).collect()).collect())
        .collect();
    let sign = |x: &IBig| x.cmp(&IBig::ZERO);
    let four = |[d, c, b, a]: [usize; 4]| {
        let part = |x: usize, y: usize, z: usize| &volumes[z][y][x];
        let (odd, even) = ([part(a, c, d), part(a, b, c)], [part(b, c, d), part(a, b, d)]);
        let parts = [even[0].clone(), -odd[0], even[1].clone(), -odd[1]];
        // The parts add up to the volume of all four.
        let all = sign(&parts.iter().sum::<IBig>());
        all != Ordering::Equal && parts.iter().all(|x| sign(x) == all || sign(x).is_eq())
    };
    (0..count).any(|d| (0..d).any(|c| (0..c).any(|b| (0..b).any(|a| four([d, c, b, a])))))
}

/// The squared distance of the origin from the hull of any number of points.
pub(super) fn from_all(points: &[Whole]) -> Fraction {
    if enclose(points) { (IBig::ZERO, IBig::ONE) } else { from_hull(points).0 }
}

/// The squared distance of a segment from a box, by the parts of the segment between faces.
pub(super) fn from_box([a, b]: &[Whole; 2], faces: &[[IBig; 2]; 3]) -> Fraction {
    let e = minus(b, a);
    let less = |x: &Fraction, y: &Fraction| &x.0 * &y.1 < &y.0 * &x.1;
    // Where the segment crosses faces, and its ends.
    let mut times = vec![(IBig::ZERO, IBig::ONE), (IBig::ONE, IBig::ONE)];
    for i in 0..3 {
        for face in &faces[i] {
            let (num, den) = (face - &a[i], e[i].clone());
            let (num, den) = if den < IBig::ZERO { (-num, -den) } else { (num, den) };
            if den > IBig::ZERO && num > IBig::ZERO && num < den {
                times.push((num, den));
            }
        }
    }
    // The squared distance at a time, by the faces that are nearest there.
    let at = |(num, den): &Fraction| -> Fraction {
        let axis = |i: usize| {
            let x = &a[i] * den + &e[i] * num;
            let [low, high] = [0, 1].each(|k: usize| &faces[i][k] * den);
            let off = if x < low {
                low - x
            } else if x > high {
                x - high
            } else {
                IBig::ZERO
            };
            &off * &off
        };
        (axis(0) + axis(1) + axis(2), den * den)
    };
    let mut candidates = times.clone();
    for s in &times {
        for t in times.iter().filter(|t| less(s, t)) {
            // The vertex of the parabola by the faces that are nearest in the middle of the two.
            let middle = (&s.0 * &t.1 + &t.0 * &s.1, &s.1 * &t.1 * IBig::from(2));
            let (mut num, mut den) = (IBig::ZERO, IBig::ZERO);
            for i in 0..3 {
                let x = &a[i] * &middle.1 + &e[i] * &middle.0;
                let face = match () {
                    () if x < &faces[i][0] * &middle.1 => &faces[i][0],
                    () if x > &faces[i][1] * &middle.1 => &faces[i][1],
                    () => continue,
                };
                num += &e[i] * (face - &a[i]);
                den += &e[i] * &e[i];
            }
            if den > IBig::ZERO && num >= IBig::ZERO && num <= den {
                candidates.push((num, den));
            }
        }
    }
    let all = candidates.iter().map(at);
    all.reduce(|x, y| if less(&y, &x) { y } else { x }).expect("an end")
}

/// The squared distance of a segment, moved by a vector, from another shape.
fn squared(ends: [[Parts; 3]; 2], by: [Parts; 3], other: Other<Parts>) -> Squared {
    match other {
        Other::Plane(n, given) => return from_plane(ends, n, given),
        Other::Ray(ray, range) => return from_ray(&ends, ray, range),
        _ => {}
    }
    let unit = least_exponent(numbers(other).iter().chain(ends.as_flattened()).chain(&by));
    let ends = ends.each(|p| three(|i: usize| whole(p[i], unit) + whole(by[i], unit)));
    let (num, den) = match (other, hull(other, unit)) {
        (Other::Box(numbers), _) => from_box(&ends, &three(|i| faces(numbers, i, unit))),
        (_, points) => {
            let points = points.expect("no box");
            let all = ends.iter().flat_map(|end| points.iter().map(|p| minus(p, end)));
            from_all(&all.collect::<Vec<_>>())
        }
    };
    Squared { num, den, unit }
}

impl<S: Sample> CapsuleCase<S> {
    /// The squared distance of the segment from the other shape, of a sphere or a capsule from its
    /// centre or segment.
    pub fn squared(&self) -> Squared {
        let parts = S::mantissa_exponent;
        squared(self.ends.each(|p| p.each(parts)), [(0, 0); 3], self.other.map(parts))
    }

    /// The same after a translation of the segment, which is exact.
    pub fn squared_after(&self, by: [S; 3]) -> Squared {
        let parts = S::mantissa_exponent;
        squared(self.ends.each(|p| p.each(parts)), by.each(parts), self.other.map(parts))
    }

    /// How that distance compares with the radius, or with both radii: equal if they touch, greater
    /// if they are apart.
    pub fn truth(&self) -> Ordering {
        let more = self.other.radius().unwrap_or(S::ZERO);
        self.squared().compare(&[self.radius, more].each(S::mantissa_exponent))
    }

    /// The crate's answers to every query about the pair, with the ends in both orders.
    pub fn answers(&self) -> Answers {
        let [a, b] = self.ends;
        let [capsule, turned] =
            [[a, b], [b, a]].each(|[a, b]| Capsule::new(a, b, self.radius).expect("a capsule"));
        let both = [&capsule, &turned];
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
            Other::Point(p) => Answers::of_point(both.each(|c| c.contains(p)).to_vec()),
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
