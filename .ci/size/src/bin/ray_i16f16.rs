//! One exact ray query in I16F16, by the rule that counts a crossing once.

#![no_std]
#![no_main]

use fixed::types::I16F16;
use septum::{Hit, Ray, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(ray: &Ray<I16F16>, triangle: &Triangle<I16F16>) -> Option<Hit<I16F16>> {
    ray.hit_once(triangle)
}
