//! Triangle against axis-aligned box.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of Graphics Tools* 6(1),
//! 2001. The 13 axes are the paper's. Three things differ: the nine edge axes share the components
//! of the triangle's normal, faces and plane come first, and the verdict is exact.
//!
//! Three kernels evaluate these axes. `rows` uses floats, four at once, with coordinates as given
//! or as `offsets` from the box. `kernel`, with `frame`, runs in any number system. `words` uses the
//! words of 32-bit cores, and `short` cuts floats to them.

mod conservative;
pub(super) mod error_bound;
pub(super) mod exact;
pub(super) mod frame;
pub(super) mod kernel;
mod offsets;
mod pair;
mod prepared;
mod relation;
pub(super) mod rows;
mod short;
pub(super) mod words;

pub(crate) use error_bound::bound_of_size;
pub(crate) use frame::range;
pub use prepared::PreparedTriangle;
pub(super) use relation::touches_face;

use super::relation::Relation;
use super::{Axis, Overlaps};
use crate::arithmetic::{
    Embeds, Float, InFloat, InRaw, Int64OfFloats, OfFour, OneType, Quad, REGISTERS_ARE_WIDE,
    Rounded, Word, is_software,
};
use crate::robust::{Predicate, Profile, WordKernel, in_cut_floats, in_exact_numbers, in_floats};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Aabb, AabbForm, Near, Triangle, Vec3};

/// Are the triangle and the box disjoint?
struct Disjoint<'a, S> {
    triangle: &'a Triangle<S>,
    aabb: &'a Aabb<S>,
}

impl<S: Scalar> Disjoint<'_, S> {
    /// The answer: from cut coordinates, if they are certain of it.
    #[inline(always)]
    fn answer(&self) -> bool {
        in_cut_floats::<S, _>(|| short::disjoint(self.triangle, self.aabb))
            .unwrap_or_else(|| S::evaluate(self))
    }

    /// How the shapes lie to each other, likewise.
    #[inline(always)]
    fn relation_in_short_words(&self) -> Option<Relation> {
        in_cut_floats::<S, _>(|| short::relation(self.triangle, self.aabb))
    }

    /// Whether `N` holds the shapes.
    #[inline(always)]
    fn is_held<N: Embeds<S>>(&self) -> bool {
        let [a, b, c] = self.triangle.points();
        let (p, q, _) = self.aabb.numbers();
        N::holds(&[a, b, c, p, q])
    }

    /// The answer in `N`, which holds the shapes.
    #[inline(always)]
    fn in_held<N: Embeds<S>>(&self) -> Option<bool> {
        match self.aabb.form() {
            AabbForm::Center { center, half } if N::CORNER_FORM_ONLY => {
                kernel::by_corners::<S, N>(self.triangle, center, center, half)
            }
            AabbForm::Center { center, half } => {
                kernel::by_center::<S, N>(self.triangle, center, half)
            }
            AabbForm::Corners { min, max } => {
                kernel::by_corners::<S, N>(self.triangle, min, max, &Vec3::splat(S::ZERO))
            }
        }
    }
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        // Here, where a fresh shape is still in registers.
        if self.is_held::<N>() { self.in_held::<N>() } else { None }
    }

    const PROFILE: Profile = Profile::QUADS;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<bool>
    where
        S: InFloat<F>,
    {
        pair::pair::<S, F>(self.triangle, self.aabb)
    }

    /// Fixed point of 64 bits is cut to 18 if it may be. Else there are words on narrow registers.
    #[inline(always)]
    fn in_words(&self, is_bounded: bool) -> Option<bool>
    where
        S: FixedBackend,
    {
        if is_bounded && S::Raw::BITS == 64 {
            return Some(conservative::disjoint(self.triangle, self.aabb));
        }
        S::in_machine_words(self)
    }

    fn exact(&self) -> bool {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
        Axis::ALL.iter().any(|&axis| exact::separates(self.triangle, self.aabb, axis))
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Disjoint<'_, S> {
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<bool> {
        if S::is_always_near::<W>() {
            Some(self.in_any_words::<W>())
        } else {
            self.in_near_words::<W>()
        }
    }
}

impl<S: Scalar> Overlaps<Aabb<S>> for Triangle<S> {
    /// Do a triangle and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and one unit. A triangle may be a segment or a point,
    /// and a box may be flat or a point.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. The verdict does not depend on
    /// vertex order, machine or compiler.
    ///
    /// *Range*: all finite floats and all fixed-point values. The first stage serves floats if the
    /// two shapes together span between 2⁻³² and 2⁴⁰. For spans between 2⁻³²⁰ and 2³²⁰, `f64` takes
    /// twice as long. In fixed point with vectors it serves coordinates below 2²⁹ (32 bits) or 2⁴⁹
    /// (64 bits) units in the last place, without vectors below 2¹⁸ or 2⁶⁰, and 8 and 16 bits
    /// always. Outside, and within rounding of contact, wider numbers decide, up to a thousand
    /// times slower.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 48 multiplications and no division, with vectors three at a time, whichever axis
    /// separates. Without vectors it is 21 comparisons if a face separates. Pairs within rounding
    /// of contact are evaluated again in wider numbers, except along a face or on a grid. For many
    /// boxes see [`PreparedTriangle`]. Fixed point on 32-bit
    /// cores has its own kernel with 30 multiplications, for shapes within 2¹⁸ units of the box
    /// (2²⁹ if the core multiplies words in full). Floats that functions compute are first cut to words, which
    /// take a tenth of the instructions. In the repository, `docs/target.csv` lists its
    /// instructions and stack, and `docs/flash.csv` its size.
    ///
    /// *Source*: Akenine-Möller 2001; the shared normal, the rows, the offsets, the error bounds
    /// and the exact stages are ours.
    ///
    /// ```
    /// use septum::{Aabb, Triangle};
    ///
    /// let cell = Aabb::from_center_half_extents([0.5; 3], [0.5; 3])?;
    /// let t = Triangle::new([1.0, 1.0, 1.0], [2.0, 1.0, 1.0], [1.0, 2.0, 2.0])?;
    /// assert!(t.overlaps(&cell)); // in one corner
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        if !S::IN_QUADS {
            return !Disjoint { triangle: self, aabb }.answer();
        }
        // A fresh box stays in registers, and later stages get a copy of it through memory. A
        // vector load of a box that was stored in parts waits for the stores, as long as the test
        // takes.
        let near = *aabb;
        match S::in_quads(&Disjoint { triangle: self, aabb: &near }) {
            Some(disjoint) => !disjoint,
            None => beyond_quads(self, *aabb),
        }
    }

    /// May a triangle and an axis-aligned box have a point in common?
    ///
    /// *Numerics*: `false` is certain, `true` may be wrong. Fixed point of up to 32 bits is exact.
    /// In 64 bits the shapes are rounded to 18 bits, and the box is grown by two units of the last
    /// of these. Floats answer `true` within 24·u·R² of an edge axis and 60·u·R³ of the plane, with
    /// u the unit roundoff and R the span of the two shapes. For a box given by its centre they
    /// also do if a vertex lies within rounding of a face.
    ///
    /// *Range*: floats whose span is outside 2⁻³² to 2⁴⁰ (`f32`) or 2⁻³²⁰ to 2³²⁰ (`f64`) get
    /// `true` unless a face separates.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: bounded. In floats it is the first stage of [`overlaps`](Overlaps::overlaps) on hosts, and takes
    /// longer than that where functions compute them; in fixed point of up to 32 bits it is
    /// [`overlaps`](Overlaps::overlaps) itself. Choose it if a bounded time matters more than the last touch,
    /// or before a finer test.
    #[inline]
    fn may_overlap(&self, aabb: &Aabb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { triangle: self, aabb }) != Some(true)
    }
}

#[cold]
#[inline(never)]
fn beyond_quads<S: Scalar>(triangle: &Triangle<S>, aabb: Aabb<S>) -> bool {
    !S::without_quads(&Disjoint { triangle, aabb: &aabb })
}

/// The kernel in the scalar's own arithmetic, for [`published`](crate::published).
#[inline(always)]
pub(crate) fn disjoint_rounded<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    if S::FLOAT.is_some() && <S::SeptumFirst as OfFour>::Quad::IS_VECTOR {
        return rows::disjoint_rounded(triangle, aabb);
    }
    // An axis whose numbers overflowed to NaN does not separate.
    Disjoint { triangle, aabb }.filter::<OneType<Rounded<S>>>() == Some(true)
}

#[cfg(feature = "fixed")]
impl<S: Scalar + InRaw<Raw = i32>> Overlaps<Near<Aabb<S>>> for Near<Triangle<S>> {
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
    /// *Numerics*: exact, in `f32` with an error bound, or in words of cut coordinates where functions compute `f32`;
    /// and where that is in doubt in integers of 60 bits, which hold every coordinate. *Panics*: never.
    #[inline]
    fn overlaps(&self, aabb: &Near<Aabb<f32>>) -> bool {
        let disjoint = Disjoint { triangle: self.get(), aabb: aabb.get() };
        let first = if is_software::<f32>() {
            short::disjoint(self.get(), aabb.get())
        } else {
            in_floats::<f32, f32, _>(&disjoint)
        };
        !first.unwrap_or_else(|| in_doubt(&disjoint))
    }
}

#[cold]
#[inline(never)]
fn in_doubt(disjoint: &Disjoint<'_, f32>) -> bool {
    let answer = disjoint.in_held::<Int64OfFloats>();
    debug_assert!(answer.is_some());
    answer.unwrap_or_default()
}

#[cfg(all(test, feature = "fixed"))]
mod tests;
