//! Triangle and axis-aligned box in machine words, for narrow registers: shared by the kernel of the
//! two and by the first stage of triangle and oriented box.

use super::relation::Relation;
use crate::arithmetic::{ProductSum, Word, out_of_line_if_wide};

/// Whether one of the remaining 10 axes separates a triangle from a box, if no face of the box does
/// ([`Projection::are_apart`]). For cores on which a product of words is cheap and a wider one is
/// not.
///
/// Each edge axis is tested on one side only. On x_i × e_k the vertices of edge k project to zero,
/// and the opposite vertex to n_i, a component of the normal. Along x_i we see a triangle and a
/// rectangle in a plane. If they are disjoint, a line along one of their sides separates them: a
/// side of the rectangle, which is a face of the box, or a side of the triangle with the whole
/// rectangle on its outer side; the sign of n_i says which side that is. (If n_i is zero, the
/// three edges lie on one line. They do not all point the same way, so together they test both
/// sides.)
///
/// Only the signs of areas and volumes are needed: see [`ProductSum`].
#[inline(never)]
pub(super) fn one_sided<W: Word>(shapes: &[Projection<W>; 3]) -> bool {
    in_areas::<W, W::Sum, Closed>(shapes)
}

/// Whether one of all 13 axes separates.
#[inline(always)]
pub(super) fn are_disjoint<W: Word>(shapes: &[Projection<W>; 3]) -> bool {
    Projection::are_apart(shapes) || one_sided(shapes)
}

/// Whether a triangle and a box are disjoint, given the box shrunk by an error on each side; `None` in doubt. A
/// triangle that meets the shrunk box meets the true one, and one that misses the grown box misses it.
#[inline(always)]
pub(super) fn are_disjoint_within<W: Word>(shrunk: &mut [Projection<W>; 3], by: W) -> Option<bool> {
    // A box thinner than the error has no inside left.
    if !Projection::is_void(shrunk) && !are_disjoint(shrunk) {
        return Some(false);
    }
    // In place, to save stack.
    for shape in shrunk.iter_mut() {
        *shape = shape.grown(by.plus(by));
    }
    one_sided(shrunk).then_some(true)
}

/// How a triangle and a box lie to each other.
///
/// The interiors are disjoint exactly if an axis has a gap of zero or more, unless both shapes
/// project to one point. The axes and sides of [`one_sided`] suffice: these are the facets of the
/// difference of the shapes.
#[inline(always)]
pub(super) fn relation<W: Word>(shapes: &[Projection<W>; 3]) -> Relation {
    if !shapes.iter().any(Projection::may_touch) && !one_sided_or_touching(shapes) {
        Relation::Overlapping
    } else if Projection::are_apart(shapes) || one_sided(shapes) {
        Relation::Disjoint
    } else {
        Relation::Touching
    }
}

#[inline(never)]
fn one_sided_or_touching<W: Word>(shapes: &[Projection<W>; 3]) -> bool {
    in_areas::<W, W::Sum, Open>(shapes)
}

/// The sets that an axis is to separate.
pub(super) trait Sets {
    const ARE_OPEN: bool;

    #[inline(always)]
    fn difference<W: Word>(a: W, b: W) -> W {
        if Self::ARE_OPEN { b - a } else { a - b }
    }

    /// Whether the axis separates, by the sign of a sum of products of such differences.
    #[inline(always)]
    fn are_apart(is_negative: bool) -> bool {
        is_negative != Self::ARE_OPEN
    }
}

/// The shapes: the gap has to be above zero.
pub(super) struct Closed;
/// Their interiors: zero suffices.
struct Open;

impl Sets for Closed {
    const ARE_OPEN: bool = false;
}
impl Sets for Open {
    const ARE_OPEN: bool = true;
}

#[inline(always)]
fn in_areas<W: Word, A: ProductSum<W>, K: Sets>(shapes: &[Projection<W>; 3]) -> bool {
    let [x, y, z] = shapes;
    let n: [A; 3] = normals(shapes);
    let turned = [turned(n[0], y, z), turned(n[1], z, x), turned(n[2], x, y)];
    turned.iter().any(|(j, l)| an_edge_misses::<W, A, K>(j, l))
        || [false, true].iter().any(|&in_mirror| is_behind::<W, A, K>(shapes, &n, in_mirror))
}

/// The components of the normal.
#[inline(always)]
pub(super) fn normals<W: Word, A: ProductSum<W>>([x, y, z]: &[Projection<W>; 3]) -> [A; 3] {
    [normal(y, z), normal(z, x), normal(x, y)]
}

/// A triangle and a box, projected on one coordinate axis, relative to the least corner of the box.
#[derive(Clone, Copy)]
pub(super) struct Projection<W> {
    /// The vertices.
    pub(super) t: [W; 3],
    /// The extent of the box.
    pub(super) size: W,
}

impl<W: Word> Projection<W> {
    /// The projection of these vertices, and of the box from `min` with extent `size`.
    #[inline(always)]
    pub(super) fn new(min: W, size: W, [a, b, c]: [W; 3]) -> Self {
        Self { t: [a.minus(min), b.minus(min), c.minus(min)], size }
    }

    /// Whether words have room for every result computed from these lengths. The lengths themselves
    /// must not have wrapped.
    #[inline(always)]
    pub(super) fn are_near(shapes: &[Self; 3]) -> bool {
        Self::longest(shapes).is_near()
    }

    /// A number at least as long as each length on all axes, and less than twice as long as the
    /// longest.
    #[inline(always)]
    pub(super) fn longest([x, y, z]: &[Self; 3]) -> W {
        x.lengths() | y.lengths() | z.lengths()
    }

    /// Whether a face of the box separates.
    #[inline(always)]
    pub(super) fn are_apart(shapes: &[Self; 3]) -> bool {
        shapes.iter().any(Self::is_apart)
    }

    /// Whether the axis separates the interiors.
    #[inline(always)]
    fn may_touch(&self) -> bool {
        let ([a, b, c], size) = (self.t, self.size);
        let is_beside = (W::ZERO - a) | (W::ZERO - b) | (W::ZERO - c) >= W::ZERO
            || (a - size) | (b - size) | (c - size) >= W::ZERO;
        is_beside && a | b | c | size != W::ZERO
    }

    /// The same with the box grown on either side.
    #[inline(always)]
    pub(super) fn grown(self, by: W) -> Self {
        let [a, b, c] = self.t;
        Self { t: [a.plus(by), b.plus(by), c.plus(by)], size: self.size.plus(by).plus(by) }
    }

    /// The same over 2^`down`, each number rounded down.
    #[inline(always)]
    pub(super) fn over(self, down: u32) -> Self {
        let [a, b, c] = self.t;
        Self { t: [a >> down, b >> down, c >> down], size: self.size >> down }
    }

    /// The same with the triangle moved.
    #[inline(always)]
    pub(super) fn moved(self, by: W) -> Self {
        let [a, b, c] = self.t;
        Self { t: [a.plus(by), b.plus(by), c.plus(by)], ..self }
    }

    /// Whether a box has shrunk to nothing.
    #[inline(always)]
    pub(super) fn is_void([x, y, z]: &[Self; 3]) -> bool {
        x.size | y.size | z.size < W::ZERO
    }

    /// A number at least as long as each of the lengths, and less than twice as long as the
    /// longest.
    #[inline(always)]
    fn lengths(&self) -> W {
        let [a, b, c] = self.t;
        a.folded() | b.folded() | c.folded() | self.size
    }

    /// Whether the axis separates: all three differences have the same sign.
    #[inline(always)]
    fn is_apart(&self) -> bool {
        let ([a, b, c], size) = (self.t, self.size);
        a & b & c < W::ZERO || (size - a) & (size - b) & (size - c) < W::ZERO
    }
}

/// The component of the normal along the axis that precedes j and l.
#[inline(always)]
fn normal<W: Word, A: ProductSum<W>>(j: &Projection<W>, l: &Projection<W>) -> A {
    out_of_line_if_wide!(W, {
        let ([a, b, c], [p, q, r]) = (j.t, l.t);
        A::new(b - a, r - q, b - c, q - p)
    })
}

/// The two axes in the order in which the triangle turns from the first to the second; a clockwise
/// triangle exchanges them.
#[inline(always)]
fn turned<'a, W: Word, A: ProductSum<W>>(
    n: A,
    j: &'a Projection<W>,
    l: &'a Projection<W>,
) -> (&'a Projection<W>, &'a Projection<W>) {
    if n.sign() < W::ZERO { (l, j) } else { (j, l) }
}

/// Whether an edge of a triangle that turns from `j` to `l` has the whole box on its outer side:
/// all x with e_j·(x_l − v_l) < e_l·(x_j − v_j).
#[inline(always)]
fn an_edge_misses<W: Word, A: ProductSum<W>, K: Sets>(
    j: &Projection<W>,
    l: &Projection<W>,
) -> bool {
    out_of_line_if_wide!(W, {
        let (mut vj, mut vl) = (j.t[2], l.t[2]);
        for (&next_j, &next_l) in j.t.iter().zip(&l.t) {
            // As a sum, which takes one instruction less. For a zero component either end will do.
            let e = [vj - next_j, next_l - vl];
            let beyond = beyond_edge::<W, A, K>([j.size, l.size], [vj, vl], e).sign();
            if K::are_apart(beyond < W::ZERO)
                && (!K::ARE_OPEN
                    || has_extent::<W, A>(j, l, e)
                    || beyond_edge::<W, A, Closed>([j.size, l.size], [vj, vl], e).sign() < W::ZERO)
            {
                return true;
            }
            (vj, vl) = (next_j, next_l);
        }
        false
    })
}

/// The greatest e_j·(x_l − v_l) − e_l·(x_j − v_j) of the box, given v, −e_j and e_l; of interiors with
/// the opposite sign. Below zero if the whole box lies on the outer side of the edge.
#[inline(always)]
pub(super) fn beyond_edge<W: Word, A: ProductSum<W>, K: Sets>(
    [size_j, size_l]: [W; 2],
    [vj, vl]: [W; 2],
    [ej, el]: [W; 2],
) -> A {
    let (xj, xl) = (size_j.where_negative(el), size_l.where_negative(ej));
    A::new(K::difference(vl, xl), ej, K::difference(vj, xj), el)
}

/// Whether the shapes are more than a point on the axis of an edge.
#[inline(never)]
fn has_extent<W: Word, A: ProductSum<W>>(
    j: &Projection<W>,
    l: &Projection<W>,
    [ej, el]: [W; 2],
) -> bool {
    let (has_j, has_l) = (j.size != W::ZERO, l.size != W::ZERO);
    el != W::ZERO && has_j || ej != W::ZERO && has_l || has_area::<W, A>(j, l)
}

/// Whether a component of the normal is not zero.
#[inline(never)]
fn has_area<W: Word, A: ProductSum<W>>(j: &Projection<W>, l: &Projection<W>) -> bool {
    normal::<W, A>(j, l).sign() < W::ZERO || normal::<W, A>(l, j).sign() < W::ZERO
}

/// Whether the box is more than a point on the normal.
#[inline(never)]
fn has_depth<W: Word, A: ProductSum<W>>([x, y, z]: &[Projection<W>; 3]) -> bool {
    let has = |i: &Projection<W>, j, l| i.size != W::ZERO && has_area::<W, A>(j, l);
    has(x, y, z) || has(y, z, x) || has(z, x, y)
}

/// Whether the whole box lies behind the plane of the triangle. With `in_mirror`, whether it lies in
/// front.
#[inline(always)]
fn is_behind<W: Word, A: ProductSum<W>, K: Sets>(
    shapes: &[Projection<W>; 3],
    n: &[A; 3],
    in_mirror: bool,
) -> bool {
    out_of_line_if_wide!(W, {
        let axes = shapes.iter().zip(n).map(|(s, &n)| (n, s.t[0], s.size));
        K::are_apart(A::is_negative(beyond_plane::<W, A, K>(axes, in_mirror)))
            && (!K::ARE_OPEN
                || has_depth::<W, A>(shapes)
                || is_behind::<W, A, Closed>(shapes, n, in_mirror))
    })
}

/// The greatest n·(x − v) of the box, with a vertex v. It is found at the corner farthest along the
/// normal, one of the two critical corners of Haines and Wallace. With `in_mirror`, the greatest
/// −n·(x − v). Of interiors with the opposite sign. Each axis has n, v and the extent of the box.
#[inline(always)]
pub(super) fn beyond_plane<W: Word, A: ProductSum<W>, K: Sets>(
    axes: impl Iterator<Item = (A, W, W)>,
    in_mirror: bool,
) -> A::Volume {
    let mut volume = A::ZERO;
    for (n, v, size) in axes {
        let up = n.sign();
        let beyond = if in_mirror {
            K::difference(v, size.where_negative(up))
        } else {
            K::difference(size.unless_negative(up), v)
        };
        volume = A::sum(volume, n, beyond);
    }
    volume
}

#[cfg(test)]
mod tests;
