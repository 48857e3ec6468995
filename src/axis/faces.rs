use super::frame::range;
use super::{Frame, Split};
use crate::scalar::{Number, Numbers, greatest};

/// Whether one of the box's three face normals separates.
///
/// They are the coordinate axes, and the projections on them the coordinates.
#[inline(always)]
pub(crate) fn faces<N: Numbers>(frame: &Frame<N>) -> Split {
    if N::FINAL {
        return one_face(frame, 0).or(one_face(frame, 1)).or(one_face(frame, 2));
    }
    let [x, y, z] = frame.gaps;
    across(frame, greatest(greatest(x, y), z))
}

/// Whether the face normal along coordinate axis `i` separates.
#[inline(always)]
pub(crate) fn one_face<N: Numbers>(frame: &Frame<N>, i: usize) -> Split {
    if N::FINAL {
        let (low, high) = range(&frame.v, i);
        let certain = (low > frame.h[i]) | (high < -frame.h[i]);
        return Split { certain, possible: certain };
    }
    across(frame, frame.gaps[i])
}

#[inline(always)]
fn across<N: Numbers>(frame: &Frame<N>, gap: N::Length) -> Split {
    let certain = gap > N::Length::ZERO;
    let touch = !frame.gaps_are_exact && gap == N::Length::ZERO;
    Split { certain, possible: certain | touch }
}
