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
//! In `super::refined`, for signs, a component x of a vector of size s (D, E or R) is cut at a grid:
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
//! `refined.g` proves what L may err.
//!
//! Nothing is lost where all l are zero. What was cut off an area is less than 2^25 + 3
//! units, L a sum of three products of that with h, and like H less than 2^53 units. X is
//! zero only if H + L is. det is a multiple of g³, taking g of the edges twice, u and v of
//! no less, for R ≥ E. The roundings that are added for w come to less than
//! 2^6·u·D·E·R ≤ 2^28·R/E units: while R ≤ 2^20·E their sum is exact too.
//!
//! D, E and R are in range: units of volumes are multiples of 2^-1038, which `f64` holds,
//! and what underflows besides is below 2^-40 of the bound.
//!
//! # What is left over
//!
//! `super::residual` puts short numbers t', u' and v' into r = s + t'·d − u'·e1 − v'·e2, with
//! true ways and edges, of which r says how far they are from t, u and v. Below, P(x) is the power
//! of two below x, and ρ the relative error of the determinant. It is asked for that R ≤ 2^22·E
//! and ρ·R ≤ 2^-20·E, and known that the ray hits.
//!
//! * u' and v' are multiples of 2^-26, and at most 1 + 2^-18: they err by ρ and half a unit. t'
//!   is a multiple of τ = 2^-24·P(R)/P(D). The hit is no farther than E + R from the origin, so
//!   |t| ≤ 2·R/D, and |t'| < 1.05·2^26·τ.
//! * A component of e1, e2 or s is cut at G = 2^-25·P(E), of d at 2^-25·P(D). What is cut off is
//!   half of that at most, and exact. The lower part has what the rounding of the difference
//!   took besides.
//! * The higher parts: one of e1 or e2 is at most 2^26 units of G; times u' that is below 2^53
//!   units of 2^-26·G, and so is t'·d, below 2^26 + 1 times 1.05·2^26 units of 2^-49·P(R). So
//!   products are exact. s + t'·d is a way from the first vertex to near the hit: E, but for
//!   τ·D/2, for 3.2·ρ·R and for the lower parts, at most 2.8·P(E); and what comes after is no
//!   greater. All are multiples of 2^-51·P(E), for R ≥ E: below 2^53 units. So sums are exact too.
//! * The lower parts, in units of u·2^-25·R, times 1/u. Of s: 0.54, and errs by that. t'·d: 1.05
//!   and 1.05; the sum: 1.6. Those of e1 and e2: 0.5, and with u' and v' 0.5 and 0.5 each; the
//!   sums with them: 2.1 and 2.6. In all 0.54 + 1.05 + 1.6 + 3.1 + 3.6 = 9.9. r is that, and a
//!   rounding of its own.
//! * The kernel takes r for s. No difference for s, so the first bound has 6 roundings for each of
//!   6 terms, t 7. With that of r itself 42 and 48 roundoffs of D·E and E·E times the greatest of
//!   r; [`LEFT`] = 45 and [`LEFT_T`] = 51. What the lower parts err counts 6 times: 60 of u·2^-25
//!   times R; [`LOST`] = 64.
//! * Divided by the determinant: ρ, and 2 roundings, of what is added. ρ is at least
//!   44·u/6: 2·ρ. Then a rounding of the sum, 1/2 ulp.
//!
//! In `f64` numbers are good if the rest comes to u of them, at most 1 ulp. In `f32` they are good
//! if the error leaves no doubt to which number they round. So it is the number that the
//! integers would give, and machines to which `f64` is dear need not ask.
//!
//! `residual.g` proves the lower parts and the volumes of r, underflow included.

/// Roundoffs in the determinant, u and v.
pub(super) const VOLUME: u16 = 44;

/// Roundoffs in the numerator of t.
pub(super) const T: u16 = 50;

/// Roundoffs in w, the difference of the others.
pub(super) const SIDES: u16 = 160;

/// What [`REFINED`] and [`LOST`] count, in roundoffs: 2^-25.
pub(super) const CUT: f64 = 1.0 / 33_554_432.0;

/// Roundoffs, times 2^-25, in the volumes in two parts.
pub(super) const REFINED: u16 = 192;

/// Roundoffs in u and v of what is left over.
pub(super) const LEFT: u16 = 45;

/// Roundoffs in its t.
pub(super) const LEFT_T: u16 = 51;

/// Roundoffs, times 2^-25, in its volumes from what it errs itself.
pub(super) const LOST: u16 = 64;

#[cfg(test)]
mod tests {
    extern crate std;

    use core::cmp::Ordering;
    use std::format;

    use super::super::crossing::{Crossing, Setting};
    use super::super::exact::ExactRay;
    use super::super::refined::Refined;
    use super::super::residual::Numbers;
    use crate::arithmetic::{Filtered, Float};
    use crate::robust::{ExactSum, Sum};
    use crate::scalar::Backend;
    use crate::shape::{Ray, Triangle};

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

    /// That no volume in two parts is farther from the truth than its bound and a rounding, and
    /// exact where it says so; and whether u is by `share` of the bound or more.
    fn check_refined([a, b, c, o, d]: Case, share: f64) -> bool {
        let refined = Refined::new(&[a, b, c, o], d).0;
        let exact = ExactRay::new::<f64>(&[a, b, c], &o, &d).crossing::<f64>();
        let (crossing, is_exact) = refined.crossing();
        let [w, u, v] = crossing.sides;
        let rounding = |x: f64| x.abs() * f64::EPSILON / 2.0;
        let told = || format!("{a:?} {b:?} {c:?} {o:?} {d:?}");
        for (exact, computed, bound) in [
            (&exact.det, [crossing.det, refined.low_det], crossing.error_bound.side),
            (&exact.t, [crossing.t, 0.0], crossing.error_bound.t + rounding(crossing.t)),
            (&exact.sides[1], [u, refined.low_u], crossing.error_bound.side),
            (&exact.sides[2], [v, refined.low_v], crossing.error_bound.side),
        ] {
            let bound = if is_exact && computed[1] != 0.0 { 0.0 } else { bound };
            assert!(!exceeds_sum(exact, computed, bound), "{}", told());
        }
        // What w is rounded by last changes no sign.
        let bound = crossing.error_bound.sides + rounding(w);
        assert!(!exceeds(&exact.sides[0], w, bound), "{}", told());
        if is_exact {
            assert_eq!(w.partial_cmp(&0.0), Some(exact.sides[0].sign()), "{}", told());
        }
        exceeds_sum(&exact.sides[1], [u, refined.low_u], crossing.error_bound.side * share)
    }

    /// That t, u and v are no farther from the truth than they say, and half an ulp; and whether
    /// one of them is by some part of it. Of a ray that hits.
    fn check_numbers([a, b, c, o, d]: Case) -> bool {
        let (points, setting) = ([a, b, c, o], Setting::new(&[a, b, c, o], d));
        let Crossing { det, t, sides: [_, u, v], .. } = setting.volumes();
        let volumes = [det, t, u, v];
        let numbers = Numbers::new::<true>(&points, d, volumes, setting.sizes());
        if !numbers.is_known {
            return false;
        }
        let exact = ExactRay::new::<f64>(&[a, b, c], &o, &d).crossing::<f64>();
        let truths =
            [&exact.t, &exact.sides[1], &exact.sides[2]].map(|x| f64::quotient(x, &exact.det));
        let mut is_of_some_size = false;
        for ((number, error), truth) in numbers.numbers.into_iter().zip(truths) {
            // Half an ulp for the truth, which is rounded as well.
            let distance = (number - truth).abs() - truth.abs() * f64::EPSILON * 1.01;
            assert!(distance <= error, "{a:?} {b:?} {c:?} {o:?} {d:?}");
            is_of_some_size |= distance > error / 2048.0;
        }
        is_of_some_size
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

    #[test]
    fn numbers_are_as_near_as_they_say() {
        let mut seed = 3_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        let mut of_some_size = 0;
        for case in 0..30_000_i32 {
            // Slivers, far origins and all far from zero; a third at edges.
            let [thin, far, away] = [case % 20, case % 7 * 3, case % 11 * 3];
            let mut vector = |size: f64| [(); 3].map(|()| random() * size);
            let (a, ab) = (vector(Float::scaled(1, away)), vector(1.0));
            let (ac, way) = (vector(Float::scaled(1, -thin)), vector(Float::scaled(1, far)));
            let plus = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
            let (b, c) = (plus(a, ab), plus(a, if case % 2 == 0 { plus(ab, ac) } else { ac }));
            let (o, mut u) = (plus(a, way), random().abs());
            if case % 3 == 0 {
                u *= <f64 as Float>::scaled(1, -case % 60);
            }
            let v = (1.0 - u) * random().abs();
            let aim = [0, 1, 2].map(|i| (b[i] - a[i]) * u + (c[i] - a[i]) * v + (a[i] - o[i]));
            let is_hit = Ray::new(o, aim).is_ok_and(|ray| {
                Triangle::new(a, b, c).is_ok_and(|triangle| ray.is_hit(&triangle))
            });
            of_some_size += u32::from(is_hit && check_numbers([a, b, c, o, aim]));
        }
        assert!(of_some_size > 100, "{of_some_size} errors are of some size");
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
