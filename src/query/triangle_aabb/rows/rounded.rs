//! The kernel in rounded floats: the operations of `kernel.rs`, and so the same answers.

use super::{InFrame, Rows};
use crate::arithmetic::{Each, FirstFloat, Float, Number, OfFour, Quad, THREE};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle};

type First<S> = <<S as FirstFloat>::SeptumFirst as OfFour>::Quad;

/// Whether one of the 13 axes separates, as the scalar's first float rounds.
#[inline(always)]
pub(in crate::query::triangle_aabb) fn disjoint<S: Scalar>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> bool {
    match *aabb.form() {
        AabbForm::Center { center: c, half: h } => {
            by_center(triangle, c.x, c.y, c.z, h.x, h.y, h.z)
        }
        AabbForm::Corners { min: a, max: b } => by_corners(triangle, a.x, a.y, a.z, b.x, b.y, b.z),
    }
}

#[allow(clippy::too_many_arguments)] // each in a register
#[inline(never)]
fn by_center<S: Scalar>(triangle: &Triangle<S>, cx: S, cy: S, cz: S, hx: S, hy: S, hz: S) -> bool {
    let (center, half) =
        (First::<S>::of_three([cx, cy, cz].each(S::first)), [hx, hy, hz].each(S::first));
    let rows = Rows::new(triangle.points().each(|p| p.each(S::first)));
    rows.seem_apart(&rows.in_frame_of_center(center, First::<S>::of_three(half)))
}

#[allow(clippy::too_many_arguments)] // each in a register
#[inline(never)]
fn by_corners<S: Scalar>(triangle: &Triangle<S>, ax: S, ay: S, az: S, bx: S, by: S, bz: S) -> bool {
    let (min, max) =
        (First::<S>::of_three([ax, ay, az].each(S::first)), [bx, by, bz].each(S::first));
    let rows = Rows::new(triangle.points().each(|p| p.each(S::first)));
    let frame = rows.in_frame_of_corners(min, First::<S>::of_three(max));
    // Of the vertices in the frame, as in `kernel.rs`, and not of the given vertices.
    let InFrame { v: [a, b, c], half, .. } = frame;
    let (low, high) = (a.least(b).least(c), a.greatest(b).greatest(c));
    let gap = low.greatest(First::<S>::splat(S::SeptumFirst::ZERO) - high);
    rows.seem_apart(&InFrame { apart: gap.exceeds(half) & THREE, ..frame })
}

impl<Q: Quad<Lane: Float>> Rows<Q> {
    #[inline(always)]
    fn seem_apart(&self, frame: &InFrame<Q>) -> bool {
        let zero = Q::splat(Q::Lane::ZERO);
        let [a, b, c] = self.edges(frame);
        // Not the greatest of the three, which may be a NaN after an overflow.
        let edges = (a.exceeds(zero) | b.exceeds(zero) | c.exceeds(zero)) & THREE;
        let plane = u32::from(self.plane(frame) > Q::Lane::ZERO);
        frame.apart | edges | plane != 0
    }
}
