//! The table of counts: how often each question of the stream escalates past each stage.

extern crate std;

use std::fmt::Write;
use std::format;
use std::string::String;

use fixed::types::{I8F8, I16F16, I32F32};

use super::Sample;
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, SMALL_CODE};
use crate::contact::contact;
use crate::query::{HitRay, HitTriangle, Motion, PreparedRay, PreparedTriangle, Relate, Sweep};
use crate::random::Random;
use crate::robust::escalations;
use crate::scalar::Backend;
use crate::shape::{Aabb, Obb, Plane, Ray, Segment, Triangle};

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
    let mut rng = Random(0x5e97_0a11);
    for case in 0..1_800 {
        let point = |rng: &mut Random| [(); 3].each(|()| S::sample(rng, case % 3));
        let [a, b, c, p, q, o, d] = [(); 7].map(|()| point(&mut rng));
        let size = |x: S| if x < S::ZERO { S::ZERO } else { x };
        let half = [(); 3].each(|()| size(S::sample(&mut rng, 1)));
        let (low, high) = ([0, 1, 2].each(|i| if p[i] < q[i] { p[i] } else { q[i] }), p);
        let high = [0, 1, 2].each(|i: usize| if high[i] < q[i] { q[i] } else { high[i] });
        let triangle = Triangle::new(a, b, c).unwrap();
        let boxes = [Aabb::from_center_half_extents(p, half), Aabb::from_min_max(low, high)];
        let mut ask = |name: &str, question: &dyn Fn()| {
            let k = QUESTIONS.iter().position(|known| *known == name).unwrap();
            for (sum, count) in counts[k].iter_mut().zip(escalations(question)) {
                *sum += count;
            }
        };
        for aabb in boxes.each(Result::unwrap) {
            ask("triangle/aabb", &|| _ = triangle.overlaps(&aabb));
            ask("triangle prepared", &|| _ = PreparedTriangle::new(&triangle).overlaps(&aabb));
            ask("triangle relation", &|| _ = triangle.relation(&aabb));
            ask("separating axis", &|| _ = triangle.separating_axis(&aabb));
            let other = Aabb::from_center_half_extents(c, half).unwrap();
            ask("aabb/aabb", &|| _ = aabb.overlaps(&other));
            if let Ok(plane) = Plane::from_point_normal(o, d) {
                ask("plane/aabb", &|| _ = plane.side_of(&aabb));
            }
            ask("segment/aabb", &|| _ = Segment::new(o, d).unwrap().overlaps(&aabb));
            let motion = Motion::new(o, d).unwrap();
            ask("sweep: whether", &|| _ = triangle.meets_along(&motion, &aabb));
            ask("sweep: when", &|| _ = triangle.first_contact(&motion, &aabb));
            ask("sweep of two boxes", &|| _ = other.first_contact(&motion, &aabb));
            ask("contact with a box", &|| _ = contact(&triangle, &aabb));
            if let Ok(ray) = Ray::new(o, d) {
                ask("ray/aabb", &|| _ = ray.overlaps(&aabb));
                ask("ray/aabb t_range", &|| _ = ray.t_range(&aabb));
                ask("ray/aabb prepared", &|| _ = PreparedRay::new(&ray).overlaps(&aabb));
            }
        }
        if let Ok(obb) = Obb::from_skewed_axes(p, [q, d, o], half) {
            ask("triangle/obb", &|| _ = triangle.overlaps(&obb));
            ask("triangle/obb relation", &|| _ = triangle.relation(&obb));
            let other = Obb::from_skewed_axes(c, [d, q, o], half);
            ask("obb/obb", &|| _ = obb.overlaps(other.as_ref().unwrap()));
            if let Ok(ray) = Ray::new(o, d) {
                ask("ray/obb", &|| _ = ray.overlaps(&obb));
            }
        }
        ask("triangle/triangle", &|| _ = triangle.overlaps(&Triangle::new(p, q, o).unwrap()));
        ask("segment/triangle", &|| _ = Segment::new(p, q).unwrap().overlaps(&triangle));
        if let Ok(obb) = Obb::from_skewed_axes(p, S::turned(), half) {
            ask("triangle/turned box", &|| _ = triangle.overlaps(&obb));
            ask("turned box relation", &|| _ = triangle.relation(&obb));
            ask("contact, turned box", &|| _ = contact(&triangle, &obb));
            if let Ok(ray) = Ray::new(o, d) {
                ask("ray/turned box", &|| _ = ray.overlaps(&obb));
                ask("ray/turned box range", &|| _ = ray.t_range_obb(&obb));
            }
        }
        if let Ok(ray) = Ray::new(o, d) {
            ask("ray/triangle is_hit", &|| _ = ray.is_hit(&triangle));
            ask("ray/triangle hit", &|| _ = ray.hit(&triangle));
            ask("both prepared is_hit", &|| {
                _ = HitRay::new(&ray).is_hit(&HitTriangle::new(&triangle))
            });
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
