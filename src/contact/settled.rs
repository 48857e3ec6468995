//! The numbers of a translation from floats, where every number within their error bounds rounds to
//! the same number of the scalar. They equal those from exact numbers, and take a fraction of the
//! time.

use core::cmp::Ordering;
use core::mem::size_of;

use super::body::{Body, Vec64};
use super::directions::Direction;
use super::filter::{Filter, Measured};
use super::measures::{Directed, Measures, Way};
use super::unit::unit;
use crate::arithmetic::{Each, exp2, largest, pick, root_of_machine};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// The unit roundoff.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// Roundoffs in a number, in addition to the errors of the overlap and of a coordinate.
const ROUNDOFFS: u16 = 64;

/// The greatest relative error of an overlap, and of a coordinate, with which a number is rounded.
const MOST: f64 = exp2(-20);

/// If P²·(1 + n)² exceeds this times a·a, the normal errs too much.
pub(super) const SQUARES: u16 = 30;

/// The way along a direction and its numbers, if floats are certain of all signs along the
/// direction, and of the number of the scalar to which each of its lengths rounds. If `bodies` are given,
/// double words also have to be certain of the unit vector; otherwise it is zero.
///
/// # The error
///
/// u is the unit roundoff; a = x × y with products of at most P, and n of the two sides are edges of
/// triangles, which have a rounding in each coordinate. Other sides are given numbers. Scalars of up
/// to 32 bits have products above 2^-300, so that nothing underflows.
///
/// * A coordinate of a errs by 2·(1 + n)·u times the greater of its two products, and by u of
///   itself.
/// * [`SQUARES`] keeps 2·√3·(1 + n)·P/|a| below 19: the direction errs by 20·u, and so does the
///   length. Its square has 3 roundings, and its root two more: 24·u.
/// * `settled.g` proves that a number differs from the truth by the errors of the overlap and
///   of its coordinate, and less than 62·u.
/// * Exact numbers are rounded after an error of up to 2^-55 = u/4 of themselves, and the two ends
///   that are compared have a rounding each.
pub(super) fn settled<S: Scalar>(
    filter: &Filter<'_>,
    (direction, numbers): (Direction, [u8; 2]),
    is_along: bool,
    bodies: Option<&[Body<'_, S>; 2]>,
) -> Option<Directed<S>> {
    // Floats of 53 digits do not round to as many.
    if size_of::<S>() >= size_of::<f64>() {
        return None;
    }
    let Measured { a, products, scale, square, overlaps, error } =
        filter.ruler.measured::<f64>(|_| numbers);
    let roundings = f64::from(1 + filter.rounded_sides(numbers));
    if filter.ruler.known(scale, square) == 0
        || scale * scale * (roundings * roundings) > f64::from(SQUARES) * square
    {
        return None;
    }
    // Bits, without a branch.
    let [overlap, other] = overlaps.each(f64::to_bits);
    let overlap = f64::from_bits(overlap ^ (overlap ^ other) & u64::from(is_along).wrapping_neg());
    let mut of_coordinates = [0.0; 3];
    for i in 0..3 {
        if products[i] > 0.0 {
            of_coordinates[i] = (2.0 * roundings * (products[i] / a[i].abs()) + 1.0) * U;
        }
    }
    let is_single = is_single(&a);
    let length = if is_single { largest(&a) } else { root_of_machine(square) };
    let inverse = 1.0 / length;
    let known = Known {
        a,
        of_coordinates,
        is_single,
        inverse,
        depth: overlap * inverse,
        of_depth: error / overlap,
    };
    let mut along = [[Ordering::Equal; 3]; 2];
    for (along, known) in along
        .as_flattened_mut()
        .iter_mut()
        .zip(filter.signs(numbers, &(a, products)).as_flattened())
    {
        *along = (*known)?;
    }
    let unit = match bodies {
        Some(bodies) => {
            let is_exact = |n: u8| bodies[usize::from(n >= 3)].is_side_exact((n % 3).into());
            if !(is_exact(numbers[0]) && is_exact(numbers[1])) {
                return None;
            }
            unit(filter.ruler.sides(numbers), is_along, inverse)?
        }
        None => [0.0; 3],
    };
    let way = Way { direction, is_along, along, is_held: false };
    Some(Directed { unit, depth: f64::INFINITY, measures: known.measures(is_along)?, way })
}

/// Whether a direction is a coordinate axis.
#[inline]
pub(super) fn is_single(a: &Vec64) -> bool {
    a.iter().filter(|&&x| x != 0.0).count() == 1
}

/// A direction in floats, and the depth along it.
pub(super) struct Known {
    /// The direction. A coordinate of zero is exact.
    pub(super) a: Vec64,
    /// How far each coordinate may be off, of itself.
    pub(super) of_coordinates: Vec64,
    /// Whether it is a coordinate axis.
    pub(super) is_single: bool,
    /// One over the length.
    pub(super) inverse: f64,
    pub(super) depth: f64,
    /// How far the depth may be off, of itself, roundings of quotients aside. It is exact if that is
    /// zero.
    pub(super) of_depth: f64,
}

impl Known {
    /// The depth, and how far it may be off, of itself.
    #[inline]
    pub(super) fn depth(&self) -> (f64, f64) {
        (self.depth, if self.of_depth == 0.0 { 0.0 } else { error_of(self.of_depth) })
    }

    /// A coordinate of the unit vector and of the translation, in magnitude, and how far each may be
    /// off, of itself.
    #[inline]
    pub(super) fn coordinate(&self, i: usize) -> [(f64, f64); 2] {
        if self.is_single {
            return [(1.0, 0.0), self.depth()];
        }
        let (ratio, error) =
            (pick(&self.a, i).abs() * self.inverse, *pick(&self.of_coordinates, i));
        [(ratio, error_of(error)), (ratio * self.depth, error_of(self.of_depth + error))]
    }

    /// The numbers of the translation, if each rounds to one number of the scalar.
    pub(super) fn measures<S: Scalar>(&self, is_along: bool) -> Option<Measures<S>> {
        // Not so if one is NaN, of an overlap or a coordinate of zero.
        let is_precise = |error: &f64| *error <= MOST;
        let are_precise = self.of_coordinates.iter().all(is_precise) && is_precise(&self.of_depth);
        if !(self.depth > 0.0 && are_precise) {
            return None;
        }
        let (depth, error) = self.depth();
        let (depth, _) = rounded::<S>(depth, error, true, false)?;
        let along = |i: usize| {
            if self.a[i] == 0.0 {
                return Some((S::ZERO, true, S::ZERO));
            }
            let is_negative = (self.a[i] > 0.0) != is_along;
            let [(ratio, of_ratio), (size, of_size)] = self.coordinate(i);
            let (along, fits) = rounded(size, of_size, true, is_negative)?;
            Some((along, fits, rounded(ratio, of_ratio, false, is_negative)?.0))
        };
        let ((x, x_fits, p), (y, y_fits, q), (z, z_fits, r)) = (along(0)?, along(1)?, along(2)?);
        let (vector, normal) = (Vec3::new(x, y, z), Vec3::new(p, q, r));
        let is_sufficient = x_fits & y_fits & z_fits;
        Some(Measures { vector, depth, normal, is_sufficient })
    }
}

/// The relative error of a number, from the sum of the errors of its factors.
#[inline]
fn error_of(factors: f64) -> f64 {
    1.01 * factors + f64::from(ROUNDOFFS) * U
}

/// The number of the scalar to which all numbers within a relative error of x round, and whether
/// the scalar holds them.
fn rounded<S: Scalar>(x: f64, error: f64, is_up: bool, is_negative: bool) -> Option<(S, bool)> {
    let rounded = |x| S::of_double(x, is_up, is_negative);
    let low = rounded(x - x * error);
    (low == rounded(x + x * error)).then_some(low)
}
