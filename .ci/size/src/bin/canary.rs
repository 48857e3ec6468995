//! What must not be found in the other programs: a panic, soft floats, and 64-bit
//! division. If the check does not find them here, the check is broken.

#![no_std]
#![no_main]

use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start(numbers: &[f64], i: usize, j: u64) -> f64 {
    numbers[i] * numbers[i + 1] + (i as u64 / j) as f64
}
