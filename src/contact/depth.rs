//! The numbers of a translation along a way, exact or with a bound.
//!
//! The depth r − d is computed as (r² − d²)/(r + d): the difference is exact, and all other
//! operations are on numbers above zero, with a bound on what is missing. The depth is along the
//! computed direction itself, so a vector that is rounded away from zero suffices.

use core::cmp::Ordering;

use super::exact::length;
use super::measures::Lengths;
use super::nearest::Place;
use super::scene::Way;
use crate::arithmetic::{Arithmetic, Embeds, Number, Soft, cross, three};
use crate::query::{along, product};
use crate::scalar::Scalar;

/// A translation of the round shape out of the flat one, in exact numbers.
pub(super) struct Out {
    pub(super) lengths: Lengths,
    /// How far the segment is away; below zero if it overlaps.
    pub(super) distance: f64,
}

/// One to the degrees one, two, three, four and six.
pub(super) struct Units<N: Arithmetic> {
    one: N::Length,
    areas: N::Area,
    volumes: N::Volume,
    quartics: N::Quartic,
    sextics: N::Sextic,
}

impl<N: Arithmetic> Units<N> {
    pub(super) fn new(one: N::Length) -> Self {
        let areas = N::area(one, one);
        let volumes = N::volume(areas, one);
        let (quartics, sextics) = (N::quartic(areas, areas), N::sextic(volumes, volumes));
        Self { one, areas, volumes, quartics, sextics }
    }
}

/// Sign and size of a number in a unit, which is a power of two.
fn in_units<T: Number>(x: T, unit: T) -> Option<(Ordering, Soft)> {
    let ((sign, size), (_, unit)) = (x.sign_and_size()?, unit.sign_and_size()?);
    Some((sign, size.over_power(unit)))
}

/// A size of a number that is above zero; `None` for other numbers.
fn above_zero<T: Number>(x: T, unit: T) -> Option<Soft> {
    in_units(x, unit).filter(|(sign, _)| sign.is_gt()).map(|(_, size)| size)
}

/// The numbers along a way; `None` if the depth is not above zero.
#[inline(never)]
pub(super) fn out<S: Scalar, N: Arithmetic>(
    way: &Way<N>,
    r: N::Length,
    unit: &Units<N>,
) -> Option<Out> {
    let square = N::area(r, r);
    let radius = in_units(r, unit.one).map(|(_, size)| size);
    let mut overlap = None;
    // The coordinates of the way; r² − d² and d², both multiplied by a third number.
    let (coordinates, apart) = match way {
        Way::Points(d) => {
            let squared = product::<N>(d, d);
            let size = |x| above_zero(x, unit.areas);
            let numbers = (size(square - squared), size(squared), Some(Soft::ONE));
            (three(|i| in_units(d[i], unit.one)), Some(numbers))
        }
        Way::Line { d, e } => {
            let (ee, de, c) = (product::<N>(e, e), product::<N>(d, e), cross::<N>(e, d));
            let (whole, squared) = (N::quartic(square, ee), along::<N>(&c, &c));
            let size = |x| above_zero(x, unit.quartics);
            let numbers = (size(whole - squared), size(squared), above_zero(ee, unit.areas));
            let coordinate = |i: usize| N::volume(ee, d[i]) - N::volume(de, e[i]);
            (three(|i| in_units(coordinate(i), unit.volumes)), Some(numbers))
        }
        Way::Normal { n, overlap: o } => {
            let nn = along::<N>(n, n);
            let apart = if *o < N::Volume::ZERO {
                let (whole, squared) = (N::sextic_of_areas(nn, square), N::sextic(*o, *o));
                let size = |x| above_zero(x, unit.sextics);
                let third = above_zero(nn, unit.quartics);
                Some((size(whole - squared), size(squared), third))
            } else {
                overlap = above_zero(*o, unit.volumes);
                None
            };
            (three(|i| in_units(n[i], unit.areas)), apart)
        }
    };
    let (length, square) = length(&coordinates)?;
    let (depth, distance) = match apart {
        Some((gap, squared, third)) => {
            let distance = squared?.over(third?).root();
            (gap?.over(third?).over(radius?.plus(distance)), Some((distance, 1.0)))
        }
        None => {
            let core = overlap.map(|overlap| overlap.over(length));
            let depth = match (radius, core) {
                (Some(radius), Some(core)) => radius.plus(core),
                (radius, core) => radius.or(core)?,
            };
            (depth, core.map(|core| (core, -1.0)))
        }
    };
    // From one in the system to the scalar's places, and as `Lengths` has them.
    let one = S::UNIT_LENGTH.parts();
    let place = Soft::of_limbs(&[one.magnitude])?.scaled(one.shift.into());
    let depth = depth.times(place).scaled(S::ONE.shift.into());
    let distance = distance.map_or(0.0, |(distance, sign)| {
        sign * distance.times(place).scaled(-i32::from(S::ONE.shift)).in_double()
    });
    let overlap = depth.times(length);
    Some(Out { lengths: Lengths { overlap, length, square, depth, coordinates }, distance })
}

/// A place as numbers of the scalar, each rounded once.
pub(super) fn rounded<N: Embeds<S>, S: Scalar>(
    place: &Place<N>,
    unit: &Units<N>,
) -> Option<[S; 3]> {
    let quotient = |from: N::Length, step: N::Sextic, den: N::Quartic| {
        let num = N::sextic_of_areas(den, N::area(from, unit.one)) + step;
        N::coordinate(num, N::sextic_of_areas(den, unit.areas), [N::Sextic::ZERO; 2])
    };
    let [x, y, z] = three(|i| match place {
        Place::Corner(x) => quotient(x[i], N::Sextic::ZERO, unit.quartics),
        Place::Edge { from, e, along, length } => {
            quotient(from[i], N::sextic_of_areas(*along, N::area(e[i], unit.one)), *length)
        }
        Place::Face { of, n, height } => {
            let step = N::sextic(*height, N::volume(n[i], unit.one));
            quotient(of[i], step, along::<N>(n, n))
        }
    });
    Some([x?, y?, z?])
}
