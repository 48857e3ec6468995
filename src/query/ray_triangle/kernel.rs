//! The crossing of a line and the plane of a triangle, as volumes: the kernel of the exact
//! ray/triangle query, in any number system.

use core::cmp::Ordering;

use super::Feature;
use super::error_bound::{SIDES, T, VOLUME};
use crate::arithmetic::{Arithmetic, Number, cross, dot, greatest, largest, least, sign, three};

/// A line and a triangle, relative to the triangle's first vertex.
#[derive(Clone, Copy)]
pub(super) struct Setting<L> {
    /// The direction.
    pub(super) d: [L; 3],
    /// The edges to the second and the third vertex.
    pub(super) e: [[L; 3]; 2],
    /// From the first vertex to the origin.
    pub(super) s: [L; 3],
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

impl<L: Copy> Setting<L> {
    /// The sign of a volume, `k` = 0, 1, 2 for w, u, v and 3 for t, if the origin moves by an
    /// infinitesimal amount along the first axis, by one infinitely smaller along the second, and
    /// again along the third. For a positive determinant. Each sign is a derivative with respect to
    /// the origin: the sign of the first component of a cross product that is not zero.
    pub(super) fn perturbed(
        &self,
        k: usize,
        difference: impl FnOnce(&[L; 3], &[L; 3]) -> [L; 3],
        first_sign: impl FnOnce(&[L; 3], &[L; 3]) -> Ordering,
    ) -> Ordering {
        let Self { d, e: [e1, e2], .. } = self;
        match k {
            0 => first_sign(d, &difference(e1, e2)),
            1 => first_sign(d, e2),
            2 => first_sign(e1, d),
            _ => first_sign(e1, e2),
        }
    }
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
        let Sizes { direction, size, .. } = self.sizes();
        greatest(direction, size)
    }

    #[inline(always)]
    pub(super) fn sizes(&self) -> Sizes<L> {
        let Self { d, e: [e1, e2], s } = self;
        let edges = greatest(largest(e1), largest(e2));
        Sizes { direction: largest(d), edges, size: greatest(edges, largest(s)) }
    }

    /// The volumes.
    ///
    /// T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
    /// *Journal of Graphics Tools* 2(1), 1997.
    #[inline(always)]
    pub(super) fn volumes<M: Arithmetic<Length = L>>(&self) -> Crossing<M::Volume> {
        let Self { d, e: [e1, e2], s } = self;
        let p = cross::<M>(d, e2);
        let q = cross::<M>(s, e1);
        let (det, u, v) = (dot::<M>(&p, e1), dot::<M>(&p, s), dot::<M>(&q, d));
        Crossing { det, t: dot::<M>(&q, e2), sides: [det - u - v, u, v] }
    }

    /// [`volumes`](Self::volumes) in large numbers. Out of line, so that their stack is free again
    /// afterwards.
    #[inline(never)]
    pub(super) fn large_volumes<M: Arithmetic<Length = L>>(&self) -> Crossing<M::Volume> {
        self.volumes::<M>()
    }

    /// [`perturbed`](Self::perturbed) in the areas of `M`. Out of line: it is seldom needed, and takes
    /// registers from what comes before.
    #[inline(never)]
    pub(super) fn perturbed_in<M: Arithmetic<Length = L>>(&self, k: usize) -> Ordering {
        let difference = |a: &[L; 3], b: &[L; 3]| three(|i| a[i] - b[i]);
        self.perturbed(k, difference, |a, b| {
            let signs = cross::<M>(a, b).map(sign);
            signs[0].then(signs[1]).then(signs[2])
        })
    }
}

impl<L: Number> Sizes<L> {
    /// Whether the error bounds hold.
    #[inline(always)]
    pub(super) fn are_in_range(&self) -> bool {
        self.direction.in_range() & self.edges.in_range() & self.size.in_range()
    }

    /// The error bounds of the volumes, for sizes in range.
    #[inline(always)]
    pub(super) fn errors<M: Arithmetic<Length = L>>(&self) -> VolumeErrors<M::Volume> {
        let Self { direction, edges, size } = *self;
        let volume = |a, b, c| M::volume(M::area(a, b), c);
        VolumeErrors {
            sides: volume(direction, edges, size).error(SIDES),
            side: volume(direction, edges, size).error(VOLUME),
            t: volume(edges, edges, size).error(T),
        }
    }
}

impl<V: Number> Crossing<V> {
    /// Whether the half-line from t = 0 crosses the triangle, if that is certain and it touches no
    /// boundary.
    ///
    /// The line crosses if w, u and v have the same sign, which is then also the determinant's, so
    /// the determinant needs no test. Everything is computed before the first branch, because a
    /// branch that is almost random costs more.
    #[inline(always)]
    pub(super) fn strictly_ahead(&self, errors: &VolumeErrors<V>) -> Option<bool> {
        let Self { t, sides: [w, u, v], .. } = *self;
        let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
        let (positive, negative) = (low > errors.sides, high < -errors.sides);
        let (ahead, behind) = (t > errors.t, t < -errors.t);
        let hit = (positive & ahead) | (negative & behind);
        // If there is a hit, no two of the four have opposite signs.
        let miss = ((low < -errors.sides) | behind) & ((high > errors.sides) | ahead);
        if hit ^ miss { Some(hit) } else { None }
    }

    /// Whether the line crosses the triangle or touches it; `None` in doubt. A line parallel to the
    /// plane does not. Without `errors` all signs are certain.
    #[inline]
    pub(super) fn meets(&self, errors: Option<&VolumeErrors<V>>) -> Option<bool> {
        let Self { det, sides: [w, u, v], .. } = *self;
        let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
        let error = errors.map_or(V::ZERO, |errors| errors.sides);
        if low < -error && high > error {
            Some(false)
        } else if errors.is_none() {
            Some(det != V::ZERO)
        } else {
            (low > error || high < -error).then_some(true)
        }
    }

    /// [`meets`](Self::meets) for large numbers, which are certain. Without copies of volumes.
    pub(super) fn meets_for_certain(&self) -> bool {
        let is_positive = self.is_front();
        !self.det.is_zero()
            && self.sides.iter().all(|x| x.is_zero() || x.is_positive() == is_positive)
    }

    /// The same in wider volumes.
    #[inline(always)]
    pub(super) fn widened<W>(self, widen: fn(V) -> W) -> Crossing<W> {
        let [w, u, v] = self.sides;
        Crossing { det: widen(self.det), t: widen(self.t), sides: [widen(w), widen(u), widen(v)] }
    }

    /// Which of w, u and v are zero.
    #[inline(always)]
    pub(super) fn zeros(&self) -> [bool; 3] {
        let [w, u, v] = &self.sides;
        [w.is_zero(), u.is_zero(), v.is_zero()]
    }

    /// The part of the triangle that is hit, if no sign is in doubt.
    #[inline(always)]
    pub(super) fn feature(&self) -> Feature {
        let [w, u, v] = self.zeros();
        Feature::from_zeros(w, u, v)
    }

    /// Whether the line runs against the normal.
    #[inline(always)]
    pub(super) fn is_front(&self) -> bool {
        self.det.is_positive()
    }
}

/// The truth, for unit tests of error bounds.
#[cfg(test)]
pub(super) mod truth {
    use super::{Crossing, Ordering, Setting};
    use crate::arithmetic::{BigInt, Embeds, Float, FullF64};
    use crate::robust::ExactSum;
    use crate::scalar::Backend;

    /// The volumes of the triangle and the origin, exactly.
    pub(in super::super) fn exact_crossing(
        [a, b, c, o]: [[f64; 3]; 4],
        d: [f64; 3],
    ) -> Crossing<BigInt<132>> {
        let [a, b, c, o, d] = FullF64::embed_held(&[a, b, c, o, d]);
        Setting::new(&[a, b, c, o], d).volumes::<FullF64>().widened(|volume| volume.resized())
    }

    /// Whether `exact` differs from the sum of the computed numbers by more than `bound`.
    pub(in super::super) fn exceeds(exact: &BigInt<132>, computed: &[f64], bound: f64) -> bool {
        let beyond = |bound: f64| {
            let mut sum = *exact;
            for part in computed.iter().map(|x| -x).chain([bound]) {
                sum.add(&[Float::parts(part), f64::ONE, f64::ONE]);
            }
            ExactSum::sign(&sum)
        };
        beyond(-bound) == Ordering::Greater || beyond(bound) == Ordering::Less
    }
}
