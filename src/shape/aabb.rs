use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite, finite_at};
use crate::arithmetic::{greatest, least, three};
use crate::scalar::Scalar;

/// An axis-aligned box, a closed set. It may be flat, or a point.
///
/// It is given by its centre and half-extents, or by its least and greatest corner, and keeps the
/// form in which it was given: conversion would round, and the rounded box would be a different
/// box.
///
/// ```
/// use septum::{Aabb, ShapeError};
///
/// let a = Aabb::from_center_half_extents([0.5, 0.5, 0.5], [0.5, 0.5, 0.5])?;
/// let b = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
/// assert!(a.overlaps(&b) && b.contains([1.0, 0.5, 0.5]));
/// let (min, max) = b.min_max().unwrap();
/// assert!(a.min_max() == Some((min, max)) && b.center_half_extents().is_none());
///
/// let flipped = Aabb::from_min_max([1.0, 0.0, 0.0], [0.0, 1.0, 1.0]);
/// assert_eq!(flipped, Err(ShapeError::MinAboveMax));
/// # Ok::<(), ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Aabb<S> {
    pub(super) form: Form<S>,
}

/// The form in which the box was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Form<S> {
    /// Centre and half-extents.
    Center { center: Vec3<S>, half: Vec3<S> },
    /// Least and greatest corner.
    Corners { min: Vec3<S>, max: Vec3<S> },
}

/// The corners of a box around both pairs of corners.
#[inline(always)]
pub(crate) fn joined<S: Scalar>([a, b]: [[S; 3]; 2], [c, d]: [[S; 3]; 2]) -> [[S; 3]; 2] {
    [three(|i| least(a[i], c[i])), three(|i| greatest(b[i], d[i]))]
}

impl<S: Scalar> Aabb<S> {
    /// A box around `center` that extends `half_extents` to either side.
    ///
    /// The corners may lie between two numbers of the scalar; queries use the exact corners.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::NegativeHalfExtent`]
    /// if a half-extent is negative.
    #[inline]
    pub fn from_center_half_extents(
        center: impl Into<Vec3<S>>,
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let (center, half) = (finite("center", center)?, finite("half_extents", half_extents)?);
        if half.x < S::ZERO || half.y < S::ZERO || half.z < S::ZERO {
            return Err(ShapeError::NegativeHalfExtent);
        }
        Ok(Self { form: Form::Center { center, half } })
    }

    /// A box from its least to its greatest corner.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::MinAboveMax`] if
    /// `min` exceeds `max` on some axis.
    #[inline]
    pub fn from_min_max(
        min: impl Into<Vec3<S>>,
        max: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let (min, max) = (finite("min", min)?, finite("max", max)?);
        if min.x > max.x || min.y > max.y || min.z > max.z {
            return Err(ShapeError::MinAboveMax);
        }
        Ok(Self { form: Form::Corners { min, max } })
    }

    /// The smallest box that contains all of these points.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a coordinate is NaN or infinite, [`ShapeError::NoPoints`] if
    /// there are no points.
    ///
    /// ```
    /// use septum::{Aabb, ShapeError, Vec3};
    ///
    /// let cloud = Aabb::from_points([[1.0, 0.0, 2.0], [0.0, 3.0, 0.5]])?;
    /// assert_eq!(cloud.min_max(), Some((Vec3::new(0.0, 0.0, 0.5), Vec3::new(1.0, 3.0, 2.0))));
    /// assert_eq!(Aabb::from_points([[0.0; 3]; 0]), Err(ShapeError::NoPoints));
    /// # Ok::<(), ShapeError>(())
    /// ```
    #[doc(alias = "bounding box")]
    pub fn from_points(
        points: impl IntoIterator<Item = impl Into<Vec3<S>>>,
    ) -> Result<Self, ShapeError> {
        let mut ends = None;
        for (i, point) in points.into_iter().enumerate() {
            let p = finite_at("points", Some(i), point)?.to_array();
            ends = Some(ends.map_or([p, p], |ends| joined(ends, [p, p])));
        }
        let [min, max] = ends.ok_or(ShapeError::NoPoints)?;
        Ok(Self::between(min.into(), max.into()))
    }
}

overlaps_methods!(
    Aabb,
    "a [`Triangle`](crate::Triangle), [`Polygon`](crate::polygon::Polygon), [`Plane`](crate::Plane), [`Segment`](crate::Segment), [`Ray`](crate::Ray), [`Obb`](crate::Obb), [`Sphere`](crate::Sphere), [`Capsule`](crate::Capsule) or another box"
);

impl<S: Copy> Aabb<S> {
    /// Centre and half-extents, if the box was given by these.
    #[inline]
    #[must_use]
    pub const fn center_half_extents(&self) -> Option<(Vec3<S>, Vec3<S>)> {
        match self.form {
            Form::Center { center, half } => Some((center, half)),
            Form::Corners { .. } => None,
        }
    }

    /// The corners, if the box was given by these.
    #[inline]
    pub(crate) const fn given_corners(&self) -> Option<(Vec3<S>, Vec3<S>)> {
        match self.form {
            Form::Corners { min, max } => Some((min, max)),
            Form::Center { .. } => None,
        }
    }

    /// A box between two corners that were checked before.
    #[inline(always)]
    pub(crate) const fn between(min: Vec3<S>, max: Vec3<S>) -> Self {
        Self { form: Form::Corners { min, max } }
    }

    /// A box around a centre; centre and half-extents were checked before.
    #[inline(always)]
    pub(crate) const fn around(center: Vec3<S>, half: Vec3<S>) -> Self {
        Self { form: Form::Center { center, half } }
    }

    /// A box around the origin with half-extents that were checked before.
    pub(crate) fn about_origin(half: Vec3<S>) -> Self
    where
        S: Scalar,
    {
        Self::around(Vec3::splat(S::ZERO), half)
    }

    #[inline(always)]
    pub(crate) const fn form(&self) -> &Form<S> {
        &self.form
    }

    /// Both vectors of the form, and whether it is centre and half-extents.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> ([S; 3], [S; 3], bool) {
        let (Form::Center { center: p, half: q } | Form::Corners { min: p, max: q }) = &self.form;
        (p.to_array(), q.to_array(), matches!(self.form, Form::Center { .. }))
    }
}
