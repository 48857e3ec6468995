//! Facts about the machine. None changes an answer.

/// Whether small code is more important than speed, by the caller's choice. A cascade then has only
/// its first stage and its last.
pub(crate) const SMALL_CODE: bool = cfg!(feature = "small");

/// Whether registers hold 64 bits. Then small coordinates have a kernel of their own. Elsewhere
/// small code is more important than speed, and one kernel chooses the width of its volumes. `--cfg
/// septum_narrow` tests that kernel on a wide machine.
pub(crate) const REGISTERS_ARE_WIDE: bool =
    cfg!(all(any(target_pointer_width = "64", target_arch = "wasm32"), not(septum_narrow)))
        && !SMALL_CODE;

/// Whether floats of this type are computed by functions.
pub(crate) const fn is_software<F>() -> bool {
    let has_floats = cfg!(target_abi = "eabihf");
    !REGISTERS_ARE_WIDE && (!has_floats || size_of::<F>() == size_of::<f64>())
}
