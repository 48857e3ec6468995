//! The crossing of a line and the plane of a triangle, as volumes: the kernel of the exact
//! ray/triangle query, in any number system.

use core::cmp::Ordering;

use super::Feature;
use super::error_bound::{SIDES, T, VOLUME};
use crate::arithmetic::{
    Arithmetic, Filtered, Number, compare, cross, dot, greatest, largest, least,
};
#[cfg(test)]
use crate::arithmetic::{BigInt, Embeds, FullF64};

/// A line and a triangle, relative to the triangle's first vertex.
#[derive(Clone, Copy)]
pub(super) struct Setting<L> {
    /// The direction.
    d: [L; 3],
    /// The edges to the second and the third vertex.
    e: [[L; 3]; 2],
    /// From the first vertex to the origin.
    s: [L; 3],
}

/// The greatest components: of the direction, of both edges, and of the edges and the vector to the
/// origin.
#[derive(Clone, Copy)]
pub(super) struct Sizes<L> {
    pub(super) direction: L,
    pub(super) edges: L,
    pub(super) size: L,
}

/// Volumes whose signs and quotients are the answer: t is `t`/det, and w, u, v are `sides`/det.
#[derive(Clone, Copy)]
pub(super) struct Crossing<V> {
    /// The determinant: w + u + v.
    pub(super) det: V,
    /// The numerator of t.
    pub(super) t: V,
    /// The numerators of the barycentric coordinates of the three vertices.
    pub(super) sides: [V; 3],
    /// The error bounds of the volumes.
    pub(super) error_bound: VolumeErrors<V>,
}

/// Error bounds of volumes.
#[derive(Clone, Copy)]
pub(super) struct VolumeErrors<V> {
    /// For the determinant, u and v.
    pub(super) side: V,
    /// For w, a difference of the three.
    pub(super) sides: V,
    /// For t.
    pub(super) t: V,
}

impl<L: Number> Setting<L> {
    #[inline(always)]
    pub(super) fn new([a, b, c, o]: &[[L; 3]; 4], d: [L; 3]) -> Self {
        let from_a = |p: &[L; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        Self { d, e: [from_a(b), from_a(c)], s: from_a(o) }
    }

    /// The greatest component of all vectors.
    #[inline(always)]
    pub(super) fn size(&self) -> L {
        let Self { d, e: [e1, e2], s } = self;
        greatest(greatest(largest(d), largest(s)), greatest(largest(e1), largest(e2)))
    }

    #[inline(always)]
    pub(super) fn sizes(&self) -> Sizes<L> {
        let Self { d, e: [e1, e2], s } = self;
        let edges = greatest(largest(e1), largest(e2));
        Sizes { direction: largest(d), edges, size: greatest(edges, largest(s)) }
    }

    /// The error bounds of the volumes.
    #[inline(always)]
    fn error_bound<M: Arithmetic<Length = L>>(&self) -> Option<VolumeErrors<M::Volume>> {
        if M::CERTAIN {
            let none = M::Volume::ZERO;
            return Some(VolumeErrors { sides: none, side: none, t: none });
        }
        error_bound::<M>(self.sizes())
    }

    /// The volumes; `None` if `M` has no error bound for them.
    ///
    /// T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
    /// *Journal of Graphics Tools* 2(1), 1997.
    #[inline(always)]
    pub(super) fn crossing<M: Arithmetic<Length = L>>(&self) -> Option<Crossing<M::Volume>> {
        Some(self.crossing_within::<M>(self.error_bound::<M>()?))
    }

    /// The volumes, and whether the error bounds are valid; without a branch.
    #[inline(always)]
    pub(super) fn crossing_if_known<M: Arithmetic<Length = L>>(
        &self,
    ) -> (Crossing<M::Volume>, bool) {
        let none = M::Volume::ZERO;
        let (error_bound, is_known) = match self.error_bound::<M>() {
            Some(error_bound) => (error_bound, true),
            None => (VolumeErrors { side: none, sides: none, t: none }, false),
        };
        (self.crossing_within::<M>(error_bound), is_known)
    }

    /// The volumes in large numbers, which are certain. Out of line, so that their stack is
    /// free again afterwards.
    #[inline(never)]
    pub(super) fn large_crossing<M: Arithmetic<Length = L>>(&self) -> Crossing<M::Volume> {
        let none = M::Volume::ZERO;
        self.crossing_within::<M>(VolumeErrors { side: none, sides: none, t: none })
    }

    /// The same direction and edges with another vector to the origin.
    #[inline(always)]
    pub(super) fn seen_along(self, s: [L; 3]) -> Self {
        Self { s, ..self }
    }

    #[inline(always)]
    fn crossing_within<M: Arithmetic<Length = L>>(
        &self,
        error_bound: VolumeErrors<M::Volume>,
    ) -> Crossing<M::Volume> {
        let Self { d, e: [e1, e2], s } = self;
        let p = cross::<M>(d, e2);
        let q = cross::<M>(s, e1);
        let (det, u, v) = (dot::<M>(&p, e1), dot::<M>(&p, s), dot::<M>(&q, d));
        Crossing { det, t: dot::<M>(&q, e2), sides: [det - u - v, u, v], error_bound }
    }

    /// The sign of barycentric coordinate `k` if the origin moves by an infinitesimal amount along
    /// the first axis, by one infinitely smaller along the second, and again along the third. For a
    /// positive determinant. Each sign is a derivative with respect to the origin.
    pub(super) fn perturbed_side<M: Arithmetic<Length = L>>(&self, k: usize) -> Ordering {
        let Self { d, e: [e1, e2], .. } = self;
        match k {
            0 => sign::<M>(&cross::<M>(d, &[e1[0] - e2[0], e1[1] - e2[1], e1[2] - e2[2]])),
            1 => sign::<M>(&cross::<M>(d, e2)),
            _ => sign::<M>(&cross::<M>(e1, d)),
        }
    }

    /// The same for t.
    pub(super) fn perturbed_t<M: Arithmetic<Length = L>>(&self) -> Ordering {
        let [e1, e2] = &self.e;
        sign::<M>(&cross::<M>(e1, e2))
    }
}

impl Setting<f64> {
    /// The volumes without error bounds.
    #[inline(always)]
    pub(super) fn volumes(&self) -> Crossing<f64> {
        let error_bound = VolumeErrors { side: 0.0, sides: 0.0, t: 0.0 };
        self.crossing_within::<Filtered<f64>>(error_bound)
    }
}

/// The volumes of the triangle and the origin, exactly, for unit tests.
#[cfg(test)]
pub(super) fn exact_crossing(points: &[[f64; 3]; 4], d: [f64; 3]) -> Crossing<BigInt<132>> {
    let [a, b, c, o] = *points;
    let [a, b, c, o, d] = FullF64::embed_held(&[a, b, c, o, d]);
    let crossing = Setting::new(&[a, b, c, o], d).crossing::<FullF64>().unwrap();
    crossing.widened(|volume| volume.resized())
}

impl<V: Number> Crossing<V> {
    /// Whether the half-line from t = 0 crosses the triangle, if that is certain and it touches no
    /// boundary.
    ///
    /// The line crosses if w, u and v have the same sign, which is then also the determinant's, so
    /// the determinant needs no test. Everything is computed before the first branch, because a
    /// branch that is almost random costs more.
    #[inline(always)]
    pub(super) fn strictly_ahead(&self) -> Option<bool> {
        let Self { t, sides: [w, u, v], error_bound, .. } = *self;
        let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
        let (positive, negative) = (low > error_bound.sides, high < -error_bound.sides);
        let (ahead, behind) = (t > error_bound.t, t < -error_bound.t);
        let hit = (positive & ahead) | (negative & behind);
        // If there is a hit, no two of the four have opposite signs.
        let miss = ((low < -error_bound.sides) | behind) & ((high > error_bound.sides) | ahead);
        if hit ^ miss { Some(hit) } else { None }
    }

    /// Whether the line crosses the triangle or touches it; `None` in doubt. A line parallel to the
    /// plane does not. `is_certain` says that all signs are certain.
    #[inline]
    pub(super) fn meets(&self, is_certain: bool) -> Option<bool> {
        let Self { det, sides: [w, u, v], error_bound, .. } = *self;
        let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
        if low < -error_bound.sides && high > error_bound.sides {
            Some(false)
        } else if is_certain {
            Some(det != V::ZERO)
        } else {
            (low > error_bound.sides || high < -error_bound.sides).then_some(true)
        }
    }

    /// Whether the line crosses the triangle or touches it, where all signs are certain.
    pub(super) fn meets_for_certain(&self) -> bool {
        let sides = || self.sides.iter();
        let is_between = sides().any(|x| *x < V::ZERO) && sides().any(|x| *x > V::ZERO);
        self.det != V::ZERO && !is_between
    }

    /// The same in wider volumes.
    #[inline(always)]
    pub(super) fn widened<W>(self, widen: fn(V) -> W) -> Crossing<W> {
        let ([w, u, v], error_bound) = (self.sides, self.error_bound);
        Crossing {
            det: widen(self.det),
            t: widen(self.t),
            sides: [widen(w), widen(u), widen(v)],
            error_bound: VolumeErrors {
                side: widen(error_bound.side),
                sides: widen(error_bound.sides),
                t: widen(error_bound.t),
            },
        }
    }

    /// The part of the triangle that is hit, if no sign is in doubt.
    #[inline(always)]
    pub(super) fn feature(&self) -> Feature {
        let [w, u, v] = self.sides;
        Feature::from_zeros(w == V::ZERO, u == V::ZERO, v == V::ZERO)
    }

    /// Whether the line runs against the normal.
    #[inline(always)]
    pub(super) fn is_front(&self) -> bool {
        self.det > V::ZERO
    }
}

/// The error bounds of the volumes, given the sizes of their operands.
#[inline(always)]
pub(super) fn error_bound<M: Arithmetic>(
    Sizes { direction, edges, size }: Sizes<M::Length>,
) -> Option<VolumeErrors<M::Volume>> {
    if !(direction.in_range() & edges.in_range() & size.in_range()) {
        return None;
    }
    Some(errors::<M>(Sizes { direction, edges, size }))
}

/// The same for sizes in range.
#[inline(always)]
pub(super) fn errors<M: Arithmetic>(
    Sizes { direction, edges, size }: Sizes<M::Length>,
) -> VolumeErrors<M::Volume> {
    let volume = |a, b, c| M::volume(M::area(a, b), c);
    VolumeErrors {
        sides: volume(direction, edges, size).error(SIDES),
        side: volume(direction, edges, size).error(VOLUME),
        t: volume(edges, edges, size).error(T),
    }
}

/// The sign of the first component that is not zero.
fn sign<M: Arithmetic>(x: &[M::Area; 3]) -> Ordering {
    let first = if x[0] != M::Area::ZERO {
        x[0]
    } else if x[1] != M::Area::ZERO {
        x[1]
    } else {
        x[2]
    };
    compare(first, M::Area::ZERO)
}
