//! The two exact signs behind every answer of this module: the side of an edge on which a point
//! lies, seen along an axis, and the side of a plane.
//!
//! A point is the middle of p and q: p = q for a corner of the grid, and p and q are opposite
//! corners for the centre of a voxel.

use core::cmp::Ordering;

use crate::arithmetic::{Each, Embeds, Parts, compare, cross, dot, sign, three};
use crate::robust::{ExactSum, Predicate, Profile, add_area, difference, single};
use crate::scalar::Scalar;

/// The sign of (b − a) × (p + q − 2a) in a plane: positive if the point lies left of the edge from
/// a to b, where the first axis points right and the second up.
#[inline(never)]
pub(super) fn turn<S: Scalar>(a: [S; 2], b: [S; 2], p: [S; 2], q: [S; 2]) -> Ordering {
    S::evaluate(&Turn { from: a, to: b, a, p, q }).cmp(&0)
}

/// The sign of (b − a) × (p − a). Edges along an axis of the grid are frequent, and two comparisons
/// settle them.
pub(super) fn exact_turn<S: Scalar>(a: [S; 2], b: [S; 2], p: [S; 2]) -> Ordering {
    match (compare(b[0], a[0]), compare(b[1], a[1])) {
        (Ordering::Equal, Ordering::Equal) => Ordering::Equal,
        (Ordering::Equal, Ordering::Less) => compare(p[0], a[0]),
        (Ordering::Equal, Ordering::Greater) => compare(a[0], p[0]),
        (Ordering::Greater, Ordering::Equal) => compare(p[1], a[1]),
        (Ordering::Less, Ordering::Equal) => compare(a[1], p[1]),
        _ => turn(a, b, p, p),
    }
}

/// The sign of the area of a triangle, seen along the third axis.
#[cold]
#[inline(never)]
pub(super) fn exact_area<S: Scalar>(points: &[[S; 3]; 3], [u, v]: [usize; 2]) -> Ordering {
    let [a, b, c] = points.each(|p| [p[u], p[v]]);
    exact_turn(a, b, c)
}

/// The sign of (to − from) × (p − a).
#[inline(never)]
pub(super) fn line_turn<S: Scalar>(a: [S; 2], [from, to]: [[S; 2]; 2], p: [S; 2]) -> Ordering {
    S::evaluate(&Turn { from, to, a, p, q: p }).cmp(&0)
}

/// Compares p with a + t·(to − from).
#[cold]
#[inline(never)]
pub(super) fn against_point<S: Scalar>(p: S, a: S, [from, to]: [S; 2], t: Parts) -> Ordering {
    let mut sum = S::SeptumSum::new();
    add_area(&mut sum, &difference(p.parts(), a.parts()), &single(S::ONE), false);
    add_area(&mut sum, &difference(to.parts(), from.parts()), &single(t), true);
    sum.sign()
}

/// Compares the middle of p and q with x; `positive` is any number above zero.
#[cold]
#[inline(never)]
pub(super) fn middle<S: Scalar>(p: S, q: S, x: S, positive: S) -> Ordering {
    let on_axis = |x: S| [x, S::ZERO];
    turn(on_axis(x), [x, positive], on_axis(p), on_axis(q)).reverse()
}

/// The sign of ((b − a) × (c − a))·(p + q − 2a).
#[inline(never)]
pub(super) fn side<S: Scalar>(triangle: &[[S; 3]; 3], p: [S; 3], q: [S; 3]) -> Ordering {
    S::evaluate(&Above { triangle, p, q }).cmp(&0)
}

struct Turn<S> {
    from: [S; 2],
    to: [S; 2],
    a: [S; 2],
    p: [S; 2],
    q: [S; 2],
}

impl<S: Scalar> Predicate<S> for Turn<S> {
    type Answer = i8;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<i8> {
        // The caller has tried floats.
        if !N::CERTAIN {
            return None;
        }
        let in_space = |[u, v]: [S; 2]| [u, v, S::ZERO];
        let all = [self.from, self.to, self.a, self.p, self.q].map(in_space);
        let [from, to, a, p, q] = N::embed(&all)?;
        let [u, v] = [0, 1].each(|i| (to[i] - from[i], (p[i] - a[i]) + (q[i] - a[i])));
        Some(sign(N::area(u.0, v.1) - N::area(v.0, u.1)) as i8)
    }
}

struct Above<'a, S> {
    triangle: &'a [[S; 3]; 3],
    p: [S; 3],
    q: [S; 3],
}

impl<S: Scalar> Predicate<S> for Above<'_, S> {
    type Answer = i8;

    fn filter<N: Embeds<S>>(&self) -> Option<i8> {
        if !N::CERTAIN {
            return None;
        }
        let [a, b, c] = *self.triangle;
        let [a, b, c, p, q] = N::embed(&[a, b, c, self.p, self.q])?;
        let (e, f) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
        let d = three(|i| (p[i] - a[i]) + (q[i] - a[i]));
        Some(sign(dot::<N>(&cross::<N>(&e, &f), &d)) as i8)
    }
}
