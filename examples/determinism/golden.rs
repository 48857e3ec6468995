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
    f32 = 0x702d_de09_996f_b92b;
    f64 = 0xded3_e51a_ded3_bc7d;
    I4F4 = 0xfc40_47c2_def8_c4fb;
    I8F8 = 0x267f_3fc2_d96b_ae78;
    I16F16 = 0xb785_b54b_1bd5_a4e2;
    I32F32 = 0x87df_4867_50da_93f1;
};
