//! One triangle against N boxes, and one box against N triangles, exactly.

use super::triangle_axes::{TriangleAxes, is_for_first};
use super::triangles::lane;
use super::{Aabbs, Triangles};
use crate::arithmetic::{Float, InFloat};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Tests all lanes at once in floats; `apart` returns the verdict and whether it is certain.
/// `overlaps` decides uncertain lanes one by one.
#[inline(always)]
pub(super) fn each<S: Scalar, const N: usize>(
    apart: impl Fn(usize) -> (bool, bool),
    overlaps: impl Fn(usize) -> bool,
) -> [bool; N] {
    if !S::IN_QUADS {
        return core::array::from_fn(overlaps);
    }
    let (mut found, mut certain, mut all) = ([false; N], [false; N], true);
    for k in 0..N {
        let (is_apart, is_certain) = apart(k);
        found[k] = !is_apart;
        certain[k] = is_certain;
    }
    for is_certain in certain {
        all &= is_certain;
    }
    if !all {
        for k in 0..N {
            if !certain[k] {
                found[k] = overlaps(k);
            }
        }
    }
    found
}

impl<S: Scalar, const N: usize> Aabbs<S, N> {
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) with each of N boxes at once.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar, with the same verdicts as for
    /// single boxes.
    ///
    /// *Range*: all of the scalar. Floats are tested all at once. With vectors and the feature
    /// `simd`, so is fixed point: of 32 bits in `f64` if the triangle reaches 2²⁴ units in the last
    /// place, and of 64 bits below 2⁵³. Other numbers, and boxes that the triangle touches, go one
    /// by one.
    ///
    /// *Panics*: never. *Cost*: 52 multiplications for a vector of boxes, also if a face separates.
    ///
    /// ```
    /// use septum::lanes::Aabbs;
    /// use septum::{Aabb, Triangle};
    ///
    /// let cell = |x: f32| Aabb::from_min_max([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]);
    /// let cells = Aabbs::new(&[cell(0.0)?, cell(1.0)?, cell(2.0)?, cell(3.0)?]).unwrap();
    /// let triangle = Triangle::new([0.5, 0.5, 0.2], [2.0, 0.5, 0.2], [0.5, 3.5, 0.2])?;
    /// assert_eq!(cells.overlaps(&triangle), [true, true, true, false]);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn overlaps(&self, triangle: &Triangle<S>) -> [bool; N] {
        if is_for_first(&triangle.points()) {
            self.overlaps_in::<S::SeptumFirst>(triangle)
        } else {
            self.overlaps_in::<S::SeptumSecond>(triangle)
        }
    }

    #[inline(always)]
    fn overlaps_in<F: Float>(&self, triangle: &Triangle<S>) -> [bool; N]
    where
        S: InFloat<F>,
    {
        let axes = TriangleAxes::<F>::new(triangle.points());
        each::<S, N>(
            |k| axes.apart_by_corners(lane(&self.min, k), lane(&self.max, k)),
            |k| triangle.overlaps(&self.at(k)),
        )
    }
}

impl<S: Scalar, const N: usize> Triangles<S, N> {
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) of each of N triangles with a box, at
    /// once.
    ///
    /// *Contact*, *Numerics*, *Range*, *Panics*: as [`Aabbs::overlaps`].
    ///
    /// *Cost*: for each vector of triangles, as one
    /// [`Triangle::overlaps`](crate::Overlaps::overlaps) without early exits.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, aabb: &Aabb<S>) -> [bool; N] {
        let (p, q, _) = aabb.numbers();
        if is_for_first(&[p, q]) && (N == 0 || is_for_first(&self.at(0))) {
            self.overlaps_in::<S::SeptumFirst>(aabb)
        } else {
            self.overlaps_in::<S::SeptumSecond>(aabb)
        }
    }

    #[inline(always)]
    fn overlaps_in<F: Float>(&self, aabb: &Aabb<S>) -> [bool; N]
    where
        S: InFloat<F>,
    {
        let alone = |k: usize| self.triangle(k).overlaps(aabb);
        let axes = |k: usize| TriangleAxes::<F>::new(self.at(k));
        let (p, q, is_by_center) = aabb.numbers();
        if is_by_center {
            each::<S, N>(|k| axes(k).apart_by_center(p, q), alone)
        } else {
            each::<S, N>(|k| axes(k).apart_by_corners(p, q), alone)
        }
    }
}
