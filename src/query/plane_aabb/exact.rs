//! The last stage for a plane and a box: exact sums.

use core::cmp::Ordering;

use crate::arithmetic::{Parts, compare};
use crate::query::exact_aabb::ExactAabb;
use crate::robust::{ExactSum, add_area, single};
use crate::scalar::Scalar;
use crate::shape::PlaneForm;

/// The sign of n·(x − p), or of n·x + d, at the corner x of the box that lies farthest, or least
/// far, along n.
pub(super) fn corner_side<S: Scalar>(
    b: &ExactAabb,
    normal: [S; 3],
    form: &PlaneForm<S>,
    along: bool,
) -> Ordering {
    let mut sum = S::Sum::new();
    for (i, n) in normal.into_iter().enumerate() {
        let toward = compare(n, S::ZERO);
        let toward = if along { toward } else { toward.reverse() };
        let from = match form {
            PlaneForm::Point(p) => p.to_array()[i].parts(),
            PlaneForm::Offset(_) => Parts::ZERO,
        };
        add_area(&mut sum, &single(n.parts()), &b.to_face(from, i, toward), false);
    }
    if let PlaneForm::Offset(d) = form {
        sum.add(&[d.parts(), S::ONE]);
    }
    sum.sign()
}
