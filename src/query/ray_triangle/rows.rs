//! The crossing with determinant, t, u and v side by side: the operations of
//! [`Setting`](super::crossing::Setting) on the same numbers, and so the same bits.
//!
//! det = (d × e2)·e1, t = (s × e1)·e2, u = (d × e2)·s, v = (s × e1)·d. A row holds a component of
//! e2, e1, d and s. The cross products combine its second half (d, s, repeated) with its first half
//! (e2, e1, repeated); the dot products multiply them by the row with the two numbers in each half
//! swapped. In vectors of two numbers none of this moves data between vectors, and in vectors of
//! four little.

use super::crossing::{Crossing, Sizes, VolumeErrors, errors};
use crate::arithmetic::{Filtered, FirstFloat, Float, Number, Quad, greatest};
use crate::scalar::Scalar;

pub(super) type First<S> = <S as FirstFloat>::SeptumFirst;

/// Whether the scalar's first float has vectors, and [`Ray::hit`](crate::Ray::hit) begins with
/// another stage.
#[inline(always)]
pub(super) fn begins_elsewhere<S: Scalar>() -> bool {
    S::IN_QUADS && (S::FLOAT.is_none() || size_of::<First<S>>() < size_of::<f64>())
}

/// A point in the scalar's first float.
#[inline(always)]
pub(super) fn first<S: FirstFloat>([x, y, z]: [S; 3]) -> [First<S>; 3] {
    [x.first(), y.first(), z.first()]
}

/// VolumeRows of a triangle and a ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct VolumeRows<Q>([Q; 3]);

/// The crossing from the rows.
pub(super) struct Found<F> {
    /// Whether the half-line from t = 0 crosses the triangle.
    pub(super) is_ahead: bool,
    /// The crossing of its line.
    pub(super) crossing: Crossing<F>,
    pub(super) sizes: Sizes<F>,
}

impl<F: Float, Q: Quad<Lane = F>> VolumeRows<Q> {
    #[inline(always)]
    pub(super) fn new([a, b, c, o]: &[[F; 3]; 4], d: [F; 3]) -> Self {
        let row = |i: usize| Q::new([c[i], b[i], d[i], o[i]]) - Q::new([a[i], a[i], F::ZERO, a[i]]);
        Self([row(0), row(1), row(2)])
    }

    /// The crossing; `None` in doubt.
    #[inline(always)]
    pub(super) fn found(&self) -> Option<Found<F>> {
        let sizes = self.sizes()?;
        let [det, t, u, v] = self.volumes();
        let error_bound = errors::<Filtered<F>>(sizes);
        let crossing = Crossing { det, t, sides: [det - u - v, u, v], error_bound };
        Some(Found { is_ahead: strictly_ahead::<Q>(&crossing)?, crossing, sizes })
    }

    /// The sizes; `None` if a size is out of range.
    #[inline(always)]
    pub(super) fn sizes(&self) -> Option<Sizes<F>> {
        let [x, y, z] = self.0;
        let largest = x.magnitude().greatest(y.magnitude()).greatest(z.magnitude());
        let (least, most) = F::RANGE;
        let (above, below) = (largest.exceeds(Q::splat(least)), Q::splat(most).exceeds(largest));
        // At least one edge and the direction are long enough, and nothing is too long.
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

/// [`Crossing::strictly_ahead`], for w, t, u and v at once.
#[inline(always)]
fn strictly_ahead<Q: Quad<Lane: Float>>(crossing: &Crossing<Q::Lane>) -> Option<bool> {
    let &Crossing { t, sides: [w, u, v], error_bound, .. } = crossing;
    let VolumeErrors { sides, t: error, .. } = error_bound;
    let (volumes, error) = (Q::new([w, t, u, v]), Q::new([sides, error, sides, sides]));
    let (positive, negative) =
        (volumes.exceeds(error), (Q::splat(Q::Lane::ZERO) - error).exceeds(volumes));
    let hit = (positive == 0b1111) | (negative == 0b1111);
    let miss = (positive != 0) & (negative != 0);
    if hit ^ miss { Some(hit) } else { None }
}
