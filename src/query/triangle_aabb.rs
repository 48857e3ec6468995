//! Triangle against axis-aligned box.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of
//! Graphics Tools* 6(1), 2001. The 13 axes are the paper's. What differs: the
//! nine edge axes share the components of the triangle's normal, faces come
//! first and nothing else is branched on, and the verdict is exact.

mod in_words;

use super::{MayOverlap, Overlaps};
use crate::axis::{self, Axis, BoxForm, Frame, Split};
use crate::linear::Vec3;
use crate::robust::{ExactBox, ExactTriangle, bounds};
use crate::scalar::{Holds, InWord, Number, Numbers, Predicate, Rounded, Scalar, Word};
use crate::shape::{Aabb, AabbForm, Triangle};

/// The question, for the number systems to answer.
struct Disjoint<'a, S> {
    triangle: &'a Triangle<S>,
    aabb: &'a Aabb<S>,
}

impl<S: Scalar> Disjoint<'_, S> {
    #[inline(always)]
    fn fits<N: Holds<S>>(&self) -> bool {
        let [a, b, c] = self.triangle.points();
        let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
            self.aabb.form();
        N::fits(&[a, b, c, p.to_array(), q.to_array()])
    }
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;

    #[inline(always)]
    fn attempt<N: Holds<S>>(&self) -> Option<bool> {
        if !self.fits::<N>() {
            return None;
        }
        match self.aabb.form() {
            AabbForm::Center { center, half } if N::ONE_FORM => {
                by_corners::<S, N>(self.triangle, center, center, half)
            }
            AabbForm::Center { center, half } => by_center::<S, N>(self.triangle, center, half),
            AabbForm::Corners { min, max } => {
                by_corners::<S, N>(self.triangle, min, max, &Vec3::splat(S::ZERO))
            }
        }
    }

    #[inline(always)]
    fn in_words<W: Word>(&self) -> Option<bool>
    where
        S: InWord<W>,
    {
        if S::ALWAYS_NEAR { Some(self.in_any_words()) } else { self.in_near_words() }
    }

    fn exact(&self) -> bool {
        Axis::ALL.iter().any(|&axis| separates_exactly(self, axis))
    }
}

// Out of line, each form apart: the compiler turns either into vector code that
// stays the same wherever it is called from, and gathers loads where they mix.
#[inline(never)]
fn by_center<S: Scalar, N: Holds<S>>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> Option<bool> {
    any_axis(&in_frame_of_center::<S, N>(triangle, center, half))
}

#[inline(never)]
fn by_corners<S: Scalar, N: Holds<S>>(
    triangle: &Triangle<S>,
    min: &Vec3<S>,
    max: &Vec3<S>,
    grown: &Vec3<S>,
) -> Option<bool> {
    any_axis(&in_frame_of_corners::<S, N>(triangle, min, max, grown))
}

#[inline(always)]
fn in_frame_of_center<S: Scalar, N: Holds<S>>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> Frame<N> {
    let [a, b, c] = triangle.points();
    let placed = N::place(&[a, b, c, center.to_array()], &[half.to_array()]);
    let ([a, b, c, center], [half]) = (placed.points, placed.extents);
    Frame::new(&[a, b, c], &BoxForm::Center(center, half))
}

#[inline(always)]
fn in_frame_of_corners<S: Scalar, N: Holds<S>>(
    triangle: &Triangle<S>,
    min: &Vec3<S>,
    max: &Vec3<S>,
    grown: &Vec3<S>,
) -> Frame<N> {
    let [a, b, c] = triangle.points();
    let placed = N::place(&[a, b, c, min.to_array(), max.to_array()], &[grown.to_array()]);
    let ([a, b, c, min, max], [grown]) = (placed.points, placed.extents);
    Frame::new(&[a, b, c], &BoxForm::Corners(min, max, grown))
}

/// Whether one of the 13 axes separates, if `N` can tell.
#[inline(always)]
fn any_axis<N: Numbers>(frame: &Frame<N>) -> Option<bool> {
    // A quarter to all of a scene's boxes lie off to one side.
    let faces = axis::faces(frame);
    if faces.certain {
        return Some(true);
    }

    let (areas, volumes) = bounds::<N>(frame.reach())?;
    let n = axis::normal(frame);
    let edges = axis::edges(frame, &n, areas);
    let plane = if N::is_slim(frame.reach()) {
        slim_plane::<N>(n, frame.v[0], frame.h)
    } else {
        axis::plane::<N>(&n, &frame.v[0], &frame.h, volumes)
    };
    faces.or(edges).or(plane).verdict()
}

/// The plane test in narrower volumes. Integers only: they have no error to
/// allow for. By value, so that no reference keeps the frame in memory.
#[inline(always)]
fn slim_plane<N: Numbers>(n: [N::Area; 3], v: [N::Length; 3], h: [N::Length; 3]) -> Split {
    axis::plane::<N::Slim>(&n, &v, &h, <N::Slim as Numbers>::Volume::ZERO)
}

/// The question whether one axis separates.
struct SeparatedBy<'a, S> {
    shapes: Disjoint<'a, S>,
    axis: Axis,
}

impl<S: Scalar> Predicate<S> for SeparatedBy<'_, S> {
    type Answer = bool;

    fn attempt<N: Holds<S>>(&self) -> Option<bool> {
        if !self.shapes.fits::<N>() {
            return None;
        }
        let triangle = self.shapes.triangle;
        let frame = match self.shapes.aabb.form() {
            AabbForm::Center { center, half } => in_frame_of_center::<S, N>(triangle, center, half),
            AabbForm::Corners { min, max } => {
                in_frame_of_corners::<S, N>(triangle, min, max, &Vec3::splat(S::ZERO))
            }
        };
        let reach = frame.reach_across_gap();
        let (areas, volumes) = bounds::<N>(reach)?;
        let n = axis::normal(&frame);
        match self.axis {
            Axis::Face(i) => axis::one_face(&frame, usize::from(i % 3)),
            Axis::Normal if N::is_slim(reach) => slim_plane::<N>(n, frame.v[0], frame.h),
            Axis::Normal => axis::plane::<N>(&n, &frame.v[0], &frame.h, volumes),
            Axis::Edge { axis, edge } => {
                axis::one_edge(&frame, &n, areas, usize::from(axis % 3), usize::from(edge % 3))
            }
        }
        .verdict()
    }

    fn exact(&self) -> bool {
        separates_exactly(&self.shapes, self.axis)
    }
}

fn separates_exactly<S: Scalar>(shapes: &Disjoint<'_, S>, axis: Axis) -> bool {
    let t = ExactTriangle::new(&shapes.triangle.points());
    let b = ExactBox::new(shapes.aabb.form());
    match axis {
        Axis::Face(i) => b.face_separates::<S>(&t, usize::from(i % 3)),
        Axis::Normal => b.normal_separates::<S>(&t, &[0, 1, 2].map(|i| t.normal_sign::<S>(i))),
        Axis::Edge { axis, edge } => {
            let (i, k) = (usize::from(axis % 3), usize::from(edge % 3));
            b.edge_separates::<S>(&t, i, k, t.normal_sign::<S>(i))
        }
    }
}

impl<S: Scalar> Overlaps<Aabb<S>> for Triangle<S> {
    /// Whether a triangle and an axis-aligned box have a point in common.
    ///
    /// *Geometry*: closed sets in one frame and unit; triangles that are
    /// segments or points, boxes that are flat or points, are what they are.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar; the verdict does
    /// not depend on vertex order, machine or compiler.
    ///
    /// *Range*: all finite floats, all fixed-point values. The fast stage serves
    /// floats while the two shapes together span between 2⁻³² and 2⁴⁰ (`f32`) or
    /// 2⁻³²⁰ and 2³²⁰ (`f64`), and fixed point while coordinates are below 2²⁸ (32
    /// bits) or 2⁶⁰ (64 bits) units of the last place; 8 and 16 bits always.
    /// Outside, and for floats within rounding of contact, wider numbers take over
    /// and at last exact sums, up to a thousand times slower.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 21 comparisons; if no face separates, 48 multiplications and no
    /// division. Floats that come within rounding of contact take it again in
    /// wider numbers. Fixed point on 32-bit cores has a kernel of its own: in I16F16,
    /// for all 13 axes, 747 instructions on a Cortex-M0 within ±4 of the box and
    /// 440 on an M4F within ±8192 (counted in QEMU, at opt-level 3; `docs/target.csv`),
    /// 2.6 and 2.3 KB of code and 248 and 200 bytes of stack at opt-level s.
    ///
    /// *Source*: Akenine-Möller 2001; the shared normal, the error bound and the
    /// exact stages are ours.
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
        !S::decide(&Disjoint { triangle: self, aabb })
    }
}

impl<S: Scalar> MayOverlap<Aabb<S>> for Triangle<S> {
    /// Whether a triangle and an axis-aligned box may have a point in common.
    ///
    /// *Numerics*: `false` is certain, `true` may be wrong. Floats answer `true`
    /// within 30·u·R² of an edge axis and 120·u·R³ of the plane, with u the unit
    /// roundoff and R the span of the two shapes; 8- and 16-bit fixed point is
    /// exact; 32 and 64 bits are brought down to 18, and the box grown by two of
    /// the units that are left. A box given by its centre is also in doubt where a
    /// vertex lies within rounding of a face.
    ///
    /// *Range*: floats whose span is outside 2⁻³² to 2⁴⁰ (`f32`) or 2⁻³²⁰ to 2³²⁰
    /// (`f64`) get `true` unless a face separates.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: the first stage of [`overlaps`](Overlaps::overlaps) and no other.
    /// Choose it where a bounded time matters more than the last touch, or before
    /// a finer test.
    #[inline]
    fn may_overlap(&self, aabb: &Aabb<S>) -> bool {
        Disjoint { triangle: self, aabb }.attempt::<S::Quick>() != Some(true)
    }
}

impl<S: Scalar> Triangle<S> {
    /// The overlap test in the scalar's own arithmetic, every result rounded:
    /// fast, and sometimes wrong.
    ///
    /// The same kernel as [`overlaps`](Self::overlaps) without its error bound.
    ///
    /// *Numerics*: on slivers, far from the origin, and within rounding of
    /// contact it errs either way; in fixed point products lose their last bits
    /// and wrap beyond the range, and then it errs often. Here for comparison,
    /// and for those who draw with it.
    ///
    /// *Panics*: never. *Cost*: 21 comparisons, 48 multiplications.
    #[inline]
    pub fn overlaps_rounded(&self, aabb: &Aabb<S>) -> bool {
        Disjoint { triangle: self, aabb }.attempt::<Rounded<S>>() == Some(false)
    }

    /// An axis on which the projections of triangle and box are disjoint, or
    /// `None` if the two overlap: a witness that anyone can check.
    ///
    /// *Numerics*: exact. It is the first such axis in the order of
    /// [`Axis::ALL`], so it is the same on every machine.
    ///
    /// *Panics*: never. *Cost*: [`overlaps`](Self::overlaps), and if that is
    /// `false` up to 13 tests of one axis.
    ///
    /// Bodies that move little between frames are kept apart by the same axis:
    /// ask for it first with [`is_separated_by`](Self::is_separated_by).
    ///
    /// ```
    /// use septum::{Aabb, Axis, Triangle};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let t = Triangle::new([2.5, 0.0, 0.5], [0.0, 2.5, 0.5], [3.0, 3.0, 0.5])?;
    /// let axis = t.separating_axis(&cell);
    /// assert_eq!(axis, Some(Axis::Edge { axis: 2, edge: 0 }));
    /// assert!(t.is_separated_by(&cell, axis.unwrap()));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn separating_axis(&self, aabb: &Aabb<S>) -> Option<Axis> {
        if self.overlaps(aabb) {
            return None;
        }
        Axis::ALL.into_iter().find(|&axis| self.is_separated_by(aabb, axis))
    }

    /// Whether the projections of triangle and box on one axis are disjoint.
    ///
    /// *Numerics*: exact. An axis that is nought, of an edge along a coordinate
    /// axis or of a degenerate triangle, separates nothing. Indices count
    /// modulo 3.
    ///
    /// *Panics*: never. *Cost*: at most that of [`overlaps`](Self::overlaps).
    pub fn is_separated_by(&self, aabb: &Aabb<S>, axis: Axis) -> bool {
        S::decide(&SeparatedBy { shapes: Disjoint { triangle: self, aabb }, axis })
    }
}
