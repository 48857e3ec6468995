//! When a box first meets a triangle on its way, in I16F16 near the origin.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::near::{Moving, Near};
use septum::sweep::FirstContact;
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(
    aabb: &Moving<Aabb<I16F16>, I16F16>,
    triangle: &Near<Triangle<I16F16>>,
) -> Option<FirstContact<I16F16>> {
    aabb.first_contact(triangle)
}
