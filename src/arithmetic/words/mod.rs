//! Machine words, for kernels on cores whose registers have 32 bits.

mod machine;
mod product_sum;
#[cfg(feature = "fixed")]
mod raw;
mod split_sum;
mod word;

pub use product_sum::ProductSum;
#[cfg(feature = "fixed")]
pub use raw::{InRaw, Raw};
pub(crate) use split_sum::SplitSum;
pub use word::{InWord, Word};
pub(crate) use word::{out_of_line, out_of_line_if_wide};
