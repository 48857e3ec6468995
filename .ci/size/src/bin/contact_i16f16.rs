//! One contact of a triangle and a box in I16F16.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::contact::{Contact, contact};
use septum::{Aabb, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(triangle: &Triangle<I16F16>, aabb: &Aabb<I16F16>) -> Option<Contact<I16F16>> {
    contact(triangle, aabb)
}
