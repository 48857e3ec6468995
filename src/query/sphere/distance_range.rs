//! Two numbers between which the squared distance of a point lies.

use crate::query::surd::last_ordinal;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Segment, ShapeError, Triangle, Vec3};

/// The numbers beside one that was rounded once, by less than a unit in the last place.
fn beside<S: Scalar>(rounded: S) -> (S, S) {
    let n = rounded.ordinal();
    let next = n.saturating_add(1).min(last_ordinal::<S>());
    (S::of_ordinal((n - 1).max(0)), S::of_ordinal(next))
}

impl<S: Scalar> Triangle<S> {
    /// Two numbers between which the square of the distance from a point to the triangle lies: the
    /// neighbours of [`distance_squared`](Self::distance_squared), but not below zero.
    ///
    /// *Numerics*: the first is not above the truth and the second not below it, each by less than
    /// two units in the last place. *Range*: as for `distance_squared`; the second is an infinity for
    /// a square beyond all floats, and the type's end for one beyond a fixed-point type.
    ///
    /// *Errors*: [`ShapeError::NotFinite`] if a coordinate is NaN or infinite. *Panics*: never.
    /// *Cost*: as `distance_squared`.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0])?;
    /// let (low, high) = t.distance_squared_range([3.0, 1.0, 0.0])?; // the truth is a half
    /// assert!(low < 0.5 && 0.5 < high && high - low < 1.0e-7);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared_range(&self, point: impl Into<Vec3<S>>) -> Result<(S, S), ShapeError> {
        self.distance_squared(point).map(beside)
    }
}

impl<S: Scalar> Segment<S> {
    /// Two numbers between which the square of the distance from a point to the segment lies.
    ///
    /// *Numerics*, *Range*, *Errors*, *Panics*, *Cost*: as for [`Triangle::distance_squared_range`].
    ///
    /// ```
    /// use septum::Segment;
    ///
    /// let s = Segment::new([0.0_f64, 0.0, 0.0], [3.0, 0.0, 0.0])?;
    /// let (low, high) = s.distance_squared_range([1.0, 2.0, 2.0])?;
    /// assert!(low < 8.0 && 8.0 < high);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared_range(&self, point: impl Into<Vec3<S>>) -> Result<(S, S), ShapeError> {
        self.distance_squared(point).map(beside)
    }
}

impl<S: Scalar> Aabb<S> {
    /// Two numbers between which the square of the distance from a point to the box lies.
    ///
    /// *Numerics*, *Range*, *Errors*, *Panics*, *Cost*: as for [`Triangle::distance_squared_range`].
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let (low, high) = cell.distance_squared_range([4.0, 5.0, 13.0])?;
    /// assert!(low < 169.0 && 169.0 < high);
    /// assert_eq!(cell.distance_squared_range([0.5; 3])?.0, 0.0);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared_range(&self, point: impl Into<Vec3<S>>) -> Result<(S, S), ShapeError> {
        self.distance_squared(point).map(beside)
    }
}
