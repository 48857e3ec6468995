//! The separating-axis kernel in any number system, on a box centred at the origin.
//!
//! By the separating axis theorem a triangle and a box are disjoint exactly if
//! their projections on one of 13 axes are: the box's three face normals
//! ([`faces`](super::faces)), the triangle's normal ([`plane`](super::plane)), and the nine
//! cross products of an edge of each ([`edges`](super::edges)).

use super::edges::{edges, one_edge};
use super::error_bound::error_bound;
use super::faces::faces;
use super::frame::{BoxForm, Frame};
use super::plane::{normal, plane};
use crate::arithmetic::{Arithmetic, Embeds, Number};
use crate::robust::Uncertain;
use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};

// Out of line, and each form apart. The compiler turns each into vector code that is the same for
// all callers; where the forms mix, it gathers loads.
#[inline(never)]
pub(super) fn by_center<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> Option<bool> {
    any_axis(&in_frame_of_center::<S, N>(triangle, center, half))
}

#[inline(never)]
pub(super) fn by_corners<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    min: &Vec3<S>,
    max: &Vec3<S>,
    grown: &Vec3<S>,
) -> Option<bool> {
    any_axis(&in_frame_of_corners::<S, N>(triangle, min, max, grown))
}

#[inline(always)]
pub(super) fn in_frame_of_center<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> Frame<N> {
    let [a, b, c] = triangle.points();
    let [a, b, c, center, half] = N::embed_held(&[a, b, c, center.to_array(), half.to_array()]);
    Frame::new(&[a, b, c], &BoxForm::Center(center, half))
}

#[inline(always)]
pub(super) fn in_frame_of_corners<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    min: &Vec3<S>,
    max: &Vec3<S>,
    grown: &Vec3<S>,
) -> Frame<N> {
    let [a, b, c] = triangle.points();
    let (min, max) = (min.to_array(), max.to_array());
    if !N::CORNER_FORM_ONLY {
        // Nothing is grown, and zeros need no check.
        let [a, b, c, min, max] = N::embed_held(&[a, b, c, min, max]);
        let form = BoxForm::Corners(min, max, [N::Length::ZERO; 3]);
        return Frame::new(&[a, b, c], &form);
    }
    let all = [a, b, c, min, max, grown.to_array()];
    let [a, b, c, min, max, grown] = N::embed_held(&all);
    Frame::new(&[a, b, c], &BoxForm::Corners(min, max, grown))
}

/// Whether one of the 13 axes separates, if `N` decides it.
#[inline(always)]
pub(super) fn any_axis<N: Arithmetic>(frame: &Frame<N>) -> Option<bool> {
    // A quarter to all of a scene's boxes lie off to one side.
    let faces = faces(frame);
    if faces.certain {
        return Some(true);
    }
    if N::LARGE {
        return Some(any_large_axis(frame));
    }

    let size = frame.size();
    let bound = error_bound::<N>(size)?;
    let n = normal(frame);
    let edges = edges(frame, &n, bound.edge);
    let plane = if N::is_narrow(size) {
        narrow_plane::<N>(n, frame.v[0], frame.h)
    } else {
        plane::<N>(&n, &frame.v[0], &frame.h, bound.plane)
    };
    faces.or(edges).or(plane).verdict()
}

/// The same of large numbers, after the faces: one axis after another, until one separates.
fn any_large_axis<N: Arithmetic>(frame: &Frame<N>) -> bool {
    let n = normal(frame);
    plane::<N>(&n, &frame.v[0], &frame.h, Number::ZERO).certain
        || (0..9).any(|axis| one_large_edge(frame, &n, axis % 3, axis / 3))
}

#[inline(never)]
fn one_large_edge<N: Arithmetic>(frame: &Frame<N>, n: &[N::Area; 3], i: usize, k: usize) -> bool {
    one_edge(frame, n, Number::ZERO, i % 3, k % 3).certain
}

/// The plane test in narrower volumes. Integers only: they have no error to
/// allow for. By value, so that no reference keeps the frame in memory.
#[inline(always)]
pub(super) fn narrow_plane<N: Arithmetic>(
    n: [N::Area; 3],
    v: [N::Length; 3],
    h: [N::Length; 3],
) -> Uncertain {
    plane::<N::Narrow>(&n, &v, &h, Number::ZERO)
}
