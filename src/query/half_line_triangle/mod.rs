//! Half-line against triangle: whether the one from a point along the first axis goes
//! through the triangle, each crossing of a closed mesh counted once.
//!
//! The half-line is seen from its end: there the triangle lies in the plane of the other
//! two axes, and the point is in it or not. A point on an edge or a vertex belongs to one of
//! the triangles there, as if it were moved by (·, ε, ε²): one displacement for all
//! triangles, hence consistent. What is in doubt is the sign of an area. The sign of a volume
//! is asked for only where the triangle reaches from before the point to behind it.

mod error_bound;
mod exact;

use core::cmp::Ordering;

use self::error_bound::{TURN, VOLUME};
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, largest};
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// How the half-line from `p` along the first axis crosses a triangle that does not contain
/// `p`: 1 against the triangle's normal turned round, which is from inside a mesh with normals
/// outward, −1 along with it, 0 not at all.
#[inline]
pub(crate) fn crossing<S: Scalar>(p: [S; 3], triangle: &Triangle<S>) -> i32 {
    let points = triangle.points();
    let [a, b, c] = &points;
    let [px, py, pz] = p;
    let above = |q: &[S; 3]| q[2] > pz;
    // Nearly all triangles of a column are left out here.
    if (above(a) == above(b)) & (above(b) == above(c)) {
        return 0;
    }
    if (a[1] <= py) & (b[1] <= py) & (c[1] <= py) | (a[1] > py) & (b[1] > py) & (c[1] > py) {
        return 0;
    }
    let (is_behind, is_ahead) =
        ((a[0] < px) & (b[0] < px) & (c[0] < px), (a[0] > px) & (b[0] > px) & (c[0] > px));
    if is_behind {
        return 0;
    }
    let mut turns = 0;
    for [u, v] in [[a, b], [b, c], [c, a]] {
        let rises = above(v);
        if above(u) == rises || !is_before(py, p, u, v) {
            continue;
        }
        turns += if rises { 1 } else { -1 };
    }
    if turns == 0 || is_ahead {
        return turns;
    }
    // The plane is met ahead if the volume has the sign of the normal's first component.
    let volume = S::evaluate(&Volume { p, points });
    if (volume.0 == Ordering::Greater) == (turns > 0) { turns } else { 0 }
}

/// Whether the point lies before the edge from `u` to `v`, along the second axis and on the
/// point's level of the third, which the edge crosses.
#[inline(always)]
fn is_before<S: Scalar>(py: S, p: [S; 3], u: &[S; 3], v: &[S; 3]) -> bool {
    if (u[1] <= py) & (v[1] <= py) {
        return false;
    }
    if (u[1] > py) & (v[1] > py) {
        return true;
    }
    let turn = S::evaluate(&Turn { p, u: *u, v: *v });
    turn.0 == if v[2] > u[2] { Ordering::Greater } else { Ordering::Less }
}

/// A sign, as an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sign(Ordering);

impl Default for Sign {
    fn default() -> Self {
        Self(Ordering::Equal)
    }
}

/// The sign of x; `None` where it is not clear of the error.
#[inline(always)]
fn sign<N: Number>(x: N, error: N, is_certain: bool) -> Option<Sign> {
    if is_certain || x > error || x < -error { x.partial_cmp(&N::ZERO).map(Sign) } else { None }
}

/// The question on which side of the edge from `u` to `v` the point is, by the second and the
/// third coordinate: the sign of (v − u) × (p − u).
struct Turn<S> {
    p: [S; 3],
    u: [S; 3],
    v: [S; 3],
}

impl<S: Scalar> Predicate<S> for Turn<S> {
    type Answer = Sign;
    const HAS_VOLUMES: bool = false;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<Sign> {
        let [p, u, v] = N::embed(&[self.p, self.u, self.v])?;
        let a = N::area(v[1] - u[1], p[2] - u[2]);
        let b = N::area(v[2] - u[2], p[1] - u[1]);
        let error = (a.magnitude() + b.magnitude()).error(TURN) + N::Area::UNDERFLOW;
        sign(a - b, error, N::CERTAIN)
    }

    fn exact(&self) -> Sign {
        Sign(exact::turn::<S>(&self.p, &self.u, &self.v))
    }
}

/// The question on which side of a triangle the point is: the sign of
/// (a − p)·((b − p) × (c − p)), which is that of the normal's product with a − p.
struct Volume<S> {
    p: [S; 3],
    points: [[S; 3]; 3],
}

impl<S: Scalar> Predicate<S> for Volume<S> {
    type Answer = Sign;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<Sign> {
        let [a, b, c] = self.points;
        let [a, b, c, p] = N::embed(&[a, b, c, self.p])?;
        let from_p = |q: [N::Length; 3]| [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
        let corners = [from_p(a), from_p(b), from_p(c)];
        let [a, b, c] = &corners;
        let size = greatest(greatest(largest(a), largest(b)), largest(c));
        if N::is_narrow(size) {
            volume::<N::Narrow>(&corners, size)
        } else {
            volume::<N>(&corners, size)
        }
    }

    fn exact(&self) -> Sign {
        Sign(exact::volume::<S>(&self.p, &self.points))
    }
}

#[inline(always)]
fn volume<N: Arithmetic>([a, b, c]: &[[N::Length; 3]; 3], size: N::Length) -> Option<Sign> {
    if !N::CERTAIN && !size.in_range() {
        return None;
    }
    let minor = |j: usize, k: usize| N::area(b[j], c[k]) - N::area(b[k], c[j]);
    let [x, y, z] = [minor(1, 2), minor(2, 0), minor(0, 1)];
    let sum = N::volume(x, a[0]) + N::volume(y, a[1]) + N::volume(z, a[2]);
    let error = N::volume(N::area(size, size), size).error(VOLUME);
    sign(sum, error, N::CERTAIN)
}
