//! Half-line against triangle: whether the half-line from a point along the first axis crosses the
//! triangle, such that each crossing of a closed mesh counts once.
//!
//! Project along the half-line: the triangle lies in the plane of the two remaining axes, and
//! contains the point or not. A point on an edge or a vertex belongs to exactly one of the
//! triangles there, as if it were displaced by (·, ε, ε²) (symbolic perturbation); the same
//! displacement for all triangles makes the counts consistent. The only sign that can be in doubt
//! is a planar area's. The sign of a volume is needed only if the triangle extends from before the
//! point to behind it.

use super::orientation::{from, sides, size};
use crate::arithmetic::{Arithmetic, Embeds, Number};
use crate::robust::{Predicate, Profile, certain_sign};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// How the half-line from `p` along the first axis crosses a triangle that does not contain `p`: 1
/// if it leaves through the triangle, along its normal, −1 if it enters, against the normal, 0 if
/// it does not cross. The sign assumes normals that point outward.
#[inline]
pub(crate) fn crossing<S: Scalar>(p: [S; 3], triangle: &Triangle<S>) -> i32 {
    let points = triangle.points();
    let [a, b, c] = &points;
    let [px, py, pz] = p;
    let above = |q: &[S; 3]| q[2] > pz;
    // Most triangles along the half-line are rejected here.
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
    // The half-line crosses the plane if the volume has the sign of the normal's first component.
    let volume = S::evaluate(&Volume { p, points });
    if (volume > 0) == (turns > 0) { turns } else { 0 }
}

/// Whether the point lies before the edge from `u` to `v` along the second axis, at its own level
/// of the third axis, which the edge crosses.
#[inline(always)]
fn is_before<S: Scalar>(py: S, p: [S; 3], u: &[S; 3], v: &[S; 3]) -> bool {
    if (u[1] <= py) & (v[1] <= py) {
        return false;
    }
    if (u[1] > py) & (v[1] > py) {
        return true;
    }
    let turn = S::evaluate(&Turn { p, u: *u, v: *v });
    turn == if v[2] > u[2] { 1 } else { -1 }
}

/// Roundoffs in the area, per sum of the sizes of its two products a and b.
///
/// Each product has two differences as factors: 2 roundings for these, 1 for the product, and 1 for
/// the last difference, of at most |a| + |b|: 4. Two more cover second orders and the roundings of
/// the bound. The loss by underflow is below the least normal number, which is added. Proved in
/// `area.g`.
const TURN: u16 = 6;

/// The question on which side of the edge from `u` to `v` the point is, in the second and third
/// coordinates: the sign of (v − u) × (p − u).
struct Turn<S> {
    p: [S; 3],
    u: [S; 3],
    v: [S; 3],
}

impl<S: Scalar> Predicate<S> for Turn<S> {
    type Answer = i8;
    const PROFILE: Profile = Profile::AREAS;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<i8> {
        let [p, u, v] = N::embed(&[self.p, self.u, self.v])?;
        let a = N::area(v[1] - u[1], p[2] - u[2]);
        let b = N::area(v[2] - u[2], p[1] - u[1]);
        let error = (a.magnitude() + b.magnitude()).error(TURN) + N::Area::UNDERFLOW;
        settled::<N>(certain_sign(a - b, error))
    }
}

/// The question on which side of a triangle the point is: the sign of n·(a − p), with n the normal
/// of the triangle a, b, c.
struct Volume<S> {
    p: [S; 3],
    points: [[S; 3]; 3],
}

impl<S: Scalar> Predicate<S> for Volume<S> {
    type Answer = i8;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<i8> {
        let [a, b, c] = self.points;
        let [a, b, c, p] = N::embed(&[a, b, c, self.p])?;
        let (e, f, to_a) = (from::<N>(&b, &a), from::<N>(&c, &a), [from::<N>(&a, &p)]);
        let [sign] = sides::<N, 1>([&e, &f], &to_a, size::<N, 1>(&to_a))?;
        settled::<N>(sign)
    }
}

/// The sign, or `None` if it is zero because of doubt.
#[inline(always)]
fn settled<N: Arithmetic>(sign: i8) -> Option<i8> {
    if sign != 0 || N::CERTAIN { Some(sign) } else { None }
}
