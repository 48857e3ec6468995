//! The closest point of a shape: checked against the least of all distances.

use core::cmp::Ordering;

use dashu_int::IBig;
use septum::{Closest, Feature};

use super::{Other, Point, SphereCase, from_hull, minus};
use crate::exact::{least_exponent, whole};
use crate::{Each, sample::Sample, three};

impl<S: Sample> SphereCase<S> {
    /// Checks the point of a triangle or of a segment closest to the centre: the feature is the
    /// nearest of all, and each coordinate is the nearest number, in floats within 0.51 units in
    /// the last place, or 0.76 of a subnormal number. `None` for other shapes.
    pub fn check_closest(&self, found: &Closest<S>) -> Option<Result<(), String>> {
        let parts = |p: Point<S>| p.each(S::mantissa_exponent);
        let given = match self.other {
            Other::Triangle(t) => t.each(parts).to_vec(),
            Other::Ends(ends) => ends.each(parts).to_vec(),
            Other::Center(c, h) => vec![parts(c), parts(h)],
            _ => return None,
        };
        let center = parts(self.center);
        let unit = least_exponent(given.iter().chain([&center]).flatten());
        let row = |p: &[(i64, i32); 3]| p.each(|x| whole(x, unit));
        let (center, mut points) = (row(&center), given.iter().map(row).collect::<Vec<_>>());
        if let Other::Center(..) = self.other {
            let (c, h) = (points[0].clone(), points[1].clone());
            points = vec![minus(&c, &h), three(|i: usize| &c[i] + &h[i])];
        }
        let points: Vec<_> = points.iter().map(|p| minus(p, &center)).collect();
        Some(self.check_against(found, &center, &points, unit))
    }

    fn check_against(
        &self,
        found: &Closest<S>,
        center: &[IBig; 3],
        points: &[[IBig; 3]],
        unit: i32,
    ) -> Result<(), String> {
        let count = points.len();
        let at = |k: usize| points[k % count].clone();
        // The least distance of the part alone, and of its boundary.
        let (part, boundary) = match found.feature {
            Feature::Vertex(k) => (vec![at(k.into())], vec![]),
            Feature::Edge(k) => {
                let k = usize::from(k);
                (vec![at(k), at(k + 1)], vec![vec![at(k)], vec![at(k + 1)]])
            }
            Feature::Interior => (points.to_vec(), three(|k| vec![at(k), at(k + 1)]).to_vec()),
        };
        let compare = |a: &(IBig, IBig), b: &(IBig, IBig)| (&a.0 * &b.1).cmp(&(&b.0 * &a.1));
        let (least, ([x, y, z], den)) = from_hull(points);
        let of_part = from_hull(&part).0;
        if compare(&of_part, &least) != Ordering::Equal {
            return Err(format!("{:?} is not the closest part", found.feature));
        }
        if boundary.iter().any(|b| compare(&from_hull(b).0, &least) == Ordering::Equal) {
            return Err(format!("the point is on the boundary of {:?}", found.feature));
        }
        for (i, (num, rounded)) in [x, y, z].into_iter().zip(found.point.to_array()).enumerate() {
            let exact = num + &center[i] * &den;
            if !is_rounded(rounded, &exact, &den, unit) {
                return Err(format!("coordinate {i} is off"));
            }
        }
        Ok(())
    }
}

/// Whether a number is the nearest to num/den·2^unit, in floats within 0.51 units in the last place
/// or 0.76 of a subnormal number; beyond the range its end, or in floats infinite.
pub fn is_rounded<S: Sample>(rounded: S, num: &IBig, den: &IBig, unit: i32) -> bool {
    let is_infinite = rounded > S::GREATEST || rounded < S::LEAST;
    let value = if is_infinite { S::ZERO } else { rounded };
    let all = [value, S::LEAST, S::GREATEST].each(S::mantissa_exponent);
    let low = all.iter().map(|x| x.1).min().unwrap_or(unit).min(unit);
    let exact = num << (unit - low) as usize;
    let [value, least, greatest] = all.each(|x| whole(x, low) * den);
    if exact < least {
        return rounded <= S::LEAST;
    } else if exact > greatest {
        return rounded >= S::GREATEST;
    }
    let (m, e) = all[0];
    let off = value - exact;
    let off = if off < IBig::ZERO { -off } else { off };
    // In hundredths of a unit in the last place; a subnormal number is rounded twice.
    let is_normal = m.unsigned_abs() >> (S::WHOLE_BITS - 1) != 0;
    let part = if !S::IS_FLOAT {
        50
    } else if is_normal {
        51
    } else {
        76
    };
    !is_infinite && off * 100 <= whole((part, e), low) * den
}

/// Whether num/den·2^unit is not below the first number, nor above the second: an infinity, or the
/// end of fixed point, has nothing above it.
pub fn is_between<S: Sample>([low, high]: [S; 2], num: &IBig, den: &IBig, unit: i32) -> bool {
    let value = |x: S| if x > S::GREATEST { S::GREATEST } else { x };
    let parts = [low, high].each(|x| value(x).mantissa_exponent());
    let least = parts.iter().map(|x| x.1).min().unwrap_or(unit).min(unit);
    let exact = num << (unit - least) as usize;
    let [below, above] = parts.each(|x| whole(x, least) * den);
    below <= exact && (exact <= above || high > S::GREATEST || !S::IS_FLOAT && high == S::GREATEST)
}
