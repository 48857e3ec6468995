//! One triangle against N boxes, and one box against N triangles, exactly.

use super::triangle_axes::TriangleAxes;
use super::triangles::lane;
use super::{Aabbs, Triangles};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle};

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
    /// `simd`, so is fixed point below 2²⁴ units in the last place (32 bits) or 2⁵³ (64 bits).
    /// Other numbers, and boxes that the triangle touches, go one by one.
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
        let axes = TriangleAxes::new(triangle.points());
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
        let alone = |k: usize| self.triangle(k).overlaps(aabb);
        match *aabb.form() {
            AabbForm::Corners { min, max } => {
                let (min, max) = (min.to_array(), max.to_array());
                each::<S, N>(|k| TriangleAxes::new(self.at(k)).apart_by_corners(min, max), alone)
            }
            AabbForm::Center { center, half } => {
                let (center, half) = (center.to_array(), half.to_array());
                each::<S, N>(|k| TriangleAxes::new(self.at(k)).apart_by_center(center, half), alone)
            }
        }
    }
}
