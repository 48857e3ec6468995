use crate::scalar::Scalar;
use crate::shape::{ShapeError, Vec3, finite};

/// A translation from one place to another.
///
/// A motion is given by two places of one point, for example a body's centre in the last frame and
/// in this one. Every other point p goes to p + (`to` − `from`). That sum is not rounded and need
/// not be a number of the scalar. At time t, from zero to one, the point is at p + t·(`to` −
/// `from`).
///
/// A motion does not turn bodies.
///
/// ```
/// use septum::sweep::Motion;
///
/// let fall = Motion::new([0.0, 0.0, 9.0], [0.0, 0.0, -9.0])?;
/// assert_eq!(fall.reversed().to().z, 9.0);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Motion<S> {
    from: Vec3<S>,
    to: Vec3<S>,
}

impl<S: Scalar> Motion<S> {
    /// The motion from one place to another; no motion if the places are equal.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] where a coordinate is NaN or infinite.
    #[inline]
    pub fn new(from: impl Into<Vec3<S>>, to: impl Into<Vec3<S>>) -> Result<Self, ShapeError> {
        Ok(Self { from: finite(from)?, to: finite(to)? })
    }
}

impl<S: Copy> Motion<S> {
    /// Where the motion begins.
    #[inline]
    #[must_use]
    pub const fn from(&self) -> Vec3<S> {
        self.from
    }

    /// Where the motion ends.
    #[inline]
    #[must_use]
    pub const fn to(&self) -> Vec3<S> {
        self.to
    }

    /// The motion back. Seen from the moving body, everything else moves like this.
    #[inline]
    #[must_use]
    pub const fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from }
    }
}
