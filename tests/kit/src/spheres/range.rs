//! Where a ray enters a sphere and leaves it: checked by the squared distance at the two values and at
//! the numbers next to them. The crate extracts roots.

use core::cmp::Ordering;

use dashu_int::IBig;
use septum::{Ray, Sphere};

use super::{Other, SphereCase, dot, minus};
use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;

/// How the distance of a point of a ray from a centre compares with a radius, and on which side of the
/// foot of the centre it lies.
fn at([o, d, center, [r, ..]]: [[Parts; 3]; 4], t: Parts) -> [Ordering; 2] {
    let unit = least_exponent([o, d, center, [r; 3]].as_flattened());
    let row = |p: [Parts; 3]| p.map(|x| whole(x, unit));
    let (t, down) = (whole(t, t.1.min(0)), t.1.min(0).unsigned_abs() as usize);
    let (d, m) = (row(d), minus(&row(o), &row(center)));
    let off = [0, 1, 2].map(|i: usize| (&m[i] << down) + &d[i] * &t);
    let r = whole(r, unit) << down;
    [dot(&off, &off).cmp(&(&r * &r)), dot(&off, &d).cmp(&IBig::ZERO)]
}

impl<S: Sample> SphereCase<S> {
    /// Checks where a ray enters the sphere and leaves it: the first value is the greatest number not
    /// above the true one and the second the least not below, unless that is beyond the ray's range
    /// or the type. `None` for other shapes.
    pub fn check_range(&self) -> Option<Result<Option<(S, S)>, String>> {
        let Other::Ray([o, d], [from, to]) = self.other else { return None };
        let ray = Ray::new(o, d).expect("a ray").with_range(from, to).expect("a range");
        let found = ray.t_range_sphere(&Sphere::new(self.center, self.radius).expect("a sphere"));
        if found.is_some() != self.truth().is_le() {
            return Some(Err(format!("{found:?}")));
        }
        let Some((enter, leave)) = found else { return Some(Ok(None)) };
        let parts = [o, d, self.center, [self.radius; 3]].map(|p| p.map(S::mantissa_exponent));
        // Not above where the line enters, or not below where it leaves.
        let is_out = |t: S, side: Ordering| {
            if t > S::GREATEST || t < S::LEAST {
                return t > S::ZERO && side.is_gt() || t < S::ZERO && side.is_lt();
            }
            let [distance, along] = at(parts, t.mantissa_exponent());
            distance.is_ge() && along != side.reverse()
        };
        let is_end = |t: S, end: Option<S>| end == Some(t) || t <= S::LEAST || t >= S::GREATEST;
        let enters = (is_out(enter, Ordering::Less) || is_end(enter, from))
            && (!is_out(enter.moved(1), Ordering::Less) || is_end(enter, None));
        let leaves = (is_out(leave, Ordering::Greater) || is_end(leave, to))
            && (!is_out(leave.moved(-1), Ordering::Greater) || is_end(leave, None));
        let is_within = from.is_none_or(|t| t <= enter) && to.is_none_or(|t| leave <= t);
        let is_right = enters && leaves && is_within && enter <= leave;
        Some(if is_right { Ok(found) } else { Err(format!("{found:?}")) })
    }
}
