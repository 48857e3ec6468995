//! How far the volumes of a ray and a triangle may be from the truth.
//!
//! All to first order in u, the unit roundoff. D is the greatest magnitude among the
//! components of the direction, E that of both edges, and R that of the edges and the way
//! to the origin. Edges and that way are differences and carry one rounding each, the
//! direction none.
//!
//! * det, u and v, in units of u·D·E·R: 6 terms each, every one a product of three
//!   components and so at most D·E·R. At most 7 roundings touch a term: 2 differences, 2
//!   products, 1 difference of products, 2 sums. 6·7 = 42; [`VOLUME`] = 44.
//! * t, in units of u·E·E·R: the same with 3 differences. 6·8 = 48; [`T`] = 50.
//! * w = det − u − v: 3·42, and the two differences, of at most 12 and 18: 156; [`SIDES`]
//!   = 160.
//!
//! # What the first order leaves out
//!
//! Terms in u² are below 156·u of the bounds. D, E and R are greatest ones of computed
//! components, which may fall short by u of themselves, and a bound is computed with 3
//! roundings: 6·u together. 2 of 42 is enough for all of it. Underflow: each of D, E and R
//! is within [`Float::RANGE`](crate::arithmetic::Float::RANGE), so u times the product of
//! any two exceeds by far what an operation can lose. `error_bound.g` proves all three
//! bounds with both.

/// Roundoffs in the determinant, u and v.
pub(super) const VOLUME: u16 = 44;

/// Roundoffs in the numerator of t.
pub(super) const T: u16 = 50;

/// Roundoffs in w, the difference of the others.
pub(super) const SIDES: u16 = 160;

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use super::super::crossing::Setting;
    use super::super::exact::ExactRay;
    use crate::arithmetic::{Filtered, Float};
    use crate::robust::{ExactSum, Sum};
    use crate::scalar::Backend;

    /// The three vertices, the origin and the direction.
    type Case = [[f64; 3]; 5];

    /// Whether `exact` − `computed` exceeds `bound` in magnitude.
    fn exceeds(exact: &Sum<132>, computed: f64, bound: f64) -> bool {
        let beyond = |bound: f64| {
            let mut sum = *exact;
            sum.add(&[Float::parts(-computed), f64::ONE, f64::ONE]);
            sum.add(&[Float::parts(bound), f64::ONE, f64::ONE]);
            sum.sign()
        };
        beyond(-bound) == Ordering::Greater || beyond(bound) == Ordering::Less
    }

    /// That no volume is farther from the truth than its bound; and whether u is by
    /// `roundoffs` or more.
    fn check([a, b, c, o, d]: Case, roundoffs: f64) -> bool {
        let crossing = Setting::new(&[a, b, c, o], d).crossing::<Filtered<f64>>().unwrap();
        let exact = ExactRay::new::<f64>(&[a, b, c], &o, &d).crossing::<f64>();
        let bound = &crossing.error_bound;
        let [w, u, v] = crossing.sides;
        for (exact, computed, bound) in [
            (&exact.det, crossing.det, bound.side),
            (&exact.t, crossing.t, bound.t),
            (&exact.sides[0], w, bound.sides),
            (&exact.sides[1], u, bound.side),
            (&exact.sides[2], v, bound.side),
        ] {
            assert!(!exceeds(exact, computed, bound), "{a:?} {b:?} {c:?} {o:?} {d:?}");
        }
        exceeds(&exact.sides[1], u, bound.side / f64::from(super::VOLUME) * roundoffs)
    }

    /// Found by a search uphill: one vertex far from all else, so that
    /// differences round, and all components alike.
    const KEPT: Case = [
        [1.0117888875055894, 1.008604519000462, 1.015084121972458],
        [5.655298613440178e-14, -1.5578537489051503e-14, 1.7660217965650408e-14],
        [-5.762057497804564e-14, -1.898481372109018e-14, 8.182343691487404e-14],
        [-7.516209876711536e-14, -1.1157741397482822e-13, 8.204548151979907e-14],
        [1.0003419137379481, -1.0062783642093733, -1.0035650472345592],
    ];

    #[test]
    fn errors_of_more_than_half_the_bound_are_within_it() {
        assert!(check(KEPT, 22.0));
        assert!(!check(KEPT, 23.0));
    }

    #[test]
    fn no_error_exceeds_its_bound() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let mut of_some_size = 0;
        for case in 0..20_000 {
            // From all alike to all small beside one vertex.
            let small = Float::scaled(1, -(case % 50));
            let mut vector = |size: f64| [(); 3].map(|()| random() * size);
            let case = [vector(1.0), vector(small), vector(small), vector(small), vector(1.0)];
            of_some_size += u32::from(check(case, 2.0));
        }
        assert!(of_some_size > 100, "{of_some_size} of 20,000 errors are of some size");
    }
}
