//! When a sphere first meets a box, and on which part.
//!
//! On each axis the centre is below the box, between its faces, or above, and passes from one to the
//! next when it crosses the plane of a face. The squared distance of the centre from the box is the
//! sum over the axes on which it is outside: a convex function of time. A crossing comes before the
//! contact if the distance is then above the radius, and the centre comes nearer. This compares
//! products of four lengths. The axes outside at the contact have one quadratic equation.
//!
//! Each axis is turned so that the centre moves upward.

use core::cmp::Ordering;

use super::{Passing, SphereContact};
use crate::arithmetic::{Arithmetic, Each, Enclosed, Number, pick, sign_of, three};
use crate::query::orientation::{Vector, from};
use crate::query::sphere::to_corners;
use crate::query::surd::{Equation, Question, root};
use crate::scalar::Scalar;
use crate::shape::Aabb;

/// From the centre to both faces on each axis, the way, which is not below zero, and the square of the
/// radius.
struct Course<N: Arithmetic> {
    faces: [[N::Length; 2]; 3],
    d: Vector<N>,
    r2: N::Area,
}

impl<N> Course<N>
where
    N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
{
    /// Whether the centre crosses a face on axis i before the contact; `None` in doubt, as in all that
    /// follow.
    fn crosses_before(&self, i: usize, face: N::Length) -> Option<bool> {
        let d = *pick(&self.d, i);
        let mut gap = -N::quartic(self.r2, N::area(d, d));
        let mut approach = N::Volume::ZERO;
        for j in (0..3).filter(|&j| j != i) {
            let ([low, high], speed) = (*pick(&self.faces, j), *pick(&self.d, j));
            let (below, above) =
                (N::minor([low, d], [face, speed]), N::minor([face, speed], [high, d]));
            if sign_of(below)? == Ordering::Greater {
                gap = gap + N::quartic(below, below);
                approach = approach + N::volume(below, speed);
            } else if sign_of(above)? == Ordering::Greater {
                gap = gap + N::quartic(above, above);
                approach = approach - N::volume(above, speed);
            }
        }
        Some(sign_of(gap)? == Ordering::Greater && sign_of(approach)? == Ordering::Greater)
    }

    /// The side of the box on which the centre is at the contact: −1, 0 or 1.
    fn side(&self, i: usize) -> Option<i8> {
        let [low, high] = *pick(&self.faces, i);
        let is_still = sign_of(*pick(&self.d, i))? == Ordering::Equal;
        let (to_low, to_high) = (sign_of(low)?, sign_of(high)?);
        let is_above =
            if is_still { to_high == Ordering::Less } else { to_high != Ordering::Greater };
        if is_above {
            return Some(1);
        }
        let is_below = to_low == Ordering::Greater;
        if is_still || is_below && !self.crosses_before(i, low)? {
            return Some(-i8::from(is_below));
        }
        Some(i8::from(self.crosses_before(i, high)?))
    }
}

impl<S: Scalar> Question<S, 6> for Passing<'_, S, Aabb<S>> {
    type Answer = SphereContact<S, [i8; 3]>;

    fn numbers(&self) -> [[S; 3]; 6] {
        let (p, q, _) = self.shape.numbers();
        let [center, radius, from, to] = self.way();
        [center, radius, from, to, p, q]
    }

    fn solve<N>(&self, numbers: &[[N::Length; 3]; 6]) -> Option<Self::Answer>
    where
        N: Arithmetic<Area: Enclosed, Quartic: Enclosed, Sextic: Enclosed>,
    {
        let [center, [r, ..], start, end, p, q] = numbers;
        let d = from::<N>(end, start);
        let (.., is_by_center) = self.shape.numbers();
        let [low, high] = to_corners::<N>(center, [p, q], is_by_center);
        let [x, y, z] = d.each(sign_of);
        let is_turned = [x?, y?, z?].each(|sign| sign == Ordering::Less);
        let course = Course::<N> {
            faces: three(|i| if is_turned[i] { [-high[i], -low[i]] } else { [low[i], high[i]] }),
            d: three(|i| if is_turned[i] { -d[i] } else { d[i] }),
            r2: N::area(*r, *r),
        };
        let sides = [course.side(0)?, course.side(1)?, course.side(2)?];
        let zero = [N::Length::ZERO; 2];
        // The way to the face, and the speed, on the axes outside.
        let ways = three(|i| {
            let ([low, high], d) = (course.faces[i], course.d[i]);
            match sides[i] {
                0 => zero,
                -1 => [low, d],
                _ => [high, d],
            }
        });
        let sum = |f: fn([N::Length; 2]) -> N::Area| f(ways[0]) + f(ways[1]) + f(ways[2]);
        let a = sum(|[_, d]| N::area(d, d));
        let (p, c) = (sum(|[m, d]| N::area(m, d)), sum(|[m, _]| N::area(m, m)) - course.r2);
        let across = |i: usize, j: usize| {
            let ([m, d], [n, e]) = (*pick(&ways, i), *pick(&ways, j));
            let minor = N::minor([m, e], [n, d]);
            N::quartic(minor, minor)
        };
        let root = root(N::quartic(a, course.r2) - (across(0, 1) + across(1, 2) + across(2, 0)))?;
        let t = Equation { a, p, c }.lesser(root).floor()?;
        let side = |i: usize| if is_turned[i] { -sides[i] } else { sides[i] };
        Some(SphereContact { t, part: Some(three(side)) })
    }
}
