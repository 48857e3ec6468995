//! The crossing with determinant, t, u and v side by side: the operations of
//! [`Setting`](super::crossing::Setting) on the same numbers, so the same bits.
//!
//! det = (d × e2)·e1, t = (s × e1)·e2, u = (d × e2)·s, v = (s × e1)·d: a row is a component of e2,
//! e1, d and s. Its first and its second half, twice each, make the cross products; with both
//! halves swapped it is what these are multiplied by. Vectors of two numbers have nothing to move
//! for that, vectors of four little.

use super::crossing::{Crossing, ErrorBound, Sizes, errors};
use crate::arithmetic::{Filtered, FirstFloat, Float, Number, Quad, greatest};
use crate::scalar::Scalar;

pub(super) type First<S> = <S as FirstFloat>::First;

/// Whether the scalar's first float has vectors and is not what [`Ray::hit`](crate::Ray::hit)
/// begins with.
#[inline(always)]
pub(super) fn begins_elsewhere<S: Scalar>() -> bool {
    S::IN_QUADS && (S::FLOAT.is_none() || size_of::<First<S>>() < size_of::<f64>())
}

/// A point in the scalar's first float.
#[inline(always)]
pub(super) fn first<S: FirstFloat>([x, y, z]: [S; 3]) -> [First<S>; 3] {
    [x.first(), y.first(), z.first()]
}

/// Rows of a triangle and a ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows<Q>([Q; 3]);

/// What they tell.
pub(super) struct Found<F> {
    /// Whether the half-line from t = 0 crosses the triangle.
    pub(super) is_ahead: bool,
    /// The crossing of its line.
    pub(super) crossing: Crossing<F>,
    pub(super) sizes: Sizes<F>,
}

impl<F: Float, Q: Quad<Lane = F>> Rows<Q> {
    #[inline(always)]
    pub(super) fn new([a, b, c, o]: &[[F; 3]; 4], d: [F; 3]) -> Self {
        let row = |i: usize| Q::new([c[i], b[i], d[i], o[i]]) - Q::new([a[i], a[i], F::ZERO, a[i]]);
        Self([row(0), row(1), row(2)])
    }

    /// `None` in doubt.
    #[inline(always)]
    pub(super) fn found(&self) -> Option<Found<F>> {
        let sizes = self.sizes()?;
        let [det, t, u, v] = self.volumes();
        let error_bound = errors::<Filtered<F>>(sizes);
        let crossing = Crossing { det, t, sides: [det - u - v, u, v], error_bound };
        Some(Found { is_ahead: strictly_ahead::<Q>(&crossing)?, crossing, sizes })
    }

    /// `None` where it is not known how far the volumes are from the truth.
    #[inline(always)]
    pub(super) fn sizes(&self) -> Option<Sizes<F>> {
        let [x, y, z] = self.0;
        let largest = x.magnitude().greatest(y.magnitude()).greatest(z.magnitude());
        let (least, most) = F::RANGE;
        let (above, below) = (largest.exceeds(Q::splat(least)), Q::splat(most).exceeds(largest));
        // One of both edges is long enough, and so is the direction; nothing is too long.
        if !((above & 0b0011 != 0) & (above & 0b0100 != 0) & (below == 0b1111)) {
            return None;
        }
        let [second, first, direction, way] = largest.to_array();
        let edges = greatest(first, second);
        Some(Sizes { direction, edges, size: greatest(edges, way) })
    }

    /// Determinant, t, u and v.
    #[inline(always)]
    pub(super) fn volumes(&self) -> [F; 4] {
        let ways = |row: Q| {
            let [_, _, d, s] = row.to_array();
            Q::new([d, s, d, s])
        };
        let edges = |row: Q| {
            let [e2, e1, _, _] = row.to_array();
            Q::new([e2, e1, e2, e1])
        };
        let swapped = |row: Q| {
            let [e2, e1, d, s] = row.to_array();
            Q::new([e1, e2, s, d])
        };
        let [x, y, z] = self.0;
        let minor = |j: Q, k: Q| ways(j) * edges(k) - ways(k) * edges(j);
        (minor(y, z) * swapped(x) + minor(z, x) * swapped(y) + minor(x, y) * swapped(z)).to_array()
    }
}

/// [`Crossing::strictly_ahead`], of w, t, u and v at once.
#[inline(always)]
fn strictly_ahead<Q: Quad<Lane: Float>>(crossing: &Crossing<Q::Lane>) -> Option<bool> {
    let &Crossing { t, sides: [w, u, v], error_bound, .. } = crossing;
    let ErrorBound { sides, t: error, .. } = error_bound;
    let (volumes, error) = (Q::new([w, t, u, v]), Q::new([sides, error, sides, sides]));
    let (positive, negative) =
        (volumes.exceeds(error), (Q::splat(Q::Lane::ZERO) - error).exceeds(volumes));
    let hit = (positive == 0b1111) | (negative == 0b1111);
    let miss = (positive != 0) & (negative != 0);
    if hit ^ miss { Some(hit) } else { None }
}
