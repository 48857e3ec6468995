//! Messages about a failed case.

use std::fmt::Debug;

use septum_kit::Sample;

/// The scalar and the case, with all digits, so that the message can be copied into a test. Floats
/// print as many digits as they need; fixed point needs a precision.
pub(crate) fn told<S: Sample>(case: &impl Debug) -> String {
    if is_float::<S>() {
        format!("{}: {case:?}", S::name())
    } else {
        format!("{}: {case:.20?}", S::name())
    }
}

/// Whether the scalar is a float.
pub(crate) fn is_float<S: Sample>() -> bool {
    // In fixed point all numbers have one exponent.
    S::GREATEST.mantissa_exponent().1 != S::ZERO.mantissa_exponent().1
}
