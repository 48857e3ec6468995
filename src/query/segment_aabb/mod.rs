//! Segment against axis-aligned box: the exact verdict.
//!
//! T. Akenine-Möller, E. Haines, N. Hoffman et al., *Real-Time Rendering*, section 16.7: three face
//! normals and three cross products. Here both kinds of axes compare the ends of slabs; see
//! `line_aabb`.

use super::Overlaps;
use super::line_aabb::Slabs;
#[cfg(feature = "fixed")]
use crate::arithmetic::IntNear;
use crate::arithmetic::{Arithmetic, Embeds};
#[cfg(feature = "fixed")]
use crate::robust::only_stage;
use crate::robust::{Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Aabb, Segment};

/// The question whether segment and box are disjoint.
struct Disjoint<'a, S> {
    segment: &'a Segment<S>,
    aabb: &'a Aabb<S>,
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let (a, b, is_segment_by_center) = self.segment.numbers();
        let (p, q, is_by_center) = self.aabb.numbers();
        let [a, b, p, q] = N::embed(&[a, b, p, q])?;
        let slabs = |o: &[N::Length; 3], d: &[N::Length; 3]| {
            if is_by_center {
                Slabs::<N>::in_center(o, d, &p, &q)
            } else {
                Slabs::<N>::in_corners(o, d, &p, &q)
            }
        };
        if !is_segment_by_center {
            let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
            let line = slabs(&a, &d);
            let faces = line.lies_before().or(slabs(&b, &d).lies_beyond());
            return verdict(faces, &line);
        }
        let line = slabs(&a, &b);
        verdict(line.lies_beyond_one(), &line)
    }
}

#[inline(always)]
fn verdict<N: Arithmetic>(faces: Uncertain, line: &Slabs<N>) -> Option<bool> {
    // In most scenes a face separates half of the pairs or more, and needs no product.
    if faces.certain {
        return Some(true);
    }
    faces.or(line.line_misses()).verdict()
}

impl<S: Scalar> Overlaps<Aabb<S>> for Segment<S> {
    /// Do a segment and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit, each in the form in which it was given: ends
    /// or centre and half-vector, corners or centre and half-extents. The segment may be a point,
    /// and the box may be flat.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values. The fast stage decides floats whose
    /// coordinate differences are zero or between 2⁻³² and 2⁴⁰ (`f32`) or 2⁻³²⁰ and 2³²⁰ (`f64`),
    /// and fixed point below 2²⁸ (32 bits) or 2⁶⁰ (64 bits) units in the last place; with 8 and 16
    /// bits it always decides. Other inputs, and floats within rounding of contact, take wider
    /// numbers and last exact integers, up to a thousand times slower.
    ///
    /// *Panics*: never. *Cost*: 12 multiplications, 9 or 12 differences. The rounded method,
    /// [`separating_axes`](crate::published::separating_axes), takes about half the time in `f32`.
    ///
    /// *Source*: *Real-Time Rendering* 16.7; the exact stages are ours.
    ///
    /// ```
    /// use septum::{Aabb, Segment};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let s = Segment::new([2.0, 0.0, 0.5], [0.0, 2.0, 0.5])?;
    /// assert!(s.overlaps(&cell)); // touches an edge
    /// let s = Segment::new([2.0, 0.0, 0.5], [0.0, 2.0000000000000004, 0.5])?;
    /// assert!(!s.overlaps(&cell)); // one unit in the last place farther off
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        !S::evaluate(&Disjoint { segment: self, aabb })
    }

    /// May a segment and an axis-aligned box have a point in common?
    ///
    /// *Numerics*: `false` is certain. Fixed point is exact, except that 64 bits return `true`
    /// beyond 2⁶⁰ units in the last place. Floats return `true` within a few roundings of contact,
    /// and outside the range of the first stage of [`overlaps`](Overlaps::overlaps).
    ///
    /// *Panics*: never. *Cost*: bounded. In floats it is the first stage of
    /// [`overlaps`](Overlaps::overlaps); in fixed point of up to 32 bits it is
    /// [`overlaps`](Overlaps::overlaps) itself.
    #[inline]
    fn may_overlap(&self, aabb: &Aabb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { segment: self, aabb }) != Some(true)
    }
}

// Doubled, all lengths are below 2^21, and a product of two is below 2^42.
#[cfg(feature = "fixed")]
impl<S: Scalar> Overlaps<Near<Aabb<S>>> for Near<Segment<S>>
where
    IntNear: Embeds<S>,
{
    /// Do a segment and an axis-aligned box near the origin have a point in common?
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact, in integers of 64 bits. *Panics*: never.
    /// *Cost*: as for segments anywhere.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::{Aabb, Segment};
    ///
    /// let at = |x: i32, y: i32, z: i32| [x, y, z].map(|k| I16F16::from_bits(k << 12));
    /// let cell = Aabb::from_min_max(at(0, 0, 0), at(8, 8, 8))?.near()?;
    /// let touching = Segment::new(at(16, 0, 4), at(0, 16, 4))?.near()?;
    /// assert!(touching.overlaps(&cell)); // at an edge
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, aabb: &Near<Aabb<S>>) -> bool {
        let disjoint = Disjoint { segment: self.get(), aabb: aabb.get() };
        !only_stage::<_, IntNear, _>(&disjoint)
    }
}
