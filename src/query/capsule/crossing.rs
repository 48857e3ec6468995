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
use crate::query::orientation::Vector;
use crate::query::sphere::{along, at_distance, first_at_distance, product};
use crate::query::surd::{Equation, Surd, is_above, root};

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
