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
//! Nothing here panics. In fixed point, products lose their last bits, and sums and quotients wrap around
//! outside the range, as a ratio of one does in a type without one. The exact queries do neither.
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
pub mod separating_axes;
pub mod shared_normal;
pub mod slabs;
pub mod slopes;
pub mod stored_normal;
pub mod volumes;
pub mod watertight;

use crate::arithmetic::{Number, Rounded, least};
use crate::query::{Candidate, Cull, Facing};
use crate::scalar::Scalar;
use crate::shape::Ray;

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

/// Which hits count: the range of t, and the sides.
#[derive(Clone, Copy)]
pub(crate) struct Limits<S> {
    /// The ends of the range, and whether each is open.
    pub t_min: S,
    pub t_max: S,
    pub open: [bool; 2],
    pub front: bool,
    pub back: bool,
}

impl<S: Scalar> Limits<S> {
    #[inline(always)]
    pub(crate) fn new(ray: &Ray<S>, cull: Cull) -> Self {
        Self {
            t_min: ray.t_min().unwrap_or(S::ZERO),
            t_max: ray.t_max().unwrap_or(S::ZERO),
            open: [ray.t_min().is_none(), ray.t_max().is_none()],
            front: cull.keeps(Facing::Front),
            back: cull.keeps(Facing::Back),
        }
    }

    /// Whether t counts. An infinity or a NaN, from an overflow, does not.
    #[inline(always)]
    fn hold(&self, t: S) -> bool {
        let is_finite = t.plain_sub(t) == S::ZERO;
        (self.open[0] | (t >= self.t_min)) & (self.open[1] | (t <= self.t_max)) & is_finite
    }

    #[inline(always)]
    fn keep(&self, front: bool) -> bool {
        (self.front & front) | (self.back & !front)
    }
}

/// A determinant, above zero if the ray comes from the front, and the products of t, u and v with
/// it.
#[derive(Clone, Copy)]
pub(crate) struct Fractions<S> {
    pub det: Rounded<S>,
    pub t: Rounded<S>,
    pub u: Rounded<S>,
    pub v: Rounded<S>,
}

/// The verdict from the signs, and the three quotients.
///
/// A miss divides by zero, which costs no division in fixed point; its quotients are not read.
#[inline(always)]
pub(crate) fn resolve<S: Scalar>(f: Fractions<S>, limits: &Limits<S>) -> Candidate<S> {
    let zero = Rounded::ZERO;
    let front = f.det > zero;
    let upright = |x: Rounded<S>| Rounded(x.0.flip_sign_by(f.det.0));
    let (det, u, v) = (upright(f.det), upright(f.u), upright(f.v));
    let w = det - u - v;
    let inside = (det > zero) & none_below_zero(u, v, w) & limits.keep(front);
    let divisor = if inside { det.0 } else { S::ZERO };
    let t = upright(f.t).0.plain_div(divisor);
    Candidate::new(
        inside & limits.hold(t),
        [t, u.0.plain_div(divisor), v.0.plain_div(divisor)],
        front,
        [w == zero, u == zero, v == zero],
    )
}

/// Whether none of three numbers is below zero. A NaN in `w` gives no; a NaN in u or v must make w
/// a NaN too.
#[inline(always)]
fn none_below_zero<S: Scalar>(u: Rounded<S>, v: Rounded<S>, w: Rounded<S>) -> bool {
    least(least(u, v), w) >= Rounded::ZERO
}
