//! Methods as published, and others in the scalar's own arithmetic: fast, rounded, and
//! sometimes wrong.
//!
//! They are yardsticks: for speed, and for what rounding does. Some also serve those who
//! only draw. Each module names its source, its cost, and what measures better. The exact
//! queries are methods of the shapes: [`Triangle::overlaps`](crate::Triangle::overlaps),
//! [`Ray::hit`](crate::Ray::hit). One method here never loses a box:
//! [`slabs::SlabRay::may_overlap`]. To walk a tree see [`prepared`](crate::prepared).
//!
//! Nothing here panics. In fixed point, products lose their last bits and sums wrap beyond
//! the range; the exact queries do neither.
//!
//! | module | question | choose it |
//! | --- | --- | --- |
//! | [`akenine_moller`] | triangle, box | for comparison |
//! | [`shared_normal`] | triangle, box | to draw, in floats |
//! | [`green_hatch`] | polygon, box | for comparison |
//! | [`separating_axes`] | segment or ray, box | for comparison |
//! | [`slabs`] | ray, many boxes | to draw; [`may_overlap`](slabs::SlabRay::may_overlap) loses no box, [`PreparedRay`](crate::prepared::PreparedRay) is exact |
//! | [`slopes`] | ray, many boxes | for comparison: slabs measure better |
//! | [`moller_trumbore`] | ray, triangle | to draw triangles that are met once |
//! | [`stored_normal`] | ray, triangle | for comparison; for t alone |
//! | [`projected`] | ray, triangle | in fixed point, to draw; in floats others measure better |
//! | [`volumes`] | ray, triangle | many rays at once; one by one others measure better |
//! | [`watertight`] | ray, triangle | eight triangles at once, without leaks; one by one the exact [`Ray::hit`](crate::Ray::hit) is faster |

pub mod akenine_moller;
mod degenerate_view;
pub mod green_hatch;
pub mod moller_trumbore;
pub mod projected;
mod resolve;
pub mod separating_axes;
pub mod shared_normal;
pub mod slabs;
pub mod slopes;
pub mod stored_normal;
mod vector;
pub mod volumes;
pub mod watertight;

pub(crate) use resolve::{Limits, resolve};
pub(crate) use vector::{Triple, rounded};
