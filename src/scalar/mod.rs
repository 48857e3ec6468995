//! The public trait `Scalar`, and for each type its constants and its cascade.

pub(crate) mod axes;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod grid;
mod in_double;
#[cfg(feature = "defmt")]
mod logged;
mod ordinal;
mod planes;
mod rotation;

pub(crate) use crate::robust::{Backend, FixedBackend, FloatFormat};

#[cfg(feature = "fixed")]
pub use fixed_point::FixedPoint;
#[cfg(feature = "defmt")]
pub(crate) use logged::Logged;
pub(crate) use ordinal::Ordinal;
pub(crate) use planes::{Planes, PlanesError};

/// Logging support, required of every scalar if the feature `defmt` is on; empty otherwise.
#[cfg(not(feature = "defmt"))]
pub(crate) trait Logged {}

#[cfg(not(feature = "defmt"))]
impl<S> Logged for S {}

/// A coordinate: `f32`, `f64`, or a signed type of the `fixed` crate of up to 64 bits.
///
/// The fixed-point types are `FixedI8`, `FixedI16`, `FixedI32` and `FixedI64` with any number of
/// fraction bits. `FixedI128` is not supported.
///
/// The trait is sealed, because exactness depends on properties of each type. Generic code needs no
/// bound other than `S: Scalar`:
///
/// ```
/// use septum::{Aabb, Scalar, Triangle};
///
/// fn count<S: Scalar>(mesh: &[Triangle<S>], cell: &Aabb<S>) -> usize {
///     mesh.iter().filter(|t| t.overlaps(cell)).count()
/// }
/// ```
// Generic code of other crates, which may have traits of its own with items of the same names, does
// not see the items of these traits: see `Backend`.
#[allow(private_bounds)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scalar of septum",
    label = "not `f32`, `f64` or a signed fixed-point type of up to 64 bits",
    note = "fixed-point types need the feature `fixed`, and the version of the crate `fixed` that septum uses"
)]
pub trait Scalar:
    Backend
    + axes::Axes
    + Planes
    + rotation::Rotation
    + grid::Gridded
    + ordinal::Ordinal
    + in_double::InDouble
    + Logged
    + Copy
    + PartialOrd
    + Default
    + core::fmt::Debug
    + Send
    + Sync
    + 'static
{
    /// Zero.
    const ZERO: Self;

    /// Whether the number is finite: not NaN and not infinite. Always `true` for fixed point.
    fn is_finite(self) -> bool;
}
