//! The point of a triangle closest to a point, in I16F16.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Closest, Triangle, Vec3};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(point: &Vec3<I16F16>, triangle: &Triangle<I16F16>) -> Option<Closest<I16F16>> {
    triangle.closest_point(*point).ok()
}
