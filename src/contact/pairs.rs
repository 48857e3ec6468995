//! The pairs of shapes that have contacts, and the contacts of those with flat faces.

use super::body::{Body, Flat, Rough, Round, in_floats};
use super::integers::has_words;
use super::least::{least_measures, least_way};
use super::measures::Directed;
use super::points::{features, points};
use super::{Contact, InteriorEdges, Translation, round};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule, Obb, Overlaps, Sphere, Triangle};
use sealed::{Near, Pair, Solid};

/// A shape with flat faces that has contacts: a [`Triangle`], an [`Aabb`] or an [`Obb`].
///
/// The trait is sealed. Code that is generic over spheres and capsules too asks for
/// [`ContactWith`].
pub trait Shape<S>: sealed::Solid<Scalar = S> {}

impl<S, A: sealed::Solid<Scalar = S>> Shape<S> for A {}

/// A shape that has contacts with another shape. [The module](super#pairs) lists the pairs.
///
/// The trait is sealed.
pub trait ContactWith<S: Scalar, Other>: sealed::Pair<S, Other> {}

impl<S: Scalar, A: sealed::Pair<S, Other>, Other> ContactWith<S, Other> for A {}

pub(super) mod sealed {
    use super::{Body, Contact, Flat, InteriorEdges, Scalar, Translation};

    /// A shape with flat faces.
    pub trait Solid {
        type Scalar;

        fn body(&self) -> Body<'_, Self::Scalar>;
    }

    /// A shape that has contacts with spheres and capsules.
    pub trait Near: Solid {
        fn flat(&self) -> Flat<'_, Self::Scalar>;
    }

    #[diagnostic::on_unimplemented(
        message = "`{Self}` has no contacts with `{Other}`",
        note = "spheres and capsules have contacts with triangles and with axis-aligned boxes"
    )]
    pub trait Pair<S: Scalar, Other> {
        fn least_translation_from(&self, other: &Other) -> Option<Translation<S>>;
        fn contact_with(&self, other: &Other, interior: InteriorEdges) -> Option<Contact<S>>;
    }
}

impl<S: Scalar> Solid for Triangle<S> {
    type Scalar = S;

    fn body(&self) -> Body<'_, S> {
        Body::Triangle(self)
    }
}

impl<S: Scalar> Solid for Aabb<S> {
    type Scalar = S;

    fn body(&self) -> Body<'_, S> {
        Body::Aabb(self)
    }
}

impl<S: Scalar> Solid for Obb<S> {
    type Scalar = S;

    fn body(&self) -> Body<'_, S> {
        Body::Obb(self)
    }
}

impl<S: Scalar> Near for Triangle<S> {
    fn flat(&self) -> Flat<'_, S> {
        Flat::Triangle(self)
    }
}

impl<S: Scalar> Near for Aabb<S> {
    fn flat(&self) -> Flat<'_, S> {
        Flat::Aabb(self)
    }
}

impl<S: Scalar, A: Solid<Scalar = S>, B: Solid<Scalar = S>> Pair<S, B> for A {
    fn least_translation_from(&self, other: &B) -> Option<Translation<S>> {
        least_translation(&[self.body(), other.body()])
    }
    fn contact_with(&self, other: &B, interior: InteriorEdges) -> Option<Contact<S>> {
        contact(&[self.body(), other.body()], interior)
    }
}

fn of_sphere<S: Scalar>(sphere: &Sphere<S>) -> Round<S> {
    Round { ends: [sphere.center(); 2], radius: sphere.radius() }
}

fn of_capsule<S: Scalar>(capsule: &Capsule<S>) -> Round<S> {
    Round { ends: capsule.ends().into(), radius: capsule.radius() }
}

impl<S: Scalar, B: Near<Scalar = S>> Pair<S, B> for Sphere<S>
where
    Self: Overlaps<B>,
{
    fn least_translation_from(&self, other: &B) -> Option<Translation<S>> {
        let meets = self.overlaps(other);
        meets.then(|| round::least_translation(other.flat(), &of_sphere(self), true))?
    }
    fn contact_with(&self, other: &B, interior: InteriorEdges) -> Option<Contact<S>> {
        let meets = self.overlaps(other);
        meets.then(|| round::contact(other.flat(), &of_sphere(self), true, interior))?
    }
}

impl<S: Scalar, B: Near<Scalar = S>> Pair<S, B> for Capsule<S>
where
    Self: Overlaps<B>,
{
    fn least_translation_from(&self, other: &B) -> Option<Translation<S>> {
        let meets = self.overlaps(other);
        meets.then(|| round::least_translation(other.flat(), &of_capsule(self), true))?
    }
    fn contact_with(&self, other: &B, interior: InteriorEdges) -> Option<Contact<S>> {
        let meets = self.overlaps(other);
        meets.then(|| round::contact(other.flat(), &of_capsule(self), true, interior))?
    }
}

impl<S: Scalar, A: Near<Scalar = S>> Pair<S, Sphere<S>> for A
where
    Sphere<S>: Overlaps<A>,
{
    fn least_translation_from(&self, other: &Sphere<S>) -> Option<Translation<S>> {
        let meets = other.overlaps(self);
        meets.then(|| round::least_translation(self.flat(), &of_sphere(other), false))?
    }
    fn contact_with(&self, other: &Sphere<S>, interior: InteriorEdges) -> Option<Contact<S>> {
        let meets = other.overlaps(self);
        meets.then(|| round::contact(self.flat(), &of_sphere(other), false, interior))?
    }
}

impl<S: Scalar, A: Near<Scalar = S>> Pair<S, Capsule<S>> for A
where
    Capsule<S>: Overlaps<A>,
{
    fn least_translation_from(&self, other: &Capsule<S>) -> Option<Translation<S>> {
        let meets = other.overlaps(self);
        meets.then(|| round::least_translation(self.flat(), &of_capsule(other), false))?
    }
    fn contact_with(&self, other: &Capsule<S>, interior: InteriorEdges) -> Option<Contact<S>> {
        let meets = other.overlaps(self);
        meets.then(|| round::contact(self.flat(), &of_capsule(other), false, interior))?
    }
}

pub(super) fn least_translation<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Translation<S>> {
    // Where it is, without a copy.
    let found = least_measures(bodies);
    let Directed { measures, way, .. } = found.as_ref()?;
    Some(measures.translation(features(bodies, way)))
}

pub(super) fn contact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    interior: InteriorEdges,
) -> Option<Contact<S>> {
    if has_words::<S>() {
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
