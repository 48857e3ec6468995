//! A tree over boxes that move.

// First, so that constructors come first on the page of `BoxTree`.
mod tree;

mod moving;
mod overlapping;
mod pairs;

pub use overlapping::BoxProbe;
pub use tree::BoxTree;
