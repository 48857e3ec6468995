//! The number systems that kernels run in. Nothing here knows a shape or a query.

mod big_int;
mod circle;
mod double;
mod enclosed;
mod ends;
mod filtered;
#[cfg(feature = "fixed")]
mod fixed;
mod float;
mod full;
mod index;
mod integer;
mod interval;
mod limbs;
mod multiples;
mod number;
mod offset;
mod parts;
mod platform;
mod portion;
mod quad;
#[cfg(feature = "fixed")]
mod quotient;
#[cfg(feature = "fixed")]
mod root;
mod rounded;
mod short_multiples;
mod soft;
mod span;
mod system;
mod wide;
mod window;
mod words;

pub use big_int::BigInt;
pub(crate) use circle::cos_sin_f64;
#[cfg(feature = "fixed")]
pub(crate) use circle::{cos_sin_30, cos_sin_62};
pub(crate) use double::{Double, fast_two_sum, two_difference};
pub use enclosed::Enclosed;
pub(crate) use enclosed::{compare_products, order_of_products, sign_of, sum_of};
pub(crate) use ends::{enclosed, lost_in_row};
pub use filtered::Filtered;
pub use float::Float;
pub(crate) use float::{
    FirstFloat, InFloat, cut, cut_to_words, fraction_bits, is_whole, quotient, three_in_float,
};
pub use full::{FullF32, FullF64};
pub(crate) use index::{Each, cross3, dot3, minus3, pick, three, turn, two};
#[cfg(feature = "fixed")]
pub(crate) use integer::{Int8, Int32, Int64, IntNear};
pub(crate) use integer::{Int16, Int64Narrow, Int64OfFloats, of_four};
pub use interval::Interval;
pub(crate) use limbs::product;
#[cfg(feature = "fixed")]
pub(crate) use limbs::{Limbs, Wide};
pub use number::{Limbed, Number};
pub(crate) use number::{compare, greatest, largest, least, sign};
pub(crate) use offset::Offset;
pub use parts::Parts;
pub(crate) use parts::{Bits, exp2, exponent, is_zero, multiple, raised, short_product};
pub(crate) use platform::{
    REGISTERS_ARE_WIDE, SMALL_CODE, cuts_floats, is_software, out_of_line, out_of_line_if_wide,
    part,
};
pub(crate) use quad::{OfFour, Quad, THREE, root_of_machine};
#[cfg(feature = "fixed")]
pub(crate) use quotient::quotient_of_sums;
#[cfg(feature = "fixed")]
pub use root::Signed;
#[cfg(feature = "fixed")]
pub(crate) use root::over_roots;
pub(crate) use rounded::{Rounded, RoundedOps};
pub use short_multiples::ShortFloat;
pub(crate) use short_multiples::{Divisor, Leading64};
pub use soft::Soft;
pub(crate) use soft::{root, whole};
pub(crate) use span::{Span, Spanned, Spans};
pub use system::{Arithmetic, Embeds, OneType};
pub(crate) use system::{cross, dot, following, of_two, once};
pub(crate) use wide::I256;
#[cfg(feature = "fixed")]
pub use window::ShortWindow;
pub use window::Window;
pub use words::{InRaw, ProductSum, Raw, WholeVolume, WholeWord, Word};
pub(crate) use words::{cross_words, dot_words, first_sign};

#[cfg(test)]
pub(crate) use words::SplitSum;
