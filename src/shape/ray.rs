use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite};
use crate::scalar::Scalar;

/// A ray: the points `origin + t·direction` for all t in a range, a closed set.
///
/// The direction may have any length except zero, and t counts in units of it: the direction is
/// never normalised, because that would round. The range is t ≥ 0 unless
/// [`with_range`](Self::with_range) changes it.
///
/// ```
/// use septum::{Ray, ShapeError, Triangle};
///
/// let ray = Ray::new([0.25, 0.25, 9.0], [0.0, 0.0, -2.0])?;
/// let floor = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// assert_eq!(ray.hit(&floor).unwrap().t, 4.5);
/// assert!(ray.with_range(0.0, 4.0)?.hit(&floor).is_none());
///
/// let still = Ray::new([0.0; 3], [0.0, 0.0, 0.0]);
/// assert_eq!(still, Err(ShapeError::ZeroDirection));
/// # Ok::<(), ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Ray<S> {
    pub(super) origin: Vec3<S>,
    pub(super) direction: Vec3<S>,
    pub(super) t_min: Option<S>,
    pub(super) t_max: Option<S>,
}

impl<S: Scalar> Ray<S> {
    /// A ray from `origin` along `direction`, for t ≥ 0.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a coordinate is NaN or infinite, [`ShapeError::ZeroDirection`]
    /// if the direction is zero.
    #[inline]
    pub fn new(
        origin: impl Into<Vec3<S>>,
        direction: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let (origin, direction) = (finite("origin", origin)?, finite("direction", direction)?);
        if direction.to_array() == [S::ZERO; 3] {
            return Err(ShapeError::ZeroDirection);
        }
        Ok(Self { origin, direction, t_min: Some(S::ZERO), t_max: None })
    }

    /// The same ray for t from `t_min` to `t_max`, both included.
    ///
    /// `None` leaves an end unbounded: `with_range(None, None)` is the whole line. In fixed point an
    /// end at the greatest number is slower: its products are beyond short integers.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if an end is NaN or infinite, [`ShapeError::EmptyRange`] if
    /// `t_min` exceeds `t_max`.
    #[inline]
    pub fn with_range(
        self,
        t_min: impl Into<Option<S>>,
        t_max: impl Into<Option<S>>,
    ) -> Result<Self, ShapeError> {
        let (t_min, t_max) = (t_min.into(), t_max.into());
        for (argument, t) in [("t_min", t_min), ("t_max", t_max)] {
            if !t.is_none_or(S::is_finite) {
                return Err(ShapeError::NotFinite { argument, index: None });
            }
        }
        if t_min.zip(t_max).is_some_and(|(min, max)| min > max) {
            return Err(ShapeError::EmptyRange);
        }
        Ok(Self { t_min, t_max, ..self })
    }

    /// The same ray, ending at `t_max`, or at `t_min` if `t_max` lies before it. `t_max` is not
    /// NaN.
    pub(crate) fn until(self, t_max: S) -> Self {
        let is_after = self.t_min.is_none_or(|t_min| t_min <= t_max);
        Self { t_max: if is_after { Some(t_max) } else { self.t_min }, ..self }
    }

    /// The origin, the direction, and the ends of the range, where it has them.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [[S; 3]; 3] {
        let end = |t: Option<S>| t.unwrap_or(S::ZERO);
        let range = [end(self.t_min), end(self.t_max), S::ZERO];
        [self.origin.to_array(), self.direction.to_array(), range]
    }

    /// The same, with the unit of length as the third number.
    #[inline(always)]
    pub(crate) fn numbers_and_unit(&self) -> [[S; 3]; 3] {
        let [origin, direction, [from, to, _]] = self.numbers();
        [origin, direction, [from, to, self.unit()]]
    }

    /// The unit of length, if floats need it where a product with an end meets a length, or zero. Fixed point has
    /// another one. If the range begins at zero, a sign suffices there.
    #[inline(always)]
    pub(crate) fn unit(&self) -> S {
        let is_later = self.t_min.is_some_and(|t| t != S::ZERO);
        let is_needed = S::FLOAT.is_some() && (self.t_max.is_some() || is_later);
        if is_needed { S::UNIT_LENGTH } else { S::ZERO }
    }
}

overlaps_methods!(
    Ray,
    "an [`Aabb`](crate::Aabb), an [`Obb`](crate::Obb), a [`Sphere`](crate::Sphere) or a [`Capsule`](crate::Capsule)"
);

impl<S: Copy> Ray<S> {
    /// The origin: the point at t = 0.
    #[inline]
    #[must_use]
    pub const fn origin(&self) -> Vec3<S> {
        self.origin
    }

    /// The direction: the vector that one unit of t spans.
    #[inline]
    #[must_use]
    pub const fn direction(&self) -> Vec3<S> {
        self.direction
    }

    /// The least t, or `None` if the ray is unbounded there.
    #[inline]
    #[must_use]
    pub const fn t_min(&self) -> Option<S> {
        self.t_min
    }

    /// The greatest t, or `None` if the ray is unbounded there.
    #[inline]
    #[must_use]
    pub const fn t_max(&self) -> Option<S> {
        self.t_max
    }
}
