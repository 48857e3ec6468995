//! The watertight test if all three edge functions are zero.

use core::cmp::Ordering;

use super::resolve::Limits;
use super::vector::Triple;
use crate::arithmetic::{Each, Number, Rounded};
use crate::query::Candidate;
use crate::robust::ExactSum;
use crate::scalar::Scalar;

/// The verdict on a triangle that the ray sees so nearly edge on that rounding erased its area.
///
/// The signs of the edge functions are computed exactly. If they agree, the triangle seen from the
/// ray is its longest side, within rounding, and the ray crosses that side.
#[cold]
#[inline(never)]
pub(super) fn degenerate_view<S: Scalar>(
    corners: [Triple<S>; 3],
    height: S,
    limits: &Limits<S>,
) -> Candidate<S> {
    let [a, b, c] = corners;
    let signs = [edge(c, b), edge(a, c), edge(b, a)];
    let front = signs.contains(&Ordering::Greater);
    let one_sided = front != signs.contains(&Ordering::Less);
    let (weights, z) = along_longest(corners);
    let t = z.0.plain_div(height);
    let hit = one_sided && limits.keep(front) && limits.hold(t);
    Candidate::new(hit, [t, weights[1].0, weights[2].0], front, signs.each(Ordering::is_eq))
}

/// The sign of p.x·q.y − p.y·q.x.
fn edge<S: Scalar>(p: Triple<S>, q: Triple<S>) -> Ordering {
    let mut sum = S::SeptumSum::new();
    sum.add(&[p[0].0.parts(), q[1].0.parts()]);
    sum.add(&[p[1].0.parts().negated(), q[0].0.parts()]);
    sum.sign()
}

/// The point of the longest side, as seen, that is nearest to the z axis: its weights of the three
/// corners, and its height.
fn along_longest<S: Scalar>(corners: [Triple<S>; 3]) -> (Triple<S>, Rounded<S>) {
    let (mut from, mut to, mut axis) = (0, 1, 0);
    let mut longest = Rounded::ZERO;
    for (p, q) in [(0, 1), (1, 2), (2, 0)] {
        for i in 0..2 {
            let length = (corners[q][i] - corners[p][i]).magnitude();
            if length > longest {
                (from, to, axis, longest) = (p, q, i, length);
            }
        }
    }
    let (p, q) = (corners[from], corners[to]);
    let one = Rounded(S::plain_one());
    let share = Rounded((-p[axis]).0.plain_div((q[axis] - p[axis]).0));
    let share = if share > Rounded::ZERO { share } else { Rounded::ZERO };
    let share = if share < one { share } else { one };
    let mut weights = [Rounded::ZERO; 3];
    weights[to] = share;
    weights[from] = one - share;
    (weights, p[2] + share * (q[2] - p[2]))
}
