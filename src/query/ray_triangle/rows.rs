//! The first stage in floats, without a branch before the verdict: for a pair, and for many pairs at
//! once ([`lanes`](crate::lanes)).
//!
//! A pair has the determinant, t, u and v side by side: the operations of [`Setting`] on the same
//! numbers, and so the same bits. det = (d × e2)·e1, t = (s × e1)·e2, u = (d × e2)·s,
//! v = (s × e1)·d. A row holds a component of e2, e1, d and s. The cross products combine its
//! second half (d, s, repeated) with its first half (e2, e1, repeated); the dot products multiply
//! them by the row with the two numbers in each half swapped. In vectors of two numbers none of
//! this moves data between vectors, and in vectors of four little.

use super::Candidate;
use super::crosses::Crosses;
use super::kernel::{Crossing, Setting, Sizes, VolumeErrors};
use super::residual::Numbers;
use crate::arithmetic::{
    Each, Embeds, Filtered, FirstFloat, Float, Number, OfFour, Quad, greatest, largest, least,
};
use crate::robust::{Clue, Stage, note};
use crate::scalar::Scalar;
use crate::shape::Ray;

type First<S> = <S as FirstFloat>::SeptumFirst;

impl<S: Scalar> Crosses<'_, S> {
    /// Whether a crossing ahead of the origin counts, and the crossing. `Err` if it is a contact,
    /// or the range is not t ≥ 0.
    #[inline(always)]
    pub(super) fn ahead(&self) -> Result<(bool, Found<f64>), Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        if !self.has_usual_range() {
            return Err(Clue::Unasked);
        }
        let [a, b, c, o, d] = Filtered::<f64>::embed(&self.rows()).ok_or(Clue::Doubt)?;
        let rows = VolumeRows::<<f64 as OfFour>::Quad>::new(&[a, b, c, o], d);
        let found = rows.found().ok_or(Clue::Doubt)?;
        Ok((found.is_ahead & self.keeps(found.crossing.is_front()), found))
    }

    /// Whether a crossing ahead of the origin counts, in the scalar's first float, for scalars
    /// whose [`Ray::hit`] begins with another stage. `None` near contact.
    #[inline(always)]
    pub(super) fn counts_in_first(&self) -> Option<bool> {
        let begins_elsewhere =
            S::IN_QUADS && (S::FLOAT.is_none() || size_of::<First<S>>() < size_of::<f64>());
        if !begins_elsewhere || !self.has_usual_range() {
            return None;
        }
        let ([a, b, c, o, d], true) = in_first(self.rows()) else { return None };
        let rows = VolumeRows::<<First<S> as OfFour>::Quad>::new(&[a, b, c, o], d);
        let Some(found) = rows.found() else {
            note(Stage::Filter);
            return None;
        };
        Some(found.is_ahead & self.keeps(found.crossing.is_front()))
    }
}

/// The points in the scalar's first float, and whether it holds them.
#[inline(always)]
fn in_first<S: FirstFloat>(points: [[S; 3]; 5]) -> ([[First<S>; 3]; 5], bool) {
    let [a, b, c, o, d] = points;
    let first = |point: [S; 3]| point.each(S::first);
    let points = [first(a), first(b), first(c), first(o), first(d)];
    let [a, b, c, o, d] = &points;
    let is_held = S::FIRST_LIMIT.is_none_or(|limit| {
        let is_held = |p: &[First<S>; 3]| largest(p) < limit;
        is_held(a) & is_held(b) & is_held(c) & is_held(o) & is_held(d)
    });
    (points, is_held)
}

/// Rows of a triangle and a ray.
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
    fn found(&self) -> Option<Found<F>> {
        let sizes = self.sizes()?;
        let [det, t, u, v] = self.volumes();
        let crossing = Crossing { det, t, sides: [det - u - v, u, v] };
        let errors = sizes.errors::<Filtered<F>>();
        Some(Found { is_ahead: strictly_ahead::<Q>(&crossing, &errors)?, crossing, sizes })
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
fn strictly_ahead<Q: Quad<Lane: Float>>(
    crossing: &Crossing<Q::Lane>,
    errors: &VolumeErrors<Q::Lane>,
) -> Option<bool> {
    let &Crossing { t, sides: [w, u, v], .. } = crossing;
    let VolumeErrors { sides, t: error, .. } = *errors;
    let (volumes, error) = (Q::new([w, t, u, v]), Q::new([sides, error, sides, sides]));
    let (positive, negative) =
        (volumes.exceeds(error), (Q::splat(Q::Lane::ZERO) - error).exceeds(volumes));
    let hit = (positive == 0b1111) | (negative == 0b1111);
    let miss = (positive != 0) & (negative != 0);
    if hit ^ miss { Some(hit) } else { None }
}

/// A ray and a triangle in `f64`, and whether the half-line from t = 0 certainly crosses it.
struct Clear {
    points: [[f64; 3]; 4],
    d: [f64; 3],
    sizes: Sizes<f64>,
    crossing: Crossing<f64>,
    errors: VolumeErrors<f64>,
    /// `None` in doubt, if the sizes are in range.
    is_ahead: Option<bool>,
}

impl Clear {
    #[inline(always)]
    fn new<S: Scalar>(ray: &Ray<S>, [a, b, c]: [[S; 3]; 3]) -> Self
    where
        Filtered<f64>: Embeds<S>,
    {
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        let [a, b, c, o, d] = Filtered::<f64>::embed_held(&[a, b, c, o, d]);
        let points = [a, b, c, o];
        let setting = Setting::new(&points, d);
        let (sizes, crossing) = (setting.sizes(), setting.volumes::<Filtered<f64>>());
        let errors = sizes.errors::<Filtered<f64>>();
        let is_ahead = crossing.strictly_ahead(&errors);
        Self { points, d, sizes, crossing, errors, is_ahead }
    }

    /// Whether the candidate with these numbers is certain, and the candidate.
    #[inline(always)]
    fn with<S: Scalar>(&self, (numbers, are_good): ([S; 3], bool)) -> (bool, Candidate<S>) {
        let (certain, hit) = match self.is_ahead {
            Some(hit) => (true, hit),
            None => (false, false),
        };
        let found = Candidate::new(hit & are_good, numbers, self.crossing.is_front(), [false; 3]);
        (self.sizes.are_in_range() & certain & (are_good | !hit), found)
    }
}

/// The bits of [`Ray::hit`] for a triangle, and whether they are certain: a hit clear of edges and
/// of the ray's ends, or a clear miss. For a ray with the range t ≥ 0.
#[inline(always)]
pub(crate) fn clear_hit<S: Scalar>(ray: &Ray<S>, triangle: [[S; 3]; 3]) -> (bool, Candidate<S>)
where
    Filtered<f64>: Embeds<S>,
{
    let clear = Clear::new(ray, triangle);
    let (Crossing { det, t, sides: [_, u, v] }, errors) = (clear.crossing, clear.errors);
    clear.with(Filtered::<f64>::quotients([t, u, v], det, [errors.t, errors.side]))
}

/// The same with numbers from the residual.
#[inline(always)]
pub(crate) fn clear_refined_hit<S: Scalar>(
    ray: &Ray<S>,
    triangle: [[S; 3]; 3],
) -> (bool, Candidate<S>)
where
    Filtered<f64>: Embeds<S>,
{
    let clear = Clear::new(ray, triangle);
    let Crossing { det, t, sides: [_, u, v] } = clear.crossing;
    let numbers = Numbers::new(false, &clear.points, clear.d, [det, t, u, v], clear.sizes);
    clear.with(numbers.rounded())
}

/// Whether the line of a ray certainly misses a triangle.
#[inline(always)]
pub(crate) fn line_clearly_misses<S: Scalar>(ray: &Ray<S>, triangle: [[S; 3]; 3]) -> bool
where
    Filtered<f64>: Embeds<S>,
{
    let Clear { sizes, crossing, errors, .. } = Clear::new(ray, triangle);
    let [w, u, v] = crossing.sides;
    let (low, high) = (least(least(u, v), w), greatest(greatest(u, v), w));
    sizes.are_in_range() & (low < -errors.sides) & (high > errors.sides)
}
