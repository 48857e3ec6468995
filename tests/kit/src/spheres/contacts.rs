//! Contacts of spheres and capsules: the oracle.
//!
//! The verdict and the depth of shapes whose segment is outside come from the squared distance in
//! rationals. A translation is applied to the segment exactly, and the distance computed anew. A
//! segment that is inside is a triangle of two corners, whose contacts have an oracle of their own.

use std::cmp::Ordering;

use dashu_int::IBig;
use septum::contact::{Contact, ContactWith, contact, least_translation};
use septum::{Capsule, Sphere, Triangle};

use super::{CapsuleCase, Other, SphereCase, Squared};
use crate::sample::Sample;
use crate::{
    Each,
    exact::{Parts, least_exponent, whole},
};

/// What a contact was found to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    Nothing,
    /// The segment is outside.
    Shallow,
    /// The segment is inside, or touches.
    Deep,
}

/// A contact in both orders.
type Both<S> = [Option<Contact<S>>; 2];

fn both<S: Sample, A, B>(round: &A, flat: &B) -> Both<S>
where
    A: ContactWith<S, B>,
    B: ContactWith<S, A>,
{
    let found = [contact(round, flat), contact(flat, round)];
    let alone = [least_translation(round, flat), least_translation(flat, round)];
    assert_eq!(alone, found.each(|c| c.map(|c| c.translation)));
    found
}

impl<S: Sample> CapsuleCase<S> {
    /// The crate's answers, with the capsule first and second, and the depth of its segment alone;
    /// `None` if the other shape is neither a triangle nor a box.
    fn contacts(&self) -> Option<(Both<S>, S)> {
        let [a, b] = self.ends;
        let capsule = Capsule::new(a, b, self.radius).expect("a capsule");
        let segment = Triangle::new(a, b, b).expect("finite");
        let sphere = Sphere::new(a, self.radius).expect("a sphere");
        let depth = |found: Option<Contact<S>>| found.map_or(S::ZERO, |c| c.translation.depth);
        let (found, of_sphere, core) = match self.other {
            Other::Triangle([p, q, r]) => {
                let t = Triangle::new(p, q, r).expect("finite");
                (both(&capsule, &t), both(&sphere, &t), depth(contact(&segment, &t)))
            }
            Other::Box(numbers) => {
                let aabb = numbers.shape().ok()?;
                (both(&capsule, &aabb), both(&sphere, &aabb), depth(contact(&segment, &aabb)))
            }
            _ => return None,
        };
        if a == b {
            assert_eq!(format!("{found:?}"), format!("{of_sphere:?}"), "{self:?}");
        }
        Some((found, core))
    }

    /// Checks the crate's answers, and says what they are; `None` if the other shape is neither a
    /// triangle nor a box, or the vector beyond the range.
    ///
    /// # Panics
    /// If something is wrong.
    pub fn check_contacts(&self) -> Option<Found> {
        let (found, core) = self.contacts()?;
        let squared = self.squared();
        let is_deep = squared.num == IBig::ZERO;
        let is_contact = if self.radius == S::ZERO {
            core > S::ZERO
        } else {
            squared.compare(&[self.radius.mantissa_exponent()]) == Ordering::Less
        };
        assert!(found.iter().all(|c| c.is_some() == is_contact), "{found:?} {self:?}");
        let [Some(first), Some(second)] = found else { return Some(Found::Nothing) };
        let t = first.translation;
        // The order matters to the sign alone.
        let reverse = second.translation;
        let is_sufficient = t.is_sufficient && reverse.is_sufficient;
        assert_eq!(t.depth, reverse.depth, "{self:?}");
        let back = reverse.vector.to_array();
        if is_sufficient {
            let are_opposite = (0..3).all(|i| {
                let [x, y] = [t.vector.to_array()[i], back[i]].each(S::mantissa_exponent);
                x.0 == -y.0 && (x.1 == y.1 || x.0 == 0)
            });
            assert!(are_opposite, "{t:?} {reverse:?} {self:?}");
        }
        if t.is_sufficient {
            let after = self.squared_after(t.vector.to_array());
            let order = after.compare(&[self.radius.mantissa_exponent()]);
            assert!(order.is_ge() || self.radius == S::ZERO, "not parted: {t:?} {self:?}");
        }
        if t.depth.is_finite() && t.depth < S::GREATEST {
            if is_deep {
                let (depth, sum) = (t.depth.approximate(), core.approximate());
                let ulp = [t.depth, core].each(|x| x.approximate() - inward(x).approximate());
                let off = (depth - (sum + self.radius.approximate())).abs();
                let most = 2.0 * ulp[0].abs().max(ulp[1].abs()) + depth * 1e-15;
                assert!(off <= most, "{depth} {sum} {self:?}");
            } else {
                self.check_depth(t.depth, &squared);
            }
        }
        for c in [&first, &second] {
            self.check_point(c);
        }
        is_sufficient.then_some(if is_deep { Found::Deep } else { Found::Shallow })
    }

    /// The depth is at least the radius less the distance, and the number before it is less than
    /// 2^-55 of that above it.
    fn check_depth(&self, depth: S, squared: &Squared) {
        let parts = [self.radius, depth, inward(depth)].each(S::mantissa_exponent);
        let unit = least_exponent(&parts).min(squared.unit);
        let [radius, depth, before]: [IBig; 3] = parts.each(|x: Parts| whole(x, unit));
        let num = &squared.num << (2 * (squared.unit - unit) as usize);
        let rest = &radius - &depth;
        let is_enough = rest <= IBig::ZERO || &rest * &rest * &squared.den <= num;
        assert!(is_enough, "depth too small: {self:?}");
        // r·(2^55 + 1) − before·2^55 > d·(2^55 + 1)
        let near = (IBig::ONE << 55) + IBig::ONE;
        let rest = radius * &near - (before << 55);
        let is_near = rest > IBig::ZERO && &rest * &rest * &squared.den > num * &near * &near;
        assert!(is_near, "depth too great: {self:?}");
    }

    /// The point of the flat shape lies on it, and that of the capsule on its surface, as far below
    /// as the depth says.
    fn check_point(&self, c: &Contact<S>) {
        let [point] = c.points() else { panic!("{c:?}") };
        let t = c.translation;
        let all = [point.on_first, point.on_second, t.vector, t.normal].each(|p| p.to_array());
        let is_within = |x: &S| x.is_finite() && *x > S::LEAST && *x < S::GREATEST;
        let is_unit = |x: &S| is_within(x) || S::GREATEST.approximate() < 1.0;
        if !all[..3].as_flattened().iter().chain([&t.depth]).all(is_within)
            || !all[3].iter().all(is_unit)
        {
            return;
        }
        let near = |x: S| (x.approximate() - inward(x).approximate()).abs();
        let [on_first, on_second, ..] = all;
        let ends = all.iter().chain(&self.ends).flatten();
        let size = ends.fold(self.radius.approximate(), |size, x| size.max(x.approximate().abs()));
        // Beyond this the distances below overflow.
        if size > f64::MAX / 8.0 {
            return;
        }
        let unit =
            all.as_flattened().iter().chain([&t.depth]).fold(0.0, |u: f64, x| u.max(near(*x)));
        let most = 1e-12 * size + 4.0 * unit;
        // A type without 1 has its greatest number in place of most coordinates of a normal.
        for i in (0..3).filter(|&i| is_within(&all[3][i])) {
            let along = on_second[i].approximate() - on_first[i].approximate();
            let step = t.normal.to_array()[i].approximate() * t.depth.approximate();
            // A unit of the normal, over the depth.
            let of_normal = near(t.normal.to_array()[i]) * t.depth.approximate();
            assert!((along - step).abs() <= most + of_normal, "{along} {step} {c:?} {self:?}");
        }
        // One lies on the flat shape, and one at the radius from the segment, within roundings.
        let from_flat =
            |center| SphereCase { center, radius: self.radius, other: self.other }.squared().root();
        let from_core = |center| {
            let other = Other::Ends(self.ends);
            SphereCase { center, radius: self.radius, other }.squared().root()
        };
        let is_on = |flat, round| {
            let surface = (from_core(round) - self.radius.approximate()).abs();
            from_flat(flat) <= 2.0 * most && surface <= 4.0 * most
        };
        let is_right = is_on(on_second, on_first) || is_on(on_first, on_second);
        assert!(is_right, "{c:?} {self:?}");
    }
}

/// The next number toward zero.
fn inward<S: Sample>(x: S) -> S {
    x.moved(if x > S::ZERO { -1 } else { 1 })
}
