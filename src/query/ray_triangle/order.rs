//! Which of two triangles a ray hits first, exactly.

use core::cmp::Ordering;

use super::HitRules;
use super::crosses::Crosses;
use crate::arithmetic::{
    Each, Embeds, Limbed, Number, REGISTERS_ARE_WIDE, compare, order_of_products,
};
#[cfg(feature = "fixed")]
use crate::arithmetic::{InRaw, of_four};
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Ray, Triangle};

impl<S: Scalar> Ray<S> {
    /// Orders two triangles by the true t of their hits, for sorting. `None` unless the ray hits
    /// both.
    ///
    /// *Numerics*: exact for every valid input, in every scalar, even if the t of two
    /// [hits](Self::hit) are equal or in the wrong order because of rounding. `Equal` means the
    /// same point. The order is therefore transitive, and the same on every machine.
    ///
    /// *Panics*: never. *Cost*: two [hits](Self::hit); and exact integers, up to a thousand times
    /// slower, if the two rounded t are equal, or in floats within a relative 2⁻²⁰.
    ///
    /// *Source*: t is a quotient of two determinants. Quotients are compared by
    /// cross-multiplication.
    ///
    /// ```
    /// use septum::{Ray, Triangle};
    ///
    /// let ray = Ray::new([0.25_f32, 0.25, 9.0], [0.0, 0.0, -1.0])?;
    /// let at = |z: f32| Triangle::new([0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]);
    /// let mut floors = [at(-2.0)?, at(1e-9)?, at(3.0)?, at(0.0)?];
    /// floors.sort_by(|a, b| ray.compare_hits(a, b).unwrap());
    /// assert_eq!(floors, [at(3.0)?, at(1e-9)?, at(0.0)?, at(-2.0)?]);
    /// // The two in the middle have the same rounded t.
    /// assert_eq!(ray.hit(&floors[1]).unwrap().t, ray.hit(&floors[2]).unwrap().t);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn compare_hits(&self, a: &Triangle<S>, b: &Triangle<S>) -> Option<Ordering> {
        Some(self.compare_found((a, self.hit(a)?.t), (b, self.hit(b)?.t)))
    }

    /// The same for two triangles that the ray hits, given the t of each hit.
    #[inline]
    pub(crate) fn compare_found(
        &self,
        (a, t): (&Triangle<S>, S),
        (b, s): (&Triangle<S>, S),
    ) -> Ordering {
        in_clear_order(t, s).unwrap_or_else(|| self.compare_exactly(a, b))
    }

    #[cold]
    fn compare_exactly(&self, a: &Triangle<S>, b: &Triangle<S>) -> Ordering {
        // On a small core one width is enough, as in `in_exact_numbers`.
        let in_window =
            if REGISTERS_ARE_WIDE { self.compare_in::<S::SeptumWindow>(a, b) } else { None };
        in_window.or_else(|| self.compare_in::<S::SeptumFull>(a, b)).unwrap_or(Ordering::Equal)
    }

    /// The order in `N`, if it holds the coordinates.
    fn compare_in<N: Embeds<S, Volume: Limbed>>(
        &self,
        a: &Triangle<S>,
        b: &Triangle<S>,
    ) -> Option<Ordering> {
        let crossing = |triangle| {
            let crosses = Crosses { ray: self, triangle, rules: HitRules::default() };
            Some(crosses.setting::<N>()?.large_volumes::<N>())
        };
        let (a, b) = (crossing(a)?, crossing(b)?);
        Some(compare_quotients([a.t, a.det], [b.t, b.det]))
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar + InRaw<Raw = i32>> Near<Ray<S>> {
    /// The order of two hits of near triangles, given the t of each. Words of 64 bits hold the
    /// volumes.
    #[inline]
    pub(crate) fn compare_found(
        &self,
        (a, t): (&Triangle<S>, S),
        (b, s): (&Triangle<S>, S),
    ) -> Ordering {
        in_clear_order(t, s).unwrap_or_else(|| self.compare_exactly(a, b))
    }

    #[cold]
    #[inline(never)]
    fn compare_exactly(&self, a: &Triangle<S>, b: &Triangle<S>) -> Ordering {
        // Every hit is one under these rules too.
        let rules = HitRules::default();
        let crossing = |triangle| {
            let counted = Crosses { ray: self.get(), triangle, rules }.in_any_words::<i32>()?;
            Some((counted.volumes.t, counted.volumes.det))
        };
        // No divisor is below zero.
        match (crossing(a), crossing(b)) {
            (Some((t, of_t)), Some((s, of_s))) => of_four(t, of_s).cmp(&of_four(s, of_t)),
            _ => Ordering::Equal,
        }
    }
}

/// The order of two numbers rounded by `hit`, if their true order is certainly the same.
///
/// In fixed point rounding keeps the order. Floats are within 2⁻²² of the truth, or of its
/// underflowed value, and `f64` is far closer: a difference of 2⁻²⁰ is clear.
fn in_clear_order<S: Scalar>(t: S, s: S) -> Option<Ordering> {
    let is_clear = match S::FLOAT {
        None => t != s,
        Some(format) => {
            let size = t.plain_abs().plain_add(s.plain_abs());
            let margin = (0..20).fold(size, |x, _| x.plain_half()).plain_add(format.least_normal);
            // A NaN, if both are infinite, is not clear.
            t.plain_sub(s).plain_abs() > margin
        }
    };
    if is_clear { t.partial_cmp(&s) } else { None }
}

/// Compares two quotients; no divisor is zero.
pub(crate) fn compare_quotients<V: Number + Limbed>([a, b]: [V; 2], [c, d]: [V; 2]) -> Ordering {
    let sign = |num: V, den: V| {
        let sign = compare(num, V::ZERO);
        if den < V::ZERO { sign.reverse() } else { sign }
    };
    let (left, right) = (sign(a, b), sign(c, d));
    if left != right || left == Ordering::Equal {
        return left.cmp(&right);
    }
    let [a, b, c, d] = [a, b, c, d].each(V::magnitude);
    let order = order_of_products([a.limbs(), d.limbs()], [c.limbs(), b.limbs()]);
    if left == Ordering::Less { order.reverse() } else { order }
}

#[cfg(test)]
mod tests {
    use super::compare_quotients;
    use crate::arithmetic::BigInt;
    use crate::arithmetic::Each;

    #[test]
    fn quotients_compare_as_products_do() {
        let some: [i128; 11] =
            [-(1 << 62), 1 - (1 << 62), -5, -1, 0, 1, 3, 7, 1 << 32, (1 << 62) - 1, 1 << 62];
        let dens = || some.into_iter().filter(|&x| x != 0);
        for (a, c) in some.into_iter().flat_map(|a| some.map(|c| (a, c))) {
            for (b, d) in dens().flat_map(|b| dens().map(move |d| (b, d))) {
                let expected =
                    (a * d * b.signum() * d.signum()).cmp(&(c * b * b.signum() * d.signum()));
                let [p, q, r, s] = [a, b, c, d].each(BigInt::<3>::from);
                assert_eq!(compare_quotients([p, q], [r, s]), expected, "{a}/{b} {c}/{d}");
            }
        }
    }

    /// Numbers longer than a limb, with a common factor.
    #[test]
    fn carries_go_through_limbs() {
        let (m, one) = (i128::from(u64::MAX), 1);
        let quarter = (m / 2) * (m / 2);
        for (a, b, c, d) in
            [(quarter, m, m / 4, one), (-m * 8, quarter, -32, m), (m, m, m + 1, m + 1)]
        {
            let [p, q, r, s] = [a, b, c, d].each(BigInt::<3>::from);
            let order = compare_quotients([p, q], [r, s]);
            assert_eq!(compare_quotients([r, s], [p, q]), order.reverse());
            // By division with remainder.
            let (x, y) = ((a.div_euclid(b), a.rem_euclid(b)), (c.div_euclid(d), c.rem_euclid(d)));
            if x.0 != y.0 {
                assert_eq!(order, x.0.cmp(&y.0));
            } else if y.1 == 0 {
                assert_eq!(order, x.1.cmp(&0));
            }
        }
    }
}
