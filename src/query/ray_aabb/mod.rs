//! Ray against axis-aligned box: the exact verdict, and where the ray enters and leaves.
//!
//! Slabs, with cross-multiplied comparisons in place of divisions; see `line_aabb`. For one ray and
//! many boxes see `prepared`.

mod error_bound;
mod faces;
mod prepared;

pub use prepared::PreparedRay;

use super::Overlaps;
use super::line_aabb::Slabs;
#[cfg(feature = "fixed")]
use crate::arithmetic::IntNear;
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, least, two_difference};
#[cfg(feature = "fixed")]
use crate::robust::only_stage;
use crate::robust::{Numeric, Predicate, Profile, Uncertain};
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Aabb, AabbForm, Ray};

/// The ends of a ray's range.
type Ends<N> = [Option<<N as Arithmetic>::Length>; 2];

/// The slabs, the ends of the ray's range, and the unit of length.
type Line<N> = (Slabs<N>, Ends<N>, <N as Arithmetic>::Length);

/// Does the ray miss the box?
struct Disjoint<'a, S> {
    ray: &'a Ray<S>,
    aabb: &'a Aabb<S>,
}

impl<S: Scalar> Disjoint<'_, S> {
    /// `None` if the numbers do not fit.
    #[inline(always)]
    fn line<N: Embeds<S>>(&self) -> Option<Line<N>> {
        let Self { ray, aabb } = self;
        let (from, to) = (ray.t_min(), ray.t_max());
        let (AabbForm::Center { center: p, half: q } | AabbForm::Corners { min: p, max: q }) =
            aabb.form();
        let ends = [from.unwrap_or(S::ZERO), to.unwrap_or(S::ZERO), ray.unit()];
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        let all = [o, d, p.to_array(), q.to_array(), ends];
        let [o, d, p, q, [t0, t1, unit]] = N::embed(&all)?;
        let line = match aabb.form() {
            AabbForm::Center { .. } => Slabs::<N>::in_center(&o, &d, &p, &q),
            AabbForm::Corners { .. } => Slabs::<N>::in_corners(&o, &d, &p, &q),
        };
        Some((line, [from.map(|_| t0), to.map(|_| t1)], unit))
    }

    /// The slabs, and whether the ray misses the box; `None` if the numbers do not fit.
    #[inline(always)]
    fn slabs<N: Embeds<S>>(&self) -> Option<(Slabs<N>, Option<bool>)> {
        let (line, [from, to], unit) = self.line::<N>()?;
        // If the range begins at zero, as for most rays, a sign suffices.
        let from_zero = self.ray.t_min() == Some(S::ZERO);
        let mut faces = if from_zero { line.lies_before() } else { Uncertain::NONE };
        let from = from.filter(|_| !from_zero);
        if faces.certain {
            return Some((line, Some(true)));
        }
        if from.is_some() || to.is_some() {
            faces = faces.or(line.lies_outside::<S>(from, to, unit));
        }
        let verdict = faces.or(line.line_misses()).verdict();
        Some((line, verdict))
    }
}

impl<S: Scalar> Predicate<S> for Disjoint<'_, S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    #[inline(always)]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.slabs::<N>()?.1
    }
}

/// Where does the ray enter and leave the box?
struct Range<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Ray<S> {
    /// The part of the ray's own range between two values of t.
    pub(super) fn clipped(&self, enter: S, leave: S) -> (S, S) {
        let within = |mut t: S| {
            t = self.t_min().map_or(t, |min| greatest(min, t));
            self.t_max().map_or(t, |max| least(max, t))
        };
        let enter = within(enter);
        // In floats one value may be rounded up and the second down.
        (enter, greatest(enter, within(leave)))
    }
}

impl<S: Scalar> Predicate<S> for Range<'_, S> {
    type Answer = Option<(S, S)>;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<Option<(S, S)>> {
        let (line, misses) = self.0.slabs::<N>()?;
        if misses? {
            return Some(None);
        }
        // Not every system has quotients, and the answer must not depend on the system.
        if !N::DIVIDES {
            return None;
        }
        let Self(Disjoint { ray, aabb }) = self;
        let mut range: Option<(S, S)> = None;
        for i in 0..3 {
            if line.m[i] == N::Length::ZERO {
                continue;
            }
            let (near, far) = match aabb.form() {
                AabbForm::Center { center, half } if !N::CERTAIN => {
                    let row = |x: S| [x, S::ZERO, S::ZERO];
                    let (c, h) = (center.to_array()[i], half.to_array()[i]);
                    let o = ray.origin().to_array()[i];
                    let [[c, ..], [h, ..], [o, ..]] = N::embed(&[row(c), row(h), row(o)])?;
                    let falls = ray.direction().to_array()[i] < S::ZERO;
                    let (c, o) = if falls { (-c, -o) } else { (c, o) };
                    (compensated::<N>(c, o, -h)?, compensated::<N>(c, o, h)?)
                }
                _ => (line.near[i], line.far[i]),
            };
            // A difference may overflow where t does not.
            if !is_finite(near) || !is_finite(far) {
                return None;
            }
            let (enter, leave) =
                (N::quotient_of_lengths(near, line.m[i]), N::quotient_of_lengths(far, line.m[i]));
            range =
                Some(range.map_or((enter, leave), |(from, to)| {
                    (greatest(from, enter), least(to, leave))
                }));
        }
        // Some component of the direction is not zero.
        Some(range.map(|(enter, leave)| ray.clipped(enter, leave)))
    }
}

impl<S: Scalar> Numeric<S> for Range<'_, S> {}

/// Whether a number is finite. Integers always are.
#[allow(clippy::eq_op)] // an infinity minus itself is a NaN
#[inline(always)]
fn is_finite<L: Number>(x: L) -> bool {
    x - x == L::ZERO
}

/// Roundoffs of its terms that a sum must exceed, so that the correction for its roundings is known
/// well enough. `compensated.g` proves it.
const LEFT: u16 = 128;

/// c − o + h in floats, less than 1.02 roundings from the truth; `None` if cancellation may make it
/// more.
fn compensated<N: Arithmetic>(c: N::Length, o: N::Length, h: N::Length) -> Option<N::Length> {
    let [along, error] = two_difference(c, o);
    let [length, second] = two_difference(along, -h);
    let lost = error + second;
    let result = length + lost;
    // The rounding of the correction, twice, is all that remains.
    let error_bound = (along.magnitude() + h.magnitude()).error(LEFT);
    (lost == N::Length::ZERO || result.magnitude() >= error_bound).then_some(result)
}

impl<S: Scalar> Overlaps<Aabb<S>> for Ray<S> {
    /// Does the ray, within its range of t, have a point in common with the axis-aligned box?
    ///
    /// *Geometry*: closed sets in one frame and one unit; the ends of the range belong to the ray.
    /// A ray within a face or along an edge meets the box. So does a ray that starts there and
    /// leads away. +0 and −0 are alike.
    ///
    /// *Contact*: touching counts as overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar and for every range.
    ///
    /// *Range*: all finite floats and all fixed-point values. The fast stage serves floats if
    /// coordinate differences, the direction and the ends of the range are zero or between 2⁻³² and
    /// 2⁴⁰ (`f32`) or 2⁻³²⁰ and 2³²⁰ (`f64`). It serves fixed point if coordinates, the
    /// direction and the ends of the range are below 2²⁸ (32 bits) or 2⁶⁰ (64 bits) units in the last
    /// place, and 8 and 16 bits always. Outside, and for floats within rounding of contact, wider numbers
    /// decide, up to a thousand times slower.
    ///
    /// *Panics*: never. *Cost*: 12 multiplications, 6 differences, no division; up to 6
    /// multiplications more for a range other than t ≥ 0.
    ///
    /// For many boxes on one ray a [`PreparedRay`] takes a fraction of the time and is as exact.
    ///
    /// *Source*: slabs after Kay and Kajiya 1986; cross-multiplied, they are the separating axes of
    /// *Real-Time Rendering* 16.7. The exact stages are ours.
    ///
    /// ```
    /// use septum::{Aabb, Ray};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let ray = Ray::new([1.0, 0.0, -3.0], [0.0, -0.0, 1.0])?;
    /// assert!(ray.overlaps(&cell)); // along an edge
    /// assert!(!ray.with_range(0.0, 2.5)?.overlaps(&cell)); // not yet there
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        !S::evaluate(&Disjoint { ray: self, aabb })
    }

    /// May the ray and the axis-aligned box have a point in common?
    ///
    /// *Numerics*: `false` is certain. Fixed point is exact, except that 64 bits answer `true`
    /// beyond 2⁶⁰ units in the last place. Floats answer `true` within a few roundings of contact,
    /// and outside the range of the first stage of [`overlaps`](Overlaps::overlaps).
    ///
    /// *Panics*: never. *Cost*: bounded. In floats it is the first stage of
    /// [`overlaps`](Overlaps::overlaps), and in fixed point of up to 32 bits
    /// [`overlaps`](Overlaps::overlaps) itself. For many boxes on one ray see [`PreparedRay`].
    #[inline]
    fn may_overlap(&self, aabb: &Aabb<S>) -> bool {
        S::evaluate_bounded(&Disjoint { ray: self, aabb }) != Some(true)
    }
}

impl<S: Scalar> Ray<S> {
    /// Where does the ray enter the axis-aligned box, and where does it leave it? As values of t;
    /// `None` if it misses the box.
    ///
    /// *Geometry*: the part of the ray's range that lies in the box, in units of the direction. A
    /// ray that starts in the box enters it where its range begins.
    ///
    /// *Contact*: touching counts as overlap; the two values may be equal.
    ///
    /// *Numerics*: the verdict is exact, as in [`overlaps`](Ray::overlaps). In fixed point the
    /// values are rounded to the nearest, ties to even, and values beyond the type are its end.
    /// `f32` is within 0.51 units in the last place, `f64` within 1.6. A float may overflow to an
    /// infinity, and below the least normal number it errs by the spacing there.
    ///
    /// *Range*: as for [`overlaps`](Ray::overlaps).
    ///
    /// *Panics*: never. *Cost*: as for [`overlaps`](Ray::overlaps), and up to six divisions.
    /// Use it for a single box, after a traversal by a [`PreparedRay`].
    ///
    /// ```
    /// use septum::{Aabb, Ray};
    ///
    /// let cell = Aabb::from_min_max([1.0, 0.0, 0.0], [3.0, 1.0, 1.0])?;
    /// let ray = Ray::new([0.0, 0.5, 0.5], [2.0, 0.0, 0.0])?;
    /// assert_eq!(ray.t_range(&cell), Some((0.5, 1.5)));
    /// assert_eq!(ray.with_range(1.0, None)?.t_range(&cell), Some((1.0, 1.5)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn t_range(&self, aabb: &Aabb<S>) -> Option<(S, S)> {
        S::evaluate_numeric(&Range(Disjoint { ray: self, aabb }))
    }
}

// Faces lie within 2^20 of zero, also in a tree over a near mesh. Sums of lengths are below 2^21.
// Their products with a direction up to 2^19 and with 2·one up to 2^33 are below 2^54. The product of
// an end of the range with the doubled direction is at most 2^51.
#[cfg(feature = "fixed")]
impl<S: Scalar> Overlaps<Near<Aabb<S>>> for Near<Ray<S>>
where
    IntNear: Embeds<S>,
{
    /// Does a ray near the origin have a point in common with an axis-aligned box there?
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact for every range of t, in integers of 64
    /// bits. *Panics*: never. *Cost*: as for rays anywhere.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::{Aabb, Ray};
    ///
    /// let at = |x: i32, y: i32, z: i32| [x, y, z].map(|k| I16F16::from_bits(k << 12));
    /// let cell = Aabb::from_min_max(at(0, 0, 0), at(8, 8, 8))?.near()?;
    /// let ray = Ray::new(at(8, 0, -16), at(0, 0, 4))?;
    /// assert!(ray.near()?.overlaps(&cell)); // along an edge
    /// let until = |t: f32| ray.with_range(I16F16::ZERO, I16F16::from_num(t));
    /// assert!(until(4.0)?.near()?.overlaps(&cell) && !until(3.9)?.near()?.overlaps(&cell));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, aabb: &Near<Aabb<S>>) -> bool {
        let disjoint = Disjoint { ray: self.get(), aabb: aabb.get() };
        !only_stage::<_, IntNear, _>(&disjoint)
    }
}
