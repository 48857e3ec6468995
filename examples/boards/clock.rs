//! Instructions, counted by the emulated board's own timer.
//!
//! QEMU gives each instruction the same time (`-icount`), so that a timer counts
//! instructions. They are not cycles.

#[cfg(target_arch = "arm")]
pub(crate) use arm::Clock;

#[cfg(target_arch = "arm")]
mod arm {
    use core::sync::atomic::{AtomicU32, Ordering};

    use cortex_m::Peripherals;
    use cortex_m::peripheral::SYST;
    use cortex_m::peripheral::syst::SystClkSource;

    /// How often the timer, which has 24 bits, has wrapped around.
    static ROUNDS: AtomicU32 = AtomicU32::new(0);

    #[cortex_m_rt::exception]
    fn SysTick() {
        // A Cortex-M0 has no fetch_add. Nothing else writes this number.
        ROUNDS.store(ROUNDS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
    }

    /// The timer, and how many ticks a known number of instructions takes.
    pub(crate) struct Clock {
        ticks: u64,
        instructions: u64,
    }

    impl Clock {
        /// Takes the timer. There is only one.
        pub(crate) fn new() -> Option<Self> {
            let mut timer = Peripherals::take()?.SYST;
            timer.set_clock_source(SystClkSource::Core);
            timer.set_reload(0x00ff_ffff);
            timer.clear_current();
            timer.enable_interrupt();
            timer.enable_counter();
            const LOOPS: u32 = 500_000;
            let start = now();
            spin(LOOPS);
            Some(Self { ticks: now() - start, instructions: 2 * u64::from(LOOPS) })
        }

        /// How many instructions `work` takes.
        pub(crate) fn count<T>(&self, work: impl FnOnce() -> T) -> (T, Option<u64>) {
            let start = now();
            let result = work();
            let ticks = now() - start;
            (result, (ticks * self.instructions).checked_div(self.ticks))
        }
    }

    /// Takes two instructions for each loop.
    #[allow(unsafe_code, reason = "assembly, for a library's loop may change")]
    #[inline(never)]
    fn spin(loops: u32) {
        // SAFETY: touches nothing but its register and the flags.
        unsafe {
            core::arch::asm!("2:", "subs {}, #1", "bne 2b", inout(reg) loops => _,
                options(nomem, nostack));
        }
    }

    /// Ticks since the beginning. The timer itself counts down.
    fn now() -> u64 {
        loop {
            let rounds = ROUNDS.load(Ordering::Relaxed);
            let left = SYST::get_current();
            if rounds == ROUNDS.load(Ordering::Relaxed) {
                return (u64::from(rounds) << 24) + u64::from(0x00ff_ffff - left);
            }
        }
    }
}

/// The core's own count of instructions.
#[cfg(target_arch = "riscv32")]
pub(crate) struct Clock;

#[cfg(target_arch = "riscv32")]
impl Clock {
    pub(crate) fn new() -> Option<Self> {
        Some(Self)
    }

    /// How many instructions `work` takes.
    pub(crate) fn count<T>(&self, work: impl FnOnce() -> T) -> (T, Option<u64>) {
        let start = riscv::register::minstret::read64();
        let result = work();
        (result, Some(riscv::register::minstret::read64() - start))
    }
}

/// A host counts no instructions. If an emulator counts them from outside, the variable
/// `COUNTED_OUTSIDE` says so, and the count here is zero.
#[cfg(not(target_os = "none"))]
pub(crate) struct Clock {
    counted: Option<u64>,
}

#[cfg(not(target_os = "none"))]
impl Clock {
    pub(crate) fn new() -> Option<Self> {
        Some(Self { counted: std::env::var_os("COUNTED_OUTSIDE").map(|_| 0) })
    }

    /// Does `work`, and counts nothing.
    pub(crate) fn count<T>(&self, work: impl FnOnce() -> T) -> (T, Option<u64>) {
        (work(), self.counted)
    }
}
