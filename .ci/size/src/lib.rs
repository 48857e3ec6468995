//! The panic handler that a linked program must have. The linker drops it from
//! one that cannot panic.

#![no_std]

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
