//! Machine words, for kernels on cores whose registers have 32 bits.

mod machine;
mod places;
mod product_sum;
mod word;

pub use places::WholeVolume;
#[cfg(test)]
pub(crate) use product_sum::SplitSum;
pub(crate) use product_sum::{cross_words, dot_words, first_sign};
pub use word::{InRaw, ProductSum, Raw, RawOffset, WholeWord, Word};
