//! Machine words, for kernels on cores whose registers have 32 bits.

mod machine;
#[cfg(feature = "fixed")]
mod places;
mod product_sum;
#[cfg(feature = "fixed")]
mod raw;
mod split_sum;
mod vector;
mod word;

#[cfg(feature = "fixed")]
pub use places::WholeVolume;
// Floats take no quotients in words.
#[cfg(not(feature = "fixed"))]
use super::number::Number as WholeVolume;
pub use product_sum::ProductSum;
#[cfg(feature = "fixed")]
pub use raw::{InRaw, Raw};
pub(crate) use split_sum::SplitSum;
pub(crate) use vector::{cross_words, dot_words, first_sign};
pub use word::{InWholeWord, InWord, WholeWord, Word};
pub(crate) use word::{out_of_line, out_of_line_if_wide};
