//! What is known of the machine, in two constants. Neither changes an answer.

/// Whether code is dearer than time, for those who asked for it: a cascade then has
/// its first stage and its last.
pub(crate) const SMALL_CODE: bool = cfg!(feature = "small");

/// Whether registers hold 64 bits. Then small coordinates have a kernel of their
/// own; elsewhere code is dearer than time, and one kernel chooses the width of
/// its volumes. `--cfg septum_narrow` tests the other one on a wide machine.
pub(crate) const REGISTERS_ARE_WIDE: bool =
    cfg!(all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)))
        && !SMALL_CODE;
