//! Without the feature `native` there are none.

use septum::mesh::Tree;
use septum::{Obb, Ray, Triangle};

use super::Balls;
use crate::candidate::{Candidate, Course};
use crate::contact::Sunk;
use crate::sweep::Shot;

pub(crate) fn boxes(_: &Course<Obb<f32>, Obb<f32>>) -> Vec<Candidate> {
    Vec::new()
}

pub(crate) fn contacts(_: &Course<Sunk<Obb<f32>>, ()>) -> Vec<Candidate> {
    Vec::new()
}

pub(crate) fn rays(_: &Course<Ray<f32>, Triangle<f32>>) -> Vec<Candidate> {
    Vec::new()
}

pub(crate) fn trees(_: &Course<Ray<f32>, Tree<'static, f32, u32>>) -> Vec<Candidate> {
    Vec::new()
}

pub fn balls(_: &[Shot]) -> Vec<Balls> {
    Vec::new()
}
