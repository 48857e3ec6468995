//! Polygon against axis-aligned box as published in 1995: outcodes, each edge, and one diagonal of
//! the box.
//!
//! D. Green, D. Hatch, "Fast Polygon-Cube Intersection Testing", *Graphics Gems V*, 1995, with the
//! outcodes of D. Voorhies, "Triangle-Cube Intersection", *Graphics Gems III*, 1992. Written from
//! the descriptions. Akenine-Möller's paper of 2001 compares itself with this test.

use super::separating_axes::{center_half, segment_misses};
use super::{Triple, rounded};
use crate::arithmetic::{Each, Number, Rounded, cross3, dot3, minus3, turn};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Polygon};

/// Does the polygon overlap the box, by the test of Green and Hatch? In the scalar's own
/// arithmetic, and sometimes wrong.
///
/// *Geometry*: a convex polygon in one plane. Of a bent polygon it sees the edges, and the plane
/// through the first vertex that is nearest to the polygon.
///
/// *Numerics*: within rounding of contact it errs in both directions. In fixed point, products lose
/// their last bits and wrap around outside the range. A box given by its corners is first converted
/// to centre and half-extents, rounded.
///
/// *Panics*: never. *Cost*: where outcodes do not decide, 12 multiplications an edge, six a vertex,
/// and a division. It is here for comparison; [`Polygon::overlaps`] is exact.
///
/// *Source*: Green and Hatch 1995; outcodes of faces, edges and corners by Voorhies 1992. Their box
/// is the unit cube. Ours is any box around the origin, and its half-extents replace the halves in
/// outcodes and diagonals.
#[inline]
#[must_use]
pub fn overlaps<S: Scalar>(polygon: &Polygon<'_, S>, aabb: &Aabb<S>) -> bool {
    let (center, h) = center_half(aabb);
    let vertices = polygon.vertices();
    let vertex = |k: usize| minus3(&rounded(vertices[k].to_array()), &center);

    let (mut faces, mut bevels) = (!0, !0);
    for k in 0..vertices.len() {
        let v = vertex(k);
        let code = face_code(&v, &h);
        if code == 0 {
            return true;
        }
        faces &= code;
        bevels &= bevel_code(&v, &h);
    }
    if faces != 0 || bevels != 0 {
        return false;
    }

    let mut before = vertex(vertices.len() - 1);
    for k in 0..vertices.len() {
        let v = vertex(k);
        if face_code(&before, &h) & face_code(&v, &h) == 0 && !segment_misses(before, v, h) {
            return true;
        }
        before = v;
    }
    is_crossed_by_diagonal(vertices.len(), vertex, h)
}

/// The faces of the box that a point lies beyond.
#[inline(always)]
fn face_code<S: Scalar>(p: &Triple<S>, h: &Triple<S>) -> u32 {
    let mut code = 0;
    for i in 0..3 {
        code |= u32::from(p[i] > h[i]) << (2 * i) | u32::from(p[i] < -h[i]) << (2 * i + 1);
    }
    code
}

/// The planes through the twelve edges and the eight corners that a point lies beyond.
#[inline(always)]
fn bevel_code<S: Scalar>(&[x, y, z]: &Triple<S>, h: &Triple<S>) -> u32 {
    let mut code = 0;
    let mut bit = 0;
    let mut add = |p: Rounded<S>, most: Rounded<S>| {
        code |= (u32::from(p > most) | u32::from(p < -most) << 1) << bit;
        bit += 2;
    };
    for (a, b, most) in [(x, y, h[0] + h[1]), (y, z, h[1] + h[2]), (z, x, h[2] + h[0])] {
        add(a + b, most);
        add(a - b, most);
    }
    let most = h[0] + h[1] + h[2];
    add(x + y + z, most);
    add(x + y - z, most);
    add(x - y + z, most);
    add(x - y - z, most);
    code
}

/// Does the diagonal of the box that is nearest to the normal cross the polygon?
#[inline(always)]
fn is_crossed_by_diagonal<S: Scalar>(
    count: usize,
    vertex: impl Fn(usize) -> Triple<S>,
    h: Triple<S>,
) -> bool {
    let first = vertex(0);
    let mut n = [Rounded::ZERO; 3];
    let mut e = minus3(&vertex(1), &first);
    for k in 2..count {
        let f = minus3(&vertex(k), &first);
        let part = cross3(&e, &f);
        n = [n[0] + part[0], n[1] + part[1], n[2] + part[2]];
        e = f;
    }
    let diagonal = [0, 1, 2].each(|i: usize| if n[i] < Rounded::ZERO { -h[i] } else { h[i] });
    let (offset, most) = (dot3(&n, &first), dot3(&n, &diagonal));
    // The plane misses the box.
    if offset.magnitude() > most {
        return false;
    }
    let t = Rounded(offset.0.plain_div(most.0));
    // Is the point inside, in the coordinate plane in which the polygon looks largest? If the
    // normal is zero, the point is NaN, and only the edges decide.
    let size = n.each(Rounded::magnitude);
    let largest = if size[0] > size[1] { 0 } else { 1 };
    let (_, j, k) = turn(if size[2] > size[largest] { 2 } else { largest });
    let (x, y) = (diagonal[j] * t, diagonal[k] * t);
    let (mut is_left, mut is_right) = (true, true);
    let mut p = vertex(count - 1);
    for i in 0..count {
        let q = vertex(i);
        let side = (q[j] - p[j]) * (y - p[k]) - (q[k] - p[k]) * (x - p[j]);
        is_left &= side >= Rounded::ZERO;
        is_right &= side <= Rounded::ZERO;
        p = q;
    }
    is_left || is_right
}
