//! Whether a triangle and a box touch or overlap: the 13 axes again, to find the axes on which they
//! only touch.

use super::Disjoint;
use super::error_bound::error_bound;
use super::frame::{Frame, range};
use super::kernel::{in_frame_of_center, in_frame_of_corners, normal};
use crate::arithmetic::{Arithmetic, Embeds, Number, dot, greatest, of_two};
use crate::query::relation::{Nearness, Relate, Relation};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// Do shapes that are not disjoint only touch?
struct Lie<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Lie<'_, S> {
    type Answer = Relation;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        if !self.0.is_held::<N>() {
            return None;
        }
        let triangle = self.0.triangle;
        let frame = match self.0.aabb.form() {
            AabbForm::Center { center, half } => in_frame_of_center::<S, N>(triangle, center, half),
            AabbForm::Corners { min, max } => {
                in_frame_of_corners::<S, N>(triangle, min, max, &Vec3::splat(S::ZERO))
            }
        };
        all_axes(&frame)
    }
}

#[inline(never)]
fn all_axes<N: Arithmetic>(frame: &Frame<N>) -> Option<Relation> {
    let bound = error_bound::<N>(frame.size_across_gap())?;
    let mut found = Nearness::NONE;
    let n = normal(frame);
    for i in 0..3 {
        let h = frame.h[i];
        if N::CERTAIN {
            let (low, high) = range(&frame.v, i);
            found.add(greatest(low, -high) - h, (high - low) + h, N::Length::ZERO);
        } else {
            // The sign of a gap is right unless it is zero.
            found.add_known(false, frame.gaps[i] >= N::Length::ZERO);
        }

        // See `kernel::edges`.
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let middle = of_two::<N, _>(n[i]);
        for k in 0..3 {
            let (e, v) = (&frame.e[k], &frame.v[k]);
            let p = N::area(e[j], v[l]) - N::area(e[l], v[j]);
            let r = N::area(e[l].magnitude(), frame.h[j]) + N::area(e[j].magnitude(), frame.h[l]);
            let reach = middle.magnitude() + r;
            // An edge along the axis gives no axis.
            if e[j] != N::Length::ZERO || e[l] != N::Length::ZERO {
                found.add((p + middle).magnitude() - reach, reach, bound.edge);
            }
        }
    }

    // See `kernel::plane`.
    let distance = dot::<N>(&n, &frame.v[0]);
    let reach = dot::<N>(&n.map(N::Area::magnitude), &frame.h);
    // A box that is a point in the triangle's plane has no reach off it.
    found.add(distance.magnitude() - reach, reach, bound.plane);
    found.relation(N::CERTAIN)
}

impl<S: Scalar> Relate<Aabb<S>> for Triangle<S> {
    fn relation(&self, aabb: &Aabb<S>) -> Relation {
        if self.overlaps(aabb) {
            S::evaluate(&Lie(Disjoint { triangle: self, aabb }))
        } else {
            Relation::Disjoint
        }
    }
}
