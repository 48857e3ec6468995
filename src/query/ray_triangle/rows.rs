//! The crossing in `f64` with determinant, t, u and v side by side: the operations of
//! [`Setting`](super::crossing::Setting) on the same numbers, so the same bits.
//!
//! det = (d × e2)·e1, t = (s × e1)·e2, u = (d × e2)·s, v = (s × e1)·d: a row is a component of e2,
//! e1, d and s. Its first and its second half, twice each, make the cross products; with both halves
//! swapped it is what these are multiplied by. Vectors of two numbers have nothing to move for that,
//! vectors of four little.

use super::crossing::{Crossing, ErrorBound, Sizes, errors};
use crate::arithmetic::{Filtered, Float, OfFour, Quad};

const LEAST: f64 = <f64 as Float>::RANGE.0;
const GREATEST: f64 = <f64 as Float>::RANGE.1;

type Row = <f64 as OfFour>::Quad;

/// Whether the half-line from t = 0 crosses the triangle, the crossing of its line, and the sizes;
/// `None` in doubt.
#[inline(always)]
pub(super) fn crossing(
    [a, b, c, o]: &[[f64; 3]; 4],
    d: [f64; 3],
) -> Option<(bool, Crossing<f64>, Sizes<f64>)> {
    let row = |i: usize| Row::new([c[i], b[i], d[i], o[i]]) - Row::new([a[i], a[i], 0.0, a[i]]);
    let [x, y, z] = [row(0), row(1), row(2)];

    let largest = x.magnitude().greatest(y.magnitude()).greatest(z.magnitude());
    let (above, below) =
        (largest.exceeds(Row::splat(LEAST)), Row::splat(GREATEST).exceeds(largest));
    // One of both edges is long enough, and so is the direction; nothing is too long.
    if !((above & 0b11 != 0) & (above & 0b0100 != 0) & (below == 0b1111)) {
        return None;
    }
    let [second, first, direction, way] = largest.to_array();
    let edges = if first > second { first } else { second };
    let sizes = Sizes { direction, edges, size: if way > edges { way } else { edges } };

    let [det, t, u, v] = volumes([x, y, z]);
    let error_bound = errors::<Filtered<f64>>(sizes);
    let crossing = Crossing { det, t, sides: [det - u - v, u, v], error_bound };
    let is_ahead = strictly_ahead(&crossing)?;
    Some((is_ahead, crossing, sizes))
}

/// Determinant, t, u and v.
#[inline(always)]
fn volumes([x, y, z]: [Row; 3]) -> [f64; 4] {
    let ways = |row: Row| {
        let [_, _, d, s] = row.to_array();
        Row::new([d, s, d, s])
    };
    let edges = |row: Row| {
        let [e2, e1, _, _] = row.to_array();
        Row::new([e2, e1, e2, e1])
    };
    let minor = |j: Row, k: Row| ways(j) * edges(k) - ways(k) * edges(j);
    let swapped = |row: Row| {
        let [e2, e1, d, s] = row.to_array();
        Row::new([e1, e2, s, d])
    };
    (minor(y, z) * swapped(x) + minor(z, x) * swapped(y) + minor(x, y) * swapped(z)).to_array()
}

/// [`Crossing::strictly_ahead`], of w, t, u and v at once.
#[inline(always)]
fn strictly_ahead(
    &Crossing { t, sides: [w, u, v], error_bound, .. }: &Crossing<f64>,
) -> Option<bool> {
    let ErrorBound { sides, t: error, .. } = error_bound;
    let volumes = Row::new([w, t, u, v]);
    let error = Row::new([sides, error, sides, sides]);
    let (positive, negative) = (volumes.exceeds(error), (Row::splat(0.0) - error).exceeds(volumes));
    let hit = (positive == 0b1111) | (negative == 0b1111);
    let miss = (positive != 0) & (negative != 0);
    if hit ^ miss { Some(hit) } else { None }
}
