//! Ray against triangle: verdicts, t, u, v, facing and feature, by every rule.

use septum::prepared::{HitRay, HitTriangle};
use septum::published;
use septum::published::stored_normal::NormalTriangle;
use septum::{Cull, HitRules};

use super::once::counts_once;
use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::is_float;
use crate::told::told;
use septum_kit::Sample;
use septum_kit::rays::{Fraction, Method, RayCase, crossing};

/// `hit`, `hits`, `hit_once`, and both with culling; and that the rounded methods terminate.
pub fn ray_triangle(data: &[u8]) {
    run::<RayTriangle>(data);
}

struct RayTriangle;

impl Check for RayTriangle {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let Some(case) = shapes.ray_case() else { return };
        let (ray, triangle) = (case.ray(), case.triangle());
        let told = |what: &str| format!("{what}, {}", told::<S>(&case));

        let (hit, truth) = (ray.hit(&triangle), crossing(&case));
        assert_eq!(hit.is_some(), truth.is_some(), "{}", told("hit"));
        assert_eq!(ray.is_hit(&triangle), truth.is_some(), "{}", told("hits"));
        if let (Some(hit), Some(truth)) = (hit, &truth) {
            assert_eq!(hit.facing, truth.facing, "{}", told("facing"));
            assert_eq!(hit.feature, truth.feature, "{}", told("feature"));
            for (name, x, truth) in
                [("t", hit.t, &truth.t), ("u", hit.u, &truth.u), ("v", hit.v, &truth.v)]
            {
                assert!(is_rounded(x, truth), "{}", told(&format!("{name} is {x:?}")));
            }
            let _ = (hit.w(), hit.point(&ray));
        }

        // The numbers are the same bits under all rules; only verdicts differ.
        let once = counts_once(&case);
        let prepared = (HitRay::new(&ray), HitTriangle::new(&triangle));
        for cull in [Cull::Nothing, Cull::Back, Cull::Front] {
            let kept = hit.filter(|hit| cull.keeps(hit.facing));
            let rules = HitRules::new().culling(cull);
            for (rules, expected) in [(rules, kept), (rules.once(), kept.filter(|_| once))] {
                assert_eq!(ray.hit_with(&triangle, rules), expected, "{} {rules:?}", told("hit"));
                let hits = ray.is_hit_with(&triangle, rules);
                assert_eq!(hits, expected.is_some(), "{} {rules:?}", told("hits"));
                let hit = prepared.0.hit_with(&prepared.1, rules);
                assert_eq!(hit, expected, "{} {rules:?}", told("prepared"));
                let hits = prepared.0.is_hit_with(&prepared.1, rules);
                assert_eq!(hits, expected.is_some(), "{} {rules:?}", told("prepared"));
            }
        }
        assert_eq!(ray.hit_once(&triangle).is_some(), once, "{}", told("hit_once"));

        check_rounded(&case);
    }
}

/// Whether a number of a hit is as accurate as promised.
fn is_rounded<S: Sample>(x: S, truth: &Fraction) -> bool {
    if !is_float::<S>() {
        return truth.is_nearest(x);
    }
    if truth.is_beyond::<S>() {
        // Beyond the greatest float there is no ulp.
        let end = if truth.approximate() > 0.0 { S::GREATEST } else { S::LEAST };
        return !x.is_finite() || (x > S::ZERO) == (end > S::ZERO);
    }
    x.is_finite() && truth.error_in_ulp(x) <= 2.0 || is_last::<S>(x, truth)
}

/// Whether an infinity stands for a number within the error bound of the greatest.
fn is_last<S: Sample>(x: S, truth: &Fraction) -> bool {
    let end = if truth.approximate() > 0.0 { S::GREATEST } else { S::LEAST };
    let steps = if S::name() == "f32" { 2 } else { 1 << 22 };
    let inner = end.moved(if end > S::ZERO { -steps } else { steps });
    let past = truth.compare(inner).is_ge() == (end > S::ZERO);
    !x.is_finite() && past && (x > S::ZERO) == (end > S::ZERO)
}

/// The rounded methods may give any answer, but must return.
fn check_rounded<S: Sample>(case: &RayCase<S>) {
    let (ray, triangle) = (case.ray(), case.triangle());
    for method in Method::ALL {
        let _ = method.ask(&ray, &triangle);
    }
    let _ = published::stored_normal::t(
        &ray,
        &NormalTriangle::new(&triangle),
        Cull::Nothing,
        S::GREATEST,
    );
}
