//! Where a ray crosses a triangle, and whether it does, as predicates: what each stage answers.

use super::crosses::Crosses;
use super::kernel::{Crossing, Sizes, VolumeErrors};
use super::refined::Met;
use super::residual::Numbers;
use super::rows::{Found, VolumeRows};
use super::sums::hit_in_sums;
use super::words::rounded;
use super::{Facing, Feature, Hit};
use crate::arithmetic::{
    Embeds, Filtered, InRaw, Number, OfFour, REGISTERS_ARE_WIDE, SMALL_CODE, WholeWord,
};
use crate::robust::{Clue, Numeric, Predicate, Stage, WordKernel, in_exact_numbers, note};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Ray, Triangle};

/// The question whether a ray hits a triangle.
pub(super) struct Hits<'a, S>(pub(super) Crosses<'a, S>);

impl<S: Scalar> Predicate<S> for Crosses<'_, S> {
    type Answer = Option<Hit<S>>;

    fn filter<N: Embeds<S>>(&self) -> Option<Option<Hit<S>>> {
        if N::LARGE {
            return self.large_crossing::<N, _>(large_numbers::<S, N>);
        }
        let found = |crossing, errors| numbers::<S, N>(true, crossing, errors);
        let hit = self.crossing::<N, _>(found).and_then(|found| found.unwrap_or(Some(None)));
        // A core without `f64` tries short multiples before it.
        let is_before_doubles = S::MAY_BE_SHORT && !N::CERTAIN && !N::HAS_QUOTIENTS;
        if is_before_doubles && !REGISTERS_ARE_WIDE && !SMALL_CODE && hit.is_none() {
            return self.in_multiples().inspect(|_| note(Stage::Filter));
        }
        hit
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Self::Answer>
    where
        S: FixedBackend,
    {
        S::in_machine_words(self)
    }

    fn exact(&self) -> Option<Hit<S>> {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
        self.in_sums(hit_in_sums)
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Crosses<'_, S> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Option<Hit<S>>> {
        self.in_words::<W, _>(|counted| counted.map(|counted| rounded(&counted)))
    }
}

impl<S: Scalar> Numeric<S> for Crosses<'_, S> {
    #[inline(always)]
    fn fast_path(&self) -> Result<Option<Hit<S>>, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (counts, Found { crossing, sizes, .. }) = self.ahead()?;
        if <Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS {
            // More accurate numbers are computed out of line, so that the common path returns no
            // result of a call.
            let errors = sizes.errors::<Filtered<f64>>();
            return numbers::<S, Filtered<f64>>(counts, crossing, Some(errors))
                .ok_or(Clue::NoNumbers);
        }
        if !counts {
            return Ok(None);
        }
        let Crossing { det, t, sides: [_, u, v] } = crossing;
        let Sizes { direction, edges, size } = sizes;
        refined_hit(self.ray, self.triangle, det, t, u, v, direction, edges, size)
            .map(Some)
            .ok_or(Clue::NoNumbers)
    }

    fn refined(&self, clue: Clue) -> Option<Option<Hit<S>>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (points, d) = doubles(self.ray, self.triangle);
        let by_rest = |feature| {
            let rows = VolumeRows::<<f64 as OfFour>::Quad>::new(&points, d);
            let Sizes { direction, edges, size } = rows.sizes()?;
            let [det, t, u, v] = rows.volumes();
            let hit = refined_hit(self.ray, self.triangle, det, t, u, v, direction, edges, size);
            hit.map(|hit| Some(Hit { feature, ..hit }))
        };
        if clue == Clue::NoNumbers {
            // `f64` has already tried this, and fixed point uses integers.
            let is_f32 = S::FLOAT.is_some() && <Filtered<f64> as Embeds<S>>::HAS_QUOTIENTS;
            return if is_f32 { by_rest(Feature::Interior) } else { None };
        }
        let Some(Met { feature, det, quotients }) = self.refined_crossing(&points, d)? else {
            return Some(None);
        };
        match quotients {
            Some(quotients) => hit(&Numbers::known(quotients), det, feature).map(Some),
            None => by_rest(feature),
        }
    }
}

impl<S: Scalar> Predicate<S> for Hits<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        if N::LARGE {
            return self.0.large_crossing::<N, _>(|_| ()).map(|found| found.is_some());
        }
        self.0.crossing::<N, _>(|_, _| ()).map(|found| found.is_some())
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<Self::Answer>
    where
        S: FixedBackend,
    {
        S::in_machine_words(self)
    }

    fn exact(&self) -> bool {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
        self.0.in_sums(|_| ()).is_some()
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Hits<'_, S> {
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<bool> {
        self.0.in_words::<W, _>(|counted| counted.is_some())
    }
}

impl<S: Scalar> Numeric<S> for Hits<'_, S> {
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
}

/// The hit at a crossing in large numbers.
#[inline(never)]
fn large_numbers<S: Scalar, N: Embeds<S>>(crossing: &Crossing<N::Volume>) -> Hit<S> {
    let Crossing { det, t, sides: [_, u, v] } = crossing;
    let ([t, u, v], _) = N::quotients([*t, *u, *v], *det, [Number::ZERO; 2]);
    let (facing, feature) = (Facing::of(crossing.is_front()), crossing.feature());
    Hit { t, u, v, facing, feature }
}

/// The hit, if it counts; `None` if the numbers in `N` are not accurate enough.
#[inline(always)]
fn numbers<S: Scalar, N: Embeds<S>>(
    counts: bool,
    crossing: Crossing<N::Volume>,
    errors: Option<VolumeErrors<N::Volume>>,
) -> Option<Option<Hit<S>>> {
    let facing = Facing::of(crossing.is_front());
    let feature = if errors.is_none() { crossing.feature() } else { Feature::Interior };
    let Crossing { det, t, sides: [_, u, v] } = crossing;
    let errors = errors.map_or([N::Volume::ZERO; 2], |errors| [errors.t, errors.side]);
    // Divides even for a miss, because that costs less than a mispredicted branch.
    let ([t, u, v], are_good) = N::quotients_of_row([det, t, u, v], errors);
    if counts & !are_good {
        return None;
    }
    let hit = Hit { t, u, v, facing, feature };
    Some(if counts { Some(hit) } else { None })
}

/// The hit, if there certainly is one, from these volumes and sizes, each in a register.
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
    hit(&Numbers::new(true, &points, d, [det, t, u, v], sizes), det, Feature::Interior)
}

/// The hit, if its numbers are accurate enough.
#[inline(always)]
fn hit<S: Scalar>(numbers: &Numbers, det: f64, feature: Feature) -> Option<Hit<S>>
where
    Filtered<f64>: Embeds<S>,
{
    let ([t, u, v], are_good) = numbers.rounded::<S>();
    are_good.then_some(Hit { t, u, v, facing: Facing::of(det > 0.0), feature })
}

/// The triangle and the origin, and the direction, in `f64`.
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
