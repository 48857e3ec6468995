//! Overlapping oriented boxes; the oracle tries all axes in integers.

use septum::Obb;
use septum_kit::boxes::{AnyBox, ObbNumbers};
use septum_kit::contacts::{ContactCase, Solid};
use septum_kit::{Rng, Sample};

use super::obb_obb::{SETS, framed};
use super::{Exam, in_scalar};
use crate::candidate::{Candidate, Course};
use crate::contact::{Sunk, ours, parry_contact, parry_manifold};
use crate::native;
use crate::pairs::Pairs;

pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exams = SETS.into_iter().map(|(set, label)| Exam {
        label,
        ask: Box::new(move |seed: u64, count: usize| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 224) << 56);
            let mut cases = Vec::new();
            while cases.len() < count {
                let case = set.case::<S>(rng);
                let AnyBox::Obb(first) = case.first else { continue };
                if framed(&first).is_some() && framed(&case.second).is_some() {
                    cases.push([first, case.second]);
                }
            }
            answers(scalar, &cases)
        }) as super::Ask,
    });
    exams.collect()
}

/// Our answers, and in `f32` the peers', for pairs of boxes with orthonormal axes.
pub(crate) fn answers<S: Sample>(
    scalar: &'static str,
    cases: &[[ObbNumbers<S>; 2]],
) -> Vec<Candidate> {
    let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
    for [first, second] in cases {
        let (Some(a), Some(b)) = (framed(first), framed(second)) else { continue };
        let solid = |b: &ObbNumbers<S>| Solid::Box(AnyBox::Obb(*b));
        let depth = ContactCase { first: solid(first), second: solid(second) }.least_depth();
        truth.push(depth.is_some());
        pairs.push(Sunk { pair: [a, b], depth }, [()]);
    }
    let course = Course::new((scalar, ""), pairs, truth);
    let mut all = ours(&course);
    if let Some(course) = in_scalar::<Course<Sunk<Obb<f32>>, ()>>(&course) {
        all.push(parry_contact(course));
        all.push(parry_manifold(course, "parry3d manifold"));
        all.extend(native::contacts(course));
    }
    all
}
