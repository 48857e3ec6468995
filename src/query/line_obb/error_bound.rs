//! How far the axes of a line and an oriented box may be from the truth, to first order in u, the
//! unit roundoff.
//!
//! As for two oriented boxes every number is a sum of terms, each a product of operands, and its
//! error the number of roundings that touch a term, times the sum of the terms' sizes. Let A be
//! the greatest magnitude among the components of the axes and one, D that of the direction, R
//! such that |m|·one ≤ R and h·A ≤ R, and T such that R ≤ T and D·|t| ≤ T. Products with one,
//! which is a power of two, are exact. m carries one rounding, and d one if it is a difference.
//!
//! * w·d, in A²·D: 6 terms of 1 for d, 2 products, 1 difference, 2 sums. 6·6 = 36;
//!   [`DIRECTION`] = 40.
//! * A face, in A²·T: w·m as above 36; t·(w·d) one product more, 42; their sum, of at most 6 and 6:
//!   12. The reach h·|u·w|: 6 terms of 2 products, 1 difference, 2 sums, and 1 product for h: 36.
//!   The difference, of at most 12 and 6: 18. In all 144; [`FACE`] = 160.
//! * The line, in A²·R·D, for A is at least one: u·(m × d), 6 terms of 2 for m and d, 2 products, 1
//!   difference, 2 sums: 42. The reach: 12 terms of h·u·u·d, 6 roundings for w·d, 1 product, 1 sum:
//!   96. The difference, of at most 6 and 12: 18. In all 156; [`LINE`] = 175.
//!
//! R, D and T are zero, or within the range of a float: so what underflow takes is far below what
//! is added to the counts. `error_bound.g` proves all three, second orders and underflow included.

use crate::arithmetic::{Arithmetic, Number, greatest};

const DIRECTION: u16 = 40;
const FACE: u16 = 160;
const LINE: u16 = 175;

/// How far computed axes may be from the truth.
pub(super) struct ErrorBound<P> {
    pub(super) direction: P,
    pub(super) face: P,
    pub(super) line: P,
}

/// The greatest magnitudes: of the axes and one, the way to the line, its direction, the ends of
/// t and the half-extents.
pub(super) struct Sizes<P> {
    pub(super) axes: P,
    pub(super) way: P,
    pub(super) direction: P,
    pub(super) ends: P,
    pub(super) half: P,
}

/// The bounds; `None` where they are not known or products may not fit.
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
    let size = greatest(way * one, half * axes);
    let far = greatest(size, direction * ends);
    let two = one + one;
    // Axes are unit vectors, or near: what is longer may as well go to the end.
    let is_known = axes < two + two && size.in_range() && far.in_range() && direction.in_range();
    let square = axes * axes;
    is_known.then(|| ErrorBound {
        direction: (square * direction).error(DIRECTION),
        face: (square * far).error(FACE),
        line: (square * size * direction).error(LINE),
    })
}
