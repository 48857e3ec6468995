//! Sphere against triangle near the origin, in one number system.

use super::{Ball, Beyond};
use crate::arithmetic::{Embeds, Int16};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Near, Overlaps, Sphere, Triangle};

impl<S: Scalar> Overlaps<Near<Sphere<S>>> for Near<Triangle<S>>
where
    Int16: Embeds<S>,
{
    /// Do a triangle and a sphere near the origin have a point in common?
    ///
    /// *Numerics*: exact, in integers of up to 128 bits. *Panics*: never.
    #[inline]
    fn overlaps(&self, sphere: &Near<Sphere<S>>) -> bool {
        let (sphere, shape) = (sphere.get(), self.get());
        Beyond { sphere, shape, ball: Ball::Closed }.filter::<Int16>() != Some(true)
    }
}
