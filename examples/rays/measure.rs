//! Runs every method on every case, and counts wrong answers.

use std::ops::AddAssign;

use septum::Feature;

use super::leaks;
use septum_kit::Sample;
use septum_kit::rays::{Aim, Method, RaySet, Scene, Truth, crossing};

/// Wrong answers of one method.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Wrong {
    pub(crate) false_miss: u64,
    pub(crate) false_hit: u64,
    /// The largest error of t over all hits, in ulp.
    pub(crate) worst_t: f64,
}

/// The counts of one set.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) cases: u64,
    pub(crate) hits: u64,
    /// In the order of [`Method::ALL`].
    pub(crate) wrong: [Wrong; Method::ALL.len()],
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.cases += other.cases;
        self.hits += other.hits;
        for (sum, wrong) in self.wrong.iter_mut().zip(other.wrong) {
            sum.false_miss += wrong.false_miss;
            sum.false_hit += wrong.false_hit;
            sum.worst_t = sum.worst_t.max(wrong.worst_t);
        }
    }
}

/// The measurements, made for one scalar.
pub(crate) struct Instance {
    pub(crate) name: String,
    /// The largest permitted error of an exact method's t, in ulp.
    pub(crate) bound: f64,
    pub(crate) set_misfit: fn(RaySet) -> Option<&'static str>,
    pub(crate) measure: fn(RaySet, u64, usize) -> Tally,
    pub(crate) scene_misfit: fn(Scene) -> Option<&'static str>,
    pub(crate) leaks: fn(Scene, Aim, u64, usize) -> leaks::Tally,
}

impl Instance {
    pub(crate) fn of<S: Sample>() -> Self {
        let name = S::name();
        let bound = match name.as_str() {
            "f32" | "f64" => 2.0,
            _ => 0.5,
        };
        Self {
            name,
            bound,
            set_misfit: RaySet::misfit::<S>,
            measure: measure::<S>,
            scene_misfit: Scene::misfit::<S>,
            leaks: leaks::measure::<S>,
        }
    }
}

/// One set in one scalar.
pub(crate) struct SetRow<'a> {
    pub(crate) scalar: &'a Instance,
    pub(crate) set: RaySet,
    pub(crate) tally: Tally,
}

impl SetRow<'_> {
    /// Why the scalar cannot hold the set, if it cannot.
    pub(crate) fn misfit(&self) -> Option<&'static str> {
        (self.scalar.set_misfit)(self.set)
    }

    pub(crate) fn measure(&self, seed: u64, count: usize) -> Tally {
        (self.scalar.measure)(self.set, seed, count)
    }
}

fn measure<S: Sample>(set: RaySet, seed: u64, count: usize) -> Tally {
    let mut tally = Tally::default();
    for case in set.cases::<S>(seed, count) {
        let (ray, triangle, truth) = (case.ray(), case.triangle(), crossing(&case));
        tally.cases += 1;
        tally.hits += u64::from(truth.is_some());
        for (method, wrong) in Method::ALL.into_iter().zip(&mut tally.wrong) {
            match (&truth, method.ask(&ray, &triangle)) {
                (None, None) => {}
                (None, Some(_)) => wrong.false_hit += 1,
                (Some(truth), None) => {
                    wrong.false_miss += u64::from(must_hit(method, truth, &case.t_min, &case.t_max))
                }
                // Beyond the type's range, and for zero, there is no last place.
                (Some(truth), Some(_)) if truth.t.is_beyond::<S>() || truth.t.is_zero() => {}
                (Some(truth), Some(hit)) if !hit.t.is_finite() => wrong.worst_t = f64::INFINITY,
                (Some(truth), Some(hit)) => {
                    wrong.worst_t = wrong.worst_t.max(truth.t.error_in_ulp(hit.t));
                }
            }
        }
    }
    tally
}

/// Whether the method must report a hit if there is one. `hit_once` may leave a contact to a
/// neighbouring triangle.
fn must_hit<S: Sample>(
    method: Method,
    truth: &Truth,
    t_min: &Option<S>,
    t_max: &Option<S>,
) -> bool {
    let is_end = |end: &Option<S>| end.is_some_and(|x| truth.t.compare(x).is_eq());
    method != Method::Once || truth.feature == Feature::Interior && !is_end(t_min) && !is_end(t_max)
}
