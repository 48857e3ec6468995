//! Facts about the machine. None changes an answer.

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
