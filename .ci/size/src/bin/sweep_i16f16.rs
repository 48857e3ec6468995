//! One sweep of a triangle past a box in I16F16: whether, and when.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::sweep::{FirstContact, Motion, Sweep};
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    triangle: &Triangle<I16F16>,
    motion: &Motion<I16F16>,
    aabb: &Aabb<I16F16>,
) -> Option<FirstContact<I16F16>> {
    triangle.first_contact(motion, aabb)
}
