//! Counts how many of a fixed stream of questions escalate past each stage.
//!
//! An error bound that is too wide gives no wrong answer, so no hash of answers reveals it: it only
//! sends questions to more expensive arithmetic. The counts do reveal it, and they are the same on
//! every machine. After a change of a bound or a cascade, measure its price and write down the new
//! counts: `counts.txt`, and `counts_narrow.txt` for 32-bit registers (`--cfg septum_narrow`).

extern crate std;

use std::fmt::Write;
use std::format;
use std::string::String;

use fixed::types::{I8F8, I16F16, I32F32};

use crate::arithmetic::{InRaw, REGISTERS_ARE_WIDE, SMALL_CODE};
use crate::contact::contact;
use crate::query::{HitRay, HitTriangle, Motion, PreparedRay, PreparedTriangle, Relate, Sweep};
use crate::random::Random;
use crate::robust::escalations;
use crate::scalar::{Backend, Scalar};
use crate::shape::{Aabb, Obb, Plane, Ray, Segment, Triangle};

struct Rng(Random);

impl Rng {
    /// An integer from −n to n.
    fn within(&mut self, n: u32) -> i64 {
        let z = self.0.bits() as u32;
        ((u64::from(z) * u64::from(2 * n + 1)) >> 32) as i64 - i64::from(n)
    }
}

trait Sample: Scalar {
    /// A number of one of three kinds: on a coarse grid, on a fine grid, or on a fine grid far from
    /// zero, where the last digits of the type decide contact.
    fn sample(rng: &mut Rng, kind: u32) -> Self;

    /// Orthogonal axes, of length one or nearly.
    fn turned() -> [[Self; 3]; 3];
}

/// The axes after two rotations by the angles of the 3-4-5 triangle, in hundredths.
const TURNED: [[i64; 3]; 3] = [[60, 80, 0], [-48, 36, 80], [64, -48, 60]];

/// A sample of a float. In `f64` the samples for `f32` are exact, so they are rounded once.
fn float(rng: &mut Rng, kind: u32, far: f64) -> f64 {
    match kind {
        0 => rng.within(4) as f64,
        1 => rng.within(1 << 20) as f64 / 262_144.0,
        _ => far + rng.within(1 << 20) as f64 / 262_144.0,
    }
}

impl Sample for f32 {
    fn sample(rng: &mut Rng, kind: u32) -> Self {
        float(rng, kind, 1e5) as Self
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.map(|u| u.map(|x| x as Self / 100.0))
    }
}

impl Sample for f64 {
    fn sample(rng: &mut Rng, kind: u32) -> Self {
        float(rng, kind, 1e14)
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.map(|u| u.map(|x| x as Self / 100.0))
    }
}

impl<S: Scalar + InRaw> Sample for S {
    fn sample(rng: &mut Rng, kind: u32) -> Self {
        let [coarse, fine, far] = match S::FRACTION_BITS {
            8 => [6, 13, 13],
            16 => [15, 18, 30],
            _ => [30, 20, 62],
        };
        Self::from_raw(match kind {
            0 => rng.within(4) << coarse,
            1 => rng.within(1 << 20) >> (20 - fine),
            _ => (1 << far) + (rng.within(1 << 20) >> (20 - fine)),
        })
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.map(|u| u.map(|x| Self::from_raw((x << S::FRACTION_BITS) / 100)))
    }
}

/// Writes how often each question escalates: past the first look, past a filter, past a stage for
/// narrow registers, and how often it reaches exact sums. For contacts, the number of directions
/// that floats leave to exact sums.
fn rows<S: Sample>(scalar: &str, to: &mut String) {
    const QUESTIONS: [&str; 28] = [
        "triangle/aabb",
        "separating axis",
        "triangle/obb",
        "aabb/aabb",
        "plane/aabb",
        "segment/aabb",
        "ray/aabb",
        "ray/aabb t_range",
        "ray/triangle is_hit",
        "ray/triangle hit",
        "ray/aabb prepared",
        "triangle/triangle",
        "segment/triangle",
        "obb/obb",
        "triangle relation",
        "triangle/turned box",
        "triangle/obb relation",
        "turned box relation",
        "ray/obb",
        "ray/turned box",
        "ray/turned box range",
        "sweep: whether",
        "sweep: when",
        "sweep of two boxes",
        "contact with a box",
        "contact, turned box",
        "triangle prepared",
        "both prepared is_hit",
    ];
    let mut counts = [[0; 4]; QUESTIONS.len()];
    let mut rng = Rng(Random(0x5e97_0a11));
    for case in 0..1_800 {
        let point = |rng: &mut Rng| [(); 3].map(|()| S::sample(rng, case % 3));
        let [a, b, c, p, q, o, d] = [(); 7].map(|()| point(&mut rng));
        let size = |x: S| if x < S::ZERO { S::ZERO } else { x };
        let half = [(); 3].map(|()| size(S::sample(&mut rng, 1)));
        let (low, high) = ([0, 1, 2].map(|i| if p[i] < q[i] { p[i] } else { q[i] }), p);
        let high = [0, 1, 2].map(|i: usize| if high[i] < q[i] { q[i] } else { high[i] });
        let triangle = Triangle::new(a, b, c).unwrap();
        let boxes = [Aabb::from_center_half_extents(p, half), Aabb::from_min_max(low, high)];
        let mut ask = |k: usize, question: &dyn Fn()| {
            for (sum, count) in counts[k].iter_mut().zip(escalations(question)) {
                *sum += count;
            }
        };
        for aabb in boxes.map(Result::unwrap) {
            ask(0, &|| _ = triangle.overlaps(&aabb));
            ask(26, &|| _ = PreparedTriangle::new(&triangle).overlaps(&aabb));
            ask(14, &|| _ = triangle.relation(&aabb));
            ask(1, &|| _ = triangle.separating_axis(&aabb));
            ask(3, &|| _ = aabb.overlaps(&Aabb::from_center_half_extents(c, half).unwrap()));
            if let Ok(plane) = Plane::from_point_normal(o, d) {
                ask(4, &|| _ = plane.side_of(&aabb));
            }
            ask(5, &|| _ = Segment::new(o, d).unwrap().overlaps(&aabb));
            let motion = Motion::new(o, d).unwrap();
            ask(21, &|| _ = triangle.meets_along(&motion, &aabb));
            ask(22, &|| _ = triangle.first_contact(&motion, &aabb));
            let other = Aabb::from_center_half_extents(c, half).unwrap();
            ask(23, &|| _ = other.first_contact(&motion, &aabb));
            ask(24, &|| _ = contact(&triangle, &aabb));
            if let Ok(ray) = Ray::new(o, d) {
                ask(6, &|| _ = ray.overlaps(&aabb));
                ask(7, &|| _ = ray.t_range(&aabb));
                ask(10, &|| _ = PreparedRay::new(&ray).overlaps(&aabb));
            }
        }
        if let Ok(obb) = Obb::from_skewed_axes(p, [q, d, o], half) {
            ask(2, &|| _ = triangle.overlaps(&obb));
            ask(16, &|| _ = triangle.relation(&obb));
            let other = Obb::from_skewed_axes(c, [d, q, o], half);
            ask(13, &|| _ = obb.overlaps(other.as_ref().unwrap()));
            if let Ok(ray) = Ray::new(o, d) {
                ask(18, &|| _ = ray.overlaps(&obb));
            }
        }
        ask(11, &|| _ = triangle.overlaps(&Triangle::new(p, q, o).unwrap()));
        ask(12, &|| _ = Segment::new(p, q).unwrap().overlaps(&triangle));
        if let Ok(obb) = Obb::from_skewed_axes(p, S::turned(), half) {
            ask(15, &|| _ = triangle.overlaps(&obb));
            ask(17, &|| _ = triangle.relation(&obb));
            ask(25, &|| _ = contact(&triangle, &obb));
            if let Ok(ray) = Ray::new(o, d) {
                ask(19, &|| _ = ray.overlaps(&obb));
                ask(20, &|| _ = ray.t_range_obb(&obb));
            }
        }
        if let Ok(ray) = Ray::new(o, d) {
            ask(8, &|| _ = ray.is_hit(&triangle));
            ask(9, &|| _ = ray.hit(&triangle));
            ask(27, &|| _ = HitRay::new(&ray).is_hit(&HitTriangle::new(&triangle)));
        }
    }
    for (question, [numeric, filter, narrow, exact]) in QUESTIONS.iter().zip(counts) {
        writeln!(to, "{scalar:7}{question:20}{numeric:6}{filter:7}{narrow:7}{exact:7}").unwrap();
    }
}

#[test]
fn questions_escalate_as_often_as_they_did() {
    // Builds with short cascades have other stages, and so has fixed point without vectors.
    if SMALL_CODE || (REGISTERS_ARE_WIDE && !<I16F16 as Backend>::IN_QUADS) {
        return;
    }
    let mut counts = format!(
        "scalar {:20}{:>6}{:>7}{:>7}{:>7}\n",
        "question", "look", "filter", "narrow", "exact"
    );
    rows::<f32>("f32", &mut counts);
    rows::<f64>("f64", &mut counts);
    // Eight bits take the stages of sixteen.
    rows::<I8F8>("I8F8", &mut counts);
    rows::<I16F16>("I16F16", &mut counts);
    rows::<I32F32>("I32F32", &mut counts);
    let kept = if REGISTERS_ARE_WIDE {
        include_str!("counts.txt")
    } else {
        include_str!("counts_narrow.txt")
    };
    assert!(counts == kept, "the counts are now\n{counts}");
}

/// How many of 100,000 pairs of random triangles and boxes the first stage leaves in doubt.
#[test]
fn a_triangle_and_a_box_are_hardly_ever_in_doubt() {
    fn count<S: Sample>(is_prepared: bool) -> u32 {
        let mut doubts = 0;
        let mut rng = Rng(Random(0x7a11));
        for _ in 0..1_000 {
            let point = |rng: &mut Rng| [(); 3].map(|()| S::sample(rng, 1));
            let triangle = [(); 3].map(|()| point(&mut rng));
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
    let found = [false, true].map(|is_prepared| {
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
        let mut rng = Rng(Random(0x6a11));
        let mut point = || [(); 3].map(|()| S::sample(&mut rng, 1));
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
        let [x, y, z] = [0, 1, 2].map(ordered);
        Aabb::from_min_max([x.0, y.0, z.0], [x.1, y.1, z.1]).unwrap()
    } else {
        let half = q.map(|x| if x < S::ZERO { S::ZERO } else { x });
        Aabb::from_center_half_extents(p, half).unwrap()
    }
}

/// How many of 100,000 pairs of random boxes and prepared rays, as in a tree, the prepared ray
/// leaves in doubt.
#[test]
fn a_prepared_ray_is_hardly_ever_in_doubt() {
    fn count<S: Sample>(by_corners: bool) -> u32 {
        let mut doubts = 0;
        let mut rng = Rng(Random(0xb0c5));
        for _ in 0..1_000 {
            let point = |rng: &mut Rng| [(); 3].map(|()| S::sample(rng, 1));
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
    let found = [true, false].map(|by_corners| {
        [
            count::<f32>(by_corners),
            count::<f64>(by_corners),
            count::<I16F16>(by_corners),
            count::<I32F32>(by_corners),
        ]
    });
    assert_eq!(found, [[0; 4]; 2]);
}

/// Boxes, and a triangle, a segment and a ray along axes of space, against a box that is tilted by
/// the residue of a quarter turn, by less and by more: how many of 7,200 pairs come to exact sums.
#[test]
fn nearly_parallel_axes_are_hardly_ever_in_doubt() {
    fn count<S: Sample>(near: fn(f64) -> S) -> u32 {
        let mut rng = Rng(Random(0x7117));
        let mut at_the_end = 0;
        for tilt in [1e-30, 1e-18, 6.1e-17, 1e-15, 1e-14, 1e-12] {
            for _ in 0..200 {
                let mut number = || rng.within(1 << 20) as f64 / 524_288.0;
                let [p, q] = [(); 2].map(|()| [(); 3].map(|()| number()));
                let half = [(); 3].map(|()| near(number().abs() + 0.25));
                let point = |x: f64, y: f64| [near(p[0] + x), near(p[1] + y), near(p[2])];
                let box_of = |center: [f64; 3], axes: [[f64; 3]; 3]| {
                    Obb::new(center.map(near), axes.map(|u| u.map(near)), half).unwrap()
                };
                let tilted = box_of(q, [[1.0, 0.0, 0.0], [0.0, 1.0, tilt], [0.0, -tilt, 1.0]]);
                let turned = box_of([0.0; 3], [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]);
                let aabb = Aabb::from_center_half_extents([S::ZERO; 3], half).unwrap();
                let corners = [point(0.0, 0.0), point(1.0, 0.0), point(0.0, 1.0)];
                let triangle = Triangle::new(corners[0], corners[1], corners[2]).unwrap();
                let segment = Segment::new(corners[0], corners[2]).unwrap();
                let ray = Ray::new(corners[0], [0.0, 1.0, 0.0].map(near)).unwrap();
                // Turned about two axes of space.
                let edges = [[0.0, tilt, 0.0], [1.0, 0.0, tilt], [tilt, 1.0, 0.0]];
                let [a, b, c] = edges.map(|p| p.map(near));
                let flat = Triangle::new(a, b, c).unwrap();
                let questions: [&dyn Fn() -> bool; 6] = [
                    &|| flat.overlaps(&aabb),
                    &|| tilted.overlaps(&turned),
                    &|| tilted.overlaps(&aabb),
                    &|| triangle.overlaps(&tilted),
                    &|| segment.overlaps(&tilted),
                    &|| ray.overlaps(&tilted),
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
