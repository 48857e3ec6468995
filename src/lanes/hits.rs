use crate::query::{Candidate, Hit};
use crate::scalar::Scalar;

/// The hits of one ray on N triangles, or of N rays on one.
///
/// Where `mask` is false, t, u and v are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hits<S, const N: usize> {
    /// Which lanes have a hit.
    pub mask: [bool; N],
    /// See [`Hit::t`].
    pub t: [S; N],
    /// See [`Hit::u`].
    pub u: [S; N],
    /// See [`Hit::v`].
    pub v: [S; N],
    marks: [u8; N],
}

impl<S: Scalar, const N: usize> Hits<S, N> {
    /// Collects lane by lane, into separate local arrays. Arrays filled in place would be copied
    /// out by loads wider than the stores, which stalls.
    #[inline(always)]
    pub(super) fn each(mut found: impl FnMut(usize) -> Candidate<S>) -> Self {
        let zero = [S::ZERO; N];
        let (mut t, mut u, mut v) = (zero, zero, zero);
        let (mut mask, mut marks) = ([false; N], [0; N]);
        for k in 0..N {
            let found = found(k);
            let or_zero = |x: S| if found.hit { x } else { S::ZERO };
            mask[k] = found.hit;
            t[k] = or_zero(found.t);
            u[k] = or_zero(found.u);
            v[k] = or_zero(found.v);
            marks[k] = if found.hit { found.marks } else { 0 };
        }
        Self { mask, t, u, v, marks }
    }

    #[inline(always)]
    pub(super) fn set(&mut self, k: usize, found: Candidate<S>) {
        self.mask[k] = found.hit;
        (self.t[k], self.u[k], self.v[k]) = (found.t, found.u, found.v);
        self.marks[k] = found.marks;
    }

    /// The hit in lane `k`, if there is one.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<Hit<S>> {
        let hit = *self.mask.get(k)?;
        let (t, u, v) = (self.t[k], self.u[k], self.v[k]);
        Candidate { hit, t, u, v, marks: self.marks[k] }.into_hit()
    }

    /// Does any lane have a hit?
    #[inline]
    #[must_use]
    pub fn any(&self) -> bool {
        let mut any = false;
        for hit in self.mask {
            any |= hit;
        }
        any
    }

    /// The lane and the hit with the least t; the first of equal ones.
    #[inline]
    #[must_use]
    pub fn nearest(&self) -> Option<(usize, Hit<S>)> {
        let mut nearest = None;
        for k in 0..N {
            if self.mask[k] && nearest.is_none_or(|n: usize| self.t[k] < self.t[n]) {
                nearest = Some(k);
            }
        }
        nearest.and_then(|k| Some((k, self.get(k)?)))
    }
}

/// Entries and exits of one ray on N boxes, or of N rays on one box.
///
/// Lanes whose `mask` is false hold zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranges<S, const N: usize> {
    /// Lanes whose ray meets its box.
    pub mask: [bool; N],
    /// The t at which the ray enters the box.
    pub t_enter: [S; N],
    /// The t at which the ray leaves the box.
    pub t_leave: [S; N],
}

impl<S: Scalar, const N: usize> Ranges<S, N> {
    /// Collects lane by lane, into separate local arrays: see [`Hits`].
    #[inline(always)]
    pub(super) fn each(mut interval: impl FnMut(usize) -> (S, S)) -> Self {
        let zero = [S::ZERO; N];
        let (mut mask, mut t_enter, mut t_leave) = ([false; N], zero, zero);
        for k in 0..N {
            let (enter, leave) = interval(k);
            let met = enter <= leave;
            mask[k] = met;
            t_enter[k] = if met { enter } else { S::ZERO };
            t_leave[k] = if met { leave } else { S::ZERO };
        }
        Self { mask, t_enter, t_leave }
    }

    /// Entry and exit in lane `k`, if its ray meets its box.
    #[inline]
    #[must_use]
    pub fn get(&self, k: usize) -> Option<(S, S)> {
        if *self.mask.get(k)? { Some((self.t_enter[k], self.t_leave[k])) } else { None }
    }
}

#[inline(always)]
pub(super) fn minus<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[0].plain_sub(b[0]), a[1].plain_sub(b[1]), a[2].plain_sub(b[2])]
}
