//! Facts about the machine, and calls in place of copies of code. None changes an answer.

/// Whether small code is more important than speed, by the caller's choice. A cascade then has only
/// its first stage and its last.
pub(crate) const SMALL_CODE: bool = cfg!(feature = "small");

/// The slack of a [`Soft`](super::Soft). A short one lets intervals of floats settle fewer questions, but
/// where registers are narrow a second word in each number costs more.
#[cfg(all(
    any(target_pointer_width = "64", target_arch = "wasm32"),
    not(any(septum_narrow, feature = "small"))
))]
pub(crate) type Slack = u64;
#[cfg(not(all(
    any(target_pointer_width = "64", target_arch = "wasm32"),
    not(any(septum_narrow, feature = "small"))
)))]
pub(crate) type Slack = u32;

/// Whether registers hold 64 bits. Then small coordinates have a kernel of their own. Elsewhere
/// small code is more important than speed, and one kernel chooses the width of its volumes. `--cfg
/// septum_narrow` tests that kernel on a wide machine.
pub(crate) const REGISTERS_ARE_WIDE: bool = Slack::BITS == 64;

/// Whether floats of this type are computed by functions.
pub(crate) const fn is_software<F>() -> bool {
    let has_floats = cfg!(target_abi = "eabihf");
    !REGISTERS_ARE_WIDE && (!has_floats || size_of::<F>() == size_of::<f64>())
}

/// Whether floats of this type are cut to words before they are computed by functions. Small code does without.
pub(crate) const fn cuts_floats<F>() -> bool {
    is_software::<F>() && !SMALL_CODE
}

/// Whether a multiplication gives the full product of two words.
///
/// ARMv6-M has neither long products nor atomics, and ARMv7-M has both; stable Rust can query only
/// atomics. RISC-V has long products if it has a multiplication. With 64-bit registers there is no
/// choice, except in tests of the other path.
pub(crate) const HAS_LONG_PRODUCTS: bool = cfg!(any(
    all(target_arch = "arm", target_has_atomic = "32"),
    all(target_arch = "riscv32", target_feature = "m"),
    all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)),
));

/// Calls `f` out of line.
#[inline(never)]
pub(crate) fn out_of_line<T>(f: impl FnOnce() -> T) -> T {
    f()
}

/// A part of a kernel. With narrow registers it is a call: most operations are calls there, and one
/// copy of each part suffices.
#[inline(always)]
pub(crate) fn part<T>(f: impl FnOnce() -> T) -> T {
    if REGISTERS_ARE_WIDE { f() } else { out_of_line(f) }
}

/// The expression, and in wide words a call of it, so that there is one copy. A closure alone does
/// not suffice: used twice, it is not inlined for narrow words either.
macro_rules! out_of_line_if_wide {
    ($word:ident, $value:expr) => {
        if $word::IS_WIDE { $crate::arithmetic::out_of_line(move || $value) } else { $value }
    };
}
pub(crate) use out_of_line_if_wide;
