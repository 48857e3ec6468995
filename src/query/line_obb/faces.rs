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
use super::{Disjoint, Line, in_window};
use crate::arithmetic::{Embeds, Number, cross3, dot3, pick, three, turn};
use crate::query::crossing::{Crossing, Entries, crossings};
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
        in_window(self).or_else(|| faces(&self.0.exactly())).unwrap_or_default()
    }
}

/// The signs of the kernel's numbers, computed or exact.
pub(super) trait Signs {
    /// Whether the line is not parallel to slab `i`; `None` in doubt.
    fn crosses(&self, i: usize) -> Option<bool>;

    /// Whether w_i·d is below zero.
    fn is_below(&self, i: usize) -> bool;

    /// Whether v is below zero.
    fn is_volume_below(&self) -> bool;

    /// Whether u_k·(m × d) + h_i·(w_j·d) + h_j·(w_i·d) is above zero, with i and j next to k in
    /// cyclic order; `None` in doubt. `minus` says which terms are subtracted.
    fn is_line_above(&self, k: usize, minus: [bool; 3]) -> Option<bool>;

    /// The same for (w_i·m + t·(w_i·d)) + h_i·v, with t the first or the last of the range; `None`
    /// without an end there.
    fn is_face_above(&self, i: usize, is_last: bool, minus: [bool; 2]) -> Option<Option<bool>>;
}

fn faces(of: &impl Signs) -> Option<Answer> {
    let face = |is_back: bool| {
        let last = OneWay { of, is_back }.last_entered()?;
        let is_upper = |i: usize| of.is_below(i) != of.is_volume_below();
        Some(last.map(|i| (i as u8, is_upper(i) != is_back)))
    };
    Some([face(false)?, face(true)?])
}

/// The entries of the ray into the slabs, or of the ray that runs back.
struct OneWay<'a, T> {
    of: &'a T,
    is_back: bool,
}

impl<T: Signs> Entries for OneWay<'_, T> {
    fn crosses(&self, i: usize) -> Option<bool> {
        self.of.crosses(i)
    }

    fn is_later(&self, i: usize, j: usize) -> Option<bool> {
        let Self { of, is_back } = self;
        let (_, next, last) = turn(i);
        let is_cyclic = j == next;
        let is_odd = of.is_below(i) ^ of.is_below(j) ^ of.is_volume_below();
        let beside = is_odd ^ is_cyclic ^ is_back;
        // h_j·|w_i·d| is added, and h_i·|w_j·d| subtracted.
        let (of_i, of_j) = (of.is_below(i), !of.is_below(j));
        if is_cyclic {
            of.is_line_above(last, [beside, of_j, of_i])
        } else {
            of.is_line_above(next, [beside, of_i, of_j])
        }
    }

    fn is_past(&self, i: usize) -> Option<bool> {
        let Self { of, is_back } = self;
        let minus = [of.is_below(i) != *is_back, of.is_volume_below()];
        of.is_face_above(i, *is_back, minus).unwrap_or(Some(false))
    }
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
        let w = [cross3(&u[1], &u[2]), cross3(&u[2], &u[0]), cross3(&u[0], &u[1])];
        let (along, volume) = (three(|i| dot3(&w[i], d)), dot3(&u[0], &w[0]));
        let has_sign = Uncertain::above(volume.magnitude(), error_of_volume).verdict()?;
        has_sign.then_some(Self { s, error, across: cross3(m, d), along, w, volume })
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

impl<P: Number + Mul<Output = P>> Signs for Computed<'_, P> {
    fn crosses(&self, i: usize) -> Option<bool> {
        let crosses = Uncertain::above(pick(&self.along, i).magnitude(), self.error.direction);
        crosses.verdict().or_else(|| self.is_parallel(i).then_some(false))
    }

    fn is_below(&self, i: usize) -> bool {
        *pick(&self.along, i) < P::ZERO
    }

    fn is_volume_below(&self) -> bool {
        self.volume < P::ZERO
    }

    fn is_line_above(&self, k: usize, [minus, of_j, of_i]: [bool; 3]) -> Option<bool> {
        let Self { s: Operands { u, h, one, .. }, error, across, along, .. } = self;
        let (k, i, j) = turn(k);
        let beside = signed(dot3(across, pick(u, k)) * *one, minus);
        let reach = |i: usize, j: usize, minus: bool| signed(*pick(h, i) * *pick(along, j), minus);
        Uncertain::above(beside + (reach(i, j, of_j) + reach(j, i, of_i)), error.line).verdict()
    }

    fn is_face_above(&self, i: usize, is_last: bool, minus: [bool; 2]) -> Option<Option<bool>> {
        let Self { s: Operands { m, ends: [from, to], h, one, .. }, error, along, w, .. } = self;
        let t = if is_last { to } else { from }.as_ref()?;
        let at = dot3(pick(w, i), m) * *one + *pick(along, i) * *t;
        let at = signed(at, minus[0]) + signed(*pick(h, i) * self.volume, minus[1]);
        Some(Uncertain::above(at, error.face).verdict())
    }
}

fn signed<P: Number>(x: P, minus: bool) -> P {
    if minus { -x } else { x }
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
