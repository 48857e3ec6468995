//! Which crossings count, by the rules and the range of the ray, in number systems.

use core::cmp::Ordering;

use super::crossing::{Crossing, Setting, Sizes};
use super::exact::ExactRay;
use super::rows::{First, Found, VolumeRows, begins_elsewhere, first};
use super::{Facing, HitRules};
use crate::arithmetic::{Embeds, Filtered, Number, OfFour, compare, largest};
use crate::robust::{Clue, ExactSum, Stage, note};
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
    fn has_usual_range(&self) -> bool {
        self.ray.t_min() == Some(S::ZERO) && self.ray.t_max().is_none()
    }

    /// Whether a crossing ahead of the origin counts, and the crossing. `Err` if it is a contact,
    /// or the range is not t ≥ 0.
    #[inline(always)]
    pub(super) fn ahead(&self) -> Result<(bool, Crossing<f64>, Sizes<f64>), Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        if !self.has_usual_range() {
            return Err(Clue::Unasked);
        }
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        let [a, b, c, o, d] = Filtered::<f64>::embed(&[a, b, c, o, d]).ok_or(Clue::Doubt)?;
        let rows = VolumeRows::<<f64 as OfFour>::Quad>::new(&[a, b, c, o], d);
        let Found { is_ahead, crossing, sizes } = rows.found().ok_or(Clue::Doubt)?;
        let keeps = self.rules.cull.keeps(Facing::of(crossing.is_front()));
        Ok((is_ahead & keeps, crossing, sizes))
    }

    /// Whether a crossing ahead of the origin counts, in the scalar's first float, for scalars
    /// whose [`Ray::hit`](crate::Ray::hit) begins with another stage. `None` near contact.
    #[inline(always)]
    pub(super) fn counts_in_first(&self) -> Option<bool> {
        if !begins_elsewhere::<S>() || !self.has_usual_range() {
            return None;
        }
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        let [a, b, c, o, d] = [first(a), first(b), first(c), first(o), first(d)];
        if let Some(limit) = S::FIRST_LIMIT {
            let is_held = |p: &[First<S>; 3]| largest(p) < limit;
            if !(is_held(&a) & is_held(&b) & is_held(&c) & is_held(&o) & is_held(&d)) {
                return None;
            }
        }
        let Some(found) = VolumeRows::<<First<S> as OfFour>::Quad>::new(&[a, b, c, o], d).found()
        else {
            note(Stage::Filter);
            return None;
        };
        Some(found.is_ahead & self.rules.cull.keeps(Facing::of(found.crossing.is_front())))
    }

    /// Ray and triangle in `N`, if `N` can hold them.
    #[inline(always)]
    pub(super) fn setting<N: Embeds<S>>(&self) -> Option<Setting<N::Length>> {
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        let [a, b, c, o, d] = N::embed(&[a, b, c, o, d])?;
        Some(Setting::new(&[a, b, c, o], d))
    }

    /// The crossing, if it counts, in any range and including contacts; `None` in doubt.
    #[inline]
    pub(super) fn crossing<N: Embeds<S>>(&self) -> Option<Option<Crossing<N::Volume>>> {
        let setting = self.setting::<N>()?;
        // w is a difference of three determinants: twice the volume of a box's plane axis.
        let size = setting.size();
        let crossing = if N::is_narrow(size + size) {
            let crossing = setting.crossing::<N::Narrow>()?;
            crossing.meets(N::CERTAIN)?.then(|| crossing.widened(N::widened))
        } else {
            let crossing = setting.crossing::<N>()?;
            crossing.meets(N::CERTAIN)?.then_some(crossing)
        };
        let Some(crossing) = crossing else { return Some(None) };
        Some(self.counts::<N>(&setting, &crossing, N::CERTAIN)?.then_some(crossing))
    }

    /// The same where numbers are large, and what `found` makes of the crossing. By reference, because
    /// the volumes of a crossing take up to 6 KB.
    #[inline(never)]
    pub(super) fn large_crossing<N: Embeds<S>, T>(
        &self,
        found: impl FnOnce(&Crossing<N::Volume>) -> T,
    ) -> Option<Option<T>> {
        let setting = self.setting::<N>()?;
        let crossing = setting.large_crossing::<N>();
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
        self.counts::<N>(setting, crossing, true)
    }

    /// Whether the crossing of a line that meets the triangle counts; `None` in doubt. `is_certain`
    /// says that all signs are certain.
    #[inline(always)]
    pub(super) fn counts<N: Embeds<S>>(
        &self,
        setting: &Setting<N::Length>,
        crossing: &Crossing<N::Volume>,
        is_certain: bool,
    ) -> Option<bool> {
        let zero = N::Volume::ZERO;
        let is_front = crossing.is_front();
        if !self.rules.cull.keeps(Facing::of(is_front)) {
            return Some(false);
        }
        if is_certain && self.rules.once {
            for (k, side) in crossing.sides.iter().enumerate() {
                let perturbed = || oriented(setting.perturbed_side::<N>(k), is_front);
                if *side == zero && perturbed() == Ordering::Less {
                    return Some(false);
                }
            }
        }
        if N::LARGE && self.has_usual_range() {
            let side = oriented(compare(crossing.t, zero), is_front);
            let perturbed = || oriented(setting.perturbed_t::<N>(), is_front);
            return Some(self.admits(side, Ordering::Greater, perturbed));
        }
        let Crossing { det, t, error_bound, .. } = *crossing;
        let (det, t) = if is_front { (det, t) } else { (-det, -t) };
        for (end, inside) in self.ends() {
            let Some(end) = end else { continue };
            let side = if end == S::ZERO {
                let is_clear = is_certain || t.magnitude() > error_bound.t;
                is_clear.then(|| t.partial_cmp(&zero)).flatten()
            } else {
                let errors =
                    [error_bound.t + t.magnitude().error(1), error_bound.side + det.error(1)];
                N::compare_quotient(t, det, errors, end)
            }?;
            let perturbed = || oriented(setting.perturbed_t::<N>(), is_front);
            if !self.admits(side, inside, perturbed) {
                return Some(false);
            }
        }
        Some(true)
    }

    /// The ends of the range, and the side of each end on which the range lies.
    #[inline(always)]
    pub(super) fn ends(&self) -> [(Option<S>, Ordering); 2] {
        [(self.ray.t_min(), Ordering::Greater), (self.ray.t_max(), Ordering::Less)]
    }

    pub(super) fn taken_apart(&self) -> ExactRay {
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        ExactRay::new(&self.triangle.points(), &o, &d)
    }

    /// Whether a crossing counts, by exact sums, and if so whether the line runs against the
    /// normal.
    pub(super) fn passes(
        &self,
        exact: &ExactRay,
        det: &S::SeptumSum,
        sides: &[S::SeptumSum; 3],
        t: &S::SeptumSum,
    ) -> Option<bool> {
        let det = det.sign();
        let is_front = det == Ordering::Greater;
        if det == Ordering::Equal || !self.rules.cull.keeps(Facing::of(is_front)) {
            return None;
        }
        for (k, side) in sides.iter().enumerate() {
            let perturbed = || oriented(exact.perturbed_side::<S>(k), is_front);
            if !self.admits(oriented(side.sign(), is_front), Ordering::Greater, perturbed) {
                return None;
            }
        }
        for (end, inside) in self.ends() {
            let Some(end) = end else { continue };
            let side = if end == S::ZERO { t.sign() } else { exact.compare(end) };
            let perturbed = || oriented(exact.perturbed_t::<S>(), is_front);
            if !self.admits(oriented(side, is_front), inside, perturbed) {
                return None;
            }
        }
        Some(is_front)
    }

    /// Whether a value on this side of an end counts, if only values `inside` do.
    #[inline(always)]
    pub(super) fn admits(
        &self,
        side: Ordering,
        inside: Ordering,
        perturbed: impl Fn() -> Ordering,
    ) -> bool {
        match side {
            Ordering::Equal if self.rules.once => perturbed() == inside,
            Ordering::Equal => true,
            side => side == inside,
        }
    }
}

/// The sign, as it is for a positive determinant.
#[inline(always)]
fn oriented(sign: Ordering, is_front: bool) -> Ordering {
    if is_front { sign } else { sign.reverse() }
}
