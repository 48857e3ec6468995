use crate::scalar::Scalar;

/// Where one ray enters and leaves each of N boxes, or each of N rays one box; zero
/// where `mask` is false.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranges<S, const N: usize> {
    /// Which lanes meet.
    pub mask: [bool; N],
    /// Where the ray enters the box.
    pub t_enter: [S; N],
    /// Where it leaves it.
    pub t_leave: [S; N],
}

impl<S: Scalar, const N: usize> Ranges<S, N> {
    /// Lane by lane, into arrays of their own: see [`Hits`](super::Hits).
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

    /// Where ray and box of lane `k` meet, if they do.
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
