//! Triangle and box near the origin: queries without the last stages.

use super::Disjoint;
use super::kernel::by_either_form;
#[cfg(feature = "fixed")]
use crate::arithmetic::InWord;
use crate::arithmetic::{Filtered, Int64OfFloats, is_software};
use crate::robust::in_floats;
#[cfg(feature = "fixed")]
use crate::scalar::Scalar;
use crate::shape::{Aabb, Near, Overlaps, Triangle};

#[cfg(feature = "fixed")]
impl<S: Scalar + InWord<i32>> Overlaps<Near<Aabb<S>>> for Near<Triangle<S>> {
    /// Do a triangle and an axis-aligned box near the origin have a point in common?
    ///
    /// *Numerics*: exact, in 32-bit words alone. *Panics*: never.
    #[inline]
    fn overlaps(&self, aabb: &Near<Aabb<S>>) -> bool {
        !Disjoint { triangle: self.get(), aabb: aabb.get() }.in_any_words::<i32>()
    }
}

impl Overlaps<Near<Aabb<f32>>> for Near<Triangle<f32>> {
    /// Do a triangle and an axis-aligned box near the origin have a point in common?
    ///
    /// *Numerics*: exact, in `f32` with an error bound, and where that is in doubt in integers of 60
    /// bits, which hold every coordinate. *Panics*: never.
    #[inline]
    fn overlaps(&self, aabb: &Near<Aabb<f32>>) -> bool {
        let disjoint = Disjoint { triangle: self.get(), aabb: aabb.get() };
        let disjoint_in_floats = if is_software::<f32>() {
            by_either_form::<f32, Filtered<f32>>(self.get(), aabb.get().form())
        } else {
            in_floats::<f32, f32, _>(&disjoint)
        };
        !disjoint_in_floats.unwrap_or_else(|| in_doubt(&disjoint))
    }
}

#[cold]
#[inline(never)]
fn in_doubt(disjoint: &Disjoint<'_, f32>) -> bool {
    let answer = disjoint.in_held::<Int64OfFloats>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}
