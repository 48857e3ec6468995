use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite};
use crate::scalar::Scalar;

/// A plane: all points x with n·(x − p) = 0, or with n·x + d = 0.
///
/// The normal points to its front. The normal may have any length except zero.
///
/// ```
/// use septum::{Aabb, Plane, Side};
///
/// let room = Aabb::from_min_max([0, 0, 0].map(f64::from), [4.0, 3.0, 2.5])?;
/// let ceiling = Plane::from_point_normal([0.0, 0.0, 2.5], [0.0, 0.0, 1.0])?;
/// assert!(ceiling.overlaps(&room)); // contact counts
/// assert_eq!(ceiling.side_of(&room), Side::Both);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Plane<S> {
    pub(super) normal: Vec3<S>,
    pub(super) form: Form<S>,
}

/// The position of the plane along its normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Form<S> {
    /// Through a point.
    Point(Vec3<S>),
    /// The d of n·x + d = 0.
    Offset(S),
}

impl<S: Scalar> Plane<S> {
    /// The point, the d, and the unit of length that a product with d needs; zero where the form has none.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> ([S; 3], S, S) {
        match self.form {
            Form::Point(p) => (p.to_array(), S::ZERO, S::ZERO),
            Form::Offset(d) => ([S::ZERO; 3], d, S::UNIT_LENGTH),
        }
    }

    /// A plane through `point`, at right angles to `normal`.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::ZeroNormal`] if the
    /// normal is zero.
    #[inline]
    pub fn from_point_normal(
        point: impl Into<Vec3<S>>,
        normal: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let point = finite("point", point)?;
        Ok(Self { normal: nonzero(normal)?, form: Form::Point(point) })
    }

    /// A plane by its equation n·x + d = 0.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a number is NaN or infinite, [`ShapeError::ZeroNormal`] if the
    /// normal is zero.
    #[inline]
    pub fn from_equation(normal: impl Into<Vec3<S>>, d: S) -> Result<Self, ShapeError> {
        if !d.is_finite() {
            return Err(ShapeError::NotFinite { argument: "d", index: None });
        }
        Ok(Self { normal: nonzero(normal)?, form: Form::Offset(d) })
    }
}

overlaps_methods!(
    Plane,
    "an [`Aabb`](crate::Aabb), a [`Sphere`](crate::Sphere) or a [`Capsule`](crate::Capsule)"
);

impl<S: Copy> Plane<S> {
    /// The normal, as given.
    #[inline]
    #[must_use]
    pub const fn normal(&self) -> Vec3<S> {
        self.normal
    }

    /// The point on the plane, if the plane was given by a point.
    #[inline]
    #[must_use]
    pub const fn point(&self) -> Option<Vec3<S>> {
        match self.form {
            Form::Point(p) => Some(p),
            Form::Offset(_) => None,
        }
    }

    /// The d of n·x + d = 0, if the plane was given by it.
    #[inline]
    #[must_use]
    pub const fn offset(&self) -> Option<S> {
        match self.form {
            Form::Offset(d) => Some(d),
            Form::Point(_) => None,
        }
    }
}

fn nonzero<S: Scalar>(normal: impl Into<Vec3<S>>) -> Result<Vec3<S>, ShapeError> {
    let n = finite("normal", normal)?;
    if n.x == S::ZERO && n.y == S::ZERO && n.z == S::ZERO {
        return Err(ShapeError::ZeroNormal);
    }
    Ok(n)
}
