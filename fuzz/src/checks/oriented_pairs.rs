//! Boxes of either kind against oriented boxes.

use super::triangle_obb::axes;
use crate::scalars::{Check, run};
use crate::shapes::{Shapes, magnitude};
use crate::told::told;
use septum::relation::Relation;
use septum_kit::Sample;
use septum_kit::boxes::{AnyBox, BoxCase, ObbNumbers};

/// `overlaps`, in either order, and `may_overlap`.
pub fn oriented_pairs(data: &[u8]) {
    run::<OrientedPairs>(data);
}

struct OrientedPairs;

pub(super) fn obb<S: Sample>(shapes: &mut Shapes<'_, S>) -> ObbNumbers<S> {
    let axes = axes(shapes);
    ObbNumbers { center: shapes.point(), axes, half: shapes.point().map(magnitude) }
}

impl Check for OrientedPairs {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let second = obb(shapes);
        let first = match shapes.bytes.below(3) {
            0 => AnyBox::Aabb(shapes.aabb()),
            1 => AnyBox::Obb(obb(shapes)),
            // Parallel to the second box.
            _ => AnyBox::Obb(ObbNumbers { axes: second.axes, ..obb(shapes) }),
        };
        let case = BoxCase { first, second };
        // Axes that do not span space are refused: see `constructors`.
        let Some((answers, may)) = case.answers() else { return };
        let meets = case.meets();
        assert_eq!(answers, [meets; 2], "{}", told::<S>(&case));
        assert!(may || !meets, "may_overlap, {}", told::<S>(&case));
        let relations = case.relations().expect("shapes");
        let are_disjoint = relations.map(|relation| relation == Relation::Disjoint);
        assert_eq!(are_disjoint, [!meets; 2], "relation, {}", told::<S>(&case));
    }
}
