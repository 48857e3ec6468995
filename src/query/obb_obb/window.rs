//! Two boxes in doubt, by exact integers in a window of 120 bits. Only the axes that floats leave
//! open are computed.

use crate::arithmetic::{BigInt, Embeds, Float, Number, Window, cross, dot};
use crate::query::relation::{Nearness, Relation};

/// The 15 axes, each the cross product of two of the vectors u_0, u_1, u_2, v_0, v_1, v_2: the face
/// normals of the first box and of the second, and then for each v_j its products with all u_i.
const AXES: [[usize; 2]; 15] = [
    [1, 2],
    [2, 0],
    [0, 1],
    [4, 5],
    [5, 3],
    [3, 4],
    [0, 3],
    [1, 3],
    [2, 3],
    [0, 4],
    [1, 4],
    [2, 4],
    [0, 5],
    [1, 5],
    [2, 5],
];

/// The boxes as they are given: centres and half-extents, or corners of the first, and the axes.
pub(super) struct Given<F> {
    pub(super) first: [[F; 3]; 2],
    pub(super) second: [[F; 3]; 2],
    pub(super) u: [[F; 3]; 3],
    pub(super) v: [[F; 3]; 3],
    pub(super) by_corners: bool,
}

/// Returns the relation of two boxes. Bit k of `open` marks entry k of [`AXES`] for the test; on all
/// other axes the boxes overlap for certain. Returns `None` if the window does not hold the numbers.
#[cold]
#[inline(never)]
pub(super) fn relation<F: Float>(boxes: &Given<F>, open: u32) -> Option<Relation> {
    let Given { first: [p, q], second: [b, k], u: [u0, u1, u2], v: [v0, v1, v2], .. } = *boxes;
    let ones = [F::from(1); 3];
    let all = [p, q, b, k, u0, u1, u2, v0, v1, v2, ones];
    let [p, q, b, k, u0, u1, u2, v0, v1, v2, [one, ..]] = Window::embed(&all)?;
    let by = |f: fn([i128; 4]) -> i128| [0, 1, 2].map(|i: usize| f([p[i], q[i], b[i], k[i]]));
    // Between corners all lengths are doubled.
    let (d, h, k) = if boxes.by_corners {
        (by(|[p, q, b, _]| (b - p) + (b - q)), by(|[p, q, ..]| q - p), by(|[.., k]| k + k))
    } else {
        (by(|[p, _, b, _]| b - p), q, k)
    };

    let (spans, extents) = ([u0, u1, u2, v0, v1, v2], [h, k]);
    let mut found = Nearness::NONE;
    for (_, [a, b]) in AXES.iter().enumerate().filter(|(bit, _)| open >> bit & 1 == 1) {
        let (a, b) = (*a, *b);
        let axis = cross::<Window>(&spans[a], &spans[b]);
        let along = |x: &[i128; 3], times: i128| -> BigInt<8> {
            dot::<Window>(&axis, x).times::<2, 8>(&times.into()).magnitude()
        };
        let mut reach = BigInt::<8>::ZERO;
        for (r, span) in spans.iter().enumerate().filter(|&(r, _)| r != a && r != b) {
            reach = reach + along(span, extents[r / 3][r % 3]);
        }
        found.add(along(&d, one) - reach, reach, BigInt::ZERO);
        if found.is_disjoint {
            break;
        }
    }
    found.relation(true)
}
