//! The oracle for ray and triangle. It solves for the intersection, where the crate computes signs
//! of volumes.
//!
//! Unless they are parallel, the plane of the triangle and the line of the ray meet in one point P.
//! The oracle computes P as a fraction, in integers over one denominator. It then projects P and
//! the triangle along the axis nearest to the normal; P lies in the triangle if it lies on the
//! inner side of each edge in that plane (E. Haines' survey of point in polygon, in *Graphics Gems
//! IV*, 1994). The areas of P with the edges, divided by the triangle's area, are the barycentric
//! coordinates.

use core::cmp::Ordering;

use dashu_int::IBig;
use septum::{Facing, Feature};

use super::{Fraction, RayCase};
use crate::{Each, Parts, Ring, Sample, odd_mantissa, three};

/// The complete answer about a crossing.
#[derive(Clone, Debug)]
pub struct Truth {
    pub t: Fraction,
    pub u: Fraction,
    pub v: Fraction,
    pub facing: Facing,
    pub feature: Feature,
}

/// Where the ray crosses the triangle, if it does.
pub fn crossing<S: Sample>(case: &RayCase<S>) -> Option<Truth> {
    let taken = Taken::of(case);
    match Whole::narrow(&taken) {
        Some(narrow) => narrow.solve(taken.range),
        None => taken.crossing_wide(),
    }
}

/// The same in integers of any size.
pub fn crossing_wide<S: Sample>(case: &RayCase<S>) -> Option<Truth> {
    Taken::of(case).crossing_wide()
}

/// The case in integers, relative to the ray's origin. The ray's direction has a unit of its own.
struct Whole<I> {
    vertices: [[I; 3]; 3],
    direction: [I; 3],
    /// The exponent of the unit of t.
    exponent: i32,
}

/// Origin and vertices, and the direction, as mantissas and exponents; the least exponents of the
/// two; and the range of t.
struct Taken {
    points: [[Option<Parts>; 3]; 4],
    direction: [Option<Parts>; 3],
    units: [i32; 2],
    range: [Option<Parts>; 2],
}

fn least_exponent(numbers: &[Option<Parts>]) -> i32 {
    numbers.iter().flatten().map(|&(_, e)| e).min().unwrap_or(0)
}

impl Taken {
    fn of<S: Sample>(case: &RayCase<S>) -> Self {
        let [a, b, c] = case.vertices;
        let points = [case.origin, a, b, c].each(|v| v.each(odd_mantissa));
        let direction = case.direction.each(odd_mantissa);
        let units = [points.as_flattened(), &direction].each(least_exponent);
        let range = [case.t_min, case.t_max].each(|end| end.map(S::mantissa_exponent));
        Self { points, direction, units, range }
    }

    fn crossing_wide(&self) -> Option<Truth> {
        let whole = |part: Option<Parts>, unit: i32| {
            part.map_or(IBig::ZERO, |(m, e)| IBig::from(m) << (e - unit) as usize)
        };
        Whole::new(self, whole).solve(self.range)
    }

    /// The bits of the longest point and of the direction, in integers.
    fn bits(&self) -> [u32; 2] {
        let [unit, step] = self.units;
        let bits = |&(m, e): &Parts, unit| {
            (e - unit) as u32 + i64::BITS - m.unsigned_abs().leading_zeros()
        };
        let points = self.points.as_flattened().iter().flatten().map(|part| bits(part, unit));
        let direction = self.direction.iter().flatten().map(|part| bits(part, step));
        [points.max().unwrap_or(0), direction.max().unwrap_or(0)]
    }
}

impl Whole<i128> {
    /// The case in 128 bits, if they suffice. With points below 2^(p−1) and a direction below 2^d,
    /// vertices relative to the origin are below 2^p, areas below 2^(2p+3), their products with the
    /// direction below 2^(2p+d+5), with a vertex below 2^(3p+5). A coordinate of P − v is below
    /// 2^(3p+d+6), and its product with an edge's, twice, is below 2^(4p+d+8).
    fn narrow(parts: &Taken) -> Option<Self> {
        let [points, d] = parts.bits();
        let p = points + 1;
        let whole =
            |part: Option<Parts>, unit| part.map_or(0, |(m, e)| i128::from(m) << (e - unit));
        (4 * p + d + 8 <= 125).then(|| Self::new(parts, whole))
    }
}

impl<I: Ring> Whole<I> {
    fn new(parts: &Taken, whole: impl Fn(Option<Parts>, i32) -> I) -> Self {
        let [unit, step] = parts.units;
        let [o, a, b, c] = parts.points.each(|v| v.each(|part| whole(part, unit)));
        Self {
            vertices: [a, b, c].each(|v| I::difference(&v, &o)),
            direction: parts.direction.each(|part| whole(part, step)),
            exponent: unit - step,
        }
    }

    fn solve(&self, [t_min, t_max]: [Option<Parts>; 2]) -> Option<Truth> {
        let ([a, b, c], d) = (&self.vertices, &self.direction);
        let normal = I::cross(&I::difference(b, a), &I::difference(c, a));
        let (num, den) = (I::dot(&normal, a), I::dot(&normal, d));
        if den.sign() == 0 {
            return None;
        }
        // The projection along the axis of the greatest area, and P − v in it for a vertex v, times
        // den.
        let i = longest(&normal);
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let seen_from = |v: &[I; 3], axis: usize| d[axis].times(&num).minus(&v[axis].times(&den));
        let area = |from: &[I; 3], to: &[I; 3]| {
            let edge = I::difference(to, from);
            edge[j].times(&seen_from(from, k)).minus(&edge[k].times(&seen_from(from, j)))
        };
        // The total is normal[i]·den: inside, all areas have its sign.
        let areas = [area(b, c), area(c, a), area(a, b)];
        let sign = normal[i].sign() * den.sign();
        if areas.iter().any(|x| x.sign() * sign < 0) {
            return None;
        }

        let t = Fraction::new(num.big(), den.big(), self.exponent);
        // The end at zero, where most rays begin, needs no long arithmetic.
        let from_zero = t_min.is_some_and(|(m, _)| m == 0);
        let is_early = if from_zero {
            num.sign() * den.sign() < 0
        } else {
            t_min.is_some_and(|end| t.compare_parts(end) == Ordering::Less)
        };
        if is_early || t_max.is_some_and(|end| t.compare_parts(end) == Ordering::Greater) {
            return None;
        }
        let whole = normal[i].times(&den).big();
        let share = |k: usize| Fraction::new(areas[k].big(), whole.clone(), 0);
        Some(Truth {
            t,
            u: share(1),
            v: share(2),
            facing: if den.sign() < 0 { Facing::Front } else { Facing::Back },
            feature: feature(three(|k| areas[k].sign() == 0)),
        })
    }
}

/// The index of the component with the greatest magnitude.
fn longest<I: Ring>(v: &[I; 3]) -> usize {
    let exceeds = |a: &I, b: &I| a.minus(b).times(&a.plus(b)).sign() > 0;
    let i = usize::from(exceeds(&v[1], &v[0]));
    if exceeds(&v[2], &v[i]) { 2 } else { i }
}

/// The feature on which the point lies: coordinate k is zero on the edge opposite vertex k, and two
/// are zero at the vertex of the third.
fn feature(zero: [bool; 3]) -> Feature {
    match zero.iter().filter(|&&zero| zero).count() {
        0 => Feature::Interior,
        1 => {
            let vertex = zero.iter().position(|&zero| zero).expect("one") as u8;
            Feature::Edge((vertex + 1) % 3)
        }
        _ => Feature::Vertex(zero.iter().position(|&zero| !zero).expect("one is left") as u8),
    }
}
