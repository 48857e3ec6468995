//! Machine words, for kernels on cores whose registers have 32 bits.

mod machine;
mod places;
mod product_sum;
mod raw;
mod split_sum;
mod word;

pub use places::WholeVolume;
pub use product_sum::ProductSum;
pub(crate) use product_sum::{cross_words, dot_words, first_sign};
pub use raw::{InRaw, Raw};
pub(crate) use split_sum::SplitSum;
pub use word::{InWholeWord, InWord, WholeWord, Word};
pub(crate) use word::{out_of_line, out_of_line_if_wide, part};
