//! Spheres that move past triangles and boxes: a case, and the oracle.
//!
//! The way up to a time is a segment, whose squared distance from the shape comes from the oracle of
//! capsules. If it is below the square of the radius, the time is after the contact. If it equals
//! that, another time just before decides.

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use septum::relation::Relation;
use septum::sweep::{Motion, SphereContact, Sweep};
use septum::{Feature, Sphere, Triangle};

use super::capsules::{from_all, from_box};
use super::{CapsuleCase, Other, Point, SphereCase, SphereSet, faces, hull, minus, numbers};
use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;
use crate::{Each, rng::Rng, three};

/// A sphere that moves past a triangle or a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereSweep<S> {
    pub center: Point<S>,
    pub radius: S,
    pub way: [Point<S>; 2],
    pub other: Other<S>,
}

/// The part that a sphere touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    Triangle(Feature),
    Box([i8; 3]),
}

type Whole = [IBig; 3];

/// The shape or a part of it, as points or as faces of a box.
enum Hull {
    Points(Vec<Whole>),
    Faces([[IBig; 2]; 3]),
}

/// All numbers as integers in one unit.
struct Shapes {
    center: Whole,
    d: Whole,
    radius: IBig,
    hull: Hull,
    /// The bits of the longest of these.
    bits: usize,
}

impl Shapes {
    /// How the distance of the way up to m·2^e from a hull compares with the radius.
    fn compare(&self, (m, e): (&IBig, i32), hull: &Hull) -> Ordering {
        let down = e.min(0).unsigned_abs() as usize;
        let scaled = |x: &IBig| x << down;
        let row = |p: &Whole| three(|i: usize| scaled(&p[i]));
        let start = row(&self.center);
        let end = three(|i: usize| &start[i] + &self.d[i] * (m << e.max(0) as usize));
        let r = scaled(&self.radius);
        let (num, den) = match hull {
            Hull::Points(points) => {
                let to =
                    |end: &Whole| points.iter().map(|p| minus(&row(p), end)).collect::<Vec<_>>();
                from_all(&[to(&start), to(&end)].concat())
            }
            Hull::Faces(faces) => {
                let faces = three(|i: usize| [0, 1].each(|k: usize| scaled(&faces[i][k])));
                from_box(&[start, end], &faces)
            }
        };
        num.cmp(&(&r * &r * den))
    }

    /// How a time compares with the time of contact.
    ///
    /// Where all from an earlier time on is contact without depth, that time is a quotient whose
    /// divisor has degree 4, the double root of an equation: it is not nearer to `m`·2^`e`, as a part
    /// of that, than one by the product of `m` and the divisor.
    fn order(&self, (m, e): Parts) -> Ordering {
        let whole = IBig::from(m);
        let places = 6 * self.bits + 128;
        match self.compare((&whole, e), &self.hull) {
            // Just before.
            Ordering::Equal if m != 0 => {
                let before = (whole << places) - IBig::ONE;
                match self.compare((&before, e - places as i32), &self.hull) {
                    Ordering::Greater => Ordering::Equal,
                    _ => Ordering::Greater,
                }
            }
            order => order.reverse(),
        }
    }

    fn part(&self, part: Part) -> Hull {
        match (part, &self.hull) {
            (Part::Triangle(part), Hull::Points(points)) => {
                let at = |k: u8| points[usize::from(k) % 3].clone();
                Hull::Points(match part {
                    Feature::Interior => points.clone(),
                    Feature::Edge(k) => vec![at(k), at(k + 1)],
                    Feature::Vertex(k) => vec![at(k)],
                })
            }
            (Part::Box(sides), Hull::Faces(faces)) => Hull::Faces(three(|i: usize| {
                let [low, high] = faces[i].clone();
                match sides[i] {
                    -1 => [low.clone(), low],
                    0 => [low, high],
                    _ => [high.clone(), high],
                }
            })),
            _ => panic!("another shape"),
        }
    }
}

impl<S: Sample> SphereSweep<S> {
    /// A case of this set: half of them with a contact on the way, a quarter that nearly graze.
    pub fn of_set(set: SphereSet, rng: &mut Rng) -> Self {
        let CapsuleCase { ends, mut radius, other } = loop {
            let case = set.capsule::<S>(rng);
            if matches!(case.other, Other::Triangle(_) | Other::Box(_)) {
                break case;
            }
        };
        let [a, b] = ends;
        let plus = |p: Point<S>| three(|i: usize| p[i].plus(b[i].minus(a[i])));
        let is_finite = |p: &Point<S>| p.iter().all(|x| x.is_finite());
        let from = if rng.one_in(2) { a } else { b };
        // In fixed point this may wrap around; it is then another motion.
        let way = [from, plus(from)];
        let way = if rng.one_in(2) && is_finite(&way[1]) { way } else { ends };
        if rng.one_in(2) {
            let [near, far] =
                [ends, [a, a]].each(|ends| CapsuleCase { ends, radius, other }.squared().root());
            let part = [0.5, 0.01, 0.999][rng.below(3)];
            let middle = near * (1.0 - part) + far * part;
            radius = if middle.is_finite() { S::nearest(middle) } else { radius };
        }
        Self { center: a, radius, way, other }
    }

    fn shapes(&self) -> Shapes {
        let parts = S::mantissa_exponent;
        let row = |p: Point<S>| p.each(parts);
        let (other, rows) =
            (self.other.map(parts), [row(self.center), row(self.way[0]), row(self.way[1])]);
        let radius = parts(self.radius);
        let all = numbers(other);
        let unit = least_exponent(all.iter().chain(rows.as_flattened()).chain([&radius]));
        let [center, from, to] = rows.each(|p| p.each(|x| whole(x, unit)));
        let hull = match other {
            Other::Box(numbers) => Hull::Faces(three(|i| faces(numbers, i, unit))),
            _ => Hull::Points(hull(other, unit).expect("a triangle")),
        };
        let (d, radius) = (minus(&to, &from), whole(radius, unit));
        let all = all.iter().chain(rows.as_flattened()).map(|&x| whole(x, unit).bit_len());
        let bits = all.chain([radius.bit_len()]).max().unwrap_or(0) + 1;
        Shapes { center, d, radius, hull, bits }
    }

    /// The nearest relation, the time, and the part that is touched first.
    fn answers(&self) -> (bool, Relation, Option<(S, Option<Part>)>) {
        let sphere = Sphere::new(self.center, self.radius).expect("a sphere");
        let motion = Motion::new(self.way[0], self.way[1]).expect("finite places");
        match self.other {
            Other::Triangle([a, b, c]) => {
                let t = Triangle::new(a, b, c).expect("finite vertices");
                let first: Option<SphereContact<S, Feature>> = sphere.first_contact(&motion, &t);
                let first = first.map(|first| (first.t, first.part.map(Part::Triangle)));
                (sphere.meets_along(&motion, &t), sphere.relation_along(&motion, &t), first)
            }
            Other::Box(numbers) => {
                let aabb = numbers.shape().expect("a box");
                let first: Option<SphereContact<S, [i8; 3]>> = sphere.first_contact(&motion, &aabb);
                let first = first.map(|first| (first.t, first.part.map(Part::Box)));
                (sphere.meets_along(&motion, &aabb), sphere.relation_along(&motion, &aabb), first)
            }
            _ => panic!("another shape"),
        }
    }

    /// Checks all answers: 0 for a miss, 1 for contact at the start, 2 for contact on the way.
    ///
    /// # Panics
    /// If one is wrong.
    pub fn check(&self) -> usize {
        let shapes = self.shapes();
        let truth = shapes.compare((&IBig::ONE, 0), &shapes.hull);
        let (meets, relation, first) = self.answers();
        assert_eq!((meets, first.is_some()), (truth.is_le(), truth.is_le()), "{self:?}");
        let has_radius = self.radius > S::ZERO;
        let is_right = match relation {
            Relation::Disjoint => truth.is_gt(),
            Relation::Touching => truth.is_eq(),
            Relation::Overlapping => truth.is_lt() || truth.is_eq() && !has_radius,
        };
        assert!(is_right, "{relation:?} {truth:?} {self:?}");
        let Some((t, part)) = first else { return 0 };
        let Self { center, radius, other, .. } = *self;
        let is_at_start = SphereCase { center, radius, other }.truth().is_le();
        assert_eq!(part.is_none(), is_at_start, "{self:?}");
        let Some(part) = part else {
            assert!(t == S::ZERO, "{self:?}");
            return 1;
        };
        let next = t.moved(1);
        let order = |t: S| shapes.order(t.mantissa_exponent());
        assert!(order(t).is_le(), "{t:?} is late: {part:?} {self:?}");
        let is_last = next == t || order(next).is_gt();
        assert!(is_last, "{t:?} is early: {part:?} {self:?}");
        // The part is met before the next number.
        let (m, e) = next.mantissa_exponent();
        let is_met = shapes.compare((&IBig::from(m), e), &shapes.part(part)).is_le();
        assert!(is_met || next == t, "{part:?} {t:?} {self:?}");
        2
    }
}
