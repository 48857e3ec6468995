//! Contacts of shapes with flat faces.

use super::body::{Body, Rough};
use super::integers::is_whole;
use super::least::{least_measures, least_way};
use super::measures::Directed;
use super::points::{features, points};
use super::{Contact, InteriorEdges, Translation};
use crate::scalar::Scalar;

pub(super) fn least_translation<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Translation<S>> {
    // Where it is, without a copy.
    let found = least_measures(bodies, || in_floats(bodies));
    let Directed { measures, way, .. } = found.as_ref()?;
    Some(measures.translation(features(bodies, way)))
}

pub(super) fn contact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    interior: InteriorEdges,
) -> Option<Contact<S>> {
    if is_whole::<S>() {
        let best = least_way(bodies, None, interior);
        let best = best.as_ref()?;
        return Some(with_points(bodies, &mut in_floats(bodies), best));
    }
    let mut rough = in_floats(bodies);
    let best = least_way(bodies, Some(&rough), interior);
    Some(with_points(bodies, &mut rough, best.as_ref()?))
}

/// The contact of a way out, and its points.
#[inline(always)]
fn with_points<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &mut [Rough; 2],
    best: &Directed<S>,
) -> Contact<S> {
    // Where they are, without a copy.
    let Directed { measures, way, .. } = best;
    let translation = measures.translation(features(bodies, way));
    let features = translation.features;
    let points = points(bodies, &bodies[1].origin(), rough, best, features);
    Contact { translation, is_held: way.is_held, points }
}

/// The shapes in floats, relative to the origin of the second.
#[inline(always)]
pub(super) fn in_floats<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> [Rough; 2] {
    [bodies[0].rough(&bodies[1], 1.0), bodies[1].rough(&bodies[1], 1.0)]
}
