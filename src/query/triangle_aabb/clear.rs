//! Triangle against axis-aligned box where the answer is clear at once: the kernel in floats
//! without a branch, for many at once.

use super::edges::edges;
use super::error_bound::bound_of_size;
use super::faces::faces;
use super::frame::{BoxForm, Frame};
use super::plane::{normal, plane};
use crate::arithmetic::{Filtered, FirstFloat, Number, greatest};

/// The three points of a triangle.
type Points<S> = [[S; 3]; 3];

/// Whether an axis separates a triangle from the box with these corners, and whether that is
/// certain.
#[inline(always)]
pub(crate) fn apart_by_corners<S: FirstFloat>(
    points: Points<S>,
    min: [S; 3],
    max: [S; 3],
) -> (bool, bool) {
    let [min, max] = [min, max].map(|p| p.map(S::first));
    let form = BoxForm::Corners(min, max, [S::First::ZERO; 3]);
    apart::<S>(points.map(|p| p.map(S::first)), &form, [min, max])
}

/// The same for the box with this centre and these half-extents.
#[inline(always)]
pub(crate) fn apart_by_center<S: FirstFloat>(
    points: Points<S>,
    center: [S; 3],
    half: [S; 3],
) -> (bool, bool) {
    let [center, half] = [center, half].map(|p| p.map(S::first));
    let form = BoxForm::Center(center, half);
    apart::<S>(points.map(|p| p.map(S::first)), &form, [center, half])
}

#[inline(always)]
fn apart<S: FirstFloat>(
    points: Points<S::First>,
    form: &BoxForm<S::First>,
    of_box: [[S::First; 3]; 2],
) -> (bool, bool) {
    let frame = Frame::<Filtered<S::First>>::new(&points, form);
    let faces = faces(&frame);
    let size = frame.size();
    let bound = bound_of_size::<Filtered<S::First>>(size);
    let n = normal(&frame);
    let edges = edges(&frame, &n, bound.edge);
    let plane = plane::<Filtered<S::First>>(&n, &frame.v[0], &frame.h, bound.plane);
    let all = faces.or(edges).or(plane);
    let mut are_held = true;
    if let Some(limit) = S::FIRST_LIMIT {
        let [a, b, c] = points;
        for p in [a, b, c, of_box[0], of_box[1]] {
            let most = greatest(greatest(p[0].magnitude(), p[1].magnitude()), p[2].magnitude());
            are_held &= most < limit;
        }
    }
    // Faces take no products, so that their certainty does not hang on the size.
    let is_certain = faces.certain | size.in_range() & !(all.certain ^ all.possible);
    (all.certain, is_certain & are_held)
}
