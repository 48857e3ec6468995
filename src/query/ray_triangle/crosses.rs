//! Which crossings count, by the rules and the range of the ray, in every arithmetic.

use core::cmp::Ordering;

use super::kernel::{Crossing, Setting, VolumeErrors};
use super::{Facing, HitRules};
use crate::arithmetic::{Embeds, Number, sign};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// The question where a ray crosses a triangle.
pub(super) struct Crosses<'a, S> {
    pub(super) ray: &'a Ray<S>,
    pub(super) triangle: &'a Triangle<S>,
    pub(super) rules: HitRules,
}

impl<S: Scalar> Crosses<'_, S> {
    /// Whether the range is t ≥ 0.
    #[inline(always)]
    pub(super) fn has_usual_range(&self) -> bool {
        self.ray.t_min() == Some(S::ZERO) && self.ray.t_max().is_none()
    }

    /// The vertices and the origin, and the direction.
    #[inline(always)]
    pub(super) fn rows(&self) -> [[S; 3]; 5] {
        let [a, b, c] = self.triangle.points();
        [a, b, c, self.ray.origin().to_array(), self.ray.direction().to_array()]
    }

    /// Whether the rules keep a hit on this side.
    #[inline(always)]
    pub(super) fn keeps(&self, is_front: bool) -> bool {
        self.rules.cull.keeps(Facing::of(is_front))
    }

    /// Ray and triangle in `N`, if `N` can hold them.
    #[inline(always)]
    pub(super) fn setting<N: Embeds<S>>(&self) -> Option<Setting<N::Length>> {
        let [a, b, c, o, d] = N::embed(&self.rows())?;
        Some(Setting::new(&[a, b, c, o], d))
    }

    /// What `found` makes of the crossing and its error bounds, if the crossing counts, in any range
    /// and including contacts; `None` in doubt. Exact crossings have no bounds.
    #[inline]
    pub(super) fn crossing<N: Embeds<S>, T>(
        &self,
        found: impl FnOnce(Crossing<N::Volume>, Option<VolumeErrors<N::Volume>>) -> T,
    ) -> Option<Option<T>> {
        let setting = self.setting::<N>()?;
        let sizes = setting.sizes();
        if !N::CERTAIN && !sizes.are_in_range() {
            return None;
        }
        let errors = if N::CERTAIN { None } else { Some(sizes.errors::<N>()) };
        // w is a difference of three determinants: twice the volume of a box's plane axis.
        let size = setting.size();
        let crossing = if N::is_narrow(size + size) {
            let crossing = setting.volumes::<N::Narrow>();
            crossing.meets(None)?.then(|| crossing.widened(N::widened))
        } else {
            let crossing = setting.volumes::<N>();
            crossing.meets(errors.as_ref())?.then_some(crossing)
        };
        let Some(crossing) = crossing else { return Some(None) };
        let counts = self.counts::<N>(&setting, &crossing, errors.as_ref())?;
        Some(if counts { Some(found(crossing, errors)) } else { None })
    }

    /// [`crossing`](Self::crossing) where numbers are large. By reference, because the volumes of a
    /// crossing take up to 4 KB.
    #[inline(never)]
    pub(super) fn large_crossing<N: Embeds<S>, T>(
        &self,
        found: impl FnOnce(&Crossing<N::Volume>) -> T,
    ) -> Option<Option<T>> {
        let setting = self.setting::<N>()?;
        let crossing = setting.large_volumes::<N>();
        let counts = crossing.meets_for_certain() && self.large_counts::<N>(&setting, &crossing)?;
        Some(if counts { Some(found(&crossing)) } else { None })
    }

    /// [`counts`](Self::counts), out of line: a range takes copies of volumes.
    #[inline(never)]
    fn large_counts<N: Embeds<S>>(
        &self,
        setting: &Setting<N::Length>,
        crossing: &Crossing<N::Volume>,
    ) -> Option<bool> {
        self.counts::<N>(setting, crossing, None)
    }

    /// Whether the crossing of a line that meets the triangle counts; `None` in doubt. Without
    /// `errors` all signs are certain.
    #[inline(always)]
    pub(super) fn counts<N: Embeds<S>>(
        &self,
        setting: &Setting<N::Length>,
        crossing: &Crossing<N::Volume>,
        errors: Option<&VolumeErrors<N::Volume>>,
    ) -> Option<bool> {
        let is_front = crossing.is_front();
        let zeros = if errors.is_none() { crossing.zeros() } else { [false; 3] };
        let Crossing { det, t, .. } = *crossing;
        // Once for both ends, because a branch on the side is almost random.
        let (det, t) = if is_front { (det, t) } else { (-det, -t) };
        let compare_with = |end: S| {
            if end == S::ZERO {
                let is_clear = errors.is_none_or(|errors| t.magnitude() > errors.t);
                return is_clear.then(|| sign(t));
            }
            // What is certain of its sign is rounded all the same.
            let [of_t, of_det] = if N::CERTAIN {
                [N::Volume::ZERO; 2]
            } else {
                [t.magnitude().error(1), det.error(1)]
            };
            let errors =
                errors.map_or([of_t, of_det], |errors| [errors.t + of_t, errors.side + of_det]);
            N::compare_quotient(t, det, errors, end)
        };
        self.admits(is_front, zeros, compare_with, |k| setting.perturbed_in::<N>(k))
    }

    /// Whether the crossing of a line that meets the triangle counts; `None` in doubt. `zeros` says
    /// which of w, u and v are zero, `compare_with` compares t with an end of the range, and
    /// `perturbed` is that of the setting.
    #[inline(always)]
    pub(super) fn admits(
        &self,
        is_front: bool,
        zeros: [bool; 3],
        compare_with: impl Fn(S) -> Option<Ordering>,
        perturbed: impl Fn(usize) -> Ordering,
    ) -> Option<bool> {
        if !self.keeps(is_front) {
            return Some(false);
        }
        let moved = |k: usize| oriented(perturbed(k), is_front);
        if self.rules.once {
            for (k, is_zero) in zeros.into_iter().enumerate() {
                if is_zero && moved(k) == Ordering::Less {
                    return Some(false);
                }
            }
        }
        let ends = [(self.ray.t_min(), Ordering::Greater), (self.ray.t_max(), Ordering::Less)];
        for (end, inside) in ends {
            let Some(end) = end else { continue };
            let is_inside = match compare_with(end)? {
                Ordering::Equal => !self.rules.once || moved(3) == inside,
                side => side == inside,
            };
            if !is_inside {
                return Some(false);
            }
        }
        Some(true)
    }
}

/// The sign, as it is for a positive determinant.
#[inline(always)]
pub(super) fn oriented(sign: Ordering, is_front: bool) -> Ordering {
    if is_front { sign } else { sign.reverse() }
}
