//! A program that logs: by defmt on Arm, by semihosting on RISC-V, by `println!`
//! on a host.

/// Logs a line. Its format string must mean the same to all three loggers.
#[cfg(target_arch = "arm")]
macro_rules! say {
    ($($log:tt)*) => { defmt::info!($($log)*) };
}

#[cfg(target_arch = "riscv32")]
macro_rules! say {
    ($($log:tt)*) => { semihosting::println!($($log)*) };
}

#[cfg(not(target_os = "none"))]
macro_rules! say {
    ($($log:tt)*) => { println!($($log)*) };
}

/// `main`, or the entry point of the board. It fails if `$run` returns false.
macro_rules! program {
    ($run:path) => {
        #[cfg(not(target_os = "none"))]
        fn main() -> std::process::ExitCode {
            if $run() { std::process::ExitCode::SUCCESS } else { std::process::ExitCode::FAILURE }
        }

        #[cfg(target_os = "none")]
        mod board {
            #[cfg(target_arch = "arm")]
            use defmt_semihosting as _;

            use super::*;

            #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
            #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
            fn main() -> ! {
                semihosting::process::exit(if $run() { 0 } else { 1 })
            }

            #[panic_handler]
            fn panic(_info: &core::panic::PanicInfo<'_>) -> ! {
                #[cfg(target_arch = "arm")]
                defmt::error!("{}", defmt::Display2Format(_info));
                #[cfg(target_arch = "riscv32")]
                semihosting::println!("{_info}");
                semihosting::process::exit(101)
            }
        }
    };
}
pub(crate) use {program, say};
