//! What makes the answers right: bounds with their derivations, the exact
//! stage, and the normal that is nearly nought.

mod bounds;
mod exact;
mod exact_line;
mod exact_ray;
mod exact_skewed;
mod near_zero_normal;

pub(crate) use bounds::{PLANE, RAY, RAY_SIDES, SKEWED, bounds};
pub(crate) use exact::{ExactBox, ExactTriangle};
pub(crate) use exact_line::ExactLine;
pub(crate) use exact_ray::ExactRay;
pub(crate) use exact_skewed::ExactSkewed;
