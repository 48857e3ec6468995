use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{ShapeError, finite};
use crate::scalar::Scalar;

/// A segment: all points between two ends, a closed set.
///
/// It is given by its ends, or by its centre and the vector from there to one end, as in *Real-Time
/// Rendering*. It keeps the form in which it was given, because conversion would round. The ends
/// may coincide: such a segment is a point, and queries about it are still exact.
///
/// ```
/// use septum::{Aabb, Segment};
///
/// let cell = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
/// let s = Segment::new([-1.0, 1.0, 0.5], [2.0, 1.0, 0.5])?;
/// assert!(s.overlaps(&cell)); // along a face
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segment<S> {
    pub(super) form: Form<S>,
}

/// The form in which the segment was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Form<S> {
    /// Two ends.
    Ends(Vec3<S>, Vec3<S>),
    /// Centre, and the vector from it to one end.
    Center { center: Vec3<S>, half: Vec3<S> },
}

impl<S: Scalar> Segment<S> {
    /// A segment between two ends.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a coordinate is NaN or infinite.
    #[inline]
    pub fn new(a: impl Into<Vec3<S>>, b: impl Into<Vec3<S>>) -> Result<Self, ShapeError> {
        Ok(Self { form: Form::Ends(finite("a", a)?, finite("b", b)?) })
    }

    /// A segment from `center − half_vector` to `center + half_vector`.
    ///
    /// The ends may lie between two numbers of the scalar; queries use the exact ends.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] if a coordinate is NaN or infinite.
    #[inline]
    pub fn from_center_half_vector(
        center: impl Into<Vec3<S>>,
        half_vector: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        Ok(Self {
            form: Form::Center {
                center: finite("center", center)?,
                half: finite("half_vector", half_vector)?,
            },
        })
    }
}

overlaps_methods!(
    Segment,
    "an [`Aabb`](crate::Aabb), an [`Obb`](crate::Obb), a [`Triangle`](crate::Triangle), a [`Sphere`](crate::Sphere) or a [`Capsule`](crate::Capsule)"
);

impl<S: Copy> Segment<S> {
    /// A segment between two ends that are known to be finite.
    pub(crate) const fn unchecked(a: Vec3<S>, b: Vec3<S>) -> Self {
        Self { form: Form::Ends(a, b) }
    }

    /// The two ends, if the segment was given by these.
    #[inline]
    #[must_use]
    pub const fn ends(&self) -> Option<(Vec3<S>, Vec3<S>)> {
        match self.form {
            Form::Ends(a, b) => Some((a, b)),
            Form::Center { .. } => None,
        }
    }

    /// Centre and half-vector, if the segment was given by these.
    #[inline]
    #[must_use]
    pub const fn center_half_vector(&self) -> Option<(Vec3<S>, Vec3<S>)> {
        match self.form {
            Form::Center { center, half } => Some((center, half)),
            Form::Ends(..) => None,
        }
    }

    #[inline(always)]
    pub(crate) const fn form(&self) -> &Form<S> {
        &self.form
    }

    /// Both vectors of the form, and whether it is centre and half-vector.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> ([S; 3], [S; 3], bool) {
        let (Form::Ends(a, b) | Form::Center { center: a, half: b }) = &self.form;
        (a.to_array(), b.to_array(), matches!(self.form, Form::Center { .. }))
    }
}
