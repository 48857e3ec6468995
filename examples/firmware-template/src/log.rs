//! Lines of text: by semihosting, or with the feature `defmt` by RTT.
//!
//! Semihosting is for QEMU and debuggers. Without a debugger its first line stops the chip.

#[cfg(feature = "defmt")]
use defmt_rtt as _;

/// Logs a line. Its format string means the same to both loggers.
#[cfg(not(feature = "defmt"))]
macro_rules! say {
    ($($log:tt)*) => { $crate::log::write(format_args!($($log)*)) };
}
#[cfg(feature = "defmt")]
macro_rules! say {
    ($($log:tt)*) => { defmt::info!($($log)*) };
}
pub(crate) use say;

/// In place of `semihosting::println!`, which links panics.
#[cfg(not(feature = "defmt"))]
pub(crate) fn write(line: core::fmt::Arguments<'_>) {
    use core::fmt::{Result, Write};
    struct Console;

    impl Write for Console {
        fn write_str(&mut self, text: &str) -> Result {
            text.bytes().for_each(semihosting::sys::arm_compat::sys_writec);
            Ok(())
        }
    }
    let _ = writeln!(Console, "{line}");
}

/// Ends the program in QEMU; a chip waits.
pub(crate) fn end() -> ! {
    #[cfg(not(feature = "defmt"))]
    semihosting::process::exit(0);
    #[cfg(feature = "defmt")]
    loop {
        cortex_m::asm::wfi();
    }
}
