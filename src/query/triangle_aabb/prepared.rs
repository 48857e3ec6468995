//! One triangle against many axis-aligned boxes.

use super::Disjoint;
use super::rows::Rows;
use crate::arithmetic::{FirstFloat, OfFour, Quad};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

type First<S> = <S as FirstFloat>::First;
type FirstQuad<S> = <First<S> as OfFour>::Quad;

/// A triangle prepared for many axis-aligned boxes: exact, and up to twice as fast as the
/// triangle itself.
///
/// Choose it to voxelize, or wherever a triangle meets more than two or three boxes. The
/// answers are those of [`Triangle::overlaps`](crate::Overlaps::overlaps).
///
/// *Numerics*: exact. Edges, normal and all else that does not depend on the box are computed
/// once. Where floats leave a doubt, the triangle itself is asked.
///
/// *Range*: all of the scalar. It is fast where the first stage of the triangle is; fixed
/// point must also be below 2²⁴ units in the last place (32 bits) or 2⁵³ (64 bits), and needs
/// a machine with vectors and the feature `simd`. Elsewhere the triangle itself is asked about
/// every box, and preparing gains nothing.
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
    rows: Option<Rows<FirstQuad<S>>>,
}

impl<S: Scalar> PreparedTriangle<S> {
    /// The triangle, prepared for many boxes.
    ///
    /// *Panics*: never. *Cost*: 7 multiplications in each of three lanes.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        let points = || triangle.points().map(|p| p.map(S::first));
        Self { triangle: *triangle, rows: S::IN_QUADS.then(|| Rows::new(points())) }
    }

    /// The triangle.
    #[inline]
    #[must_use]
    pub const fn triangle(&self) -> &Triangle<S> {
        &self.triangle
    }

    /// Whether the triangle and an axis-aligned box have a point in common: what
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) answers.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 6 comparisons; if no face separates, 33 multiplications at most, in three
    /// lanes.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        let clear = match (&self.rows, *aabb.form()) {
            (None, _) => None,
            (Some(rows), AabbForm::Center { center, half }) => {
                rows.apart_by_center(S::FIRST_LIMIT, row(center), row(half))
            }
            (Some(rows), AabbForm::Corners { min, max }) => {
                rows.apart_by_corners(S::FIRST_LIMIT, row(min), row(max))
            }
        };
        match clear {
            Some(apart) => !apart,
            // Of a copy: a box just made stays in registers.
            None => ask_the_triangle(&self.triangle, *aabb),
        }
    }
}

#[cold]
#[inline(never)]
fn ask_the_triangle<S: Scalar>(triangle: &Triangle<S>, aabb: Aabb<S>) -> bool {
    !S::evaluate(&Disjoint { triangle, aabb: &aabb })
}

#[inline(always)]
fn row<S: FirstFloat<First = Q::Lane>, Q: Quad>(v: Vec3<S>) -> Q {
    Q::of_three([v.x.first(), v.y.first(), v.z.first()])
}
