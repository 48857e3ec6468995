//! Capsule against triangle near the origin, in one number system.

use super::{Beyond, passes};
use crate::arithmetic::{Embeds, Int16};
use crate::query::sphere::Ball;
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Capsule, Near, Overlaps, Triangle};

impl<S: Scalar> Overlaps<Near<Capsule<S>>> for Near<Triangle<S>>
where
    Int16: Embeds<S>,
{
    /// Do a triangle and a capsule near the origin have a point in common?
    ///
    /// *Numerics*: exact, in integers of up to 128 bits. *Panics*: never.
    #[inline]
    fn overlaps(&self, capsule: &Near<Capsule<S>>) -> bool {
        let (capsule, shape) = (capsule.get(), self.get());
        Beyond { capsule, shape, ball: Ball::Closed }.filter::<Int16>() != Some(true)
            || passes(capsule, shape).filter::<Int16>() == Some(true)
    }
}
