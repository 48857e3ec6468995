//! Where a box can stop at the latest before a triangle, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::{Moving, Near};
use septum::{Aabb, Triangle, Vec3};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    aabb: &Moving<Aabb<I16F16>, I16F16>,
    triangle: &Near<Triangle<I16F16>>,
) -> Option<Vec3<I16F16>> {
    aabb.last_free(triangle)
}
