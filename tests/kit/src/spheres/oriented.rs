//! Oriented boxes against spheres and capsules: the hull of eight corners.

use dashu_int::IBig;
use septum::Obb;

use super::{Other, Point, minus};
use crate::exact::{Parts, least_exponent, whole};
use crate::sample::Sample;
use crate::{Each, rng::Rng, three};

/// The corners in units of 2^unit.
pub(super) fn corners(
    center: [IBig; 3],
    axes: [[Parts; 3]; 3],
    half: [Parts; 3],
    unit: i32,
) -> Vec<[IBig; 3]> {
    let [of_axes, of_half] = units(&axes, &half);
    let up = (of_axes + of_half - unit) as usize;
    let mut all = vec![center];
    for (axis, h) in axes.iter().zip(half) {
        let along = axis.each(|u| (whole(u, of_axes) * whole(h, of_half)) << up);
        let both = |p: &[IBig; 3]| [minus(p, &along), three(|i: usize| &p[i] + &along[i])];
        all = all.iter().flat_map(both).collect();
    }
    all
}

/// The units of axes and of half-extents.
pub(super) fn units(axes: &[[Parts; 3]; 3], half: &[Parts; 3]) -> [i32; 2] {
    [least_exponent(axes.as_flattened()), least_exponent(half)]
}

/// An oriented box, a quarter of them flat; a point if the axes do not span space.
pub(super) fn any<S: Sample>(
    rng: &mut Rng,
    center: Point<S>,
    axes: [Point<S>; 3],
    mut half: Point<S>,
) -> Other<S> {
    if rng.one_in(4) {
        half[rng.below(3)] = S::ZERO;
    }
    match Obb::from_skewed_axes(center, axes, half) {
        Ok(_) => Other::Obb(center, axes, half),
        Err(_) => Other::Point(center),
    }
}

pub(super) fn obb<S: Sample>(center: Point<S>, axes: [Point<S>; 3], half: Point<S>) -> Obb<S> {
    Obb::from_skewed_axes(center, axes, half).expect("axes that span space")
}
