//! One ray against eight triangles at once, in the scenes with many triangles for each ray.

use septum::lanes::{Hits, NormalTriangles, Triangles};
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Cull, Ray, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;

const N: usize = 8;

#[inline(never)]
fn moller_trumbore<S: Scalar>(r: &Ray<S>, t: &Triangles<S, N>) -> Hits<S, N> {
    t.hit_moller_trumbore(r, Cull::Nothing)
}

#[inline(never)]
fn stored_normal<S: Scalar>(r: &Ray<S>, t: &NormalTriangles<S, N>) -> Hits<S, N> {
    t.hit(r, Cull::Nothing)
}

#[inline(never)]
fn volumes<S: Scalar>(r: &Ray<S>, t: &Triangles<S, N>) -> Hits<S, N> {
    t.hit_volumes(r, Cull::Nothing)
}

#[inline(never)]
fn watertight<S: Scalar>(r: &ShearedRay<S>, t: &Triangles<S, N>) -> Hits<S, N> {
    t.hit_watertight(r, Cull::Nothing)
}

#[inline(never)]
fn exact<S: Scalar>(r: &Ray<S>, t: &Triangles<S, N>) -> Hits<S, N> {
    t.hit(r)
}

/// The methods for many triangles at once, in one scalar.
pub fn lanes<S: Scalar>(course: &Course<Ray<S>, Triangle<S>>) -> Vec<Candidate> {
    let plain = course.prepared("8 at once", |p| p.blocks().map(Ray::clone, Triangles::new));
    let sheared = course
        .prepared("8 at once, ray prepared", |p| p.blocks().map(ShearedRay::new, Triangles::new));
    let with_normals =
        |block: &[Triangle<S>; N]| NormalTriangles::new(&block.map(|t| NormalTriangle::new(&t)));
    let normals =
        course.prepared("8 at once, prepared", |p| p.blocks().map(Ray::clone, with_normals));
    let none = Promise::Nothing;
    vec![
        plain.candidate("exact", Promise::Exact, exact),
        plain.candidate("Möller–Trumbore", none, moller_trumbore),
        normals.candidate("stored normal", none, stored_normal),
        plain.candidate("volumes", none, volumes),
        sheared.candidate("watertight (Woop)", none, watertight),
    ]
}

impl<S: Scalar> Answer for Hits<S, N> {
    fn count(&self) -> usize {
        self.mask.iter().map(|m| usize::from(*m)).sum()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.extend(self.mask);
    }
}
