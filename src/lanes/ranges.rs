use crate::scalar::Scalar;

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
    /// Collects lane by lane, into separate local arrays: see [`Hits`](super::Hits).
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
