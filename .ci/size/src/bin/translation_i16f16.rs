//! The least translation of a triangle and a box in I16F16, without contact points.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::contact::{Translation, least_translation};
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<I16F16>, aabb: &Aabb<I16F16>) -> Option<Translation<I16F16>> {
    least_translation(triangle, aabb)
}
