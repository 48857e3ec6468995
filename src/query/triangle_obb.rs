//! Triangle against oriented box.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of
//! Graphics Tools* 6(1), 2001: transform the triangle by the inverse of the box's
//! transform, then test against an axis-aligned box. That is
//! [`Triangle::overlaps_by_transform`]. Its rounding moves the triangle, so the
//! exact verdict takes another way: the 13 axes of the two shapes as given.

use super::{MayOverlap, Overlaps};
use crate::axis::{self, Skewed};
use crate::linear::Vec3;
use crate::robust::{ExactSkewed, SKEWED};
use crate::scalar::{Holds, Number, Predicate, Rounded, Scalar, greatest};
use crate::shape::{Aabb, Obb, Triangle};

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
    fn attempt<N: Holds<S>>(&self) -> Option<bool> {
        let one = N::one()?;
        let [a, b, c] = self.triangle.points();
        let ([u, v, w], half) = (self.axes(), self.obb.half_extents().to_array());
        let center = self.obb.center().to_array();
        if !N::fits(&[a, b, c, center, u, v, w, half]) {
            return None;
        }
        let placed = N::place(&[a, b, c, center], &[u, v, w, half]);
        let ([a, b, c, center], [u, v, w, h]) = (placed.points, placed.extents);

        let operands = |x: [N::Length; 3]| [x[0], x[1], x[2]].map(N::operand);
        let from = |x: [N::Length; 3], y: [N::Length; 3]| {
            operands([x[0] - y[0], x[1] - y[1], x[2] - y[2]])
        };
        let s = Skewed {
            t: [from(a, center), from(b, center), from(c, center)],
            e: [from(b, a), from(c, b), from(a, c)],
            u: [operands(u), operands(v), operands(w)],
            h: operands(h),
            one,
        };
        let axes = largest(one, &s.u);
        let length = largest(largest(N::Product::ZERO, &s.t), &s.e);
        let half = largest(N::Product::ZERO, &[s.h]);
        axis::skewed::<N>(&s, N::product_bounds(axes, length, half, SKEWED)?).verdict()
    }

    fn exact(&self) -> bool {
        ExactSkewed::new::<S>(
            &self.triangle.points(),
            self.obb.center().to_array(),
            &self.axes(),
            self.obb.half_extents().to_array(),
        )
        .separates::<S>()
    }
}

/// The greatest magnitude among the coordinates, and `least` at least.
fn largest<P: Number, const K: usize>(least: P, x: &[[P; 3]; K]) -> P {
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
    /// differences, axes and half-extents stay within 2³⁰ units of the last place
    /// (2²⁸ where registers have 32 bits). Elsewhere, and for floats within
    /// rounding of contact, exact sums take over, a hundred times slower.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: some 190 multiplications; fixed point in 128 bits.
    ///
    /// *Source*: separating axes after Gottschalk, Lin and Manocha 1996 and
    /// Akenine-Möller 2001, for axes that need not be orthonormal.
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        !S::decide(&Disjoint { triangle: self, obb })
    }
}

impl<S: Scalar> MayOverlap<Obb<S>> for Triangle<S> {
    /// Whether a triangle and an oriented box may have a point in common.
    ///
    /// *Numerics*: `false` is certain. Floats answer `true` within rounding of
    /// contact, and outside the range of the fast stage (see
    /// [`overlaps`](Overlaps::overlaps)). Fixed point is exact within it, and
    /// answers `true` outside it.
    ///
    /// *Panics*: never. *Cost*: the first stage of
    /// [`overlaps`](Overlaps::overlaps) and no other.
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        Disjoint { triangle: self, obb }.attempt::<S::Products>() != Some(true)
    }
}

impl<S: Scalar> Triangle<S> {
    /// The overlap test with an oriented box as published in 2001, in the
    /// scalar's own arithmetic: the triangle is taken into the box's frame and
    /// tested against an axis-aligned box, rounded at every step.
    ///
    /// *Geometry*: the inverse of a rotation is its transpose, so the axes must be
    /// orthonormal; what they lack to it comes on top of the rounding.
    ///
    /// *Numerics*: sometimes wrong, see
    /// [`overlaps_as_published`](Self::overlaps_as_published).
    ///
    /// *Panics*: never. *Cost*: 27 multiplications and the test.
    ///
    /// *Source*: Akenine-Möller 2001, section 2.
    pub fn overlaps_by_transform(&self, obb: &Obb<S>) -> bool {
        let center = obb.center().to_array();
        let into = |p: [S; 3]| {
            let d = [0, 1, 2].map(|i: usize| Rounded(p[i]) - Rounded(center[i]));
            obb.axes().map(|axis| {
                let [x, y, z] = axis.to_array().map(Rounded);
                (x * d[0] + y * d[1] + z * d[2]).0
            })
        };
        let [a, b, c] = self.points().map(into).map(Vec3::from);
        let aabb = Aabb::about_origin(obb.half_extents());
        Triangle::from_rounded([a, b, c]).overlaps_as_published(&aabb)
    }
}
