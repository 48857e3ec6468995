//! What must not be found in the other programs: a panic, and soft floats. If
//! the check finds neither here, the check is broken.

#![no_std]
#![no_main]

use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(numbers: &[f32], i: usize) -> f32 {
    numbers[i] * numbers[i + 1]
}
