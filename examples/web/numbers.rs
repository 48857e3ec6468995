//! The numbers of questions and answers.
#![allow(unsafe_code, reason = "an export")]

use core::sync::atomic::{AtomicU32, Ordering};

/// The numbers of a question, as bits.
pub(crate) static NUMBERS: [AtomicU32; 15] = [const { AtomicU32::new(0) }; 15];

#[unsafe(export_name = "numbers")]
extern "C" fn numbers() -> *const AtomicU32 {
    NUMBERS.as_ptr()
}

/// Number `k`.
pub(crate) fn ask(k: usize) -> u32 {
    NUMBERS.get(k).map_or(0, |number| number.load(Ordering::Relaxed))
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
