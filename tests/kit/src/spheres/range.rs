//! Where a ray enters a sphere or a capsule and leaves it: checked by the squared distance at the two
//! values and at the numbers next to them. The crate extracts roots.

use core::cmp::Ordering;

use dashu_int::IBig;
use septum::{Capsule, Sphere};

use super::{CapsuleCase, Other, Point, SphereCase, dot, from_hull, minus};
use crate::exact::{Parts, least_exponent, whole};
use crate::{Each, sample::Sample, three};

/// A line, and the ends and the radius of a capsule.
struct Line {
    origin: [IBig; 3],
    direction: [IBig; 3],
    ends: [[IBig; 3]; 2],
    radius: IBig,
}

impl Line {
    fn new([o, d]: [[Parts; 3]; 2], ends: [[Parts; 3]; 2], r: Parts) -> Self {
        let unit = least_exponent([o, d, ends[0], ends[1], [r; 3]].as_flattened());
        let row = |p: [Parts; 3]| p.each(|x| whole(x, unit));
        Self { origin: row(o), direction: row(d), ends: ends.each(row), radius: whole(r, unit) }
    }

    /// How the distance of the point at t/2^`down` from the segment compares with the radius, and
    /// whether it shrinks or grows.
    fn at(&self, t: &IBig, down: usize) -> [Ordering; 2] {
        let at = three(|i: usize| (&self.origin[i] << down) + &self.direction[i] * t);
        let ends = self.ends.each_ref().each(|end| {
            let end = end.each_ref().each(|x| x << down);
            minus(&end, &at)
        });
        let ((num, den), (closest, _)) = from_hull(&ends);
        let r = &self.radius << down;
        let growth = -dot(&closest, &self.direction);
        [num.cmp(&(den * &r * &r)), growth.cmp(&IBig::ZERO)]
    }

    /// Whether t is at most the time at which the line enters.
    fn is_before(&self, t: Parts) -> bool {
        let (t, down) = (whole(t, t.1.min(0)), t.1.min(0).unsigned_abs() as usize);
        match self.at(&t, down) {
            [Ordering::Greater, growth] => growth.is_lt(),
            [Ordering::Less, _] => false,
            [_, Ordering::Less] => true,
            [_, Ordering::Greater] => false,
            // It touches: is it apart a little earlier?
            _ => self.at(&((t << MORE) - IBig::ONE), down + MORE)[0].is_gt(),
        }
    }

    /// The same of the opposite direction.
    fn turned(&self) -> Self {
        Self {
            origin: self.origin.clone(),
            direction: self.direction.each_ref().each(|x| -x),
            ends: self.ends.clone(),
            radius: self.radius.clone(),
        }
    }
}

/// Places that are more than those of a number of any scalar.
const MORE: usize = 2_200;

/// Checks where a ray enters and leaves: the first value is the greatest number not above the true one
/// and the second the least not below, unless that is beyond the ray's range or the type.
fn check<S: Sample>(
    [ray, ends]: [[Point<S>; 2]; 2],
    radius: S,
    [from, to]: [Option<S>; 2],
    (enter, leave): (S, S),
) -> bool {
    let parts = |p: Point<S>| p.each(S::mantissa_exponent);
    let line = Line::new(ray.each(parts), ends.each(parts), radius.mantissa_exponent());
    let turned = line.turned();
    let is_beyond = |t: S| t > S::GREATEST || t < S::LEAST;
    // Not above the first time, and not below the last.
    let enters =
        |t: S| if is_beyond(t) { t < S::ZERO } else { line.is_before(t.mantissa_exponent()) };
    let leaves = |t: S| {
        let (m, exponent) = if is_beyond(t) { return t > S::ZERO } else { t.mantissa_exponent() };
        // The least integer has no opposite, and is even.
        turned.is_before(m.checked_neg().map_or((-(m / 2), exponent + 1), |m| (m, exponent)))
    };
    let is_end = |t: S, end: Option<S>| end == Some(t) || t <= S::LEAST || t >= S::GREATEST;
    let enters =
        (enters(enter) || is_end(enter, from)) && (!enters(enter.moved(1)) || is_end(enter, None));
    let leaves =
        (leaves(leave) || is_end(leave, to)) && (!leaves(leave.moved(-1)) || is_end(leave, None));
    let is_within = from.is_none_or(|t| t <= enter) && to.is_none_or(|t| leave <= t);
    enters && leaves && is_within && enter <= leave
}

/// What the crate found, if that is right. `None` stands for a miss.
type Checked<S> = Result<Option<(S, S)>, String>;

impl<S: Sample> CapsuleCase<S> {
    /// Checks where a ray enters the capsule and leaves it. `None` for other shapes.
    pub fn check_range(&self) -> Option<Checked<S>> {
        let Other::Ray(numbers, range) = self.other else { return None };
        let capsule = Capsule::new(self.ends[0], self.ends[1], self.radius).expect("a capsule");
        let found = super::ray(numbers, range).t_range_capsule(&capsule);
        let is_right = found.map_or(self.truth().is_gt(), |found| {
            self.truth().is_le() && check([numbers, self.ends], self.radius, range, found)
        });
        Some(if is_right { Ok(found) } else { Err(format!("{found:?}")) })
    }
}

impl<S: Sample> SphereCase<S> {
    /// The same of a sphere.
    pub fn check_range(&self) -> Option<Checked<S>> {
        let Other::Ray(numbers, range) = self.other else { return None };
        let sphere = Sphere::new(self.center, self.radius).expect("a sphere");
        let found = super::ray(numbers, range).t_range_sphere(&sphere);
        let is_right = found.map_or(self.truth().is_gt(), |found| {
            let ends = [self.center; 2];
            self.truth().is_le() && check([numbers, ends], self.radius, range, found)
        });
        Some(if is_right { Ok(found) } else { Err(format!("{found:?}")) })
    }
}
