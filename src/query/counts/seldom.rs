//! Of many random questions the first stage leaves hardly any in doubt.

use fixed::types::{I16F16, I32F32};

use super::Sample;
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, SMALL_CODE};
use crate::query::{HitRay, HitTriangle, PreparedRay, PreparedTriangle};
use crate::random::Random;
use crate::robust::escalations;
use crate::scalar::{Backend, Scalar};
use crate::shape::{Aabb, Capsule, Obb, Ray, Segment, Sphere, Triangle};

/// How many of 100,000 pairs of random triangles and boxes the first stage leaves in doubt.
#[test]
fn a_triangle_and_a_box_are_hardly_ever_in_doubt() {
    fn count<S: Sample>(is_prepared: bool) -> u32 {
        let mut doubts = 0;
        let mut rng = Random(0x7a11);
        for _ in 0..1_000 {
            let point = |rng: &mut Random| [(); 3].each(|()| S::sample(rng, 1));
            let triangle = [(); 3].each(|()| point(&mut rng));
            let [a, b, c] = triangle;
            let triangle = Triangle::new(a, b, c).unwrap();
            let prepared = PreparedTriangle::new(&triangle);
            for k in 0..100 {
                let aabb = random_box(k % 2 == 0, point(&mut rng), point(&mut rng));
                let [past_the_first, ..] = escalations(|| {
                    _ = if is_prepared {
                        prepared.overlaps(&aabb)
                    } else {
                        triangle.overlaps(&aabb)
                    };
                });
                doubts += past_the_first;
            }
        }
        doubts
    }
    let found = [false, true].each(|is_prepared| {
        [
            count::<f32>(is_prepared),
            count::<f64>(is_prepared),
            count::<I16F16>(is_prepared),
            count::<I32F32>(is_prepared),
        ]
    });
    // Without vectors other kernels run.
    if REGISTERS_ARE_WIDE && !SMALL_CODE && <I16F16 as Backend>::IN_QUADS {
        assert_eq!(found, [[1, 1, 1, 1], [2, 2, 3, 2]]);
    }
}

/// How many of 100,000 pairs of prepared random rays and triangles the first stage leaves in doubt.
/// The error bound depends on the distance from the origin.
#[test]
fn a_ray_and_a_triangle_are_seldom_in_doubt() {
    fn count<S: Sample>() -> u32 {
        let mut doubts = 0;
        let mut rng = Random(0x6a11);
        let mut point = || [(); 3].each(|()| S::sample(&mut rng, 1));
        let mut shapes = || {
            let ray = HitRay::new(&Ray::new(point(), point()).unwrap());
            let triangle = Triangle::new(point(), point(), point()).unwrap();
            (ray, HitTriangle::new(&triangle))
        };
        for _ in 0..100_000 {
            let (ray, triangle) = shapes();
            let [past_the_first, ..] = escalations(|| _ = ray.is_hit(&triangle));
            doubts += past_the_first;
        }
        doubts
    }
    let found = [count::<f32>(), count::<f64>(), count::<I16F16>(), count::<I32F32>()];
    if REGISTERS_ARE_WIDE && !SMALL_CODE {
        assert_eq!(found, [1; 4]);
    }
}

/// A box with opposite corners p and q, or with centre p and half-extents from q.
fn random_box<S: Scalar>(by_corners: bool, p: [S; 3], q: [S; 3]) -> Aabb<S> {
    if by_corners {
        let ordered = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
        let [x, y, z] = [0, 1, 2].each(ordered);
        Aabb::from_min_max([x.0, y.0, z.0], [x.1, y.1, z.1]).unwrap()
    } else {
        let half = q.each(|x| if x < S::ZERO { S::ZERO } else { x });
        Aabb::from_center_half_extents(p, half).unwrap()
    }
}

/// How many of 100,000 pairs of random boxes and prepared rays, as in a tree, the prepared ray
/// leaves in doubt.
#[test]
fn a_prepared_ray_is_hardly_ever_in_doubt() {
    fn count<S: Sample>(by_corners: bool) -> u32 {
        let mut doubts = 0;
        let mut rng = Random(0xb0c5);
        for _ in 0..1_000 {
            let point = |rng: &mut Random| [(); 3].each(|()| S::sample(rng, 1));
            let ray = Ray::new(point(&mut rng), point(&mut rng)).unwrap();
            let prepared = PreparedRay::new(&ray);
            for _ in 0..100 {
                let aabb = random_box(by_corners, point(&mut rng), point(&mut rng));
                let [past_the_first, ..] = escalations(|| {
                    assert_eq!(prepared.overlaps(&aabb), ray.overlaps(&aabb));
                });
                doubts += past_the_first;
            }
        }
        doubts
    }
    let found = [true, false].each(|by_corners| {
        [
            count::<f32>(by_corners),
            count::<f64>(by_corners),
            count::<I16F16>(by_corners),
            count::<I32F32>(by_corners),
        ]
    });
    assert_eq!(found, [[0; 4]; 2]);
}

/// Boxes, and a triangle, a segment, a ray and a capsule along axes of space, against a box that is tilted by
/// the residue of a quarter turn, by less and by more: how many of 8,400 pairs come to exact numbers.
#[test]
fn nearly_parallel_axes_are_hardly_ever_in_doubt() {
    fn count<S: Sample>(near: fn(f64) -> S) -> u32 {
        let mut rng = Random(0x7117);
        let mut at_the_end = 0;
        for tilt in [1e-30, 1e-18, 6.1e-17, 1e-15, 1e-14, 1e-12] {
            for _ in 0..200 {
                let mut number = || rng.within(1 << 20) as f64 / 524_288.0;
                let [p, q] = [(); 2].each(|()| [(); 3].each(|()| number()));
                let half = [(); 3].each(|()| near(number().abs() + 0.25));
                let point = |x: f64, y: f64| [near(p[0] + x), near(p[1] + y), near(p[2])];
                let box_of = |center: [f64; 3], axes: [[f64; 3]; 3]| {
                    Obb::new(center.each(near), axes.each(|u| u.each(near)), half).unwrap()
                };
                let tilted = box_of(q, [[1.0, 0.0, 0.0], [0.0, 1.0, tilt], [0.0, -tilt, 1.0]]);
                let turned = box_of([0.0; 3], [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]);
                let aabb = Aabb::from_center_half_extents([S::ZERO; 3], half).unwrap();
                let corners = [point(0.0, 0.0), point(1.0, 0.0), point(0.0, 1.0)];
                let triangle = Triangle::new(corners[0], corners[1], corners[2]).unwrap();
                let segment = Segment::new(corners[0], corners[2]).unwrap();
                let ray = Ray::new(corners[0], [0.0, 1.0, 0.0].each(near)).unwrap();
                // Turned about two axes of space.
                let edges = [[0.0, tilt, 0.0], [1.0, 0.0, tilt], [tilt, 1.0, 0.0]];
                let [a, b, c] = edges.each(|p| p.each(near));
                let flat = Triangle::new(a, b, c).unwrap();
                let capsule = Capsule::new(corners[0], corners[2], near(0.5)).unwrap();
                let questions: [&dyn Fn() -> bool; 7] = [
                    &|| flat.overlaps(&aabb),
                    &|| tilted.overlaps(&turned),
                    &|| tilted.overlaps(&aabb),
                    &|| triangle.overlaps(&tilted),
                    &|| segment.overlaps(&tilted),
                    &|| ray.overlaps(&tilted),
                    &|| capsule.overlaps(&tilted),
                ];
                for ask in questions {
                    let [.., exact] = escalations(|| _ = ask());
                    at_the_end += exact;
                }
            }
        }
        at_the_end
    }
    // Without rows the generic kernels have no second look at axes that are nearly parallel.
    if !SMALL_CODE && REGISTERS_ARE_WIDE {
        assert_eq!([count(|x| x as f32), count(|x| x)], [0; 2]);
    }
}

/// Points and segments in the place of triangles and segments, flat boxes, and capsules that stand or have no
/// length: how many of 2,000 pairs of each kind come to exact numbers.
#[test]
fn shapes_without_extent_are_hardly_ever_in_doubt() {
    fn count<S: Sample>() -> [u32; 7] {
        let mut rng = Random(0xf1a7);
        let mut at_the_end = [0; 7];
        for n in 0..2_000 {
            let mut point = || -> [S; 3] { [(); 3].each(|()| S::sample(&mut rng, 1)) };
            let size = |x: S| if x < S::ZERO { S::ZERO.plain_sub(x) } else { x };
            let (p, q, center, half) = (point(), point(), point(), point().each(size));
            let (obb, aabb) = (
                Obb::new(center, S::turned(), half).unwrap(),
                Aabb::from_center_half_extents(center, half).unwrap(),
            );
            let flat = Obb::new(center, S::turned(), [half[0], S::ZERO, half[2]]).unwrap();
            // From no length to two sides of three that are one.
            let [a, b, c] = [[p, p, p], [p, p, q], [p, q, p], [p, q, q]][n % 4];
            let triangle = Triangle::new(a, b, c).unwrap();
            let segment = Segment::new(p, p).unwrap();
            let top = if n % 2 == 0 { p } else { [p[0], p[1], q[2]] };
            let capsule = Capsule::new(p, top, half[1]).unwrap();
            let sphere = Sphere::new(p, half[1]).unwrap();
            let questions: [&dyn Fn() -> bool; 7] = [
                &|| obb.contains(p),
                &|| segment.overlaps(&obb),
                &|| triangle.overlaps(&obb),
                &|| triangle.overlaps(&flat),
                &|| sphere.overlaps(&flat),
                &|| capsule.overlaps(&aabb),
                &|| capsule.overlaps(&obb),
            ];
            for (count, ask) in at_the_end.iter_mut().zip(questions) {
                let [_, filter, _, exact] = escalations(|| _ = ask());
                *count += filter + exact;
            }
        }
        at_the_end
    }
    if !SMALL_CODE && REGISTERS_ARE_WIDE {
        assert_eq!([count::<f32>(), count::<f64>()], [[0; 7]; 2]);
        // A box without thickness is thinner than its error.
        assert_eq!(count::<I32F32>(), [0, 0, 2, 106, 0, 0, 0]);
    }
}
