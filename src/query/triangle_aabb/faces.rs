use super::frame::{Frame, range};
use crate::arithmetic::{Arithmetic, Number, greatest};
use crate::robust::Uncertain;

/// Whether one of the box's three face normals separates.
///
/// They are the coordinate axes, and the projections are the coordinates.
#[inline(always)]
pub(super) fn faces<N: Arithmetic>(frame: &Frame<N>) -> Uncertain {
    if N::CERTAIN {
        return one_face(frame, 0).or(one_face(frame, 1)).or(one_face(frame, 2));
    }
    let [x, y, z] = frame.gaps;
    across(frame, greatest(greatest(x, y), z))
}

/// Whether the face normal along coordinate axis `i` separates.
#[inline(always)]
pub(super) fn one_face<N: Arithmetic>(frame: &Frame<N>, i: usize) -> Uncertain {
    if N::CERTAIN {
        let (low, high) = range(&frame.v, i);
        return Uncertain::known((low > frame.h[i]) | (high < -frame.h[i]));
    }
    across(frame, frame.gaps[i])
}

#[inline(always)]
fn across<N: Arithmetic>(frame: &Frame<N>, gap: N::Length) -> Uncertain {
    let certain = gap > N::Length::ZERO;
    let touch = !frame.gaps_are_exact && gap == N::Length::ZERO;
    Uncertain { certain, possible: certain | touch }
}
