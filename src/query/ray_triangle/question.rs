//! The question where a ray crosses a triangle, and whether it does, for number systems and
//! exact sums to answer.

use core::cmp::Ordering;

use super::crossing::{Crossing, Setting, Sizes};
use super::exact::ExactRay;
use super::narrow::rounded;
use super::refined::Met;
use super::residual::Numbers;
use super::{Facing, Feature, Hit, HitRules};
use crate::arithmetic::{Embeds, Filtered, InWholeWord, Number, ShortFloat, WholeWord};
use crate::robust::{Clue, ExactSum, Predicate};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

/// The question where a ray crosses a triangle.
pub(super) struct Crosses<'a, S> {
    pub(super) ray: &'a Ray<S>,
    pub(super) triangle: &'a Triangle<S>,
    pub(super) rules: HitRules,
}

/// The question whether it does.
pub(super) struct Hits<'a, S>(pub(super) Crosses<'a, S>);

impl<S: Scalar> Predicate<S> for Crosses<'_, S> {
    type Answer = Option<Hit<S>>;

    fn filter<N: Embeds<S>>(&self) -> Option<Option<Hit<S>>> {
        match self.crossing::<N>()? {
            Some(crossing) => numbers::<S, N>(true, crossing),
            None => Some(None),
        }
    }

    #[inline(always)]
    fn fast_path(&self) -> Result<Option<Hit<S>>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (counts, crossing, sizes) = self.ahead()?;
        if <Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS {
            if let Some(hit) = numbers::<S, Filtered<f64>>(counts, crossing) {
                return Ok(hit);
            }
            if S::FLOAT.is_none() {
                return Err(Clue::NoNumbers);
            }
        } else if !counts {
            return Ok(None);
        }
        let Crossing { det, t, sides: [_, u, v], .. } = crossing;
        let Sizes { direction, edges, size } = sizes;
        refined_hit(self.ray, self.triangle, det, t, u, v, direction, edges, size)
            .map(Some)
            .ok_or(Clue::NoNumbers)
    }

    fn refined(&self, clue: Clue) -> Option<Option<Hit<S>>>
    where
        Filtered<f64>: Embeds<S>,
    {
        // If there are no numbers, they were looked for.
        if clue == Clue::NoNumbers {
            return None;
        }
        let (points, d) = doubles(self.ray, self.triangle);
        let Some(Met { feature, det, quotients }) = self.refined_crossing(&points, d)? else {
            return Some(None);
        };
        if let Some(quotients) = quotients {
            return hit(&Numbers::known(quotients), det, feature).map(Some);
        }
        let setting = Setting::new(&points, d);
        let Crossing { det, t, sides: [_, u, v], .. } = setting.volumes();
        let Sizes { direction, edges, size } = setting.sizes();
        let hit = refined_hit(self.ray, self.triangle, det, t, u, v, direction, edges, size);
        hit.map(|hit| Some(Hit { feature, ..hit }))
    }

    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Option<Hit<S>>>
    where
        S: InWholeWord<W>,
    {
        self.in_words::<W, _>(|counted| counted.map(|counted| rounded::<S, W>(&counted)))
    }

    #[inline(always)]
    fn in_short_multiples(&self) -> Option<Option<Hit<S>>>
    where
        S: ShortFloat,
    {
        self.in_multiples()
    }

    fn exact(&self) -> Option<Hit<S>> {
        let exact = self.taken_apart();
        let crossing = exact.crossing::<S>();
        let is_front = self.passes(&exact, &crossing.det, &crossing.sides, &crossing.t)?;
        let quotient = |x| S::quotient(x, &crossing.det);
        let [w, u, v] = &crossing.sides;
        let is_zero = |x: &S::Sum| x.sign() == Ordering::Equal;
        Some(Hit {
            t: quotient(&crossing.t),
            u: quotient(u),
            v: quotient(v),
            facing: facing(is_front),
            feature: Feature::from_zeros(is_zero(w), is_zero(u), is_zero(v)),
        })
    }
}

impl<S: Scalar> Predicate<S> for Hits<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.0.crossing::<N>().map(|crossing| crossing.is_some())
    }

    #[inline(always)]
    fn fast_path(&self) -> Result<bool, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        self.0.ahead().map(|(counts, ..)| counts)
    }

    fn refined(&self, _: Clue) -> Option<bool>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (points, d) = doubles(self.0.ray, self.0.triangle);
        self.0.refined_crossing(&points, d).map(|found| found.is_some())
    }

    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<bool>
    where
        S: InWholeWord<W>,
    {
        self.0.in_words::<W, _>(|counted| counted.is_some())
    }

    fn exact(&self) -> bool {
        let exact = self.0.taken_apart();
        let crossing = exact.crossing::<S>();
        self.0.passes(&exact, &crossing.det, &crossing.sides, &crossing.t).is_some()
    }
}

/// The hit, if it counts; `None` where `N` has no good numbers for it.
#[inline(always)]
fn numbers<S: Scalar, N: Embeds<S>>(
    counts: bool,
    crossing: Crossing<N::Volume>,
) -> Option<Option<Hit<S>>> {
    let facing = facing(crossing.is_front());
    let Crossing { det, t, sides: [_, u, v], error_bound } = crossing;
    let feature = if N::CERTAIN { crossing.feature() } else { Feature::Interior };
    // Even for a miss: to divide is cheaper than to guess wrong whether it is one.
    let ([t, u, v], are_good) = N::quotients([t, u, v], det, [error_bound.t, error_bound.side]);
    if counts & !are_good {
        return None;
    }
    let hit = Hit { t, u, v, facing, feature };
    Some(if counts { Some(hit) } else { None })
}

/// The hit, where there is one for certain, of these volumes and sizes: each in a register.
#[allow(clippy::too_many_arguments)]
#[inline(never)]
fn refined_hit<S: Scalar>(
    ray: &Ray<S>,
    triangle: &Triangle<S>,
    det: f64,
    t: f64,
    u: f64,
    v: f64,
    direction: f64,
    edges: f64,
    size: f64,
) -> Option<Hit<S>>
where
    Filtered<f64>: Embeds<S>,
{
    let (points, d) = doubles(ray, triangle);
    let sizes = Sizes { direction, edges, size };
    hit(&Numbers::new::<true>(&points, d, [det, t, u, v], sizes), det, Feature::Interior)
}

/// The hit, if its numbers are good.
#[inline(always)]
fn hit<S: Scalar>(numbers: &Numbers, det: f64, feature: Feature) -> Option<Hit<S>>
where
    Filtered<f64>: Embeds<S>,
{
    let ([t, u, v], are_good) = numbers.rounded::<S>();
    are_good.then_some(Hit { t, u, v, facing: facing(det > 0.0), feature })
}

/// The triangle and the origin, and the direction.
#[inline(always)]
fn doubles<S: Scalar>(ray: &Ray<S>, triangle: &Triangle<S>) -> ([[f64; 3]; 4], [f64; 3])
where
    Filtered<f64>: Embeds<S>,
{
    let [a, b, c] = triangle.points();
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let [a, b, c, o, d] = Filtered::<f64>::embed_held(&[a, b, c, o, d]);
    ([a, b, c, o], d)
}

#[inline(always)]
pub(super) fn facing(is_front: bool) -> Facing {
    if is_front { Facing::Front } else { Facing::Back }
}

impl<S: Scalar> Crosses<'_, S> {
    /// Whether a crossing ahead of the origin counts, and the crossing, where it is
    /// not a contact and the range is the usual one.
    #[inline(always)]
    fn ahead(&self) -> Result<(bool, Crossing<f64>, Sizes<f64>), Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        if self.ray.t_min() != Some(S::ZERO) || self.ray.t_max().is_some() {
            return Err(Clue::Unasked);
        }
        let setting = self.setting::<Filtered<f64>>().ok_or(Clue::Doubt)?;
        let crossing = setting.crossing::<Filtered<f64>>().ok_or(Clue::Doubt)?;
        let keeps = self.rules.cull.keeps(facing(crossing.is_front()));
        let is_ahead = crossing.strictly_ahead().ok_or(Clue::Doubt)?;
        Ok((is_ahead & keeps, crossing, setting.sizes()))
    }

    /// Ray and triangle in `N`, if it holds them.
    #[inline(always)]
    pub(super) fn setting<N: Embeds<S>>(&self) -> Option<Setting<N::Length>> {
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        let [a, b, c, o, d] = N::embed(&[a, b, c, o, d])?;
        Some(Setting::new(&[a, b, c, o], d))
    }

    /// The crossing, if it counts, contacts and any range included; `None` in doubt.
    #[inline]
    fn crossing<N: Embeds<S>>(&self) -> Option<Option<Crossing<N::Volume>>> {
        let setting = self.setting::<N>()?;
        // w is a difference of three determinants: twice what a box's plane comes to.
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

    /// Whether the crossing of a line that meets the triangle counts; `None` in doubt.
    /// `is_certain` says that all signs are.
    #[inline(always)]
    pub(super) fn counts<N: Embeds<S>>(
        &self,
        setting: &Setting<N::Length>,
        crossing: &Crossing<N::Volume>,
        is_certain: bool,
    ) -> Option<bool> {
        let zero = N::Volume::ZERO;
        let is_front = crossing.is_front();
        if !self.rules.cull.keeps(facing(is_front)) {
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

    /// The ends of the range, and on which side of each it lies.
    #[inline(always)]
    pub(super) fn ends(&self) -> [(Option<S>, Ordering); 2] {
        [(self.ray.t_min(), Ordering::Greater), (self.ray.t_max(), Ordering::Less)]
    }

    fn taken_apart(&self) -> ExactRay {
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        ExactRay::new(&self.triangle.points(), &o, &d)
    }

    /// Whether a crossing counts, by exact sums, and if so whether the line runs
    /// against the normal.
    fn passes(
        &self,
        exact: &ExactRay,
        det: &S::Sum,
        sides: &[S::Sum; 3],
        t: &S::Sum,
    ) -> Option<bool> {
        let det = det.sign();
        let is_front = det == Ordering::Greater;
        if det == Ordering::Equal || !self.rules.cull.keeps(facing(is_front)) {
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

    /// Whether what lies on this side of an end counts, if only `inside` does.
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

/// A sign, for a determinant above zero.
#[inline(always)]
fn oriented(sign: Ordering, is_front: bool) -> Ordering {
    if is_front { sign } else { sign.reverse() }
}
