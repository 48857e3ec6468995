//! Where a ray enters a capsule and leaves it: the line's crossings in both directions.

use super::crossing::Crossing;
use crate::arithmetic::{Arithmetic, Enclosed, three};
use crate::query::orientation::from;
use crate::query::surd::Question;
use crate::scalar::Scalar;
use crate::shape::{Capsule, Ray};

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
