//! Oriented box against oriented and axis-aligned box.

mod error_bound;
mod exact;
mod floats;
mod frames;
mod kernel;
mod rows;

use self::error_bound::error_bound;
use self::exact::ExactBoxes;
use self::frames::InDoubt;
use self::kernel::{Boxes, all_axes};
use super::Overlaps;
use super::obb_short;
use super::orientation::Vector;
use super::relation::{Asked, Relate, Relation};
use super::triangle_obb::{has_second_look, operands, way};
use crate::arithmetic::{
    Each, Embeds, Float, InFloat, Number, greatest, largest, of_two, once, three,
};
use crate::arithmetic::{REGISTERS_ARE_WIDE, Word};
use crate::robust::{Numeric, Predicate, Profile, in_cut_floats, noted};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Aabb, Obb};

/// The question how a box and an oriented box lie to each other.
struct Lie<'a, S> {
    first: First<'a, S>,
    second: &'a Obb<S>,
    asked: Asked,
}

/// An axis-aligned or an oriented box.
#[derive(Clone, Copy)]
enum First<'a, S> {
    Aabb(&'a Aabb<S>),
    Obb(&'a Obb<S>),
}

impl<S: Scalar> Lie<'_, S> {
    #[cold]
    #[inline(never)]
    fn by_second_look<N: Embeds<S>>(&self) -> Option<Relation> {
        self.by_these_axes::<N>(true)
    }

    /// The relation by the axes in a number system.
    #[inline(always)]
    fn by_these_axes<N: Embeds<S>>(&self, looks_twice: bool) -> Option<Relation> {
        let zero = N::Product::ZERO;
        let three_operands = |axes: [Vector<N>; 3]| axes.each(operands::<N>);
        let [b, v0, v1, v2, k] = self.second.numbers();
        let boxes = match self.first {
            First::Obb(first) => {
                let [a, u0, u1, u2, h] = first.numbers();
                let ([v0, v1, v2, b, k, u0, u1, u2, a, h], one) =
                    N::embed_with_one(&[v0, v1, v2, b, k, u0, u1, u2, a, h])?;
                Boxes {
                    d: way::<N>(b, a),
                    u: three_operands([u0, u1, u2]),
                    h: operands::<N>(h),
                    v: three_operands([v0, v1, v2]),
                    k: operands::<N>(k),
                    one,
                }
            }
            First::Aabb(first) => {
                let (p, q, is_by_center) = first.numbers();
                let ([v0, v1, v2, b, k, p, q], one) = N::embed_with_one(&[v0, v1, v2, b, k, p, q])?;
                let (d, h, k) = if is_by_center {
                    (way::<N>(b, p), operands::<N>(q), operands::<N>(k))
                } else {
                    (
                        operands::<N>(three(|i| of_two::<N, _>((b[i] - p[i]) + (b[i] - q[i])))),
                        operands::<N>(three(|i| of_two::<N, _>(q[i] - p[i]))),
                        operands::<N>(k.each(once::<N, _>)),
                    )
                };
                let u = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
                Boxes { d, u, h, v: three_operands([v0, v1, v2]), k, one }
            }
        };
        let most =
            |x: &[[N::Product; 3]; 3]| x.iter().fold(zero, |most, x| greatest(most, largest(x)));
        let axes = greatest(greatest(most(&boxes.u), most(&boxes.v)), boxes.one);
        let half = greatest(largest(&boxes.h), largest(&boxes.k));
        let error = error_bound::<N>(boxes.one, axes, largest(&boxes.d), half)?;
        all_axes(&boxes, &error, N::CERTAIN, looks_twice)
    }

    /// The relation. Floats that functions compute begin with cut numbers.
    #[inline(always)]
    fn relation(&self) -> Relation {
        let cut = || match self.first {
            First::Obb(first) => obb_short::floats::boxes(first, self.second),
            First::Aabb(first) => obb_short::floats::aabb_and_obb(first, self.second),
        };
        in_cut_floats::<S, _>(cut).unwrap_or_else(|| S::evaluate_numeric(self))
    }
}

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        match self.by_these_axes::<N>(false) {
            None if has_second_look::<N>() => self.by_second_look::<N>(),
            answer => answer,
        }
    }

    const PROFILE: Profile = Profile::QUADS_AND_CUT;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<Relation>
    where
        S: InFloat<F>,
    {
        match frames::relation::<S, F>(self) {
            Some(Ok(relation)) => Some(relation),
            Some(Err(InDoubt)) => rows::relation_near_contact::<S, F>(self),
            None => rows::relation::<S, F>(self),
        }
    }

    #[inline(never)]
    fn in_words(&self, _: bool) -> Option<Relation>
    where
        S: FixedBackend,
    {
        // `f64` holds 32 bits, and leaves only near contacts to other stages. `may_overlap` has
        // no stage that some machines lack.
        if REGISTERS_ARE_WIDE && S::Raw::BITS < 64 && self.asked != Asked::MayOverlap {
            return noted(None);
        }
        noted(match self.first {
            First::Obb(first) => obb_short::boxes(first, self.second),
            First::Aabb(first) => obb_short::aabb_and_obb(first, self.second),
        })
    }

    fn exact(&self) -> Relation {
        ExactBoxes::new(self).relation::<S>()
    }
}

impl<S: Scalar> Numeric<S> for Lie<'_, S> {}

impl<S: Scalar> Overlaps<Obb<S>> for Obb<S> {
    /// Do two oriented boxes have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and one unit. Each box is the parallelepiped that its
    /// numbers describe, also if rounding left its axes slightly short or skewed. Flat boxes,
    /// segments and points are boxes.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. Parallel and nearly parallel axes
    /// need no threshold.
    ///
    /// *Range*: as for a triangle and an [oriented
    /// box](crate::Triangle#impl-Overlaps<Obb<S>>-for-Triangle<S>).
    ///
    /// *Panics*: never. *Cost*: 21 multiplications if a coordinate separates, about 180 if a face
    /// does, and otherwise 267; with vectors, four at once, and half as many if the axes are
    /// orthonormal up to rounding. Where floats are in doubt, integers
    /// take ten times as long if they hold all coordinates, and exact sums longer. Without vectors,
    /// fixed point of up to 32 bits begins in `f64` on a machine that has it. All other fixed point, and floats
    /// that functions compute, begin in integers: about 210 multiplications.
    ///
    /// *Source*: S. Gottschalk, M. C. Lin, D. Manocha, SIGGRAPH 1996; skewed axes and the exact
    /// stages are ours.
    ///
    /// ```
    /// use septum::Obb;
    ///
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([0.0, 0.0, 0.0], axes, [2.0, 1.0, 0.5])?;
    /// let above = Obb::new([0.0, 0.0, 1.0], axes, [1.0, 1.0, 0.5])?;
    /// assert!(tool.overlaps(&above)); // face on face
    /// let above = Obb::new([0.0, 0.0, 1.0000000000000002], axes, [1.0, 1.0, 0.5])?;
    /// assert!(!tool.overlaps(&above));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Obb<S>) -> bool {
        let question = Lie { first: First::Obb(self), second: other, asked: Asked::Overlaps };
        question.relation() != Relation::Disjoint
    }

    /// May two oriented boxes have a point in common?
    ///
    /// *Numerics*: `false` is certain. In floats `true` may be wrong within rounding of contact,
    /// and beyond the range of the first stage of [`overlaps`](Overlaps::overlaps). Fixed point is
    /// exact in up to 16 bits; in more, `true` may be wrong within some 2⁻¹⁵ of the shapes' size of
    /// contact, wherever the shapes are: for less than one in a thousand pairs of random shapes.
    ///
    /// *Panics*: never. *Cost*: bounded; as for the first stages of
    /// [`overlaps`](Overlaps::overlaps), but floats that functions compute take longer.
    #[inline]
    fn may_overlap(&self, other: &Obb<S>) -> bool {
        let question = Lie { first: First::Obb(self), second: other, asked: Asked::MayOverlap };
        S::evaluate_bounded(&question) != Some(Relation::Disjoint)
    }
}

impl<S: Scalar> Relate<Obb<S>> for Obb<S> {
    fn relation(&self, other: &Obb<S>) -> Relation {
        Lie { first: First::Obb(self), second: other, asked: Asked::Relation }.relation()
    }
}

impl<S: Scalar> Overlaps<Obb<S>> for Aabb<S> {
    /// Do an axis-aligned box and an oriented box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and one unit. The axis-aligned box is given by its
    /// corners, or by centre and half-extents. The oriented box is the parallelepiped that its
    /// numbers describe. Flat boxes, segments and points are boxes.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*, *Panics*, *Cost* and *Source*: as for [two oriented
    /// boxes](Obb#impl-Overlaps<Obb<S>>-for-Obb<S>).
    ///
    /// ```
    /// use septum::{Aabb, Obb};
    ///
    /// let cell = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([2.4, 0.5, 0.5], axes, [1.0, 1.0, 0.25])?;
    /// assert!(tool.overlaps(&cell)); // a corner reaches to x = 1
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        let question = Lie { first: First::Aabb(self), second: obb, asked: Asked::Overlaps };
        question.relation() != Relation::Disjoint
    }

    /// May an axis-aligned box and an oriented box have a point in common?
    ///
    /// *Numerics*, *Panics* and *Cost*: as for [two oriented
    /// boxes](Obb#impl-Overlaps<Obb<S>>-for-Obb<S>).
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        let question = Lie { first: First::Aabb(self), second: obb, asked: Asked::MayOverlap };
        S::evaluate_bounded(&question) != Some(Relation::Disjoint)
    }
}

impl<S: Scalar> Relate<Obb<S>> for Aabb<S> {
    fn relation(&self, obb: &Obb<S>) -> Relation {
        Lie { first: First::Aabb(self), second: obb, asked: Asked::Relation }.relation()
    }
}
