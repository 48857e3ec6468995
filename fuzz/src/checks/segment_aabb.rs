//! Segment against axis-aligned box.

use crate::scalars::{Check, run};
use crate::shapes::Shapes;
use crate::told::told;
use septum::published;
use septum_kit::Sample;
use septum_kit::lines::{Line, LineBox};

/// `overlaps` and `may_overlap`; and that the rounded method terminates.
pub fn segment_aabb(data: &[u8]) {
    run::<SegmentAabb>(data);
}

struct SegmentAabb;

impl Check for SegmentAabb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let aabb = shapes.aabb();
        let (a, b) = (shapes.point(), shapes.point());
        let by_center = shapes.bytes.one_in(2);
        let line = if by_center { Line::Center(a, b) } else { Line::Ends(a, b) };
        let case = LineBox { line, aabb };

        let truth = case.meets();
        assert_eq!(case.overlaps(), truth, "overlaps, {}", told::<S>(&case));
        assert!(case.may_overlap() || !truth, "may_overlap, {}", told::<S>(&case));
        let segment = case.segment().expect("two points");
        let _ = published::separating_axes::segment_overlaps(&segment, &case.aabb());
    }
}
