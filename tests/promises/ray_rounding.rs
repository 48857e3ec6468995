//! t, u and v of `ray.hit`: the nearest numbers in fixed point, and within 2 ulp in floats.

use fixed::FixedI8;
use fixed::types::extra::{LeEqU8, U0, U4, U7};
use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::{Ray, Triangle};
use septum_kit::rays::{RayCase, RaySet, crossing};
use septum_kit::{Each, Rng, Sample, three};

/// num / den to the nearest, ties to even, clamped to 8 bits.
fn nearest(num: i32, den: i32) -> i32 {
    let (num, den) = if den < 0 { (-num, -den) } else { (num, den) };
    let (q, r) = (num.div_euclid(den), num.rem_euclid(den));
    let up = 2 * r > den || 2 * r == den && q % 2 != 0;
    (q + i32::from(up)).clamp(-128, 127)
}

fn fixed<Frac: LeEqU8>(bits: i32) -> FixedI8<Frac> {
    FixedI8::from_bits(bits as i8)
}

/// All t of an 8-bit type: the ray from every height with every step, which gives every quotient with
/// the plane at the ends of the range, and the signs of all numbers with the plane near the middle.
fn every_t<Frac: LeEqU8 + Send + Sync + 'static>() {
    let at = fixed::<Frac>;
    let mut ends = 0;
    for height in [-128, -1, 0, 1, 127] {
        let corner = |x, y| [at(x), at(y), at(height)];
        let floor = Triangle::new(corner(-99, -99), corner(99, -99), corner(0, 99)).unwrap();
        for step in (-128..128).filter(|&step| step != 0) {
            for origin in -128..128 {
                let ray = Ray::new([at(0), at(0), at(origin)], [at(0), at(0), at(step)]).unwrap();
                let hit = ray.with_range(None, None).unwrap().hit(&floor).expect("it crosses");
                let expected = nearest((height - origin) << Frac::U32, step);
                assert_eq!(i32::from(hit.t.to_bits()), expected, "{height}, {origin}, {step}");
                ends += u32::from(expected == 127 || expected == -128);
            }
        }
    }
    assert!(ends > 500);
}

/// All u and v of an 8-bit type on the edges of right triangles of every length, at the ends of the
/// range and around the middle.
fn every_u_and_v<Frac: LeEqU8 + Send + Sync + 'static>() {
    let at = fixed::<Frac>;
    for a in [-128, -127, -65, -1, 0, 1, 66, 126, 127] {
        for b in (-128..128).filter(|&b| b != a) {
            let far = if a < 0 { 127 } else { -128 };
            let along_x = [[a, a], [b, a], [a, far]].each(|[x, y]| [at(x), at(y), at(0)]);
            let along_y = [[a, a], [far, a], [a, b]].each(|[x, y]| [at(x), at(y), at(0)]);
            let [along_x, along_y] =
                [along_x, along_y].each(|[p, q, r]| Triangle::new(p, q, r).unwrap());
            for x in a.min(b)..=a.max(b) {
                let down = [at(0), at(0), at(-1)];
                let expected = nearest((x - a) << Frac::U32, b - a);
                let hit = Ray::new([at(x), at(a), at(3)], down).unwrap().hit(&along_x).unwrap();
                assert_eq!((hit.u.to_bits().into(), hit.v), (expected, at(0)), "{a}, {b}, {x}");
                let hit = Ray::new([at(a), at(x), at(3)], down).unwrap().hit(&along_y).unwrap();
                assert_eq!((hit.u, hit.v.to_bits().into()), (at(0), expected), "{a}, {b}, {x}");
            }
        }
    }
}

#[test]
fn every_t_of_i4f4() {
    every_t::<U4>();
}

#[test]
fn every_t_of_i8f0_and_i1f7() {
    every_t::<U0>();
    every_t::<U7>();
}

#[test]
fn every_u_and_v_of_8_bits() {
    every_u_and_v::<U4>();
    every_u_and_v::<U0>();
    every_u_and_v::<U7>();
}

fn is_nearest_on_every_set<S: Sample>() {
    for set in RaySet::ALL {
        for case in set.cases::<S>(51, 10_000) {
            let Some(truth) = crossing(&case) else { continue };
            let hit = case.ray().hit(&case.triangle()).expect("a hit");
            for (name, x, truth) in
                [("t", hit.t, &truth.t), ("u", hit.u, &truth.u), ("v", hit.v, &truth.v)]
            {
                assert!(
                    truth.is_nearest(x),
                    "{set:?}: {name} is {}: {case:?}",
                    truth.approximate()
                );
            }
        }
    }
}

#[test]
fn nearest_in_i4f4_and_i8f8() {
    is_nearest_on_every_set::<I4F4>();
    is_nearest_on_every_set::<I8F8>();
}

#[test]
fn nearest_in_i16f16() {
    is_nearest_on_every_set::<I16F16>();
}

#[test]
fn nearest_in_i32f32() {
    is_nearest_on_every_set::<I32F32>();
}

/// Checks that the numbers of a hit are within 2 ulp; returns whether there is a hit.
fn check<S: Sample>(case: &RayCase<S>, told: &str) -> bool {
    let Some(truth) = crossing(case) else { return false };
    let hit = case.ray().hit(&case.triangle()).expect("a hit");
    for (name, x, truth) in [("t", hit.t, &truth.t), ("u", hit.u, &truth.u), ("v", hit.v, &truth.v)]
    {
        // Beyond the greatest float there is no ulp.
        if !truth.is_beyond::<S>() {
            let error = truth.error_in_ulp(x);
            assert!(error <= 2.0, "{told}: {name} is {error} ulp off: {case:?}");
        }
    }
    true
}

fn within_2_ulp_on_every_set<S: Sample>() {
    for set in RaySet::ALL {
        for case in set.cases::<S>(52, 20_000) {
            check(&case, set.name());
        }
    }
}

#[test]
fn within_2_ulp_in_f32() {
    within_2_ulp_on_every_set::<f32>();
}

#[test]
fn within_2_ulp_in_f64() {
    within_2_ulp_on_every_set::<f64>();
}

/// Coordinates without a common unit that 60 bits can hold, so that differences are rounded and
/// integers overflow: products of two numbers, some of them tiny. The ray aims at the interior, at
/// an edge, or nearly within the plane, from near the triangle or far away.
#[test]
fn within_2_ulp_of_long_numbers_in_f64() {
    let mut rng = Rng::new(53);
    let mut hits = 0;
    for case in 0..60_000 {
        let spread = [0, 0, 12, 40][case / 4 % 4];
        let number = |rng: &mut Rng| {
            let size = f64::from_bits((1023 - rng.below(spread + 1) as u64) << 52);
            rng.real(-1.0, 1.0) * rng.real(-1.0, 1.0) * size
        };
        let [a, b, c, o] = [(); 4].each(|()| rng.triple(number));
        let (u, v) = match case % 4 {
            0 => (rng.real(0.0, 1.0), 0.0),
            1 => (rng.real(0.0, 1e-6), rng.real(0.0, 1e-9)),
            _ => (rng.real(0.0, 0.5), rng.real(0.0, 0.5)),
        };
        let target = three(|i| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]));
        let far = [1.0, 1e-3, 1e5][case % 3];
        let direction = three(|i| (target[i] - o[i] * far) / 3.0);
        let case = RayCase::new(o.each(|x| x * far), direction, [a, b, c]);
        hits += usize::from(check(&case, "long"));
    }
    assert!(hits > 30_000, "{hits} hits");
}
