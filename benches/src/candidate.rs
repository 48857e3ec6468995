//! Who runs: a test on its data, with its answers checked.

use std::rc::Rc;

use septum::{Aabb, Scalar, Triangle};

use crate::data::{Data, Form, Unit};
use crate::scene::Scene;

/// What a test promises of its answers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Promise {
    Exact,
    NeverMisses,
    Nothing,
}

/// One test on one scene.
pub struct Candidate {
    pub who: String,
    pub scalar: &'static str,
    pub form: &'static str,
    /// Runs through the scene once and counts the overlaps.
    pub run: Box<dyn Fn() -> usize>,
    pub overlaps: usize,
    pub false_disjoint: usize,
    pub false_overlap: usize,
    promise: Promise,
}

impl Candidate {
    pub fn new<T: 'static, B: 'static>(
        who: &str,
        (scalar, form): (&'static str, Form),
        promise: Promise,
        (data, truth): (&Rc<Data<T, B>>, &[bool]),
        test: fn(&T, &B) -> bool,
    ) -> Self {
        let answers = data.answers(test);
        let differ = |said: bool| {
            let wrong = |(a, t): &(&bool, &bool)| **a == said && **t != said;
            answers.iter().zip(truth).filter(wrong).count()
        };
        let (false_disjoint, false_overlap) = (differ(false), differ(true));
        let overlaps = answers.iter().filter(|a| **a).count();
        let data = Rc::clone(data);
        Self {
            who: who.into(),
            scalar,
            form: form.name(),
            run: Box::new(move || data.count(test)),
            overlaps,
            false_disjoint,
            false_overlap,
            promise,
        }
    }

    /// Whether it kept what it promises on this scene.
    pub fn kept_its_word(&self) -> bool {
        match self.promise {
            Promise::Exact => self.false_disjoint == 0 && self.false_overlap == 0,
            Promise::NeverMisses => self.false_disjoint == 0,
            Promise::Nothing => true,
        }
    }
}

/// A mode of ours.
type Test<S> = fn(&Triangle<S>, &Aabb<S>) -> bool;

// Each test behind a function that is called, not inlined.

#[inline(never)]
fn as_published<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.overlaps_as_published(b)
}

#[inline(never)]
fn rounded<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.overlaps_rounded(b)
}

#[inline(never)]
fn conservative<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.may_overlap(b)
}

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    t.overlaps(b)
}

/// The test that all ratios are to.
pub fn yardstick(scene: &Scene) -> Candidate {
    let data = Rc::new(F32.data(scene, Form::Center));
    let truth = F32.truth(&data);
    let is = (F32.name, Form::Center);
    Candidate::new("yardstick: as published", is, Promise::Nothing, (&data, &truth), as_published)
}

/// All our modes in one scalar.
pub fn ours<S: Scalar>(scene: &Scene, unit: &Unit<S>, form: Form) -> Vec<Candidate> {
    let data = Rc::new(unit.data(scene, form));
    let truth = unit.truth(&data);
    let modes: [(_, _, Test<S>); 4] = [
        ("exact", Promise::Exact, exact),
        ("conservative", Promise::NeverMisses, conservative),
        ("rounded", Promise::Nothing, rounded),
        ("as published", Promise::Nothing, as_published),
    ];
    let candidate = |(who, promise, test)| {
        Candidate::new(who, (unit.name, form), promise, (&data, &truth), test)
    };
    modes.map(candidate).into()
}

pub const F32: Unit<f32> = Unit { name: "f32", scale: 1.0, near: |x| x as f32, value: f64::from };
