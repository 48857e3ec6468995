//! Whether a triangle and an oriented box touch or overlap: the same axes, evaluated twice.

use core::marker::PhantomData;

use super::Disjoint;
use crate::query::relation::{Nearness, Relate, Relation};
use crate::scalar::Scalar;
use crate::shape::{Obb, Triangle};

impl<S: Scalar> Relate<Obb<S>> for Triangle<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        Disjoint { triangle: self, obb, reading: PhantomData::<Nearness> }.answer()
    }
}
