//! Rays, segments and oriented boxes; the oracle clips the range of t.

use septum::{Obb, Ray, Segment};
use septum_kit::boxes::BoxSet;
use septum_kit::lines::{Line, LineObb};
use septum_kit::{Rng, Sample};

use super::obb_obb::{SETS, framed};
use super::{Exam, in_scalar};
use crate::candidate::Course;
use crate::line_obb::{ours, peer};
use crate::pairs::Pairs;

/// Rotated, not skewed, boxes, and rays with t ≥ 0: the peer supports no others.
pub(crate) fn sets<S: Sample>(scalar: &'static str) -> Vec<Exam<&'static str>> {
    let exam = |(set, label): (BoxSet, &'static str)| Exam {
        label,
        ask: Box::new(move |seed, count| {
            let rng = &mut Rng::new(seed ^ (set as u64 + 224) << 56);
            let mut rays: (Pairs<Ray<S>, Obb<S>>, Vec<bool>) = Default::default();
            let mut segments: (Pairs<Segment<S>, Obb<S>>, Vec<bool>) = Default::default();
            while rays.1.len() < count {
                let mut case: LineObb<S> = LineObb::case(set, rng);
                let Some(obb) = framed(&case.obb) else { continue };
                if let Line::Ray(o, d, _) = case.line {
                    case.line = Line::Ray(o, d, [Some(S::ZERO), None]);
                    let Some(ray) = case.line.ray() else { continue };
                    rays.0.push(ray, [obb]);
                    rays.1.push(case.clip().is_some());
                } else if let Some(segment) = case.line.segment() {
                    segments.0.push(segment, [obb]);
                    segments.1.push(case.clip().is_some());
                }
            }
            let rays = Course::new((scalar, ""), rays.0, rays.1);
            let mut all = ours(&rays, &Course::new((scalar, ""), segments.0, segments.1));
            if let Some(rays) = in_scalar::<Course<Ray<f32>, Obb<f32>>>(&rays) {
                all.push(peer(rays, "parry3d cast_ray"));
            }
            all
        }),
    };
    SETS.into_iter().map(exam).collect()
}
