//! The errors of the axes of a line and an oriented box. u is the unit roundoff.
//!
//! Each computed number is a sum of terms, and each term a product of operands. A is the greatest
//! magnitude among the components of the axes and one, and D that of the direction. R is such that
//! |m|·one ≤ R and h·A ≤ R, and T such that R ≤ T and D·|t| ≤ T. Products with one, a power of two,
//! are exact. m carries one rounding, and d one if it is a difference. `error_bound.g` proves the
//! bounds:
//!
//! * w·d errs by at most [`DIRECTION`] roundoffs of A²·D;
//! * a face, w·m + t·(w·d) against h·|u·w|, by at most [`FACE`] roundoffs of A²·T;
//! * the line, u·(m × d) against h·u·u·d, by at most [`LINE`] roundoffs of A²·R·D, because A is at
//!   least one.
//!
//! The last two hold whichever signs h, w·m and u·(m × d) have, for the proofs bound magnitudes. u·w
//! is w·d for an axis in place of the direction, with A in place of D.
//!
//! The proofs include second orders and underflow. R and T are within the range of a float, so underflow
//! loses far less than the bounds allow. So is D, or it is zero, and so are all products with the direction.

use core::ops::Mul;

use crate::arithmetic::{Arithmetic, Number, REGISTERS_ARE_WIDE, greatest};

const DIRECTION: u16 = 40;
const FACE: u16 = 160;
const LINE: u16 = 175;

/// How far computed axes may be from the truth.
pub(super) struct ErrorBound<P> {
    pub(super) direction: P,
    pub(super) face: P,
    pub(super) line: P,
}

/// The greatest magnitudes: of the axes and one, the vector to the line, its direction, the ends of
/// t, and the half-extents.
pub(super) struct Sizes<P> {
    pub(super) axes: P,
    pub(super) way: P,
    pub(super) direction: P,
    pub(super) ends: P,
    pub(super) half: P,
}

impl<P: Number + Mul<Output = P>> Sizes<P> {
    /// A bound on the products of the axes with the vector to the line and with the half-extents.
    #[inline(always)]
    fn near(&self, one: P) -> P {
        greatest(self.way * one, self.half * self.axes)
    }

    /// The ends of the range, without those so far beyond the box that the line does not come back
    /// to it: products with the greatest number are beyond floats. Small cores keep all, because a
    /// product takes long there.
    ///
    /// On one coordinate axis the point at t is at least |t|·D − |m| from the centre, and the box
    /// reaches at most 3·h·A. Both together are at most four times [`near`](Self::near), but for
    /// roundings. `error_bound.g` proves that |t|·D of a point in the box is never computed as more
    /// than eight times as much.
    #[inline(always)]
    pub(super) fn without_far(&self, [from, to]: [Option<P>; 2], one: P) -> [Option<P>; 2] {
        if !REGISTERS_ARE_WIDE {
            return [from, to];
        }
        let two = self.near(one) + self.near(one);
        let eight = two + two + (two + two);
        let is_near = |t: &P| self.direction * t.magnitude() <= eight;
        [from.filter(|t| *t >= P::ZERO || is_near(t)), to.filter(|t| *t <= P::ZERO || is_near(t))]
    }
}

/// The bounds; `None` outside their range, or if products may not fit.
#[inline(always)]
pub(super) fn error_bound<N: Arithmetic>(
    one: N::Product,
    sizes: &Sizes<N::Product>,
) -> Option<ErrorBound<N::Product>> {
    let Sizes { axes, way, direction, ends, half } = *sizes;
    let zero = N::Product::ZERO;
    if N::CERTAIN {
        let all = greatest(greatest(axes, way), greatest(greatest(direction, ends), half));
        let none = ErrorBound { direction: zero, face: zero, line: zero };
        return all.in_range().then_some(none);
    }
    let size = sizes.near(one);
    let far = greatest(size, direction * ends);
    let two = one + one;
    // Axes are unit vectors, or nearly. Longer ones go to the last stage.
    let is_known = axes < two + two
        && size.in_range()
        && far.in_range()
        && (direction.in_range() || direction == zero);
    let square = axes * axes;
    is_known.then(|| ErrorBound {
        direction: (square * direction).error(DIRECTION),
        face: (square * far).error(FACE),
        line: (square * size * direction).error(LINE),
    })
}

/// How far u·w may be from the truth. Apart from [`ErrorBound`], whose other users store it.
pub(super) fn error_of_volume<P: Number + Mul<Output = P>>(axes: P) -> P {
    (axes * axes * axes).error(DIRECTION)
}
