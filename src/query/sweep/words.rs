//! Whether a triangle misses a box all the way, in machine words, for fixed point on narrow registers.
//! It takes a sixth to a half of the instructions of the kernel in number systems, which computes
//! whole products, and a few thousand where that kernel leaves the question to exact sums, which take
//! millions. Neither of the two is then linked.
//!
//! The triangle sweeps a prism. As in `one_sided`, an axis counts only if it is normal to a face of
//! the prism minus the box. The sign of a product then says on which side of the axis the prism lies, and
//! only that side is tested. The triangle sweeps the same prism if it moves back from the end. The
//! kernel takes the way with n·d ≥ 0, for the normal n and the motion d.
//!
//! * On x_i × e_k it is the outer side of edge k, seen along x_i. If the motion leads outward, the edge
//!   counts at the end, and otherwise at the start. The sign of (e_k × d)_i says which.
//! * On x_i × d the box lies beyond all three vertices. Both sides are tested.
//! * On n the box is behind the triangle at the start, or in front of the triangle at the end.
//! * On e_k × d edge k sweeps a face of the prism. The opposite vertex is behind it by n·d. If that is
//!   zero, the whole prism lies in the plane of the face, and either side will do.
//!
//! Start and end are both within the range of [`Word`], and d is a difference between them, as an edge
//! is. All sums are therefore within the bounds stated there.

use super::Passing;
use crate::arithmetic::{
    InRaw, ProductSum, REGISTERS_ARE_WIDE, Word, out_of_line_if_wide, pick, three,
};
use crate::query::one_sided::{Closed, Projection, beyond_edge, beyond_plane, normals};
use crate::query::triangle_aabb::words::{extents, minus, projections, words};
use crate::scalar::Scalar;

/// Whether words answer all questions about a type. For 64 bits they would be wider, and slower, than
/// numbers of the type's own width.
#[inline(always)]
pub(super) fn serve<S: Scalar>() -> bool {
    !REGISTERS_ARE_WIDE && S::FLOAT.is_none() && size_of::<S>() <= 4
}

/// Whether they do so in fewer instructions than the kernel in number systems. In 8 bits all volumes fit
/// a register.
#[inline(always)]
pub(super) fn are_short<S: Scalar>() -> bool {
    serve::<S>() && size_of::<S>() > 1
}

/// Both shapes, with the triangle at the start or at the end.
type Shapes<W> = [Projection<W>; 3];

/// The motion in words.
pub(super) struct Swept<W> {
    start: Shapes<W>,
    end: Shapes<W>,
    d: [W; 3],
}

impl<S: Scalar + InRaw> Passing<'_, S> {
    /// Whether the triangle misses the box, in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(super) fn misses_in_any_words<W: Word>(&self) -> bool {
        self.swept::<W>().misses()
    }

    /// Whether the triangle misses the box, in words wide enough for shapes and motions near each
    /// other; `None` if they are not.
    #[inline(never)]
    pub(super) fn misses_in_near_words<W: Word>(&self) -> Option<bool> {
        let swept = self.swept::<W>();
        (self.is_central::<W>() && swept.longest().is_near()).then(|| swept.misses())
    }

    #[inline(always)]
    fn swept<W: Word>(&self) -> Swept<W> {
        let [from, to] = self.ends();
        let d = minus(&words(&to), &words(&from));
        let start = projections(self.triangle, self.aabb);
        Swept { start, end: three(|i| start[i].moved(d[i])), d }
    }

    /// Whether differences from the box and from the motion's start that were wrapped are long.
    #[inline(always)]
    fn is_central<W: Word>(&self) -> bool {
        let ([from, _], (min, _)) = (self.ends(), extents(self.aabb));
        words(&from).iter().chain(&min).all(|x: &W| x.is_central())
    }
}

impl<W: Word> Swept<W> {
    /// The shapes at the start, and the motion.
    #[inline(always)]
    pub(super) fn new(start: Shapes<W>, d: [W; 3]) -> Self {
        Self { start, end: three(|i| start[i].moved(d[i])), d }
    }

    /// Whether the box has not shrunk to nothing.
    pub(super) fn has_inside(&self) -> bool {
        !Projection::is_void(&self.start)
    }

    /// A number at least as long as each length, and less than twice as long as the longest.
    #[inline(always)]
    pub(super) fn longest(&self) -> W {
        Projection::longest(&self.start) | Projection::longest(&self.end)
    }

    #[inline(always)]
    pub(super) fn misses(&self) -> bool {
        self.is_beyond_face() || self.is_beyond_slanted::<W::Sum>()
    }

    /// Whether a face of the box separates all the way.
    #[inline(always)]
    pub(super) fn is_beyond_face(&self) -> bool {
        self.start.iter().zip(&self.end).any(|(start, end)| {
            let ([a, b, c], [p, q, r], size) = (start.t, end.t, start.size);
            let is_above = (size - a) & (size - b) & (size - c);
            a & b & c & p & q & r < W::ZERO
                || is_above & (size - p) & (size - q) & (size - r) < W::ZERO
        })
    }

    /// Whether another axis separates all the way.
    #[inline(always)]
    fn is_beyond_slanted<A: ProductSum<W>>(&self) -> bool {
        let n: [A; 3] = normals(&self.start);
        // The prism is the same if the triangle moves back from the end. It then moves along n.
        let (start, end, [dx, dy, dz]) = if A::is_negative(along(&n, &self.d)) {
            (&self.end, &self.start, minus(&[W::ZERO; 3], &self.d))
        } else {
            (&self.start, &self.end, self.d)
        };
        let [x, y, z] = start;
        let sides = [
            Side::new(n[0], [y, z], [dy, dz]),
            Side::new(n[1], [z, x], [dz, dx]),
            Side::new(n[2], [x, y], [dx, dy]),
        ];
        if sides.iter().any(Side::is_beyond) {
            return true;
        }
        let on = |shapes: &Shapes<W>| three(|i| (n[i], shapes[i].t[0], shapes[i].size));
        is_beyond::<W, A>(on(start), false)
            || is_beyond::<W, A>(on(end), true)
            || (0..3).any(|k| {
                is_beyond::<W, A>(
                    three(|i| (*pick(&sides[i].q, k), *pick(&start[i].t, k), start[i].size)),
                    false,
                )
            })
    }
}

/// n·d.
#[inline(always)]
fn along<W: Word, A: ProductSum<W>>(n: &[A; 3], d: &[W; 3]) -> A::Volume {
    n.iter().zip(d).fold(A::ZERO, |sum, (&n, &d)| A::sum(sum, n, d))
}

/// Whether the box lies behind a plane; with `in_mirror`, in front.
#[inline(always)]
fn is_beyond<W: Word, A: ProductSum<W>>(axes: [(A, W, W); 3], in_mirror: bool) -> bool {
    out_of_line_if_wide!(
        W,
        A::is_negative(beyond_plane::<W, A, Closed>(axes.into_iter(), in_mirror))
    )
}

/// Both shapes and the motion, seen along a coordinate axis.
struct Side<'a, W, A> {
    /// The component of the normal on this axis.
    n: A,
    /// The component of d × e, for the edge that ends at each vertex.
    q: [A; 3],
    /// The next two axes.
    jl: [&'a Projection<W>; 2],
    d: [W; 2],
}

impl<'a, W: Word, A: ProductSum<W>> Side<'a, W, A> {
    #[inline(never)]
    fn new(n: A, [j, l]: [&'a Projection<W>; 2], [dj, dl]: [W; 2]) -> Self {
        let ([a, b, c], [p, q, r]) = (j.t, l.t);
        let across = |ej, el| A::new(ej, dl, el, dj);
        let q = [across(c - a, p - r), across(a - b, q - p), across(b - c, r - q)];
        Self { n, q, jl: [j, l], d: [dj, dl] }
    }

    /// Whether a line along an edge or along the motion separates.
    #[inline(never)]
    fn is_beyond(&self) -> bool {
        let [dj, dl] = self.d;
        self.is_beyond_an_edge()
            || self.is_beyond_way([W::ZERO - dj, dl])
            || self.is_beyond_way([dj, W::ZERO - dl])
    }

    #[inline(always)]
    fn is_beyond_an_edge(&self) -> bool {
        let Self { n, q, jl: [j, l], d: [dj, dl] } = self;
        let turned = n.sign();
        let (mut vj, mut vl) = (j.t[2], l.t[2]);
        for ((&next_j, &next_l), q) in j.t.iter().zip(&l.t).zip(q) {
            // The outer side of a clockwise triangle is on the left.
            let (mut ej, mut el) = (vj - next_j, next_l - vl);
            if turned < W::ZERO {
                (ej, el) = (W::ZERO - ej, W::ZERO - el);
            }
            let is_early = q.sign() ^ turned;
            let v = [vj + dj.unless_negative(is_early), vl + dl.unless_negative(is_early)];
            if beyond_edge::<W, A, Closed>([j.size, l.size], v, [ej, el]).sign() < W::ZERO {
                return true;
            }
            (vj, vl) = (next_j, next_l);
        }
        false
    }

    #[inline(always)]
    fn is_beyond_way(&self, way: [W; 2]) -> bool {
        let [j, l] = self.jl;
        j.t.iter().zip(&l.t).all(|(&vj, &vl)| {
            beyond_edge::<W, A, Closed>([j.size, l.size], [vj, vl], way).sign() < W::ZERO
        })
    }
}

mod time;

#[cfg(all(test, feature = "fixed"))]
mod tests;
