//! When a point that moves comes within a radius of a segment, and leaves it.
//!
//! m goes from the point to an end, e along the segment, and d along the way. At t the point is within
//! the radius of the segment's line if |(m − t·d) × e| is at most r·|e|, and of an end if |m − t·d|
//! is at most r. Squared, each is a quadratic equation in t. A root of the line counts if the point
//! is then between the ends; a root of an end always counts. The least root that counts is the first
//! time: all points within the radius of the segment are a convex set.
//!
//! Whether a root lies before a rational time is a sign at that time. When the point is over the end of
//! the segment, with k = e·d and h = e·m, k times the vector to that end is w = k·m − h·d, and w·w
//! compares with r²·k²: products of six lengths.

use core::cmp::Ordering;

use crate::arithmetic::{Arithmetic, Enclosed, cross, dot, sign_of, three};
use crate::query::orientation::{Vector, from};
use crate::query::sphere::{along, at_distance, first_at_distance, product};
use crate::query::surd::{Equation, Question, Surd, is_above, root};
use crate::scalar::Scalar;
use crate::shape::{Capsule, Ray};

/// A segment by vectors from the point to its ends and along it, the way, and the square of the
/// radius.
pub(crate) struct Crossing<N: Arithmetic> {
    pub(crate) m: [Vector<N>; 2],
    pub(crate) e: Vector<N>,
    pub(crate) d: Vector<N>,
    pub(crate) r2: N::Area,
}

impl<N> Crossing<N>
where
    N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
{
    /// The equation of the line; the second `None` if the way is parallel to it, the first in doubt, as
    /// in all that follow.
    #[inline(always)]
    pub(crate) fn line(&self) -> Option<Option<Equation<N::Quartic>>> {
        let Self { m, e, d, r2 } = self;
        let (speed, gap) = (cross::<N>(d, e), cross::<N>(&m[0], e));
        let a = along::<N>(&speed, &speed);
        if !is_above(a)? {
            return Some(None);
        }
        let c = along::<N>(&gap, &gap) - N::quartic(product::<N>(e, e), *r2);
        Some(Some(Equation { a, p: along::<N>(&speed, &gap), c }))
    }

    /// The lesser root of the line's equation, if it counts.
    #[inline(never)]
    pub(crate) fn between(&self, line: Equation<N::Quartic>) -> Option<Option<Surd<N::Quartic>>> {
        let Self { m, e, d, r2 } = self;
        let volume = dot::<N>(&cross::<N>(&m[0], d), e);
        let q = N::sextic_of_areas(line.a, *r2) - N::sextic(volume, volume);
        if sign_of(q)? == Ordering::Less {
            return Some(None);
        }
        let is_ahead = line.is_ahead()?;
        // The point is between the ends if h < t·k < h + e·e.
        let (ee, k, h) = (product::<N>(e, e), product::<N>(e, d), product::<N>(e, &m[0]));
        let h = [h, h + ee];
        let is_between = match sign_of(k)? {
            Ordering::Equal => is_above(-h[0])? && is_above(h[1])?,
            Ordering::Greater => {
                self.order(&m[0], k, h[0], is_ahead)? == Ordering::Greater
                    && self.order(&m[1], k, h[1], is_ahead)? == Ordering::Less
            }
            Ordering::Less => {
                self.order(&m[1], -k, -h[1], is_ahead)? == Ordering::Greater
                    && self.order(&m[0], -k, -h[0], is_ahead)? == Ordering::Less
            }
        };
        if !is_between {
            return Some(None);
        }
        let root = root(q)?.zip(root(ee)?).map(|(q, length)| q.times(length));
        Some(Some(line.lesser(root)))
    }

    /// How the time of the line compares with h/k, when the point is over an end; k is above zero.
    /// A line that is ahead has its time above zero.
    fn order(&self, m: &Vector<N>, k: N::Area, h: N::Area, is_ahead: bool) -> Option<Ordering> {
        if is_ahead && !is_above(h)? {
            return Some(Ordering::Greater);
        }
        let d = &self.d;
        let approach =
            sign_of(N::quartic(product::<N>(d, m), k) - N::quartic(product::<N>(d, d), h))?;
        let w = three(|i| N::volume(k, m[i]) - N::volume(h, d[i]));
        let square = |i: usize| N::sextic(w[i], w[i]);
        let reach = N::sextic_of_areas(N::quartic(k, k), self.r2);
        Some(match sign_of(square(0) + square(1) + square(2) - reach)? {
            Ordering::Greater if approach == Ordering::Greater => Ordering::Greater,
            Ordering::Equal if approach != Ordering::Less => Ordering::Equal,
            _ => Ordering::Less,
        })
    }

    /// The equation of an end to which this vector goes.
    #[inline(always)]
    pub(crate) fn end(&self, m: &Vector<N>) -> Equation<N::Area> {
        at_distance::<N>(m, &self.d, self.r2)
    }

    /// The lesser root of that, if there is one.
    #[inline(never)]
    pub(crate) fn around(
        &self,
        m: &Vector<N>,
        end: Equation<N::Area>,
    ) -> Option<Option<Surd<N::Area>>> {
        first_at_distance::<N>(end, [m, &self.d], self.r2)
    }
}

/// The question where the line of a ray enters and leaves a capsule that it meets.
struct Range<'a, S>(&'a Ray<S>, &'a Capsule<S>);

impl<S: Scalar> Question<S, 5> for Range<'_, S> {
    type Answer = (S, S);

    fn numbers(&self) -> [[S; 3]; 5] {
        let Self(ray, capsule) = self;
        let (a, b) = capsule.ends();
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        [o, d, a.to_array(), b.to_array(), [capsule.radius(); 3]]
    }

    fn solve<N>(&self, [o, d, a, b, [r, ..]]: &[[N::Length; 3]; 5]) -> Option<(S, S)>
    where
        N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
    {
        let m = [from::<N>(a, o), from::<N>(b, o)];
        let forward = Crossing::<N> { m, e: from::<N>(b, a), d: *d, r2: N::area(*r, *r) };
        let backward = Crossing::<N> { d: three(|i| -d[i]), ..forward };
        Some((first(&forward, false)?, first(&backward, true)?))
    }
}

/// The first time, rounded down; or minus the first time, rounded up.
#[inline(never)]
fn first<S, N>(crossing: &Crossing<N>, is_minus: bool) -> Option<S>
where
    S: Scalar,
    N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
{
    let mut first: Option<S> = None;
    let mut add = |t: S| {
        if first.is_none_or(|first| if is_minus { first < t } else { t < first }) {
            first = Some(t);
        }
    };
    for m in &crossing.m {
        if let Some(end) = crossing.around(m, crossing.end(m))? {
            add(end.lesser(is_minus, is_minus)?);
        }
    }
    if let Some(line) = crossing.line()? {
        if let Some(line) = crossing.between(line)? {
            add(line.lesser(is_minus, is_minus)?);
        }
    }
    first
}

impl<S: Scalar> Ray<S> {
    /// Where does the ray enter the capsule, and where does it leave it? As values of t; `None` if it
    /// misses the capsule.
    ///
    /// *Geometry*, *Contact*, *Numerics*, *Range*: as [`t_range_sphere`](Self::t_range_sphere).
    ///
    /// *Panics*: never. *Cost*: as for `overlaps`; a hit takes 120 multiplications for both values,
    /// each with an error bound, four to six roots and as many divisions of integers. Where
    /// `t_range_sphere` takes exact integers, it takes them too.
    ///
    /// ```
    /// use septum::{Capsule, Ray};
    ///
    /// let walker = Capsule::new([4.0_f32, 0.0, 0.0], [4.0, 0.0, 8.0], 1.0)?;
    /// let ray = Ray::new([0.0, 0.0, 3.0], [2.0, 0.0, 0.0])?;
    /// assert_eq!(ray.t_range_capsule(&walker), Some((1.5, 2.5)));
    /// let down = Ray::new([4.0, 0.0, 11.0], [0.0, 0.0, -1.0])?;
    /// assert_eq!(down.t_range_capsule(&walker), Some((2.0, 12.0))); // from end to end
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn t_range_capsule(&self, capsule: &Capsule<S>) -> Option<(S, S)> {
        if !capsule.overlaps(self) {
            return None;
        }
        // Exact numbers always have an answer.
        let (enter, leave) = Range(self, capsule).settle()?;
        Some(self.clipped(enter, leave))
    }
}
