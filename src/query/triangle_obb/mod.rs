//! Triangle against oriented box.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of Graphics Tools* 6(1),
//! 2001, transforms the triangle by the inverse of the box's transform and tests it against an
//! axis-aligned box. That is [`overlaps_obb`](crate::published::akenine_moller::overlaps_obb) in
//! `published`. Its rounding moves the triangle, so the exact verdict uses the 13 axes of the two
//! shapes as given (`kernel`). Fixed point, and floats that functions compute (`floats`), first transform the
//! triangle in short words, with a bound on the error (`short`); for many triangles, the products of the axes
//! are computed once (`prepared`). The last stages, words of 64 bits and exact sums, follow a look at numbers cut to
//! 18 bits (`cut`).

mod cut;
mod error_bound;
pub(super) mod exact;
mod floats;
mod kernel;
mod known;
mod prepared;
mod relation;
mod short;

use core::marker::PhantomData;

use self::exact::{ExactParallelepiped, InSums, InWords};
use self::kernel::{Parallelepiped, all_axes};
use self::short::Change;
use super::Overlaps;
use super::relation::Reading;
use crate::arithmetic::{
    Arithmetic, Each, Embeds, InRaw, Number, REGISTERS_ARE_WIDE, SMALL_CODE, WholeWord, Word,
    greatest, largest,
};
use crate::robust::{Predicate, Profile, Uncertain, WordKernel, noted};
use crate::scalar::{FixedBackend, Scalar};
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Obb, Triangle};

pub(super) use self::error_bound::error_bound;
pub(super) use self::kernel::{lie_along_one_axis, operands, way};
pub use self::prepared::PreparedObb;
pub(super) use self::short::{EXACT, are_disjoint};
pub(super) use known::{Known, Size, raw};

/// Are the triangle and the oriented box disjoint, or, by [`Nearness`](super::relation::Nearness), do they
/// touch or overlap?
pub(super) struct Disjoint<'a, S, R = Uncertain> {
    triangle: &'a Triangle<S>,
    obb: &'a Obb<S>,
    reading: PhantomData<R>,
}

impl<'a, S> Disjoint<'a, S> {
    #[inline(always)]
    pub(super) const fn new(triangle: &'a Triangle<S>, obb: &'a Obb<S>) -> Self {
        Self { triangle, obb, reading: PhantomData }
    }
}

impl<S: Scalar, R: Reading> Predicate<S> for Disjoint<'_, S, R> {
    type Answer = R::Answer;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<R::Answer> {
        self.by_axes::<N>()
    }

    const PROFILE: Profile = Profile::CUT;

    /// First in short words with a bound; then in words that hold all: on narrow registers, and of 64-bit
    /// fixed point shapes on a grid.
    ///
    /// If the triangle meets the shrunk box, it has a point in the interior of the true box,
    /// because the bound exceeds the error. The triangle's interior has points arbitrarily near
    /// that point, so some of them are in the interior of the box too.
    #[inline(always)]
    fn in_words(&self, is_bounded: bool) -> Option<R::Answer>
    where
        S: FixedBackend,
    {
        if is_bounded {
            let framed = self.framed(Change::Grown, Self::vertices_from_center);
            return Some(R::clear(framed.is_none_or(|framed| framed.are_certainly_disjoint())));
        }
        let answer = noted(self.in_short_words()).map(R::clear);
        if REGISTERS_ARE_WIDE && !SMALL_CODE && S::Raw::BITS == 64 {
            let one = || S::one_in::<i64>().filter(|one| one.has_volumes());
            return answer.or_else(|| self.in_near_words(one()?));
        }
        answer.or_else(|| S::in_machine_words(self))
    }

    fn exact(&self) -> R::Answer {
        let exact =
            ExactParallelepiped::<InSums<S>>::new(self.triangle.points(), self.obb.numbers());
        if REGISTERS_ARE_WIDE && !SMALL_CODE { exact.after_cut::<R>() } else { exact.answer::<R>() }
    }
}

impl<S: Scalar + InRaw, R: Reading> WordKernel<S> for Disjoint<'_, S, R> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<R::Answer> {
        let one = S::one_in::<W>()?;
        if S::is_always_near::<W>() {
            Some(self.in_any_words::<W>(one))
        } else {
            self.in_near_words::<W>(one)
        }
    }
}

/// Whether zero axes can cause doubt, and code size does not matter.
pub(super) const fn has_second_look<N: Arithmetic>() -> bool {
    !N::CERTAIN && !SMALL_CODE
}

impl<S: Scalar> Disjoint<'_, S> {
    /// Whether a face of the box separates, by exact sums.
    pub(super) fn is_beyond_a_face(&self) -> bool {
        ExactParallelepiped::<InSums<S>>::new(self.triangle.points(), self.obb.numbers())
            .is_beyond_a_face()
    }
}

impl<S: Scalar, R: Reading> Disjoint<'_, S, R> {
    #[inline(always)]
    fn answer(&self) -> R::Answer {
        self.in_cut_floats().map_or_else(|| S::evaluate(self), R::clear)
    }

    /// The relation by the axes in a number system, if it is certain.
    #[inline(always)]
    fn by_axes<N: Embeds<S>>(&self) -> Option<R::Answer> {
        match self.by_these_axes::<N>(false) {
            None if has_second_look::<N>() => self.by_second_look::<N>(),
            answer => answer,
        }
    }

    #[cold]
    #[inline(never)]
    fn by_second_look<N: Embeds<S>>(&self) -> Option<R::Answer> {
        self.by_these_axes::<N>(true)
    }

    #[inline(always)]
    fn by_these_axes<N: Embeds<S>>(&self, looks_twice: bool) -> Option<R::Answer> {
        let ([a, b, c], [center, u, v, w, half]) = (self.triangle.points(), self.obb.numbers());
        let ([a, b, c, center, u, v, w, h], one) =
            N::embed_with_one(&[a, b, c, center, u, v, w, half])?;
        let s = Parallelepiped {
            t: [way::<N>(a, center), way::<N>(b, center), way::<N>(c, center)],
            e: [way::<N>(b, a), way::<N>(c, b), way::<N>(a, c)],
            u: [operands::<N>(u), operands::<N>(v), operands::<N>(w)],
            h: operands::<N>(h),
            one,
        };
        let axes = most(one, &s.u);
        let length = most(most(N::Product::ZERO, &s.t), &s.e);
        let half = largest(&s.h);
        let error = error_bound::<N>(one, axes, length, half)?;
        all_axes::<_, R>(&s, &error, looks_twice).answer(N::CERTAIN)
    }
}

/// The last stage in words, for narrow registers.
impl<S: Scalar + InRaw, R: Reading> Disjoint<'_, S, R> {
    /// The first stage for shapes that are near. Its stack is free again before the last stage.
    #[inline(never)]
    fn first_near_stage(&self) -> Option<bool> {
        are_disjoint(self.obb, || Known::Nothing, EXACT, || self.vertices_from_near())
    }

    /// The answer in words that hold the shapes wherever they are.
    #[cold]
    #[inline(never)]
    fn in_any_words<W: WholeWord>(&self, one: W) -> R::Answer {
        self.in_words(one).after_cut::<R>()
    }

    /// The answer in words that hold the shapes if they are near each other, or far apart and of
    /// few digits.
    #[cold]
    #[inline(never)]
    fn in_near_words<W: WholeWord>(&self, one: W) -> Option<R::Answer> {
        let mut words = self.in_words(one);
        let center = self.obb.center().to_array().each(S::in_word::<W>);
        (center.iter().all(|x| x.is_central()) && words.becomes_near())
            .then(|| words.after_cut::<R>())
    }

    #[inline(always)]
    fn in_words<W: WholeWord>(&self, one: W) -> ExactParallelepiped<InWords<W>> {
        ExactParallelepiped::in_words(self.triangle.points(), self.obb.numbers(), one)
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar + InRaw<Raw = i32>> Overlaps<Near<Obb<S>>> for Near<Triangle<S>> {
    /// Do a triangle and an oriented box near the origin have a point in common?
    ///
    /// *Numerics*: exact, in 32-bit words alone. *Panics*: never.
    #[inline]
    fn overlaps(&self, obb: &Near<Obb<S>>) -> bool {
        let question = Disjoint::new(self.get(), obb.get());
        // A box is near only if a word of its type can hold one.
        let Some(one) = S::one_in() else { return self.get().overlaps(obb.get()) };
        !question.first_near_stage().unwrap_or_else(|| question.in_any_words::<i32>(one))
    }

    #[inline]
    fn may_overlap(&self, obb: &Near<Obb<S>>) -> bool {
        let question = Disjoint::new(self.get(), obb.get());
        question
            .framed(Change::Grown, Disjoint::<S>::vertices_from_near)
            .is_some_and(|framed| !framed.are_certainly_disjoint())
    }
}

/// The greatest magnitude among the coordinates, and at least `least`.
fn most<P: Number, const K: usize>(least: P, x: &[[P; 3]; K]) -> P {
    x.as_flattened().iter().fold(least, |most, x| greatest(most, x.magnitude()))
}

impl<S: Scalar> Overlaps<Obb<S>> for Triangle<S> {
    /// Do a triangle and an oriented box have a point in common?
    ///
    /// *Geometry*: closed sets. The box is the parallelepiped that its numbers describe, also if
    /// rounding left its axes slightly short or skewed.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats and all fixed-point values. The first stage serves floats if the
    /// axes have components below 4 and the spans are those for an axis-aligned box. It serves
    /// fixed point wherever the shapes are. It leaves a doubt within rounding of contact. In fixed
    /// point that is about 2⁻¹⁴ of the shapes' size, and boxes thinner than that are in doubt if
    /// they are met; axes of very different lengths, or nearly in one plane, leave more. Then wider
    /// numbers decide: in 64-bit fixed point words, for shapes of up to 34 bits on a grid; in fixed
    /// point of up to 30 fraction bits first 128 bits, for coordinates within 2³⁰ units in the last
    /// place. At last exact sums decide, up to a thousand times slower. Where registers have 32 bits,
    /// fixed point of up to 32 bits takes words instead, and no sums; words of 64 bits only for axes
    /// that numbers of 18 bits leave in doubt.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: in floats about 190 multiplications. In fixed point of every width, and in floats that functions
    /// compute, 51 of 32 bits and a test against an axis-aligned box; fewer if a face separates.
    ///
    /// *Source*: separating axes after Gottschalk, Lin and Manocha 1996 and Akenine-Möller 2001,
    /// for axes that need not be orthonormal. The first stage of fixed point is the transform of
    /// Akenine-Möller 2001, with an error bound that is ours.
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        !Disjoint::new(self, obb).answer()
    }

    /// May a triangle and an oriented box have a point in common?
    ///
    /// *Numerics*: `false` is certain. Floats answer `true` within rounding of contact, and outside
    /// the range of the first stage (see [`overlaps`](Overlaps::overlaps)). Fixed point of every
    /// width answers `true` if the shapes come within about 2⁻¹⁴ of their size: for less than one
    /// in a thousand pairs of random shapes.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: bounded. It is the first stage of [`overlaps`](Overlaps::overlaps), but for floats that
    /// functions compute.
    ///
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        S::evaluate_bounded(&Disjoint::new(self, obb)) != Some(true)
    }
}
