//! The faces through which a ray enters and leaves the box, exactly.
//!
//! With the names of the kernel and v = u_0·w_0, the ray enters slab i at t_i = −(σ_i·h_i·v +
//! w_i·m)/(w_i·d), with σ_i the sign of v·(w_i·d). By w_i × w_j = v·u_k, for i, j, k in cyclic
//! order, t_i − t_j has the sign of
//!
//! h_j·|w_i·d| − h_i·|w_j·d| − s·u_k·(m × d), with s the sign of v·(w_i·d)·(w_j·d).
//!
//! So t exceeds t_i if ±(w_i·m + t·(w_i·d)) + h_i·|v| is above zero, with the sign of w_i·d. Both are
//! numbers of the kernel, but for signs. The ray leaves where the ray with −d enters, at −t.

use core::ops::Mul;

use super::error_bound::{ErrorBound, error_bound, error_of_volume};
use super::kernel::Operands;
use super::{Disjoint, Line};
use crate::arithmetic::{Embeds, Number, pick, three, turn};
use crate::query::crossing::{Crossing, Entries, crossings};
use crate::query::triangle_obb::{cross, dot};
use crate::robust::{Predicate, Uncertain};
use crate::scalar::Scalar;
use crate::shape::{Obb, Ray};

/// The faces through which the ray enters the box, which it meets, and leaves it: the axis, and
/// whether it is the upper side.
struct Faces<'a, S>(Disjoint<'a, S>);

type Answer = [Option<(u8, bool)>; 2];

impl<S: Scalar> Predicate<S> for Faces<'_, S> {
    type Answer = Answer;

    #[inline(never)]
    fn filter<N: Embeds<S>>(&self) -> Option<Answer> {
        let s = self.0.operands::<N>()?;
        let sizes = s.sizes();
        let error = error_bound::<N>(s.one, &sizes)?;
        faces(&Computed::new(&s, &error, error_of_volume(sizes.axes))?)
    }

    fn exact(&self) -> Answer {
        faces(&self.0.exactly().entries::<S>()).unwrap_or_default()
    }
}

/// The entries of a ray into the slabs of an oriented box, and of the ray that runs back.
pub(super) trait ThereAndBack {
    /// The entries of the ray, or of the ray that runs back.
    fn entries(&self, is_back: bool) -> impl Entries;

    /// Whether the ray enters slab `i`, which it crosses, on the upper side.
    fn is_upper(&self, i: usize) -> bool;
}

fn faces(of: &impl ThereAndBack) -> Option<Answer> {
    let face = |is_back: bool| {
        let last = of.entries(is_back).last_entered()?;
        Some(last.map(|i| (i as u8, of.is_upper(i) != is_back)))
    };
    Some([face(false)?, face(true)?])
}

/// The numbers of the kernel.
struct Computed<'a, P> {
    s: &'a Operands<P>,
    error: &'a ErrorBound<P>,
    /// m × d.
    across: [P; 3],
    /// w_i·d.
    along: [P; 3],
    w: [[P; 3]; 3],
    volume: P,
}

impl<'a, P: Number + Mul<Output = P>> Computed<'a, P> {
    #[inline(always)]
    fn new(s: &'a Operands<P>, error: &'a ErrorBound<P>, error_of_volume: P) -> Option<Self> {
        let Operands { m, d, u, .. } = s;
        let w = [cross(&u[1], &u[2]), cross(&u[2], &u[0]), cross(&u[0], &u[1])];
        let (along, volume) = (three(|i| dot(&w[i], d)), dot(&u[0], &w[0]));
        let has_sign = Uncertain::above(volume.magnitude(), error_of_volume).verdict()?;
        has_sign.then_some(Self { s, error, across: cross(m, d), along, w, volume })
    }

    fn is_below(&self, i: usize) -> bool {
        *pick(&self.along, i) < P::ZERO
    }

    /// Whether w_i·d is a sum of products with zero.
    fn is_parallel(&self, i: usize) -> bool {
        let (_, j, k) = turn(i);
        let (v, n, d) = (pick(&self.s.u, j), pick(&self.s.u, k), &self.s.d);
        let is_zero = |a: usize, b: usize| (*pick(v, a) == P::ZERO) | (*pick(n, b) == P::ZERO);
        (0..3).all(|c| {
            let (c, a, b) = turn(c);
            (*pick(d, c) == P::ZERO) | (is_zero(a, b) & is_zero(b, a))
        })
    }
}

impl<P: Number + Mul<Output = P>> ThereAndBack for Computed<'_, P> {
    fn entries(&self, is_back: bool) -> impl Entries {
        OneWay { of: self, is_back }
    }

    fn is_upper(&self, i: usize) -> bool {
        self.is_below(i) != (self.volume < P::ZERO)
    }
}

struct OneWay<'a, P> {
    of: &'a Computed<'a, P>,
    is_back: bool,
}

impl<P: Number + Mul<Output = P>> Entries for OneWay<'_, P> {
    fn crosses(&self, i: usize) -> Option<bool> {
        let Computed { along, error, .. } = self.of;
        let crosses = Uncertain::above(pick(along, i).magnitude(), error.direction).verdict();
        crosses.or_else(|| self.of.is_parallel(i).then_some(false))
    }

    fn is_later(&self, i: usize, j: usize) -> Option<bool> {
        let Computed { s: Operands { u, h, one, .. }, error, across, along, volume, .. } = self.of;
        let (_, next, last) = turn(i);
        let is_cyclic = j == next;
        let k = if is_cyclic { last } else { next };
        let beside = dot(across, pick(u, k)) * *one;
        let is_odd = self.of.is_below(i) ^ self.of.is_below(j) ^ (*volume < P::ZERO);
        let beside = if is_odd ^ !is_cyclic ^ self.is_back { beside } else { -beside };
        let along = |i: usize| pick(along, i).magnitude();
        let span = *pick(h, i) * along(j) - *pick(h, j) * along(i);
        Uncertain::above(beside - span, error.line).verdict()
    }

    fn is_past(&self, i: usize) -> Option<bool> {
        let Computed { s: Operands { m, ends, h, one, .. }, error, along, w, volume, .. } = self.of;
        let [from, to] = ends;
        let Some(t) = (if self.is_back { to } else { from }) else { return Some(false) };
        let at = dot(pick(w, i), m) * *one + *pick(along, i) * *t;
        let at = if self.of.is_below(i) != self.is_back { -at } else { at };
        Uncertain::above(at + *pick(h, i) * volume.magnitude(), error.face).verdict()
    }
}

impl<S: Scalar> Ray<S> {
    /// Where and through which faces does the ray enter the oriented box, and leave it? `None` if it
    /// misses the box.
    ///
    /// *Geometry*, *Contact*: as [`t_range_obb`](Self::t_range_obb). [`Crossing::normal`] gives the
    /// outward normal of a face.
    ///
    /// *Numerics*: the values of t are those of [`t_range_obb`](Self::t_range_obb), with its
    /// rounding. The faces are exact, and named as by [`crossings`](Self::crossings).
    ///
    /// *Range*: as for [`t_range_obb`](Self::t_range_obb). *Panics*: never. *Cost*:
    /// [`t_range_obb`](Self::t_range_obb), and for a hit about as much as
    /// [`overlaps`](Ray::overlaps) more. Through an edge of the box, in floats, exact sums.
    ///
    /// ```
    /// use septum::{Obb, Ray, Vec3};
    ///
    /// let tool = Obb::from_turns([0.0; 3], [0.0, 0.0, 0.25], [3.0, 1.0, 1.0])?;
    /// let ray = Ray::new([0.0, -5.0, 0.0], [0.0, 2.0, 0.0])?;
    /// let [enter, leave] = ray.crossings_obb(&tool).unwrap();
    /// assert_eq!((enter.t, enter.face), (1.0, Some(0))); // the lower side of the box's x
    /// assert_eq!(enter.normal(&tool), Some(Vec3::new(0.0, -1.0, 0.0)));
    /// assert_eq!((leave.t, leave.face), (4.0, Some(1)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[doc(alias = "normal")]
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn crossings_obb(&self, obb: &Obb<S>) -> Option<[Crossing<S>; 2]> {
        let range = self.t_range_obb(obb)?;
        Some(crossings(range, S::evaluate(&Faces(Disjoint { line: Line::Ray(self), obb }))))
    }
}
