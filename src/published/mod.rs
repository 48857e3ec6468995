//! Published methods, and others in the scalar's own arithmetic: fast, rounded, and sometimes
//! wrong.
//!
//! They are for comparison: how fast a query can be, and what rounding does to it. Some are also
//! good enough for drawing. Each module names its source, its cost, and the method that measures
//! better. The exact queries are methods of the shapes, such as
//! [`Triangle::overlaps`](crate::Triangle::overlaps) and [`Ray::hit`](crate::Ray::hit). Of the
//! methods here, [`slabs::SlabRay::may_overlap`] never loses a box. To traverse a tree, see
//! [`prepared`](crate::prepared).
//!
//! ```
//! use septum::published::moller_trumbore;
//! use septum::{Cull, Ray, Triangle};
//!
//! let floor = Triangle::new([0.0_f32; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
//! let ray = Ray::new([0.25, 0.5, 9.0], [0.0, 0.0, -2.0])?;
//! let rounded = moller_trumbore::hit(&ray, &floor, Cull::Nothing).unwrap();
//! assert_eq!(rounded.t, ray.hit(&floor).unwrap().t);
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! Nothing here panics. In fixed point, products lose their last bits, and sums wrap around outside
//! the range. The exact queries do neither.
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
pub mod green_hatch;
pub mod moller_trumbore;
pub mod projected;
mod resolve;
pub mod separating_axes;
pub mod shared_normal;
pub mod slabs;
pub mod slopes;
pub mod stored_normal;
pub mod volumes;
pub mod watertight;

use crate::arithmetic::Rounded;
use crate::scalar::Scalar;
use crate::shape::Ray;

pub(crate) use resolve::{Limits, resolve};

/// A vector in the scalar's own arithmetic.
pub(crate) type Triple<S> = [Rounded<S>; 3];

#[inline(always)]
pub(crate) fn rounded<S>([x, y, z]: [S; 3]) -> Triple<S> {
    [Rounded(x), Rounded(y), Rounded(z)]
}

/// The origin and the direction of a ray.
#[inline(always)]
pub(crate) fn line<S: Scalar>(ray: &Ray<S>) -> (Triple<S>, Triple<S>) {
    (rounded(ray.origin().to_array()), rounded(ray.direction().to_array()))
}

/// Component `i` of three, by its address, because a branch on the index would be unpredictable.
#[inline(always)]
fn by_index<T>(x: &[T; 3], i: u8) -> &T {
    &x[if i < 3 { usize::from(i) } else { 0 }]
}
