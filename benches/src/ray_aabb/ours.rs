//! Our methods, in any scalar.

use septum::prepared::PreparedRay;
use septum::published;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum::{Aabb, Ray, Scalar, Segment};

use crate::candidate::{Candidate, Course, Promise};
use crate::unit::{F32, Form, Unit};

use super::scenes::Scene;

#[inline(never)]
fn exact<S: Scalar>(r: &Ray<S>, b: &Aabb<S>) -> bool {
    r.overlaps(b)
}

#[inline(never)]
fn exact_t_range<S: Scalar>(r: &Ray<S>, b: &Aabb<S>) -> Option<(S, S)> {
    r.t_range(b)
}

#[inline(never)]
fn prepared<S: Scalar>(r: &PreparedRay<S>, b: &Aabb<S>) -> bool {
    r.overlaps(b)
}

#[inline(never)]
fn conservative<S: Scalar>(r: &Ray<S>, b: &Aabb<S>) -> bool {
    r.may_overlap(b)
}

#[inline(never)]
fn as_published<S: Scalar>(r: &Ray<S>, b: &Aabb<S>) -> bool {
    published::separating_axes::ray_overlaps(r, b)
}

#[inline(never)]
fn slabs<S: Scalar>(r: &SlabRay<S>, b: &Aabb<S>) -> bool {
    r.overlaps_rounded(b)
}

#[inline(never)]
fn slabs_t_range<S: Scalar>(r: &SlabRay<S>, b: &Aabb<S>) -> Option<(S, S)> {
    r.t_range_rounded(b)
}

#[inline(never)]
fn slabs_conservative<S: Scalar>(r: &SlabRay<S>, b: &Aabb<S>) -> bool {
    r.may_overlap(b)
}

#[inline(never)]
fn slope<S: Scalar>(r: &SlopeRay<S>, b: &Aabb<S>) -> bool {
    r.overlaps_rounded(b)
}

#[inline(never)]
fn slope_t_enter<S: Scalar>(r: &SlopeRay<S>, b: &Aabb<S>) -> Option<S> {
    r.t_enter_rounded(b)
}

#[inline(never)]
fn segment_exact<S: Scalar>(s: &Segment<S>, b: &Aabb<S>) -> bool {
    s.overlaps(b)
}

#[inline(never)]
fn segment_as_published<S: Scalar>(s: &Segment<S>, b: &Aabb<S>) -> bool {
    published::separating_axes::segment_overlaps(s, b)
}

/// The scene in a scalar; the truth is the exact verdict in `f64`.
pub fn course<S: Scalar>(scene: &Scene, unit: &Unit<S>, form: Form) -> Course<Ray<S>, Aabb<S>> {
    let pairs = scene.map(|l| unit.ray(l), |c| unit.aabb(c, form));
    let wide = pairs.map(|r| unit.wide_ray(r), |b| unit.wide_aabb(b));
    Course::new((unit.name, form.name()), pairs, wide.answers(|r, b| r.overlaps(b)))
}

/// The same scene with segments, which have their own truth.
pub fn segments<S: Scalar>(
    scene: &Scene,
    unit: &Unit<S>,
    form: Form,
) -> Course<Segment<S>, Aabb<S>> {
    let pairs = scene.map(|l| unit.segment(l), |c| unit.aabb(c, form));
    let wide = pairs.map(|s| unit.wide_segment(s), |b| unit.wide_aabb(b));
    Course::new((unit.name, form.name()), pairs, wide.answers(|s, b| s.overlaps(b)))
}

/// The test that the pictures use as yardstick.
pub fn yardstick(scene: &Scene) -> Candidate {
    let course = course(scene, &F32, Form::Corners);
    course.candidate("yardstick: as published (SAT)", Promise::Nothing, as_published)
}

/// All our methods in one scalar. Rays are prepared before the clock starts.
pub fn ours<S: Scalar>(
    plain: &Course<Ray<S>, Aabb<S>>,
    segment: &Course<Segment<S>, Aabb<S>>,
) -> Vec<Candidate> {
    let ray = plain.prepared(plain.form, |p| p.map(PreparedRay::new, Aabb::clone));
    let slab = plain.prepared(plain.form, |p| p.map(SlabRay::new, Aabb::clone));
    let slopes = plain.prepared(plain.form, |p| p.map(SlopeRay::new, Aabb::clone));
    let (never_misses, none) = (Promise::NeverMisses, Promise::Nothing);
    vec![
        plain.candidate("exact", Promise::Exact, exact),
        ray.candidate("exact, ray prepared", Promise::Exact, prepared),
        plain.candidate("exact t_range", Promise::Exact, exact_t_range),
        plain.candidate("conservative", never_misses, conservative),
        plain.candidate("as published (SAT)", none, as_published),
        slab.candidate("slabs, rounded", none, slabs),
        slab.candidate("slabs, rounded t_range", none, slabs_t_range),
        slab.candidate("slabs, conservative", never_misses, slabs_conservative),
        slopes.candidate("slopes, rounded", none, slope),
        slopes.candidate("slopes, rounded t_enter", none, slope_t_enter),
        segment.candidate("segment, exact", Promise::Exact, segment_exact),
        segment.candidate("segment, as published (SAT)", none, segment_as_published),
    ]
}
