//! Triangle against oriented box.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of
//! Graphics Tools* 6(1), 2001: transform the triangle by the inverse of the box's
//! transform, then test against an axis-aligned box. That is
//! [`overlaps_obb`](crate::published::akenine_moller::overlaps_obb) in `published`. Its
//! rounding moves the triangle, so the exact verdict takes another way: the 13 axes of the
//! two shapes as given.

mod error_bound;
mod exact;
mod kernel;

pub(super) use self::error_bound::error_bound;
use self::exact::ExactParallelepiped;
use self::kernel::{Parallelepiped, any_axis};
pub(super) use self::kernel::{cross, dot};
use super::Overlaps;
use crate::arithmetic::{Embeds, Number, greatest, largest};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Obb, Triangle};

/// The question, for the number systems to answer.
struct Disjoint<'a, S> {
    triangle: &'a Triangle<S>,
    obb: &'a Obb<S>,
}

impl<S: Scalar> Disjoint<'_, S> {
    fn axes(&self) -> [[S; 3]; 3] {
        let [u, v, w] = *self.obb.axes();
        [u.to_array(), v.to_array(), w.to_array()]
    }
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let one = N::one()?;
        let [a, b, c] = self.triangle.points();
        let ([u, v, w], half) = (self.axes(), self.obb.half_extents().to_array());
        let center = self.obb.center().to_array();
        let [a, b, c, center, u, v, w, h] = N::embed(&[a, b, c, center, u, v, w, half])?;

        let operands = |x: [N::Length; 3]| [x[0], x[1], x[2]].map(N::operand);
        let from = |x: [N::Length; 3], y: [N::Length; 3]| {
            operands([x[0] - y[0], x[1] - y[1], x[2] - y[2]])
        };
        let s = Parallelepiped {
            t: [from(a, center), from(b, center), from(c, center)],
            e: [from(b, a), from(c, b), from(a, c)],
            u: [operands(u), operands(v), operands(w)],
            h: operands(h),
            one,
        };
        let axes = most(one, &s.u);
        let length = most(most(N::Product::ZERO, &s.t), &s.e);
        let half = largest(&s.h);
        any_axis(&s, &error_bound::<N>(one, axes, length, half)?).verdict()
    }

    fn exact(&self) -> bool {
        ExactParallelepiped::new::<S>(
            &self.triangle.points(),
            self.obb.center().to_array(),
            &self.axes(),
            self.obb.half_extents().to_array(),
        )
        .separates::<S>()
    }
}

/// The greatest magnitude among the coordinates, and `least` at least.
fn most<P: Number, const K: usize>(least: P, x: &[[P; 3]; K]) -> P {
    x.as_flattened().iter().fold(least, |most, x| greatest(most, x.magnitude()))
}

impl<S: Scalar> Overlaps<Obb<S>> for Triangle<S> {
    /// Whether a triangle and an oriented box have a point in common.
    ///
    /// *Geometry*: closed sets. The box is the parallelepiped that its numbers
    /// describe: axes that a rotation left a little short or askew are taken as
    /// they are.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values. The fast stage serves
    /// floats whose axes have components below 4, with spans as for an
    /// axis-aligned box, and fixed point of at most 30 fraction bits while
    /// differences, axes and half-extents stay within 2³⁰ units in the last place
    /// (2²⁸ where registers have 32 bits). Elsewhere, and for floats within
    /// rounding of contact, exact sums take over: on a Cortex-M0 a verdict in I32F32
    /// takes 12 to 20 million instructions (`docs/target.csv` in the repository).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: some 190 multiplications; fixed point in 128 bits, whatever the type, so
    /// that a narrow type gains nothing here.
    ///
    /// *Source*: separating axes after Gottschalk, Lin and Manocha 1996 and
    /// Akenine-Möller 2001, for axes that need not be orthonormal.
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        !S::evaluate(&Disjoint { triangle: self, obb })
    }

    /// Whether a triangle and an oriented box may have a point in common.
    ///
    /// *Numerics*: `false` is certain. Floats answer `true` within rounding of
    /// contact, and outside the range of the first stage (see
    /// [`overlaps`](Overlaps::overlaps)). Fixed point of 8 and 16 bits is exact; 32
    /// and 64 bits are exact within that range, and answer `true` outside it.
    ///
    /// *Panics*: never. *Cost*: as [`overlaps`](Overlaps::overlaps) without exact sums,
    /// but for 8 and 16 bits.
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { triangle: self, obb }) != Some(true)
    }
}
