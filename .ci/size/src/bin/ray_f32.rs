//! One exact ray query in f32, by the rule that counts a crossing once.

#![no_std]
#![no_main]

use septum::{Hit, Ray, Triangle};
use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(ray: &Ray<f32>, triangle: &Triangle<f32>) -> Option<Hit<f32>> {
    ray.hit_once(triangle)
}
