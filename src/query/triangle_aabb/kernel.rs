//! The separating-axis kernel in any number system, on a box centred at the origin.
//!
//! By the separating axis theorem a triangle and a box are disjoint exactly if
//! their projections on one of 13 axes are: the box's three face normals ([`faces`]),
//! the triangle's normal ([`plane`]), and the nine cross products of an edge of each ([`edges`]).

use super::error_bound::error_bound;
use super::frame::{BoxForm, Frame, range};
use crate::arithmetic::{
    Arithmetic, Embeds, Number, cross, dot, following, greatest, of_two, three,
};
use crate::robust::Uncertain;
use crate::scalar::Scalar;
use crate::shape::{AabbForm, Triangle, Vec3};

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

/// The triangle in the frame of the box; `N` holds both.
#[inline(always)]
pub(super) fn in_frame<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    form: &AabbForm<S>,
) -> Frame<N> {
    match form {
        AabbForm::Center { center, half } => in_frame_of_center(triangle, center, half),
        AabbForm::Corners { min, max } => {
            in_frame_of_corners(triangle, min, max, &Vec3::splat(S::ZERO))
        }
    }
}

#[inline(always)]
fn in_frame_of_center<S: Scalar, N: Embeds<S>>(
    triangle: &Triangle<S>,
    center: &Vec3<S>,
    half: &Vec3<S>,
) -> Frame<N> {
    let [a, b, c] = triangle.points();
    let [a, b, c, center, half] = N::embed_held(&[a, b, c, center.to_array(), half.to_array()]);
    Frame::new(&[a, b, c], &BoxForm::Center(center, half))
}

#[inline(always)]
fn in_frame_of_corners<S: Scalar, N: Embeds<S>>(
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
    faces.or(edges).or(plane_of_size(frame, n, size, bound.plane)).verdict()
}

/// The same of large numbers, after the faces: one axis after another, until one separates.
fn any_large_axis<N: Arithmetic>(frame: &Frame<N>) -> bool {
    let n = normal(frame);
    plane::<N>(&n, &frame.v[0], &frame.h, Number::ZERO).certain
        || (0..3).any(|k| (0..3).any(|i| one_large_edge(frame, &n, i, k)))
}

#[inline(never)]
fn one_large_edge<N: Arithmetic>(frame: &Frame<N>, n: &[N::Area; 3], i: usize, k: usize) -> bool {
    one_edge(frame, n, Number::ZERO, following::<N>(i).0, following::<N>(k).0).certain
}

/// [`plane`], in narrower volumes if the size permits.
#[inline(always)]
pub(super) fn plane_of_size<N: Arithmetic>(
    frame: &Frame<N>,
    n: [N::Area; 3],
    size: N::Length,
    error_bound: N::Volume,
) -> Uncertain {
    if N::is_narrow(size) {
        // Integers only: they have no error to allow for. Copies, so that no reference keeps the
        // frame in memory.
        let (n, v, h) = (n, frame.v[0], frame.h);
        return plane::<N::Narrow>(&n, &v, &h, Number::ZERO);
    }
    plane::<N>(&n, &frame.v[0], &frame.h, error_bound)
}

/// Whether one of the box's three face normals separates.
///
/// They are the coordinate axes, and the projections are the coordinates.
#[inline(always)]
pub(super) fn faces<N: Arithmetic>(frame: &Frame<N>) -> Uncertain {
    if N::LARGE {
        return Uncertain::known((0..3).any(|i| one_face(frame, i).certain));
    }
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

/// The triangle's normal, e0 × e1.
#[inline(always)]
pub(in crate::query) fn normal<N: Arithmetic>(frame: &Frame<N>) -> [N::Area; 3] {
    let [e0, e1, _] = &frame.e;
    cross::<N>(e0, e1)
}

/// Whether the triangle's normal separates: whether the plane of the triangle
/// misses the box.
///
/// The triangle projects to one number, n·v, and the box to ±Σ h·|n|: the
/// distances along n to the two critical corners of Haines and Wallace.
#[inline(always)]
pub(in crate::query) fn plane<N: Arithmetic>(
    n: &[N::Area; 3],
    v: &[N::Length; 3],
    h: &[N::Length; 3],
    error_bound: N::Volume,
) -> Uncertain {
    let distance = dot::<N>(n, v);
    if N::LARGE {
        // A short number changes its sign more easily than a long one.
        let h = three(|i| if n[i] < N::Area::ZERO { -h[i] } else { h[i] });
        let certain = distance.magnitude() > dot::<N>(n, &h);
        return Uncertain { certain, possible: certain };
    }
    let radius = N::volume(n[0].magnitude(), h[0])
        + N::volume(n[1].magnitude(), h[1])
        + N::volume(n[2].magnitude(), h[2]);
    let beyond = distance.magnitude() - radius;
    Uncertain::above(beyond, error_bound)
}

/// Whether one of the nine cross products of a coordinate axis x_i and an edge e_k separates.
///
/// Project on x_i × e_k from the vertex v_k where the edge begins. The whole edge projects to p =
/// (e_k × v_k)_i, and the opposite vertex to p + n_i. The component n_i of the triangle's normal is
/// the same for all three edges. So the triangle covers the interval from p to p + n_i, with middle
/// p + n_i/2 and radius |n_i|/2. The box covers ±r with r = h_j·|e_l| + h_l·|e_j|. The axis
/// separates if |p + n_i/2| > |n_i|/2 + r.
#[inline(always)]
pub(super) fn edges<N: Arithmetic>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    error_bound: N::Area,
) -> Uncertain {
    let mut so_far = Uncertain::NONE;
    for k in 0..3 {
        for i in 0..3 {
            so_far = so_far.or(one_edge(frame, n, error_bound, i, k));
        }
    }
    so_far
}

/// The projections of the shapes on the cross product of coordinate axis `i` and edge `k`: the
/// magnitude of p + n_i/2, the sum |n_i|/2 + r, and whether the axis is not zero.
#[inline(always)]
pub(super) fn edge_axis<N: Arithmetic>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    i: usize,
    k: usize,
) -> (N::Area, N::Area, impl Fn() -> bool) {
    let (_, j, l) = following::<N>(i);
    let (e, v, h) = (&frame.e[k], &frame.v[k], &frame.h);

    let p = N::minor([e[j], v[l]], [e[l], v[j]]);
    let r = N::area(e[l].magnitude(), h[j]) + N::area(e[j].magnitude(), h[l]);
    let middle = of_two::<N, _>(n[i]);
    // An edge along x_i has e_j = e_l = 0, exactly: the axis is zero and separates nothing. Without
    // this rule every box-shaped mesh would be in doubt.
    let is_axis = move || (e[j] != N::Length::ZERO) | (e[l] != N::Length::ZERO);
    ((p + middle).magnitude(), middle.magnitude() + r, is_axis)
}

/// Whether the cross product of coordinate axis `i` and edge `k` separates.
#[inline(always)]
pub(super) fn one_edge<N: Arithmetic>(
    frame: &Frame<N>,
    n: &[N::Area; 3],
    error_bound: N::Area,
    i: usize,
    k: usize,
) -> Uncertain {
    let (far, reach, is_axis) = edge_axis(frame, n, i, k);
    if N::CERTAIN {
        return Uncertain::known(far > reach);
    }
    // Rounded as in `rows`, so that the same is certain on every machine.
    let found = Uncertain::above(far - reach, error_bound);
    Uncertain { possible: found.possible & is_axis(), ..found }
}
