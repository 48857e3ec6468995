//! Ray against axis-aligned box: verdicts, t of entry and exit, prepared rays.

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::is_float;
use crate::told::told;
use septum::prepared::PreparedRay;
use septum::published;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum_kit::Sample;
use septum_kit::lines::{Fraction, LineBox};

/// `overlaps`, `may_overlap`, `t_range`; `overlaps` of a `PreparedRay`, and `may_overlap` of a
/// `SlabRay`; and that the rounded methods terminate and agree with each other.
pub fn ray_aabb(data: &[u8]) {
    run::<RayAabb>(data);
}

struct RayAabb;

impl Check for RayAabb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let Some(case) = shapes.ray_box() else { return };
        let (ray, aabb) = (case.ray().expect("a ray"), case.aabb());
        let slabs = SlabRay::new(&ray);

        let clipped = case.clip();
        let truth = clipped.is_some();
        assert_eq!(ray.overlaps(&aabb), truth, "overlaps, {}", told::<S>(&case));
        assert!(ray.may_overlap(&aabb) || !truth, "may_overlap, {}", told::<S>(&case));
        let prepared = PreparedRay::new(&ray);
        assert_eq!(prepared.overlaps(&aabb), truth, "prepared, {}", told::<S>(&case));
        let may = slabs.may_overlap(&aabb);
        assert!(may || !truth, "slabs, {}", told::<S>(&case));

        let found = ray.t_range(&aabb);
        assert_eq!(found.is_some(), truth, "t_range, {}", told::<S>(&case));
        if let (Some((enter, leave)), Some([Some(from), Some(to)])) = (found, clipped) {
            check_ends(&case, [(enter, from), (leave, to)]);
        }

        let range = slabs.t_range_rounded(&aabb);
        assert_eq!(range.is_some(), slabs.overlaps_rounded(&aabb), "{}", told::<S>(&case));
        let slopes = SlopeRay::new(&ray);
        let _ = (slopes.overlaps_rounded(&aabb), slopes.t_enter_rounded(&aabb));
        let _ = published::separating_axes::ray_overlaps(&ray, &aabb);
    }
}

fn check_ends<S: Sample>(case: &LineBox<S>, ends: [(S, Fraction); 2]) {
    assert!(ends[0].0 <= ends[1].0, "{}", told::<S>(&case));
    for (t, truth) in ends {
        let told = || told::<S>(&(t, case));
        if !is_float::<S>() {
            assert_eq!(t, truth.nearest_fixed(), "{}", told());
        } else if t.is_finite() {
            // Hundredths of the last place.
            let bound = if S::name() == "f32" { 51 } else { 160 };
            assert!(truth.is_within(t, (bound, 100)), "{}", told());
        } else {
            // Overflow: the true t is within the bound of the greatest number, or beyond it.
            let end = if t > S::ZERO { S::GREATEST } else { S::LEAST };
            let beyond = truth.exceeds_number(end) == (t > S::ZERO);
            assert!(beyond || truth.is_within(end, (160, 100)), "{}", told());
        }
    }
}
