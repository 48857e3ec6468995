//! The errors of the computed numbers, measured against integers of 128 bits.

use fixed::types::{I2F30, I4F4, I8F8, I16F16};

use super::*;
use crate::arithmetic::{Each, cross3, dot3, exp2};
use crate::random::Random;
use crate::shape::{Obb, Triangle, Vec3};

fn wide<S: InRaw>(v: Vec3<S>) -> [i128; 3] {
    raw(&v).each(|x| x.into().into())
}

/// The greatest part of the allowed error that occurred; `None` if a face separates.
fn found<S: Scalar + InRaw>(question: &Disjoint<'_, S>) -> Option<f64> {
    let framed = question.framed(Change::Grown, Disjoint::vertices_from_center)?;
    assert!(Projection::are_near(&framed.shapes), "{:?} {:?}", question.triangle, question.obb);
    let u = question.obb.axes().each(wide);
    let (center, half) = (wide(question.obb.center()), wide(question.obb.half_extents()));
    let w = [cross3(&u[1], &u[2]), cross3(&u[2], &u[0]), cross3(&u[0], &u[1])];
    let volume = dot3(&u[0], &w[0]).abs();
    let errors_over = |unit: f64| {
        let mut most = 0.0;
        for i in 0..3 {
            let Projection { t: vertices, size } = framed.shapes[i];
            let off = |x: i32, truth: i128| (f64::from(x) - truth as f64 / unit).abs();
            let extent = off(size / 2 - framed.by, half[i] * volume);
            for k in 0..3 {
                let p = wide(question.triangle.vertices()[k]);
                let d = [p[0] - center[0], p[1] - center[1], p[2] - center[2]];
                let vertex = off(vertices[k] - size / 2, dot3(&w[i], &d) << S::FRACTION_BITS);
                most = f64::max(most, vertex + extent);
            }
        }
        most
    };
    // The computed numbers are the true ones over a power of two; the best-fitting power is taken.
    let found = (0..160).map(|k| errors_over(exp2(k - 40)));
    let found = found.fold(f64::INFINITY, f64::min) / f64::from(framed.by);
    assert!(found <= 1.0, "{:?} {:?}", question.triangle, question.obb);
    Some(found)
}

/// Tests shapes of all sizes, near and far, with the greatest and the least numbers.
fn most_found<S: Scalar + InRaw>(bits: u32, of: impl Fn(i64) -> S) -> (u32, f64) {
    let random = &mut Random(0x0bb);
    let (mut asked, mut most) = (0, 0.0_f64);
    for case in 0..6_000 {
        // Integers of so many bits.
        let mut row = |bits: u32| [(); 3].each(|()| random.of_bits(0, bits));
        let ends = |x: i64| if case % 5 == 0 { (x >> (bits - 1)) * ((1 << bits) - 1) } else { x };
        let size = 1 + case % bits;
        let far = row(if case % 3 == 0 { bits } else { 1 });
        let near = |row: [i64; 3]| {
            let shifted = |i: usize| (row[i] + far[i]).clamp(-(1 << bits), (1 << bits) - 1);
            [0, 1, 2].each(|i| of(ends(shifted(i))))
        };
        let [a, b, c, center] = [(); 4].each(|()| near(row(size)));
        let half = row(size).each(|x| of(x.abs() - 1));
        let axes = [(); 3].each(|()| Vec3::from(row(1 + case / 7 % bits).each(|x| of(ends(x)))));
        let triangle = Triangle::new(a, b, c).unwrap();
        let Ok(obb) = Obb::from_skewed_axes(center, axes, half) else { continue };
        if let Some(found) = found(&Disjoint::new(&triangle, &obb)) {
            (asked, most) = (asked + 1, most.max(found));
        }
    }
    (asked, most)
}

/// The bound holds, and is not much wider than the errors that occur.
#[test]
fn no_error_exceeds_its_bound() {
    for (asked, most) in [
        most_found(7, |x| I4F4::from_bits(x as i8)),
        most_found(15, |x| I8F8::from_bits(x as i16)),
        most_found(31, |x| I16F16::from_bits(x as i32)),
        most_found(31, |x| I2F30::from_bits(x as i32)),
    ] {
        assert!(asked > 1_500 && most > 0.5, "{asked} {most}");
    }
}
