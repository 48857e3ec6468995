//! Two oriented boxes; the oracle clips.

use septum::Obb;
use septum_kit::boxes::{AnyBox, BoxCase, BoxSet, ObbNumbers};
use septum_kit::{Rng, Sample};

use super::{Exam, in_scalar};
use crate::candidate::Course;
use crate::native;
use crate::obb_obb::{in_vectors, ours, peer};
use crate::pairs::Pairs;

/// The sets of rotated, not skewed, boxes: the peer supports no others.
pub(crate) const SETS: [(BoxSet, &str); 3] = [
    (BoxSet::Turned, "turned"),
    (BoxSet::NearlyParallel, "nearly parallel"),
    (BoxSet::Grid, "grid"),
];

/// The box, if its axes are orthonormal.
pub(crate) fn framed<S: Sample>(numbers: &ObbNumbers<S>) -> Option<Obb<S>> {
    let obb = numbers.shape().ok()?;
    Obb::new(obb.center(), *obb.axes(), obb.half_extents()).ok()
}

pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |(set, label): (BoxSet, &'static str)| Exam {
        label,
        ask: Box::new(move |seed, count| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 192) << 56);
            let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
            while truth.len() < count {
                let case: BoxCase<S> = set.case(rng);
                let AnyBox::Obb(first) = case.first else { continue };
                let (Some(b), Some(c)) = (framed(&first), framed(&case.second)) else { continue };
                pairs.push(b, [c]);
                truth.push(case.meets());
            }
            let course = Course::new((scalar, ""), pairs, truth);
            let mut all = ours(&course);
            if let Some(course) = in_scalar::<Course<Obb<f32>, Obb<f32>>>(&course) {
                all.push(peer(course, "parry3d"));
                all.push(in_vectors(course));
                all.extend(native::boxes(course));
            }
            all
        }),
    };
    SETS.into_iter().map(exam).collect()
}
