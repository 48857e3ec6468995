//! The hashes, the same on every machine.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use crate::stream::{CASES, hash};

/// A scalar's name, its hash as computed here, and as it was first computed.
pub(crate) struct Golden {
    pub(crate) name: &'static str,
    pub(crate) compute: fn() -> u64,
    pub(crate) expected: u64,
}

macro_rules! golden {
    ($($scalar:ident = $expected:literal;)*) => {
        [$(Golden {
            name: stringify!($scalar),
            compute: || hash::<$scalar>(CASES),
            expected: $expected,
        }),*]
    };
}

/// A change of any of these is a change of what is promised: see DETERMINISM.md.
pub(crate) const GOLDEN: [Golden; 6] = golden! {
    f32 = 0x6cc9_b90f_afb6_a8ad;
    f64 = 0x01c9_faf1_0ac2_6bbd;
    I4F4 = 0x5b70_3894_11e1_eac7;
    I8F8 = 0x55dd_56b0_d4f5_2da1;
    I16F16 = 0x5016_831a_6115_4e36;
    I32F32 = 0xd4e9_075e_c52a_2fff;
};
