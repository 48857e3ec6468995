//! Computed zeros in the float kernel: whether rounding made them.

use super::{InFrame, Rows, largest};
use crate::arithmetic::{Float, Number, Quad, THREE, two_difference};

/// Whether every gap of zero between a triangle and a box given by its centre is exact: the
/// difference that gave it was not rounded.
pub(super) fn gaps_are_exact<Q: Quad<Lane: Float>>(rows: &Rows<Q>, center: Q, half: Q) -> bool {
    let zero = Q::splat(Q::Lane::ZERO);
    let ([low, low_lost], [high, high_lost]) =
        (two_difference(rows.low, center), two_difference(rows.high, center));
    let is_rounded = |lost: Q| lost.magnitude().exceeds(zero);
    let (above, below) = (half.exceeds(low), high.exceeds(zero - half));
    (is_rounded(low_lost) & !above | is_rounded(high_lost) & !below) & THREE == 0
}

/// Whether the coordinates of a triangle and of a box, given by `p` and `q`, are multiples of a
/// unit so great that no sum of products of three differences up to the pair's size is rounded.
pub(super) fn is_on_grid<Q: Quad<Lane: Float>>(
    rows: &Rows<Q>,
    frame: &InFrame<Q>,
    p: Q,
    q: Q,
) -> bool {
    let size = largest(frame.size);
    let shifter = Q::splat(size.power_of_two_below() * Q::Lane::GRID_SHIFTER);
    let mut off = 0;
    for x in [rows.v[0], rows.v[1], rows.v[2], p, q] {
        let whole = (x + shifter) - shifter;
        off |= whole.exceeds(x) | x.exceeds(whole);
    }
    off & THREE == 0
}
