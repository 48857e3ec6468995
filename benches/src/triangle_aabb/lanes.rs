//! One triangle against eight boxes at once, and one box against eight triangles.

use septum::lanes::{Aabbs, CellTriangle, Cells, Triangles};
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;

const N: usize = 8;

#[inline(never)]
fn exact<S: Scalar>(t: &Triangle<S>, b: &Aabbs<S, N>) -> [bool; N] {
    b.overlaps(t)
}

#[inline(never)]
fn triangles<S: Scalar>(b: &Aabb<S>, t: &Triangles<S, N>) -> [bool; N] {
    t.overlaps(b)
}

/// The exact test of a box for many triangles at once, in one scalar.
pub fn lanes_of_triangles<S: Scalar>(course: &Course<Triangle<S>, Aabb<S>>) -> Vec<Candidate> {
    let many = course
        .prepared("triangles, 8 at once", |p| p.turned().blocks().map(Aabb::clone, Triangles::new));
    vec![many.candidate("exact", Promise::Exact, triangles)]
}

#[inline(never)]
fn of_one_size<S: Scalar, const M: usize>(t: &Triangle<S>, b: &Cells<S, M>) -> [bool; M] {
    b.overlaps(t)
}

#[inline(never)]
fn prepared<S: Scalar, const M: usize>(t: &CellTriangle<S>, b: &Cells<S, M>) -> [bool; M] {
    t.overlaps(b)
}

/// The exact test for many boxes at once, in one scalar.
pub fn lanes<S: Scalar>(
    by_corners: &Course<Triangle<S>, Aabb<S>>,
    by_center: &Course<Triangle<S>, Aabb<S>>,
) -> Vec<Candidate> {
    let block = |boxes: &[Aabb<S>; N]| Aabbs::new(boxes).expect("made of corners");
    let many =
        by_corners.prepared("corners, 8 at once", |p| p.blocks().map(Triangle::clone, block));
    let mut all = vec![many.candidate("exact", Promise::Exact, exact)];
    all.extend(cells::<S, N>("one size, 8 at once", by_center));
    all.extend(cells::<S, 32>("one size, 32 at once", by_center));
    all
}

fn cells<S: Scalar, const M: usize>(
    form: &'static str,
    course: &Course<Triangle<S>, Aabb<S>>,
) -> [Candidate; 2] {
    let cells = |boxes: &[Aabb<S>; M]| Cells::new(boxes).expect("cubes of one size");
    let equal = course.prepared(form, |p| p.blocks().map(Triangle::clone, cells));
    let ready = course.prepared(form, |p| {
        p.blocks().map(Triangle::clone, cells).map_with_first(CellTriangle::new)
    });
    [
        equal.candidate("exact", Promise::Exact, of_one_size),
        ready.candidate("exact, prepared", Promise::Exact, prepared),
    ]
}

impl<const M: usize> Answer for [bool; M] {
    fn count(&self) -> usize {
        self.iter().map(|met| usize::from(*met)).sum()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.extend(self);
    }
}
