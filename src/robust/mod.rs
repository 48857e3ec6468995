//! What makes the answers right: bounds with their derivations, the exact
//! stage, and the normal that is nearly nought.

mod bounds;
mod exact;
mod near_zero_normal;

pub(crate) use bounds::bounds;
pub(crate) use exact::{ExactBox, ExactTriangle};
