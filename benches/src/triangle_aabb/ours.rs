//! Our modes, in any scalar.

use septum::published;
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::unit::{F32, Form, Unit};

use super::scenes::Scene;

/// A mode of ours.
type Test<S> = fn(&Triangle<S>, &Aabb<S>) -> bool;

#[inline(never)]
fn as_published<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    published::akenine_moller::overlaps(t, b)
}

#[inline(never)]
fn rounded<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    published::shared_normal::overlaps(t, b)
}

#[inline(never)]
fn conservative<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.may_overlap(b)
}

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.overlaps(b)
}

/// The scene in a scalar; the truth is the exact test in `f64`.
pub fn course<S: Scalar>(
    scene: &Scene,
    unit: &Unit<S>,
    form: Form,
) -> Course<Triangle<S>, Aabb<S>> {
    let pairs = scene.map(|t| unit.triangle(t), |c| unit.aabb(c, form));
    let wide = pairs.map(|t| unit.wide_triangle(t), |b| unit.wide_aabb(b));
    Course::new((unit.name, form.name()), pairs, wide.answers(|t, b| t.overlaps(b)))
}

/// The test that all ratios refer to.
pub fn yardstick(scene: &Scene) -> Candidate {
    let course = course(scene, &F32, Form::Center);
    course.candidate("yardstick: as published", Promise::Nothing, as_published)
}

/// All our modes in one scalar.
pub fn ours<S: Scalar>(course: &Course<Triangle<S>, Aabb<S>>) -> Vec<Candidate> {
    let modes: [(_, _, Test<S>); 4] = [
        ("exact", Promise::Exact, exact),
        ("conservative", Promise::NeverMisses, conservative),
        ("rounded", Promise::Nothing, rounded),
        ("as published", Promise::Nothing, as_published),
    ];
    modes.map(|(who, promise, test)| course.candidate(who, promise, test)).into()
}
