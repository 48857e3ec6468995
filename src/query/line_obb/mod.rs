//! Rays and segments against oriented box: the exact verdict, and where a ray enters and leaves.
//!
//! Both are parts of lines and have the same test. For axis-aligned boxes see `line_aabb`.

mod error_bound;
mod exact;
mod faces;
mod kernel;
#[cfg(feature = "fixed")]
mod near;
mod range;
mod residual;
mod rows;
mod slabs;
mod words;

use self::error_bound::error_bound;
use self::exact::ExactLine;
use self::kernel::{Operands, any_axis};
use self::range::Range;
use super::Overlaps;
use super::obb_short;
use super::triangle_obb::exact::InSums;
use super::triangle_obb::{has_second_look, operands, way};
use crate::arithmetic::{Each, Embeds, Float, InFloat, Number, Parts};
use crate::arithmetic::{REGISTERS_ARE_WIDE, SMALL_CODE};
use crate::robust::{Predicate, Profile, Vector, difference, in_cut_floats, noted, single};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Obb, Ray, Segment, SegmentForm};

/// A part of a line.
#[derive(Clone, Copy)]
enum Line<'a, S> {
    Ray(&'a Ray<S>),
    Segment(&'a Segment<S>),
}

/// Does the part of the line miss the box?
struct Disjoint<'a, S> {
    line: Line<'a, S>,
    obb: &'a Obb<S>,
}

impl<S: Scalar> Disjoint<'_, S> {
    /// The origin, the direction or the far end, and the ends of a ray's t.
    fn rows(&self) -> [[S; 3]; 3] {
        let none = [S::ZERO; 3];
        match self.line {
            Line::Ray(ray) => ray.numbers(),
            Line::Segment(segment) => {
                let (a, b, _) = segment.numbers();
                [a, b, none]
            }
        }
    }

    fn exactly(&self) -> ExactLine<InSums<S>> {
        let [p, q, _] = self.rows().each(|row| row.each(S::parts));
        let c = self.obb.center().to_array().each(S::parts);
        let from = |a: [Parts; 3], b: [Parts; 3]| -> Vector {
            core::array::from_fn(|i| difference(a[i], b[i]))
        };
        let (d, ends) = match self.line {
            Line::Ray(ray) => {
                (q.each(single), [ray.t_min(), ray.t_max()].each(|t| t.map(S::parts)))
            }
            Line::Segment(segment) => match segment.form() {
                SegmentForm::Ends(..) => (from(q, p), [Some(Parts::ZERO), Some(S::ONE)]),
                SegmentForm::Center { .. } => {
                    (q.each(single), [Some(S::ONE.negated()), Some(S::ONE)])
                }
            },
        };
        ExactLine::of(self.obb, from(p, c), d, ends)
    }

    #[cold]
    #[inline(never)]
    fn by_second_look<N: Embeds<S>>(&self) -> Option<bool> {
        self.by_these_axes::<N>(true)
    }

    /// The verdict of the axes in a number system.
    #[inline(always)]
    fn by_these_axes<N: Embeds<S>>(&self, looks_twice: bool) -> Option<bool> {
        let s = self.operands::<N>()?;
        let error = error_bound::<N>(s.one, &s.sizes())?;
        any_axis(&s, &error, looks_twice).verdict()
    }

    /// The line and the box in a number system.
    #[inline(always)]
    fn operands<N: Embeds<S>>(&self) -> Option<Operands<N::Product>> {
        let zero = N::Product::ZERO;
        let [p, q, ends] = self.rows();
        let [c, u, v, w, h] = self.obb.numbers();
        let ([p, q, ends, c, u, v, w, h], one) = N::embed_with_one(&[p, q, ends, c, u, v, w, h])?;
        let (d, ends) = match self.line {
            Line::Ray(ray) => {
                let [from, to, _] = operands::<N>(ends);
                (operands::<N>(q), [ray.t_min().map(|_| from), ray.t_max().map(|_| to)])
            }
            Line::Segment(segment) => match segment.form() {
                SegmentForm::Ends(..) => (way::<N>(q, p), [Some(zero), Some(one)]),
                SegmentForm::Center { .. } => (operands::<N>(q), [Some(-one), Some(one)]),
            },
        };
        let u = [operands::<N>(u), operands::<N>(v), operands::<N>(w)];
        let s = Operands { m: way::<N>(p, c), d, ends, u, h: operands::<N>(h), one };
        if N::CERTAIN {
            return Some(s);
        }
        Some(Operands { ends: s.sizes().without_far(s.ends, one), ..s })
    }

    /// The answer. Floats that functions compute begin with cut numbers.
    #[inline(always)]
    fn is_disjoint(&self) -> bool {
        let cut = || match self.line {
            Line::Ray(ray) => obb_short::floats::ray(ray, self.obb),
            Line::Segment(segment) => obb_short::floats::segment(segment, self.obb),
        };
        in_cut_floats::<S, _>(cut).unwrap_or_else(|| S::evaluate(self))
    }
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        match self.by_these_axes::<N>(false) {
            None if has_second_look::<N>() => self.by_second_look::<N>(),
            answer => answer,
        }
    }

    const PROFILE: Profile = Profile::QUADS_AND_CUT;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<bool>
    where
        S: InFloat<F>,
    {
        rows::is_separated::<S, F>(self)
    }

    #[inline(never)]
    fn in_words(&self, is_bounded: bool) -> Option<bool>
    where
        S: FixedBackend,
    {
        // Vectors hold 16 bits, and leave only near contacts to other stages.
        if REGISTERS_ARE_WIDE && S::ALWAYS_NEAR {
            return noted(None);
        }
        // A bounded query is the same on every machine.
        let in_frame = if REGISTERS_ARE_WIDE || is_bounded { None } else { self.in_short_words() };
        noted(in_frame.or_else(|| match self.line {
            Line::Ray(ray) => obb_short::ray(ray, self.obb),
            Line::Segment(segment) => obb_short::segment(segment, self.obb),
        }))
    }

    fn exact(&self) -> bool {
        in_window(self).unwrap_or_else(|| self.exactly().is_separated())
    }
}

/// The answer of the kernel in a window of 120 bits, if it holds the coordinates: in a tenth of the
/// time of exact sums.
fn in_window<S: Scalar, P: Predicate<S>>(question: &P) -> Option<P::Answer> {
    if REGISTERS_ARE_WIDE && !SMALL_CODE { question.filter::<S::SeptumWindow>() } else { None }
}

impl<S: Scalar> Overlaps<Obb<S>> for Ray<S> {
    /// Does the ray, within its range of t, have a point in common with the oriented box?
    ///
    /// *Geometry*: closed sets in one frame and one unit; the ends of the range belong to the ray.
    /// The box is the parallelepiped that its numbers describe, also if rounding left its axes
    /// slightly short or skewed.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar and for every range.
    ///
    /// *Range*: all finite floats and all fixed-point values. The first stage serves the range of
    /// two oriented boxes. In floats the direction, and its product with the ends of the range,
    /// must also be within that of the coordinates. Outside, and for floats within rounding of
    /// contact, wider numbers decide, up to a thousand times slower.
    ///
    /// *Panics*: never. *Cost*: about 75 multiplications, no division. Floats that functions compute begin in integers,
    /// except in `may_overlap`, which takes longer there.
    ///
    /// *Source*: separating axes as for a segment and an axis-aligned box in *Real-Time Rendering*
    /// 16.7. Axes that need not be orthonormal, the bound and the exact stages are ours.
    ///
    /// ```
    /// use septum::{Obb, Ray};
    ///
    /// let axes = [[0.75, 1.0, 0.0], [-1.0, 0.75, 0.0], [0.0, 0.0, 1.25]];
    /// let tool = Obb::from_skewed_axes([0.0; 3], axes, [4.0, 4.0, 1.0])?;
    /// let ray = Ray::new([-7.0, 9.0, 0.0], [1.0, 0.0, 0.0])?;
    /// assert!(!ray.overlaps(&tool));
    /// let ray = Ray::new([-7.0, 7.0, 0.0], [1.0, 0.0, 0.0])?;
    /// assert!(ray.overlaps(&tool)); // through the corner (-1, 7)
    /// assert!(!ray.with_range(0.0, 5.0)?.overlaps(&tool)); // not yet there
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        !Disjoint { line: Line::Ray(self), obb }.is_disjoint()
    }

    /// May the ray and the oriented box have a point in common?
    ///
    /// *Numerics*: `false` is certain. In floats `true` may be wrong within rounding of contact,
    /// and outside the range of the first stage. Fixed point is exact in up to 16 bits; in more,
    /// `true` may be wrong within some 2⁻¹³ of the distance and size of the box: for less than one
    /// in a thousand random pairs.
    ///
    /// *Panics*: never. *Cost*: bounded: [`overlaps`](Overlaps::overlaps) without exact sums, in
    /// floats its first stage.
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { line: Line::Ray(self), obb }) != Some(true)
    }
}

impl<S: Scalar> Overlaps<Obb<S>> for Segment<S> {
    /// Does the segment have a point in common with the oriented box?
    ///
    /// *Geometry*: closed sets in one frame and one unit. The segment is given by its ends or by
    /// centre and half-vector, and may be a point. The box is the parallelepiped that its numbers
    /// describe.
    ///
    /// *Contact*: touching counts as overlap. *Numerics*: exact for every valid input, in every
    /// scalar.
    ///
    /// *Range*, *Panics*, *Cost*, *Source*: as for a [`Ray`].
    ///
    /// ```
    /// use septum::{Obb, Segment};
    ///
    /// let tool = Obb::from_turns([0.0; 3], [0.0, 0.0, 0.25], [3.0, 1.0, 1.0])?;
    /// let s = Segment::new([0.0, 3.0, 9.0], [0.0, 3.0, 1.0])?;
    /// assert!(s.overlaps(&tool)); // its end is at a corner of the turned box
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, obb: &Obb<S>) -> bool {
        !Disjoint { line: Line::Segment(self), obb }.is_disjoint()
    }

    /// May the segment and the oriented box have a point in common?
    ///
    /// *Numerics*: `false` is certain. *Panics*: never. *Cost*: bounded; as for a [`Ray`].
    #[inline]
    fn may_overlap(&self, obb: &Obb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { line: Line::Segment(self), obb }) != Some(true)
    }
}

impl<S: Scalar> Ray<S> {
    /// Where does the ray enter the oriented box, and where does it leave it? As values of t;
    /// `None` if it misses the box.
    ///
    /// *Geometry*, *Contact*: as [`t_range`](Self::t_range) for an axis-aligned box. The box is the
    /// parallelepiped that its numbers describe.
    ///
    /// *Numerics*: the verdict is exact. In fixed point the values are rounded to the nearest, ties
    /// to even, and values beyond the type are its end. In floats they are within 0.51 units in the
    /// last place. A float may overflow to an infinity, and below the least normal number it errs
    /// by up to 0.76 of the spacing there.
    ///
    /// *Range*: all finite floats and all fixed-point values.
    ///
    /// *Panics*: never. *Cost*: a miss costs what [`overlaps`](Overlaps::overlaps) does. A hit takes
    /// about 150 operations in `f64` and three divisions besides, for floats and for fixed point of
    /// up to 32 bits. `f64` itself has its verdict from them, and takes as many again for a hit. A
    /// few hits whose last place stays in doubt take exact sums for up to six quotients, a thousand
    /// times as long. So do all hits in fixed point of 64 bits, and in fixed point on 32-bit cores.
    /// Use this query for a single box that matters.
    ///
    /// ```
    /// use septum::{Obb, Ray};
    ///
    /// let tool = Obb::from_turns([0.0; 3], [0.0, 0.0, 0.25], [3.0, 1.0, 1.0])?;
    /// let ray = Ray::new([0.0, -5.0, 0.0], [0.0, 2.0, 0.0])?;
    /// assert_eq!(ray.t_range_obb(&tool), Some((1.0, 4.0)));
    /// assert_eq!(ray.with_range(2.0, None)?.t_range_obb(&tool), Some((2.0, 4.0)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn t_range_obb(&self, obb: &Obb<S>) -> Option<(S, S)> {
        if !Range::<S>::DECIDES && !self.overlaps(obb) {
            return None;
        }
        let (enter, leave) = S::evaluate_numeric(&Range(Disjoint { line: Line::Ray(self), obb }))?;
        Some(self.clipped(enter, leave))
    }
}
