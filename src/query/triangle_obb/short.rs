//! The first stage of fixed point: the triangle in the frame of the box, in words of 32 bits, with
//! a bound on the error.
//!
//! As in the published method, the triangle is transformed into the frame of the box, where the box
//! is axis-aligned. Vertices and extents arrive there with errors, together at most g along each
//! axis. If the true shapes have a point in common, the computed triangle has a point in the box
//! grown by g. A triangle that misses the grown box therefore misses the true one. Conversely, a
//! triangle that meets the box shrunk by g meets the true one. Both are exact queries about an
//! axis-aligned box. Triangles between the two are in doubt and go to later stages.
//!
//! # Numbers
//!
//! F is the number of fraction bits. In raw bits, d is a vertex relative to the centre, h_i a
//! half-extent, u_i an axis, and w_i = u_j × u_l. By Cramer's rule the point is in the box exactly
//! if |w_i·d|·2^F ≤ h_i·|u_0·w_0| for all i. Powers of two scale the greatest component of the axes
//! to 19 bits and lengths to 18; half-extents absorb the scale of the axes. The computed quantities
//! are then off by less than
//!
//! | quantity | magnitude | nothing cut | axes cut | lengths cut |
//! | --- | --- | --- | --- | --- |
//! | u, to the nearest | 2^19 | 0 | 1/2 | |
//! | d, to the nearest | 2^18 | 0 | | 1/2 + 2^-12 |
//! | h, to the nearest | 2^18 | 0 | | 1/2 |
//! | w_i = (u_j × u_l)/2^19, rounded down | 2^20 | 1 | 1 + 2 | |
//! | volume = u_0·w_0/2^19, rounded down | 2^21 | 1 + 3 | 1 + 9 + 3 | |
//! | vertex = w_i·d/2^10, rounded down | 3·2^28 | 1 + 768 | 1 + 2304 | and 1537 |
//! | extent = h_i·volume/2^10, rounded down | 2^29 | 1 + 1024 | 1 + 3328 | and 1024 |
//!
//! * w_i: two products of components up to 2^19, each off by 1/2; each product errs by 2^19.
//! * volume: three products of w_i, off by 1 or 3, with a component of u_0, up to 2^19; and of w_i,
//!   up to 2^20, with u_0, off by 1/2. No determinant of numbers up to 1 exceeds 4.
//! * vertex: three products of w_i, off by 1 or 3, with a length, up to 2^18; and of w_i, up to
//!   2^20, with a length, off by 1/2 + 2^-12.
//! * extent: the volume, off by 4 or 13, with h, up to 2^18; and the volume with h, off by 1/2.
//!
//! The last two columns add up to [`ERROR`], [`OF_AXES`] and [`OF_LENGTHS`]; `short.g` proves the
//! sums. A difference that does not fit its word is computed from halves, together off by up to
//! 1/2. It is cut by 13 bits or more, so this becomes at most 2^-12. The ends of a ray are off by less
//! than 2, and are cut by 13 bits or more (`line_obb::words`).
//!
//! Floats come as words of 29 bits (`floats`). 13 bits of lengths that are off by less than two are cut, and 9 of
//! axes that are off by less than one: that is 2^-12 and 2^-9, and [`OF_FLOATS`] more in the end.
//!
//! Sums of products take words of 32 bits in two parts. With one operand of 20 bits split in the
//! middle, three products are below 3·2^29.
//!
//! At the end everything is shifted down to 17 bits, by e bits. Vertices and extents are rounded
//! down and the error up, so g = error/2^e + 3 suffices, and a box shrunk by it lies inside. g is
//! below 2^8, so the kernel's lengths are below 2^18.

use super::Disjoint;
use super::known::{AXIS, Known, Sum, WholeBox, cut_axes, product, raw};
use crate::arithmetic::{InRaw, ProductSum, Raw, Word, greatest};
use crate::query::obb_short::size;
use crate::query::one_sided::{Projection, are_disjoint_within, one_sided};
use crate::scalar::Scalar;

/// The bits of a length.
const LENGTH: i32 = 18;
/// The bits of all numbers at the end.
const FINAL: i32 = 17;
/// The error of a vertex and an extent together, if nothing is cut.
const ERROR: i32 = 1794;
/// The error that cut axes add.
const OF_AXES: i32 = 3840;
/// The error that cut lengths add.
const OF_LENGTHS: i32 = 2561;
/// The error that numbers add which were floats.
pub(super) const OF_FLOATS: i32 = 16;

/// The least unit of vertices that are exact.
pub(in crate::query) const EXACT: i32 = i32::MIN;

/// A triangle in the frame of a box, and the box grown or shrunk by their errors.
pub(super) struct Framed {
    /// All numbers are within 2^18.
    shapes: [Projection<i32>; 3],
    /// How far the box is grown or shrunk on each side.
    by: i32,
}

/// Whether the box is grown or shrunk.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// A triangle that misses this box misses the true one.
    Grown,
    /// A triangle that meets this box meets the true one.
    Shrunk,
}

/// Vertices relative to the centre of a box over a power of two, and its exponent.
type Vertices<R> = ([[R; 3]; 3], i32);

/// Whether the triangle and the box are disjoint; `None` in doubt. `least` is the exponent of the least
/// unit in which the vertices are accurate enough.
#[inline(always)]
pub(in crate::query) fn are_disjoint<'c, R: Raw>(
    obb: &impl WholeBox,
    known: impl Fn() -> Known<'c>,
    least: i32,
    vertices: impl Fn() -> Vertices<R>,
) -> Option<bool> {
    // By reference, to save a copy.
    match framed(obb, known, Change::Shrunk, least, vertices).as_mut() {
        None => Some(true),
        Some(framed) => framed.are_disjoint(),
    }
}

/// The triangle in the frame of the box; `None` if a face of the box certainly separates them.
#[inline(never)]
fn framed<'c, R: Raw>(
    obb: &impl WholeBox,
    known: impl Fn() -> Known<'c>,
    change: Change,
    least: i32,
    vertices: impl Fn() -> Vertices<R>,
) -> Option<Framed> {
    // A constant, except for its numbers.
    let known = known();
    let longest = known.longest(obb);
    let u = cut_axes(obb, longest);
    let mut error = ERROR + obb.error();
    if longest > AXIS {
        error += OF_AXES;
    }

    let (d, exponent) = vertices();
    let half = [obb.half()];
    let longer = longest - obb.fraction_bits();
    let down = greatest(exponent + size(&d).bits(), known.reach(obb, longer)) - LENGTH;
    let down = greatest(down, least);
    let d = Raw::cut(d, down - exponent);
    let [h] = Raw::cut(half, down - longer);
    if greatest(down - exponent, down - longer) > 0 {
        error += OF_LENGTHS;
    }

    let (mut t, mut half) = ([[0; 3]; 3], [0; 3]);
    let (mut volume, mut most) = (0, 0);
    for i in 0..3 {
        let w = known.normal(&u, i);
        if i == 0 {
            volume = known.volume(&u, &w);
        }
        t[i] = [product(&w, &d[0]), product(&w, &d[1]), product(&w, &d[2])];
        half[i] = Sum::new(volume, h[i], 0, 0).scaled();
        let ([a, b, c], r) = (t[i], half[i] + error);
        if (r - a) & (r - b) & (r - c) < 0 || (r + a) & (r + b) & (r + c) < 0 {
            return None;
        }
        most |= size(&[t[i]]) | half[i];
    }

    // The error is at most 3 + (1794 + 3840 + 2561 + 16)/2^6.
    let down = greatest((most + (most >> 8)).bits() - FINAL, 6);
    let by = (error >> down) + 3;
    let change = if change == Change::Grown { by } else { -by };
    let on = |[a, b, c]: [i32; 3], half: i32| {
        let half = (half >> down) + change;
        Projection::new(-half, half + half, [a >> down, b >> down, c >> down])
    };
    Some(Framed { shapes: [on(t[0], half[0]), on(t[1], half[1]), on(t[2], half[2])], by })
}

impl<S: Scalar + InRaw, R> Disjoint<'_, S, R> {
    /// The answer, if the cut coordinates are certain of it.
    #[inline(always)]
    pub(super) fn in_short_words(&self) -> Option<bool> {
        are_disjoint(self.obb, || Known::Nothing, EXACT, move || self.vertices_from_center())
    }

    /// The triangle in the frame of the box; `None` if a face of the box certainly separates them.
    #[inline(always)]
    pub(super) fn framed(
        &self,
        change: Change,
        vertices: impl Fn(&Self) -> Vertices<S::Raw>,
    ) -> Option<Framed> {
        framed(self.obb, || Known::Nothing, change, EXACT, move || vertices(self))
    }

    /// The vertices relative to the centre.
    #[inline(always)]
    pub(super) fn vertices_from_center(&self) -> Vertices<S::Raw> {
        let near = self.vertices_from_near();
        let [x, y, z] = raw(&self.obb.center());
        let is_central = x.is_central() && y.is_central() && z.is_central();
        if S::ALWAYS_NEAR || (is_central && size(&near.0).bits() < S::Raw::BITS as i32 - 1) {
            near
        } else {
            self.vertices_from_far()
        }
    }

    /// The vertices if no difference of coordinates overflows.
    #[inline(always)]
    pub(super) fn vertices_from_near(&self) -> Vertices<S::Raw> {
        let [a, b, c] = self.triangle.vertices();
        let center = raw(&self.obb.center());
        let from =
            |p: [S::Raw; 3]| [p[0].minus(center[0]), p[1].minus(center[1]), p[2].minus(center[2])];
        ([from(raw(a)), from(raw(b)), from(raw(c))], 0)
    }

    /// The vertices if differences may not fit, from differences of halves.
    #[cold]
    #[inline(never)]
    fn vertices_from_far(&self) -> Vertices<S::Raw> {
        let points = self.triangle.vertices();
        let center = raw(&self.obb.center());
        let (mut d, mut halves, mut wraps) =
            ([[S::Raw::ZERO; 3]; 3], [[S::Raw::ZERO; 3]; 3], S::Raw::ZERO);
        for k in 0..3 {
            let p = raw(&points[k]);
            for i in 0..3 {
                d[k][i] = p[i].minus(center[i]);
                halves[k][i] = (p[i] >> 1) - (center[i] >> 1);
                wraps = wraps | ((p[i] ^ center[i]) & (p[i] ^ d[k][i]));
            }
        }
        if wraps < S::Raw::ZERO { (halves, 1) } else { (d, 0) }
    }
}

impl Framed {
    /// Whether the shapes are disjoint, by the shrunk box; `None` in doubt.
    #[inline(always)]
    fn are_disjoint(&mut self) -> Option<bool> {
        are_disjoint_within(&mut self.shapes, self.by)
    }

    /// Whether the shapes are disjoint for certain, by the grown box.
    #[inline(always)]
    pub(super) fn are_certainly_disjoint(&self) -> bool {
        one_sided(&self.shapes)
    }
}

#[cfg(test)]
mod tests;
