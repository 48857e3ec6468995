use core::fmt;

/// Why no shape could be made of what was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ShapeError {
    /// A coordinate is NaN or infinite.
    NotFinite,
    /// A half-extent is below nought.
    NegativeHalfExtent,
    /// On some axis the least corner lies above the greatest.
    MinAboveMax,
    /// The axes do not span space: one is nought, or they lie in one plane.
    DependentAxes,
    /// The axes are not at right angles, or not of length one, by more than any
    /// rounding explains.
    NotOrthonormal,
    /// A plane's normal is nought.
    ZeroNormal,
    /// A ray's direction is nought.
    ZeroDirection,
    /// A range ends before it begins.
    EmptyRange,
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "a coordinate is NaN or infinite",
            Self::NegativeHalfExtent => "a half-extent is negative",
            Self::MinAboveMax => "the least corner lies above the greatest",
            Self::DependentAxes => "the axes are linearly dependent",
            Self::NotOrthonormal => "the axes are not orthonormal",
            Self::ZeroNormal => "the normal is zero",
            Self::ZeroDirection => "the direction is zero",
            Self::EmptyRange => "the range ends before it begins",
        })
    }
}

impl core::error::Error for ShapeError {}
