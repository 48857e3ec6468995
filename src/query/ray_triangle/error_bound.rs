//! The errors of the volumes of a ray and a triangle.
//!
//! D is the greatest magnitude among the components of the direction, E among those of both edges,
//! and R among those of the edges and the vector to the origin. Edges and that vector are
//! differences with one rounding each; the direction is exact. D, E and R are within
//! [`Float::RANGE`](crate::arithmetic::Float::RANGE).
//!
//! `error_bound.g` proves, second orders and underflow included:
//!
//! * det, u and v err by at most [`VOLUME`] roundoffs of D·E·R,
//! * t by at most [`T`] roundoffs of E·E·R,
//! * w = det − u − v by at most [`SIDES`] roundoffs of D·E·R.

/// Roundoffs in the determinant, u and v.
pub(super) const VOLUME: u16 = 44;

/// Roundoffs in the numerator of t.
pub(super) const T: u16 = 50;

/// Roundoffs in w, the difference of the three.
pub(super) const SIDES: u16 = 160;

#[cfg(test)]
mod tests {
    extern crate std;

    use std::format;

    use super::super::kernel::truth::{exact_crossing, exceeds};
    use super::super::kernel::{Crossing, Setting};
    use super::super::refined::Refined;
    use super::super::residual::Numbers;
    use crate::arithmetic::{Each, Filtered, Float};
    use crate::random::Random;
    use crate::scalar::Backend;
    use crate::shape::{Ray, Triangle};

    /// The three vertices, the origin and the direction.
    type Case = [[f64; 3]; 5];

    /// Checks that every volume is within its bound; returns whether u errs by `roundoffs` or more.
    fn check([a, b, c, o, d]: Case, roundoffs: f64) -> bool {
        let setting = Setting::new(&[a, b, c, o], d);
        assert!(setting.sizes().are_in_range());
        let crossing = setting.volumes::<Filtered<f64>>();
        let bound = setting.sizes().errors::<Filtered<f64>>();
        let exact = exact_crossing([a, b, c, o], d);
        let [w, u, v] = crossing.sides;
        for (exact, computed, bound) in [
            (&exact.det, crossing.det, bound.side),
            (&exact.t, crossing.t, bound.t),
            (&exact.sides[0], w, bound.sides),
            (&exact.sides[1], u, bound.side),
            (&exact.sides[2], v, bound.side),
        ] {
            assert!(!exceeds(exact, &[computed], bound), "{a:?} {b:?} {c:?} {o:?} {d:?}");
        }
        exceeds(&exact.sides[1], &[u], bound.side / f64::from(super::VOLUME) * roundoffs)
    }

    /// Checks that every volume in two parts is within its bound and a rounding, and exact where it
    /// claims to be; returns whether u errs by `share` of the bound or more.
    fn check_refined([a, b, c, o, d]: Case, share: f64) -> bool {
        let refined = Refined::new(&[a, b, c, o], d).0;
        let exact = exact_crossing([a, b, c, o], d);
        let (crossing, errors, is_exact) = refined.crossing();
        let [w, u, v] = crossing.sides;
        let rounding = |x: f64| x.abs() * f64::EPSILON / 2.0;
        let told = || format!("{a:?} {b:?} {c:?} {o:?} {d:?}");
        for (exact, computed, bound) in [
            (&exact.det, [crossing.det, refined.low_det], errors.side),
            (&exact.t, [crossing.t, 0.0], errors.t + rounding(crossing.t)),
            (&exact.sides[1], [u, refined.low_u], errors.side),
            (&exact.sides[2], [v, refined.low_v], errors.side),
        ] {
            let bound = if is_exact && computed[1] != 0.0 { 0.0 } else { bound };
            assert!(!exceeds(exact, &computed, bound), "{}", told());
        }
        // The last rounding of w changes no sign.
        let bound = errors.sides + rounding(w);
        assert!(!exceeds(&exact.sides[0], &[w], bound), "{}", told());
        if is_exact {
            assert_eq!(w.partial_cmp(&0.0), Some(exact.sides[0].sign()), "{}", told());
        }
        exceeds(&exact.sides[1], &[u, refined.low_u], errors.side * share)
    }

    /// For a ray that hits: checks that t, u and v are within their error bounds and half an ulp;
    /// returns whether a number errs by a notable part of its bound.
    fn check_numbers([a, b, c, o, d]: Case) -> bool {
        let (points, setting) = ([a, b, c, o], Setting::new(&[a, b, c, o], d));
        let Crossing { det, t, sides: [_, u, v] } = setting.volumes::<Filtered<f64>>();
        let volumes = [det, t, u, v];
        let numbers = Numbers::new(true, &points, d, volumes, setting.sizes());
        if !numbers.is_known {
            return false;
        }
        let exact = exact_crossing([a, b, c, o], d);
        let truths =
            [&exact.t, &exact.sides[1], &exact.sides[2]].each(|x| f64::quotient(x, &exact.det));
        let mut is_of_some_size = false;
        for ((number, error), truth) in numbers.numbers.into_iter().zip(truths) {
            // Half an ulp for the truth, which is rounded as well.
            let distance = (number - truth).abs() - truth.abs() * f64::EPSILON * 1.01;
            assert!(distance <= error, "{a:?} {b:?} {c:?} {o:?} {d:?}");
            is_of_some_size |= distance > error / 2048.0;
        }
        is_of_some_size
    }

    /// Found by a hill-climbing search: one vertex far from the rest, so that differences round,
    /// and all components of similar size.
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
        let mut random = Random(1);
        let (mut of_some_size, mut of_some_size_refined) = (0, 0);
        for case in 0..20_000 {
            // From vectors of equal size to all small except one vertex.
            let small = Float::scaled(1, -(case % 50));
            let mut vector = |size: f64| [(); 3].each(|()| random.number() * size);
            let case = [vector(1.0), vector(small), vector(small), vector(small), vector(1.0)];
            of_some_size += u32::from(check(case, 2.0));
            of_some_size_refined += u32::from(check_refined(case, 1.0 / 64.0));
        }
        assert!(of_some_size > 100, "{of_some_size} of 20,000 errors are of some size");
        assert!(of_some_size_refined > 100, "{of_some_size_refined} in two parts");
    }

    #[test]
    fn numbers_are_as_near_as_they_say() {
        let mut random = Random(3);
        let mut of_some_size = 0;
        for case in 0..30_000_i32 {
            // Slivers, far origins and positions far from zero; a third of the rays at edges.
            let [thin, far, away] = [case % 20, case % 7 * 3, case % 11 * 3];
            let mut vector = |size: f64| [(); 3].each(|()| random.number() * size);
            let (a, ab) = (vector(Float::scaled(1, away)), vector(1.0));
            let (ac, way) = (vector(Float::scaled(1, -thin)), vector(Float::scaled(1, far)));
            let plus = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
            let (b, c) = (plus(a, ab), plus(a, if case % 2 == 0 { plus(ab, ac) } else { ac }));
            let (o, mut u) = (plus(a, way), random.number().abs());
            if case % 3 == 0 {
                u *= <f64 as Float>::scaled(1, -case % 60);
            }
            let v = (1.0 - u) * random.number().abs();
            let aim = [0, 1, 2].each(|i| (b[i] - a[i]) * u + (c[i] - a[i]) * v + (a[i] - o[i]));
            let is_hit = Ray::new(o, aim).is_ok_and(|ray| {
                Triangle::new(a, b, c).is_ok_and(|triangle| ray.is_hit(&triangle))
            });
            of_some_size += u32::from(is_hit && check_numbers([a, b, c, o, aim]));
        }
        assert!(of_some_size > 100, "{of_some_size} errors are of some size");
    }

    /// Integers of up to 24 bits, and of far fewer, some rays in the plane or through an edge.
    #[test]
    fn short_numbers_lose_nothing() {
        let mut random = Random(2);
        let mut whole = |most: i64| (random.below(2 * most as u64 + 1) - most) as f64;
        let mut zeros = 0;
        for case in 0..20_000 {
            let most = if case % 2 == 0 { 2 } else { (1 << 23) - 1 };
            let mut vector = || [(); 3].each(|()| whole(most));
            let (a, b, c, o, mut d) = (vector(), vector(), vector(), vector(), vector());
            if case % 4 == 3 {
                // Toward the midpoint of an edge.
                d = [0, 1, 2].each(|i| (b[i] + c[i]) / 2.0 - o[i]);
            }
            let (refined, is_known) = Refined::new(&[a, b, c, o], d);
            if !is_known {
                continue;
            }
            let (crossing, _, is_exact) = refined.crossing();
            assert!(is_exact, "{a:?} {b:?} {c:?} {o:?} {d:?}");
            check_refined([a, b, c, o, d], 0.0);
            zeros += u32::from(crossing.sides.contains(&0.0));
        }
        assert!(zeros > 5_000, "{zeros} zeros");
    }
}
