//! Nothing, to measure the others against.

#![no_std]
#![no_main]

use septum_size as _;

#[unsafe(no_mangle)]
pub fn _start() {}
