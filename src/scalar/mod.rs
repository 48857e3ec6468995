//! The scalars: what is public of them, and for each type its constants and its cascade.

pub(crate) mod axes;
mod backend;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "fixed")]
mod fixed_point;
mod float;
mod grid;
#[cfg(feature = "defmt")]
mod logged;
mod planes;
mod rotation;
mod rounding;

pub use backend::{Backend, FloatFormat};
#[cfg(feature = "fixed")]
pub use fixed_point::FixedPoint;
pub use planes::{Planes, PlanesError};

#[cfg(feature = "defmt")]
pub use logged::Logged;

/// Asks nothing of a scalar, where there is no logging.
#[cfg(not(feature = "defmt"))]
pub trait Logged {}

#[cfg(not(feature = "defmt"))]
impl<S> Logged for S {}

/// A coordinate: `f32`, `f64`, or a signed type of the `fixed` crate of up to 64 bits.
///
/// Those are `FixedI8`, `FixedI16`, `FixedI32` and `FixedI64` with any number of fraction
/// bits. `FixedI128` is not among them.
///
/// The trait is sealed: exactness rests on what is known of each of its types.
/// Generic code needs no other bound than `S: Scalar`:
///
/// ```
/// use septum::{Aabb, Scalar, Triangle};
///
/// fn count<S: Scalar>(mesh: &[Triangle<S>], cell: &Aabb<S>) -> usize {
///     mesh.iter().filter(|t| t.overlaps(cell)).count()
/// }
/// ```
pub trait Scalar:
    Backend
    + axes::Axes
    + Planes
    + rotation::Rotation
    + grid::Gridded
    + rounding::Rounding
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

    /// Whether this is a number: not NaN, not infinite. Always true of
    /// fixed-point numbers.
    fn is_finite(self) -> bool;
}
