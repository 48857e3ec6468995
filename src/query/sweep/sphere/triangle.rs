//! When a sphere first meets a triangle, and on which part.
//!
//! m goes from the centre to a vertex, e along an edge, and d along the way. The sphere meets the
//! plane when n·(m − t·d) is r·|n|, the line of an edge when |(m − t·d) × e| is r·|e|, and a vertex
//! when |m − t·d| is r. Squared, each is a quadratic equation in t. Its lesser root counts if the
//! centre is then over the face; edges and vertices are [`Crossing`]s. The least is the time of
//! contact: these parts cover all points within r of the triangle.
//!
//! Whether a root lies before a rational time is a sign at that time. When the centre is in the plane
//! through an edge at right angles to the face, n·(m − t·d) is −n²·D/β, with D = e·(m × d) and β =
//! n·(e × d). So n²·D² compares with r²·β²: products of ten.

use core::cmp::Ordering;

use super::{Passing, SphereContact};
use crate::arithmetic::{
    Arithmetic, Each, Enclosed, Number, compare_products, cross, dot, pick, sign_of,
};
use crate::query::Feature;
use crate::query::capsule::Crossing;
use crate::query::orientation::{Vector, from};
use crate::query::sphere::along;
use crate::query::surd::{Equation, Question, Surd, is_above, root};
use crate::scalar::Scalar;
use crate::shape::Triangle;

/// The vectors of a sphere and a triangle, and the square of the radius.
struct Course<N: Arithmetic> {
    m: [Vector<N>; 3],
    e: [Vector<N>; 3],
    d: Vector<N>,
    r2: N::Area,
}

impl<N> Course<N>
where
    N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
{
    /// e·(m × d).
    fn across(&self, k: usize) -> N::Volume {
        dot::<N>(&cross::<N>(pick(&self.m, k), &self.d), pick(&self.e, k))
    }

    /// The plane, if its root counts. `None` in doubt, as in all that follow.
    #[inline(never)]
    fn face(&self) -> Option<Option<Surd<N::Sextic>>> {
        let Self { m, e, d, r2 } = self;
        let n = cross::<N>(&e[0], &e[1]);
        let nn = along::<N>(&n, &n);
        if !is_above(nn)? {
            return Some(None);
        }
        let (gap, speed) = (dot::<N>(&n, &m[0]), dot::<N>(&n, d));
        let side = sign_of(gap)?;
        if side == Ordering::Equal || side != sign_of(speed)? {
            return Some(None);
        }
        let reach = N::sextic_of_areas(nn, *r2);
        let c = N::sextic(gap, gap) - reach;
        if !is_above(c)? {
            return Some(None);
        }
        for k in 0..3 {
            if !self.is_inside(k, &n, nn, side)? {
                return Some(None);
            }
        }
        let (a, p) = (N::sextic(speed, speed), N::sextic(gap, speed));
        let root = root(reach)?.zip(root(a)?).map(|(reach, speed)| reach.times(speed));
        Some(Some(Equation { a, p, c }.lesser(root)))
    }

    /// Whether the foot of the centre lies inside of an edge when the sphere meets the plane.
    fn is_inside(
        &self,
        k: usize,
        n: &[N::Area; 3],
        nn: N::Quartic,
        side: Ordering,
    ) -> Option<bool> {
        let (m, e) = (pick(&self.m, k), pick(&self.e, k));
        let inward = along::<N>(n, &cross::<N>(e, &self.d));
        let (start, moves) = (sign_of(-along::<N>(n, &cross::<N>(e, m)))?, sign_of(inward)?);
        if start == Ordering::Equal || start == moves || moves == Ordering::Equal {
            // It stays on its side, or leaves the line at once.
            let first = if start == Ordering::Equal { moves } else { start };
            return Some(first == Ordering::Greater);
        }
        // Before or after the foot is on the line of the edge.
        let volume = self.across(k);
        let gap = sign_of(volume)?;
        let is_beyond = gap != Ordering::Equal && (gap == side) != (moves == Ordering::Greater);
        let order = if gap == Ordering::Equal || is_beyond {
            let reach = N::sextic_of_areas(inward.magnitude(), self.r2);
            compare_products([nn, inward.magnitude()], [N::sextic(volume, volume), reach])?
        } else {
            Ordering::Less
        };
        Some(order == moves)
    }

    /// A segment that is an edge, or ends at a vertex.
    #[inline(always)]
    fn crossing(&self, k: usize) -> Crossing<N> {
        let Self { m, e, d, r2 } = self;
        let next = if k == 2 { 0 } else { k + 1 };
        Crossing { m: [*pick(m, k), *pick(m, next)], e: *pick(e, k), d: *d, r2: *r2 }
    }

    /// The line of an edge.
    #[inline(never)]
    fn edge(&self, k: usize) -> Option<Option<Surd<N::Quartic>>> {
        let crossing = self.crossing(k);
        let Some(line) = crossing.line()? else { return Some(None) };
        if !line.is_ahead()? {
            return Some(None);
        }
        crossing.between(line)
    }

    /// A vertex.
    #[inline(never)]
    fn vertex(&self, k: usize) -> Option<Option<Surd<N::Area>>> {
        let crossing = self.crossing(k);
        let m = &crossing.m[0];
        let end = crossing.end(m);
        if !end.is_ahead()? {
            return Some(None);
        }
        crossing.around(m, end)
    }
}

impl<S: Scalar> Question<S, 7> for Passing<'_, S, Triangle<S>> {
    type Answer = SphereContact<S, Feature>;

    fn numbers(&self) -> [[S; 3]; 7] {
        let ([center, radius, from, to], [a, b, c]) = (self.way(), self.shape.points());
        [center, radius, from, to, a, b, c]
    }

    fn solve<N>(&self, numbers: &[[N::Length; 3]; 7]) -> Option<Self::Answer>
    where
        N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
    {
        let [center, [r, ..], start, end, a, b, c] = numbers;
        let course = Course::<N> {
            m: [a, b, c].each(|v| from::<N>(v, center)),
            e: [from::<N>(b, a), from::<N>(c, b), from::<N>(a, c)],
            d: from::<N>(end, start),
            r2: N::area(*r, *r),
        };
        if let Some(face) = course.face()? {
            return Some(SphereContact { t: face.floor()?, part: Some(Feature::Interior) });
        }
        let mut first = None;
        for k in 0..3 {
            if let Some(edge) = course.edge(k)? {
                add(&mut first, &edge, Feature::Edge(k as u8))?;
            }
        }
        for k in 0..3 {
            if let Some(vertex) = course.vertex(k)? {
                add(&mut first, &vertex, Feature::Vertex(k as u8))?;
            }
        }
        first
    }
}

/// Adds a part that is met before the first so far, and not after the end of the motion. At the number
/// where the motion ends, or next to it where the scalar holds no one, times beyond it are rounded down to it.
#[inline(always)]
fn add<S: Scalar, T: Enclosed>(
    first: &mut Option<SphereContact<S, Feature>>,
    root: &Surd<T>,
    part: Feature,
) -> Option<()> {
    let t: S = root.floor()?;
    let is_first = first.is_none_or(|first| t < first.t);
    if is_first && !(t == S::plain_one() && root.is_above_one::<S>()?) {
        *first = Some(SphereContact { t, part: Some(part) });
    }
    Some(())
}
