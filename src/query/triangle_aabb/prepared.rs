//! One triangle against many axis-aligned boxes.

use super::Disjoint;
use super::error_bound::{OFFSET_FACE, offset_bound};
use super::offsets::{ForOffsets, row, size_in_range};
use super::rows::{InFrame, Rows};
use crate::arithmetic::{Number, Quad, THREE};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// A triangle prepared for many axis-aligned boxes: exact, and up to three times as fast as the
/// triangle itself.
///
/// Use it to voxelize, or if a triangle meets more than two or three boxes. The answers are those
/// of [`Triangle::overlaps`](crate::Overlaps::overlaps).
///
/// *Numerics*: exact. Edges, normal and other values independent of the box are computed once, in
/// `f32` for every scalar. If that leaves a doubt, the unprepared test decides.
///
/// *Range*: all of the scalar. It is fast if triangle and box together span between 2⁻³² and 2⁴⁰;
/// fixed point must be below 2²⁹ units in the last place (32 bits) or 2⁴⁹ (64 bits), and needs a
/// machine with vectors and the feature `simd`. For other inputs the unprepared test decides every
/// box, and preparing gains nothing.
///
/// ```
/// use septum::prepared::PreparedTriangle;
/// use septum::{Aabb, Triangle};
///
/// let triangle = Triangle::new([0.5, 0.5, 0.2], [3.5, 0.5, 0.2], [0.5, 3.5, 0.2])?;
/// let prepared = PreparedTriangle::new(&triangle);
/// let cell = |x, y| Aabb::from_center_half_extents([x + 0.5, y + 0.5, 0.5], [0.5; 3]).unwrap();
/// assert!(prepared.overlaps(&cell(0.0, 0.0)));
/// assert!(prepared.overlaps(&cell(2.0, 1.0)));
/// assert!(prepared.overlaps(&cell(2.0, 2.0))); // touches an edge of the cell
/// assert!(!prepared.overlaps(&cell(3.0, 2.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PreparedTriangle<S: Scalar> {
    triangle: Triangle<S>,
    /// The triangle's rows, relative to its first vertex; `None` if `f32` offsets cannot hold it.
    pub(super) rows: Option<Rows<ForOffsets>>,
}

impl<S: Scalar> PreparedTriangle<S> {
    /// Prepares a triangle for many boxes.
    ///
    /// *Panics*: never. *Cost*: 7 multiplications in each of three lanes.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        let [a, b, c] = triangle.points();
        let from_a = |p: [S; 3]| row(|i| p[i].offset(a[i]));
        let rows = || Rows::of_rows([ForOffsets::splat(0.0), from_a(b), from_a(c)]);
        let are_held = S::IN_QUADS && S::have_offsets(&[a, b, c]);
        Self { triangle: *triangle, rows: are_held.then(rows) }
    }

    /// The triangle.
    #[inline]
    #[must_use]
    pub const fn triangle(&self) -> &Triangle<S> {
        &self.triangle
    }

    /// Do the triangle and an axis-aligned box have a point in common? As
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps).
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 33 multiplications in three lanes, or 2 if a face or the plane separates.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        match self.apart(aabb) {
            Some(apart) => !apart,
            // By value, because a box just made stays in registers.
            None => ask_the_triangle(&self.triangle, *aabb),
        }
    }

    /// Whether an axis separates, if that is clear.
    #[inline(always)]
    fn apart(&self, aabb: &Aabb<S>) -> Option<bool> {
        let rows = self.rows.as_ref()?;
        let frame = self.in_frame(rows, aabb)?;
        let bound = offset_bound(size_in_range(&frame)?);
        rows.apart_by_bounds(&frame, bound, bound, true).ok()
    }

    #[inline(always)]
    pub(super) fn in_frame(
        &self,
        rows: &Rows<ForOffsets>,
        aabb: &Aabb<S>,
    ) -> Option<InFrame<ForOffsets>> {
        let a = self.triangle.vertices()[0].to_array();
        let (p, q, is_by_center) = aabb.numbers();
        if !S::have_offsets(&[p, q]) {
            return None;
        }
        // The first vertex in the frame of the box, and the half-extents.
        let (at, half) = if is_by_center {
            (row(|i| a[i].offset(p[i])), row(|i| q[i].offset(S::ZERO)))
        } else {
            let twice = row(|i| a[i].offset_of_two(p[i], q[i]));
            (twice.halved(), row(|i| q[i].offset(p[i])).halved())
        };
        let (low, high) = (rows.low + at, rows.high + at);
        let size = half + (rows.high - rows.low);
        // Sums of rounded numbers need not keep their order.
        let gap = low.greatest(ForOffsets::splat(0.0) - high) - half;
        let error = size.most().error(OFFSET_FACE);
        Some(InFrame {
            v: [at, rows.v[1] + at, rows.v[2] + at],
            half,
            size,
            apart: gap.exceeds(ForOffsets::splat(error)) & THREE,
            meets: ForOffsets::splat(-error).exceeds(gap) & THREE,
        })
    }
}

#[cold]
#[inline(never)]
fn ask_the_triangle<S: Scalar>(triangle: &Triangle<S>, aabb: Aabb<S>) -> bool {
    note(Stage::Look);
    !Disjoint { triangle, aabb: &aabb }.answer()
}
