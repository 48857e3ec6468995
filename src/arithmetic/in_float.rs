//! Scalars whose coordinates a float holds.

use super::float::Float;

/// A scalar whose coordinates are numbers of the float `F`, up to a limit, or multiples of
/// such by one power of two.
pub(crate) trait InFloat<F>: Copy {
    /// Below this magnitude nothing is rounded; `None` if nothing ever is.
    const LIMIT: Option<F>;

    /// The last place of a fixed-point number, as a number; zero of a float.
    const PLACE: F;

    /// Whether [`Offset`](super::Offset) is asked before this float, and not only beyond the limit,
    /// where there are vectors.
    const OFFSETS_FIRST: bool;

    /// The coordinate, to the nearest.
    fn in_float(self) -> F;
}

/// The coordinates, to the nearest.
#[inline(always)]
pub(crate) fn three_in_float<S: InFloat<F>, F>([x, y, z]: [S; 3]) -> [F; 3] {
    [x.in_float(), y.in_float(), z.in_float()]
}

/// The float that is asked first, four at once, in a query that has a kernel for that.
pub(crate) trait FirstFloat:
    InFloat<<Self as FirstFloat>::SeptumFirst> + InFloat<<Self as FirstFloat>::SeptumSecond>
{
    /// That float.
    type SeptumFirst: Float;

    /// The float that many at once ask where the first does not hold a coordinate; the same float if
    /// no longer one would help.
    type SeptumSecond: Float;

    /// [`InFloat::LIMIT`].
    const FIRST_LIMIT: Option<Self::SeptumFirst> = <Self as InFloat<Self::SeptumFirst>>::LIMIT;

    /// [`InFloat::in_float`].
    #[inline(always)]
    fn first(self) -> Self::SeptumFirst {
        self.in_float()
    }
}

impl FirstFloat for f32 {
    type SeptumFirst = f32;
    type SeptumSecond = f32;
}

impl FirstFloat for f64 {
    type SeptumFirst = f64;
    type SeptumSecond = f64;
}

impl<S: Float + Into<F>, F: Float> InFloat<F> for S {
    // Four numbers of `f64` are faster where one vector holds them. With AVX-512 the compiler loads eight,
    // and turns them at twice the cost.
    const OFFSETS_FIRST: bool = size_of::<S>() == size_of::<f64>()
        && cfg!(any(not(target_feature = "avx"), target_feature = "avx512f"));
    const LIMIT: Option<F> = None;
    const PLACE: F = F::ZERO;

    #[inline(always)]
    fn in_float(self) -> F {
        self.into()
    }
}
