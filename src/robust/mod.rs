//! What makes the answers right: bounds with their derivations, the exact
//! stage, and the normal that is nearly nought.

mod bounds;
mod exact;
mod exact_skewed;
mod near_zero_normal;

pub(crate) use bounds::{PLANE, SKEWED, bounds};
pub(crate) use exact::{ExactBox, ExactTriangle};
pub(crate) use exact_skewed::ExactSkewed;
