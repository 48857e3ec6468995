//! One triangle against eight boxes at once.

use septum::lanes::Aabbs;
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;

const N: usize = 8;

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, b: &Aabbs<S, N>) -> [bool; N] {
    b.overlaps(t)
}

/// The exact test for many at once, in one scalar.
pub fn lanes<S: Scalar>(by_corners: &Course<Triangle<S>, Aabb<S>>) -> Vec<Candidate> {
    let block = |boxes: &[Aabb<S>; N]| Aabbs::new(boxes).expect("made of corners");
    let many =
        by_corners.prepared("corners, 8 at once", |p| p.blocks().map(Triangle::clone, block));
    vec![many.candidate("exact", Promise::Exact, exact)]
}

impl Answer for [bool; N] {
    fn count(&self) -> usize {
        self.iter().map(|met| usize::from(*met)).sum()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.extend(self);
    }
}
