//! One triangle against eight boxes at once.

use septum::lanes::{Aabbs, Cells};
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;

const N: usize = 8;

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, b: &Aabbs<S, N>) -> [bool; N] {
    b.overlaps(t)
}

#[inline(never)]
fn of_one_size<S: Scalar, const M: usize>(t: &Triangle<S>, b: &Cells<S, M>) -> [bool; M] {
    b.overlaps(t)
}

/// The exact test for many at once, in one scalar.
pub fn lanes<S: Scalar>(
    by_corners: &Course<Triangle<S>, Aabb<S>>,
    by_center: &Course<Triangle<S>, Aabb<S>>,
) -> Vec<Candidate> {
    let block = |boxes: &[Aabb<S>; N]| Aabbs::new(boxes).expect("made of corners");
    let many =
        by_corners.prepared("corners, 8 at once", |p| p.blocks().map(Triangle::clone, block));
    vec![
        many.candidate("exact", Promise::Exact, exact),
        cells::<S, N>("one size, 8 at once", by_center),
        cells::<S, 32>("one size, 32 at once", by_center),
    ]
}

fn cells<S: Scalar, const M: usize>(
    form: &'static str,
    course: &Course<Triangle<S>, Aabb<S>>,
) -> Candidate {
    let cells = |boxes: &[Aabb<S>; M]| Cells::new(boxes).expect("cubes of one size");
    let equal = course.prepared(form, |p| p.blocks().map(Triangle::clone, cells));
    equal.candidate("exact", Promise::Exact, of_one_size)
}

impl<const M: usize> Answer for [bool; M] {
    fn count(&self) -> usize {
        self.iter().map(|met| usize::from(*met)).sum()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.extend(self);
    }
}
