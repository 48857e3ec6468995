//! Scalars of any bits. proptest draws the bits and not the scalars: so it is compiled once.

use fixed::types::{I1F15, I4F4, I16F0, I33F31};
use proptest::num;
use proptest::strategy::{BoxedStrategy, Strategy};
use septum_kit::Sample;

pub(crate) trait AnyBits: Sample {
    /// The bits of finite numbers.
    fn any_bits() -> BoxedStrategy<i64>;

    /// The number of these bits.
    fn of_bits(bits: i64) -> Self;
}

macro_rules! any_bits {
    ($($scalar:ident: $bits:ident, $any:expr;)*) => {$(
        impl AnyBits for $scalar {
            fn any_bits() -> BoxedStrategy<i64> {
                $any.boxed()
            }

            fn of_bits(bits: i64) -> Self {
                Self::from_bits(bits as $bits)
            }
        }
    )*};
}
any_bits! {
    f32: u32, num::f32::ANY.prop_filter("finite", |x| x.is_finite()).prop_map(|x| x.to_bits().into());
    f64: u64, num::f64::ANY.prop_filter("finite", |x| x.is_finite()).prop_map(|x| x.to_bits() as i64);
    I4F4: i8, num::i8::ANY.prop_map(i64::from);
    I1F15: i16, num::i16::ANY.prop_map(i64::from);
    I16F0: i16, num::i16::ANY.prop_map(i64::from);
    I33F31: i64, num::i64::ANY;
}
