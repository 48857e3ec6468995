//! Ray and triangle by the stored normal.

use super::{Fractions, Limits, Triple, line, resolve, rounded};
use crate::arithmetic::{Each, Number, Rounded, cross3, dot3, minus3};
use crate::query::{Cull, Hit};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle, Vec3};

/// A triangle prepared for [`hit`]: its first vertex, its edges from there, and its normal, all
/// rounded. Twelve scalars instead of nine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalTriangle<S> {
    pub(crate) stored: [[S; 3]; 4],
}

/// The first vertex, the edges from it to the second and the third, and their cross product.
pub(crate) type Stored<S> = [Triple<S>; 4];

#[inline(always)]
pub(crate) fn store<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> Stored<S> {
    let (a, b, c) = (rounded(a), rounded(b), rounded(c));
    let (e1, e2) = (minus3(&b, &a), minus3(&c, &a));
    [a, e1, e2, cross3(&e1, &e2)]
}

impl<S: Scalar> NormalTriangle<S> {
    /// The triangle with its normal, prepared for [`hit`].
    ///
    /// *Panics*: never. *Cost*: 6 multiplications, 9 differences.
    #[inline]
    #[must_use]
    pub fn new(triangle: &Triangle<S>) -> Self {
        let plain = |v: Triple<S>| v.each(|x| x.0);
        Self { stored: store(triangle.points()).each(plain) }
    }

    /// The normal, (b − a) × (c − a), rounded. Its length is twice the area.
    #[inline]
    #[must_use]
    pub fn normal(&self) -> Vec3<S> {
        self.stored[3].into()
    }

    #[inline(always)]
    pub(crate) fn rounded(&self) -> Stored<S> {
        self.stored.each(rounded)
    }
}

/// Where does the ray cross a triangle whose normal is stored? In the scalar's own arithmetic: the
/// fastest method, and occasionally wrong.
///
/// Choose it if triangles are met often and memory has room for a third more. It takes a little
/// less time than [`moller_trumbore`](super::moller_trumbore::hit), whose page compares the
/// methods. If t is enough, or enough at first, [`t`] takes half of the time.
///
/// *Geometry*, *Contact*, *Numerics*: as for [`moller_trumbore`](super::moller_trumbore::hit).
///
/// *Panics*: never. *Cost*: 18 multiplications, 3 divisions, no early exit.
///
/// *Source*: *Real-Time Rendering*, equation 16.24, with n·d, n·s and s×d.
///
/// ```
/// use septum::published::stored_normal::{self, NormalTriangle};
/// use septum::{Cull, Ray, Triangle};
///
/// let floor = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let floor = NormalTriangle::new(&floor);
/// let ray = Ray::new([0.25, 0.5, 9.0], [0.0, 0.0, -2.0])?;
/// assert_eq!(stored_normal::hit(&ray, &floor, Cull::Nothing).unwrap().t, 4.5);
/// assert_eq!(stored_normal::t(&ray, &floor, Cull::Nothing, f64::INFINITY), 4.5);
/// assert_eq!(stored_normal::t(&ray, &floor, Cull::Front, f64::INFINITY), f64::INFINITY);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[inline]
pub fn hit<S: Scalar>(ray: &Ray<S>, triangle: &NormalTriangle<S>, cull: Cull) -> Option<Hit<S>> {
    resolve(by_normal(ray, triangle), &Limits::new(ray, cull)).into_hit()
}

/// The t of [`hit`], or `miss`.
///
/// Choose it if a loop keeps the least t. An `Option` makes the caller branch on something
/// unpredictable; a number can be selected without a branch. It takes half the time of
/// Möller–Trumbore if half of the rays hit.
///
/// *Panics*: never. *Cost*: 18 multiplications, 1 division, no branch.
#[inline]
#[must_use]
pub fn t<S: Scalar>(ray: &Ray<S>, triangle: &NormalTriangle<S>, cull: Cull, miss: S) -> S {
    let found = resolve(by_normal(ray, triangle), &Limits::new(ray, cull));
    // Selected by its address, because an `if` may become a branch.
    [miss, found.t][usize::from(found.hit)]
}

#[inline(always)]
fn by_normal<S: Scalar>(ray: &Ray<S>, triangle: &NormalTriangle<S>) -> Fractions<S> {
    stored_normal(line(ray), triangle.rounded())
}

#[inline(always)]
pub(crate) fn stored_normal<S: Scalar>(
    (origin, direction): (Triple<S>, Triple<S>),
    [a, e1, e2, n]: Stored<S>,
) -> Fractions<S> {
    let s = minus3(&origin, &a);
    let m = cross3(&s, &direction);
    let zero = Rounded::ZERO;
    Fractions {
        det: zero - dot3(&direction, &n),
        t: dot3(&s, &n),
        u: dot3(&m, &e2),
        v: zero - dot3(&m, &e1),
    }
}
