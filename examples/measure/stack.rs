//! Measures the depth of the stack, by painting it.

/// The lowest byte of the stack that `run` writes to.
#[cfg(target_os = "none")]
pub(crate) fn lowest(run: &mut dyn FnMut()) -> usize {
    painted::lowest(run)
}

/// A host's stack is not measured.
#[cfg(not(target_os = "none"))]
pub(crate) fn lowest(run: &mut dyn FnMut()) -> usize {
    run();
    0
}

#[cfg(target_os = "none")]
#[allow(unsafe_code, reason = "writes to the stack that is not in use yet, and reads it")]
mod painted {
    use core::arch::asm;
    use core::hint::black_box;
    use core::mem::MaybeUninit;

    const PAINT: u32 = 0x5e97_0a11;
    /// The number of painted bytes.
    const DEPTH: usize = 16 << 10;
    /// The bytes of stack that `paint` and `find` may take themselves. `from_below` leaves as many
    /// unused.
    const OWN: usize = 256;

    pub(super) fn lowest(run: &mut dyn FnMut()) -> usize {
        // An interrupt would leave its frame on the stack.
        #[cfg(target_arch = "arm")]
        cortex_m::interrupt::disable();
        let bottom = paint();
        from_below(run);
        let lowest = find(bottom);
        // SAFETY: nothing relies on a critical section here.
        #[cfg(target_arch = "arm")]
        unsafe {
            cortex_m::interrupt::enable();
        }
        lowest
    }

    /// Runs a function below the unpainted part of the stack.
    #[inline(never)]
    fn from_below(run: &mut dyn FnMut()) {
        let mut unused = MaybeUninit::<[u8; OWN]>::uninit();
        black_box(&mut unused);
        run();
        black_box(&mut unused);
    }

    /// Paints the stack, and returns the lowest painted address. It is not inlined, and
    /// leaves a gap below the stack pointer: this function may save registers there
    /// after it has read the pointer.
    #[inline(never)]
    fn paint() -> usize {
        let pointer: usize;
        // SAFETY: reads a register.
        unsafe {
            #[cfg(target_arch = "arm")]
            asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
            #[cfg(target_arch = "riscv32")]
            asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags));
        }
        let top = (pointer - OWN / 2) & !7;
        let bottom = top - DEPTH;
        for address in (bottom..top).step_by(4) {
            // SAFETY: memory of the stack, below all that is in use.
            unsafe { (address as *mut u32).write_volatile(PAINT) }
        }
        bottom
    }

    /// The lowest word that is no longer painted.
    #[inline(never)]
    fn find(bottom: usize) -> usize {
        let mut address = bottom;
        // SAFETY: memory of the stack; it ends where something is in use.
        while unsafe { (address as *const u32).read_volatile() } == PAINT {
            address += 4;
        }
        address
    }
}
