//! A program that prints lines of text, on any machine.

use heapless::String;

/// A line of text, and whether the result in it is right.
pub(crate) type Line = (String<120>, bool);

/// `main`, or the entry point of the machine. It prints the lines 0 to `$lines` − 1,
/// which `$line` writes, and fails if a result is wrong.
macro_rules! program {
    ($lines:expr, $line:path) => {
        #[cfg(not(any(target_os = "none", target_family = "wasm")))]
        fn main() -> std::process::ExitCode {
            let mut all = true;
            for k in 0..$lines {
                let (text, well) = $line(k);
                println!("{text}");
                all &= well;
            }
            if all { std::process::ExitCode::SUCCESS } else { std::process::ExitCode::FAILURE }
        }

        #[cfg(target_os = "none")]
        mod firmware {
            use super::*;

            #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
            #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
            fn main() -> ! {
                let mut all = true;
                for k in 0..$lines {
                    let (text, well) = $line(k);
                    semihosting::println!("{text}");
                    all &= well;
                }
                semihosting::process::exit(if all { 0 } else { 1 })
            }

            #[panic_handler]
            fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
                semihosting::println!("{info}");
                semihosting::process::exit(101)
            }
        }

        /// The exports that `node.mjs` calls.
        #[cfg(target_family = "wasm")]
        #[allow(unsafe_code, reason = "exports")]
        mod module {
            use core::sync::atomic::{AtomicU8, Ordering};

            use super::*;

            static TEXT: [AtomicU8; 120] = [const { AtomicU8::new(0) }; 120];

            #[unsafe(export_name = "lines")]
            extern "C" fn export_lines() -> usize {
                $lines
            }

            /// Writes line `k`, and returns its length.
            #[unsafe(export_name = "line")]
            extern "C" fn export_line(k: usize) -> usize {
                let (text, _) = $line(k);
                for (to, byte) in TEXT.iter().zip(text.bytes()) {
                    to.store(byte, Ordering::Relaxed);
                }
                text.len()
            }

            #[unsafe(export_name = "buffer")]
            extern "C" fn export_buffer() -> *const AtomicU8 {
                TEXT.as_ptr()
            }

            #[panic_handler]
            fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
                core::arch::wasm32::unreachable()
            }
        }
    };
}
pub(crate) use program;
