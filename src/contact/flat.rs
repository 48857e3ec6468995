//! Contacts of shapes with flat faces.

use super::body::{Body, Rough};
use super::fixed_pair::is_whole;
use super::least::{Directed, Way, least_measures, least_way};
use super::measures::Measures;
use super::points::{Points, features, points};
use super::{Contact, InteriorEdges, Translation};
use crate::scalar::Scalar;

pub(super) fn least_translation<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Translation<S>> {
    let Directed { measures, way, .. } = &least_measures(bodies, || in_floats(bodies))?;
    Some(translation(bodies, way, measures))
}

pub(super) fn contact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    interior: InteriorEdges,
) -> Option<Contact<S>> {
    let origin = bodies[1].origin();
    // In its place from the start, so that it is not copied.
    let mut rough = if is_whole::<S>() { None } else { Some(in_floats(bodies)) };
    let best = least_way(bodies, rough.as_ref(), interior)?;
    let rough = rough.get_or_insert_with(|| in_floats(bodies));
    // Where they are, without a copy.
    let Directed { unit, measures, way } = &best;
    let translation = translation(bodies, way, measures);
    let features = translation.features;
    let mut contact = Contact { translation, is_held: way.is_held, points: Points::none() };
    points(bodies, &origin, rough, way, unit, features, &mut contact.points);
    Some(contact)
}

/// The shapes in floats, relative to the origin of the second.
#[inline(always)]
pub(super) fn in_floats<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> [Rough; 2] {
    [bodies[0].rough(&bodies[1], 1.0), bodies[1].rough(&bodies[1], 1.0)]
}

fn translation<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    way: &Way,
    measures: &Measures<S>,
) -> Translation<S> {
    let &Measures { vector, depth, normal, is_sufficient } = measures;
    Translation { vector, depth, normal, features: features(bodies, way), is_sufficient }
}
