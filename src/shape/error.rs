use core::fmt;

/// The reason why a constructor refused its input.
///
/// [`NotFinite`](Self::NotFinite) names the argument; every other variant says by its meaning which
/// arguments it is about.
///
/// ```
/// use septum::{Obb, ShapeError};
///
/// let axes = [[1.0, 0.0, 0.0], [0.0, f32::NAN, 0.0], [0.0, 0.0, 1.0]];
/// let error = Obb::new([0.0; 3], axes, [1.0; 3]).unwrap_err();
/// assert_eq!(error, ShapeError::NotFinite { argument: "axes", index: Some(1) });
/// assert_eq!(error.to_string(), "a number is NaN or infinite: axes[1]");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ShapeError {
    /// A number is NaN or infinite.
    NotFinite {
        /// The name of the argument, as the constructor has it.
        argument: &'static str,
        /// The place in the argument, if it is a list.
        index: Option<usize>,
    },
    /// A half-extent is negative.
    NegativeHalfExtent,
    /// A radius is negative.
    NegativeRadius,
    /// The least corner exceeds the greatest on some axis.
    MinAboveMax,
    /// The axes do not span space: one is zero, two are parallel, or all three lie
    /// in one plane.
    DependentAxes,
    /// The axes are not orthogonal, or not of length one, by more than rounding explains.
    /// [`Obb::from_skewed_axes`](crate::Obb::from_skewed_axes) accepts them if they are meant so.
    NotOrthonormal,
    /// The scalar is a fixed-point type without integer bits, and has no vector of length one.
    /// [`Obb::from_skewed_axes`](crate::Obb::from_skewed_axes) accepts axes of any length, with
    /// half-extents in units of that length.
    NoUnitLength,
    /// The squares of the quaternion's components do not add up to one, by more than rounding
    /// explains.
    NotUnitQuaternion,
    /// A plane's normal is zero.
    ZeroNormal,
    /// A ray's direction is zero.
    ZeroDirection,
    /// A range ends before it begins.
    EmptyRange,
    /// A coordinate is too far from zero for a `near` shape.
    NotNear,
    /// A polygon has fewer than three vertices.
    TooFewVertices,
    /// A box around no points.
    NoPoints,
}

impl ShapeError {
    /// Returns the shape in a `const` or a `static`; a refused shape is a compile error.
    ///
    /// [`Result::unwrap`] is not `const`.
    ///
    /// ```
    /// use septum::{Aabb, ShapeError, Vec3};
    ///
    /// const LOW: Vec3<f32> = Vec3::splat(-1.0);
    /// const HIGH: Vec3<f32> = Vec3::splat(1.0);
    /// static CELL: Aabb<f32> = ShapeError::unwrap(Aabb::<f32>::const_new(LOW, HIGH));
    /// assert_eq!(CELL.min_max(), Some((LOW, HIGH)));
    /// ```
    ///
    /// With the corners exchanged it does not compile:
    ///
    /// ```compile_fail
    /// # use septum::{Aabb, ShapeError, Vec3};
    /// # const LOW: Vec3<f32> = Vec3::splat(-1.0);
    /// # const HIGH: Vec3<f32> = Vec3::splat(1.0);
    /// static CELL: Aabb<f32> = ShapeError::unwrap(Aabb::<f32>::const_new(HIGH, LOW));
    /// ```
    ///
    /// # Panics
    /// On an error, if called at run time. Match on the result there instead.
    #[must_use]
    #[track_caller]
    pub const fn unwrap<T: Copy>(shape: Result<T, Self>) -> T {
        match shape {
            Ok(shape) => shape,
            Err(error) => panic!("{}", error.message()),
        }
    }

    const fn message(self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "a number is NaN or infinite",
            Self::NegativeHalfExtent => "a half-extent is negative",
            Self::NegativeRadius => "a radius is negative",
            Self::MinAboveMax => "the least corner lies above the greatest",
            Self::DependentAxes => "the axes are linearly dependent",
            Self::NotOrthonormal => "the axes are not orthonormal",
            Self::NoUnitLength => "the scalar holds no vector of length one",
            Self::NotUnitQuaternion => "the quaternion is not of length one",
            Self::ZeroNormal => "the normal is zero",
            Self::ZeroDirection => "the direction is zero",
            Self::EmptyRange => "the range ends before it begins",
            Self::NotNear => "a coordinate is too far from zero",
            Self::TooFewVertices => "a polygon has fewer than three vertices",
            Self::NoPoints => "there are no points to enclose",
        }
    }
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())?;
        match *self {
            Self::NotFinite { argument, index: None } => write!(f, ": {argument}"),
            Self::NotFinite { argument, index: Some(i) } => write!(f, ": {argument}[{i}]"),
            _ => Ok(()),
        }
    }
}

impl core::error::Error for ShapeError {}
