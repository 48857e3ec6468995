//! Machine words, for kernels on cores whose registers have 32 bits.

mod machine;
mod places;
mod product_sum;
mod word;

pub use places::WholeVolume;
pub use product_sum::ProductSum;
pub(crate) use product_sum::{SplitSum, cross_words, dot_words, first_sign};
pub use word::{InRaw, InWholeWord, InWord, Raw, WholeWord, Word};
pub(crate) use word::{out_of_line, out_of_line_if_wide, part};
