//! The least and the greatest number of a type are unbounded ends of a ray, each on its own side.

use septum_c::*;

fn ray<T>([zero, near, far]: [T; 3], [t_min, t_max]: [T; 2]) -> Ray<T>
where
    T: Copy + core::ops::Neg<Output = T>,
{
    // Down through the triangle, at t = 1.
    Ray { origin: [zero, zero, near], direction: [zero, zero, -far], t_min, t_max }
}

fn triangle<T>(zero: T, one: T) -> Triangle<T>
where
    T: Copy + core::ops::Neg<Output = T>,
{
    Triangle { a: [-one, -one, zero], b: [one, -one, zero], c: [zero, one, zero] }
}

#[test]
fn of_floats() {
    use Answer::{EmptyRange, No, NotFinite, Yes};
    const INF: f32 = f32::INFINITY;
    let triangle = triangle(0.0_f32, 1.0);
    for (range, expected) in [
        ([0.0, INF], Yes),
        ([-INF, INF], Yes),
        ([-INF, f32::MIN], No),
        ([f32::MAX, INF], No),
        ([f32::MAX, f32::MIN], EmptyRange),
        ([0.0, -INF], NotFinite),
        ([INF, INF], NotFinite),
        ([INF, 0.0], NotFinite),
        ([-INF, -INF], NotFinite),
        ([INF, -INF], NotFinite),
        ([0.0, f32::NAN], NotFinite),
    ] {
        let ray = ray([0.0, 1.0, 1.0], range);
        assert_eq!(septum_ray_triangle_f32(Some(&ray), Some(&triangle)), expected, "{range:?}");
    }
}

#[test]
fn of_fixed_point() {
    use Answer::{EmptyRange, No, Yes};
    const ONE: i32 = 1 << 16;
    let triangle = triangle(0, ONE);
    for (range, expected) in [
        ([0, i32::MAX], Yes),
        ([i32::MIN, i32::MAX], Yes),
        ([i32::MAX, i32::MAX], No),
        ([i32::MIN, i32::MIN], No),
        ([0, i32::MIN], EmptyRange),
        ([i32::MAX, i32::MIN], EmptyRange),
    ] {
        let ray = ray([0, ONE, ONE], range);
        assert_eq!(septum_ray_triangle_i16f16(Some(&ray), Some(&triangle)), expected, "{range:?}");
    }
}
