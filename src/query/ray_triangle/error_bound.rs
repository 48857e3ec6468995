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

//!
//! # In two parts
//!
//! In `super::refined` a component x of a vector of size s (D, E or R) is cut at a grid:
//! x = h + l, with h a multiple of g, |h| ≤ (2^25 + 1)·g, and |l| ≤ η·s, η = 2^-25, but for
//! a trifle of 2^-28 (`arithmetic::split`). l takes the error of the difference along. A
//! component of an area is (h h − h h) + (h l + l x − h l − l x). The first bracket comes to
//! less than 2^52 times its unit, so it is exact. It is cut again: at 26 bits, and the rest
//! is at most η times its size. The three products of its higher part with h come to less
//! than 3·2^51 + 2^30 units together, so their sum, H, is exact as well. What errs is L, the
//! rest. In units of u·η·D·E·R, u the unit roundoff:
//!
//! * l: 1. h·l + l·x: 2 for l, 1 for x, 2 products, 2 for the sum, of at most 2 η: 7. The
//!   difference of two, of at most 4 η: 18. With what was cut off, 5 η: m, 23.
//! * m·x: 23, 5 for x, 5 for the product. h·l, with h ≤ 2: 2 and 2. Their sum, of at most
//!   7 η: 44. Three of them: 132, and their sums, of at most 14 η and 21 η: 167.
//! * H + L is X and what its rounding took, without loss if |H| ≥ |L|. If not, X − H may be
//!   rounded, and 21 is lost: 188. [`REFINED`] = 192. So w errs by at most 3·188 and some
//!   roundings of u·u, of 3·192.
//!
//! Nothing is lost where all l are zero. What was cut off an area is less than 2^25 + 3
//! units, L a sum of three products of that with h, and like H less than 2^53 units. X is
//! zero only if H + L is. det is a multiple of g³, taking g of the edges twice, u and v of
//! no less, for R ≥ E. The roundings that are added for w come to less than
//! 2^6·u·D·E·R ≤ 2^28·R/E units: while R ≤ 2^20·E their sum is exact too.
//!
//! A quotient of two X is divided once; what the roundings took is divided by the rounded
//! divisor and added. In `f64` it is good if what both X may err comes to u/2 of it: 1/2 ulp
//! for the division, 1/2 for both X, 1/2 for the sum (1 where that passes a power of two),
//! together 2 at most. In `f32` it is good if the error leaves no doubt to which number it
//! rounds. So it is the number that the integers would give, and machines to which `f64` is
//! dear need not ask.
//!
//! D, E and R are in range: units of volumes are multiples of 2^-1038, which `f64` holds,
//! and what underflows besides is below 2^-40 of the bound.

/// Roundoffs in the determinant, u and v.
pub(super) const VOLUME: u16 = 44;

/// Roundoffs in the numerator of t.
pub(super) const T: u16 = 50;

/// Roundoffs in w, the difference of the others.
pub(super) const SIDES: u16 = 160;

/// What [`REFINED`] counts, in roundoffs: 2^-25.
pub(super) const REFINED_UNIT: f64 = 1.0 / 33_554_432.0;

/// Roundoffs, times 2^-25, in the volumes in two parts.
pub(super) const REFINED: u16 = 192;

#[cfg(test)]
mod tests {
    extern crate std;

    use core::cmp::Ordering;
    use std::format;

    use super::super::crossing::Setting;
    use super::super::exact::ExactRay;
    use super::super::refined::Refined;
    use crate::arithmetic::{Filtered, Float};
    use crate::robust::{ExactSum, Sum};
    use crate::scalar::Backend;

    /// The three vertices, the origin and the direction.
    type Case = [[f64; 3]; 5];

    /// Whether `exact` − `computed` exceeds `bound` in magnitude.
    fn exceeds(exact: &Sum<132>, computed: f64, bound: f64) -> bool {
        exceeds_sum(exact, [computed, 0.0], bound)
    }

    /// The same of a sum of two.
    fn exceeds_sum(exact: &Sum<132>, computed: [f64; 2], bound: f64) -> bool {
        let beyond = |bound: f64| {
            let mut sum = *exact;
            for part in computed {
                sum.add(&[Float::parts(-part), f64::ONE, f64::ONE]);
            }
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

    /// That no volume in two parts is farther from the truth than its bound, and exact
    /// where it says so; and whether u is by `share` of the bound or more.
    fn check_refined([a, b, c, o, d]: Case, share: f64) -> bool {
        let refined = Refined::new(&[a, b, c, o], d).0;
        let exact = ExactRay::new::<f64>(&[a, b, c], &o, &d).crossing::<f64>();
        let (crossing, is_exact) = refined.crossing();
        let [w, u, v] = crossing.sides;
        let told = || format!("{a:?} {b:?} {c:?} {o:?} {d:?}");
        for (exact, computed, bound) in [
            (&exact.det, [crossing.det, refined.low_det], refined.det_error),
            (&exact.t, [crossing.t, refined.low_t], crossing.error_bound.t),
            (&exact.sides[1], [u, refined.low_u], crossing.error_bound.side),
            (&exact.sides[2], [v, refined.low_v], crossing.error_bound.side),
        ] {
            let bound = if is_exact { 0.0 } else { bound };
            assert!(!exceeds_sum(exact, computed, bound), "{}", told());
        }
        // What w is rounded by last changes no sign.
        let rounding = w.abs() * f64::EPSILON / 2.0;
        assert!(!exceeds(&exact.sides[0], w, crossing.error_bound.sides + rounding), "{}", told());
        if is_exact {
            assert_eq!(w.partial_cmp(&0.0), Some(exact.sides[0].sign()), "{}", told());
        }
        exceeds_sum(&exact.sides[1], [u, refined.low_u], crossing.error_bound.side * share)
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
        let (mut of_some_size, mut of_some_size_refined) = (0, 0);
        for case in 0..20_000 {
            // From all alike to all small beside one vertex.
            let small = Float::scaled(1, -(case % 50));
            let mut vector = |size: f64| [(); 3].map(|()| random() * size);
            let case = [vector(1.0), vector(small), vector(small), vector(small), vector(1.0)];
            of_some_size += u32::from(check(case, 2.0));
            of_some_size_refined += u32::from(check_refined(case, 1.0 / 64.0));
        }
        assert!(of_some_size > 100, "{of_some_size} of 20,000 errors are of some size");
        assert!(of_some_size_refined > 100, "{of_some_size_refined} in two parts");
    }

    /// Whole numbers of up to 24 bits, and far fewer, some in the plane or on an edge.
    #[test]
    fn short_numbers_lose_nothing() {
        let mut seed = 2_u64;
        let mut whole = |most: i64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ((seed >> 33) as i64 % (2 * most + 1) - most) as f64
        };
        let mut zeros = 0;
        for case in 0..20_000 {
            let most = if case % 2 == 0 { 2 } else { (1 << 23) - 1 };
            let mut vector = || [(); 3].map(|()| whole(most));
            let (a, b, c, o, mut d) = (vector(), vector(), vector(), vector(), vector());
            if case % 4 == 3 {
                // At the middle of an edge.
                d = [0, 1, 2].map(|i| (b[i] + c[i]) / 2.0 - o[i]);
            }
            let (refined, is_known) = Refined::new(&[a, b, c, o], d);
            if !is_known {
                continue;
            }
            let (crossing, is_exact) = refined.crossing();
            assert!(is_exact, "{a:?} {b:?} {c:?} {o:?} {d:?}");
            check_refined([a, b, c, o, d], 0.0);
            zeros += u32::from(crossing.sides.contains(&0.0));
        }
        assert!(zeros > 5_000, "{zeros} zeros");
    }
}
