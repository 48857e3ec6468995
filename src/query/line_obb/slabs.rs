//! Bounds on where a line enters and leaves the slabs of an oriented box, in `f64`.
//!
//! The axes of a box span space, so it is the intersection of its three slabs. A line therefore meets it if it
//! enters the last slab before it leaves the first.

use super::error_bound::{ErrorBound, Sizes, error_bound};
use super::kernel::Operands;
use crate::arithmetic::{Each, Filtered, OfFour, Quad, THREE, greatest, least, lost_in_row};
use crate::query::obb_rows::Vectors;

/// Numbers of three slabs, or of two, twice.
pub(super) type Four = <f64 as OfFour>::Quad;

/// The slabs of the box, three numbers side by side.
pub(super) struct Slabs {
    pub(super) w: Vectors<Four>,
    /// w_i·d and w_i·m.
    pub(super) along: Four,
    pub(super) middle: Four,
    /// u_0·w_0.
    pub(super) volume: f64,
    /// Bounds on where the line enters each slab, and on where it leaves it.
    pub(super) near: [Four; 2],
    pub(super) far: [Four; 2],
    /// Bounds on where it enters the last slab and leaves the first.
    pub(super) enter: [f64; 2],
    pub(super) leave: [f64; 2],
    pub(super) sizes: Sizes<f64>,
    /// How far w_i·d may be from the truth.
    pub(super) error: f64,
}

impl Slabs {
    #[inline(always)]
    pub(super) fn new(s: &Operands<f64>) -> Option<Self> {
        let u = Vectors::<Four>::new(&s.u);
        // At t = 0: numerators and divisors do not contain the ray's range.
        let sizes = Sizes { axes: greatest(u.largest().most(), s.one), ends: 0.0, ..s.sizes() };
        let ErrorBound { direction: error, face, .. } =
            error_bound::<Filtered<f64>>(s.one, &sizes)?;
        let w = u.normals();
        let (along, middle) = (w.dot(s.d), w.dot(s.m) * Four::splat(s.one));
        let volume = u.determinant(&w);
        let reach = Four::of_three(s.h) * Four::splat(volume.abs());

        let inverse = Four::splat(-1.0) / along;
        let (t, half) = (middle * inverse, reach * inverse.magnitude());
        // Both ends err by three roundoffs, and the numerator is not rounded as in the proof of its error.
        let lost = lost_in_row(t.magnitude() + half, inverse, [face, error]);
        let (near, far) = (t - half, t + half);
        let (mut near, mut far) = ([near - lost, near + lost], [far - lost, far + lost]);
        let parallel = along.magnitude().is_at_most(Four::splat(4.0 * error)) & THREE;
        if parallel != 0 {
            let inside = reach - middle.magnitude();
            [near, far] = along_slabs([near, far], inside, [face, error], parallel);
        }
        let (enter, leave) = (near.each(Four::most), far.each(fewest));
        Some(Self { w, along, middle, volume, near, far, enter, leave, sizes, error })
    }

    /// Whether the part of the line between these t misses the box, if that is certain.
    #[inline(always)]
    pub(super) fn misses(&self, [from, to]: [Option<f64>; 2]) -> Option<bool> {
        let from = from.unwrap_or(f64::NEG_INFINITY);
        let to = to.unwrap_or(f64::INFINITY);
        let ([enter, last], [first, leave]) = (self.enter, self.leave);
        if (greatest(enter, from) > leave) | (enter > to) {
            return Some(true);
        }
        let meets = (last <= first) & (from <= first) & (last <= to);
        meets.then_some(false)
    }

    /// The slabs that may be the last to be entered, and the first to be left, as bits.
    #[inline(always)]
    pub(super) fn candidates(&self) -> [u32; 2] {
        let ([last, _], [_, first]) = (self.enter, self.leave);
        let lasts = Four::splat(last).is_at_most(self.near[1]);
        [lasts & THREE, self.far[0].is_at_most(Four::splat(first)) & THREE]
    }
}

/// The least of the first three lanes.
#[inline(always)]
fn fewest(row: Four) -> f64 {
    let [x, y, z] = row.three();
    least(least(x, y), z)
}

/// The bounds if the line is parallel to these slabs, or nearly. Out of line, because few are.
#[cold]
#[inline(never)]
fn along_slabs(
    ends: [[Four; 2]; 2],
    inside: Four,
    [face, error]: [f64; 2],
    parallel: u32,
) -> [[Four; 2]; 2] {
    let [mut near, mut far] = ends.each(|ends| ends.each(Quad::to_array));
    let inside = inside.to_array();
    let is_parallel = |i: &usize| parallel >> i & 1 != 0;
    let others = || (0..3).filter(|i| !is_parallel(i));
    let enter = others().fold(f64::NEG_INFINITY, |enter, i| greatest(enter, near[0][i]));
    let leave = others().fold(f64::INFINITY, |leave, i| least(leave, far[1][i]));
    for i in (0..3).filter(is_parallel) {
        // So long the line certainly stays within the slab, or outside: the true divisor is at most 5 times
        // its error.
        let long = 0.125 * (inside[i].abs() - face) / error;
        let mut of_slab = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
        if long > 0.0 && inside[i] > 0.0 {
            of_slab = [[f64::NEG_INFINITY, -long], [long, f64::INFINITY]];
        } else if enter > -long && leave < long {
            // Within the other slabs the line is outside this one.
            of_slab[0] = [f64::INFINITY; 2];
        }
        for k in 0..2 {
            (near[k][i], far[k][i]) = (of_slab[0][k], of_slab[1][k]);
        }
    }
    [near.each(Quad::new), far.each(Quad::new)]
}
