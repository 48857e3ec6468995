//! A triangle or a face of a box, seen along the normal of a contact, and where its corners certainly
//! are, seen from another face.

use core::ops::{Div, Mul, Sub};

use super::body::{Vec64, dot};
use super::sides::Flat;
use super::solid::{EDGES, FACES, Solid};
use super::view::{Corner, Edge, View};
use crate::arithmetic::{REGISTERS_ARE_WIDE, greatest, pick};

/// The most corners that a face has.
pub(super) const CORNERS: usize = 4;

/// A triangle, or a face of a box.
pub(super) struct Face {
    pub(super) corners: [Corner; CORNERS],
    vertices: [u8; CORNERS],
    edges: [u8; CORNERS],
    /// How many corners and edges it has.
    pub(super) count: usize,
    pub(super) number: u8,
    /// The corners in words, if the view has a unit.
    pub(super) words: Option<[Flat; CORNERS]>,
}

impl Face {
    /// The triangle, or face `number` of the box. Filled where it is returned: not borrowed, and so not
    /// copied.
    #[inline(never)]
    pub(super) fn new(view: &View, shape: &Solid<'_>, number: u8) -> Self {
        let mut face = Self {
            corners: [Corner { at: [0.0; 3], flat: [0.0; 2] }; CORNERS],
            vertices: [0, 1, 2, 2],
            edges: [0, 1, 2, 2],
            count: 3,
            number,
            words: None,
        };
        if shape.rough.is_triangle {
            for k in 0..CORNERS {
                face.corners[k] = view.corner(*pick(&shape.rough.at, k));
            }
        } else {
            let n = usize::from(number & 7);
            face.count = CORNERS;
            (face.vertices, face.edges) = (FACES[n], EDGES[n]);
            if REGISTERS_ARE_WIDE {
                face.corners = shape.face(view, number);
            } else {
                for k in 0..CORNERS {
                    face.corners[k] = view.corner(shape.corner(FACES[n][k]));
                }
            }
        }
        if let Some(unit) = view.unit {
            let mut words = [[0; 2]; CORNERS];
            for (k, word) in words.iter_mut().enumerate() {
                let flat = face.corners[k % CORNERS].flat;
                *word = unit.flat(&flat);
            }
            face.words = Some(words);
        }
        face
    }

    /// The corner after corner n.
    pub(super) fn next(&self, n: usize) -> usize {
        if n + 1 < self.count { n + 1 } else { 0 }
    }

    /// The vertex at each corner, and the corner.
    pub(super) fn corners(&self) -> impl Iterator<Item = (u8, &Corner)> {
        self.vertices.into_iter().zip(&self.corners).take(self.count)
    }

    pub(super) fn edges(&self) -> impl Iterator<Item = Edge<'_>> {
        (0..self.count).map(|n| self.edge(n))
    }

    pub(super) fn vertex(&self, n: usize) -> u8 {
        self.vertices[n % CORNERS]
    }

    pub(super) fn corner(&self, n: usize) -> &Corner {
        &self.corners[n % CORNERS]
    }

    /// A corner, the next, and the one before.
    pub(super) fn frame(&self) -> [&Corner; 3] {
        [self.corner(0), self.corner(1), self.corner(self.count - 1)]
    }

    /// The ends of edge n.
    pub(super) fn ends(&self, n: usize) -> [&Corner; 2] {
        [self.corner(n), self.corner(self.next(n))]
    }

    pub(super) fn edge(&self, n: usize) -> Edge<'_> {
        Edge { ends: self.ends(n), number: self.edges[n % CORNERS] }
    }

    /// The corner farthest against a direction, and its vertex.
    pub(super) fn lowest(&self, outward: &Vec64) -> (Vec64, u8) {
        let (mut lowest, mut number) = (self.corners[0].at, self.vertices[0]);
        for (vertex, Corner { at, .. }) in self.corners() {
            if dot(outward, at) < dot(outward, &lowest) {
                (lowest, number) = (*at, vertex);
            }
        }
        (lowest, number)
    }
}

/// The positions of a face's corners relative to another face, where they are certain.
pub(super) trait Known {
    /// The corners certainly within the other face, and those certainly outside of it, as bits. All others
    /// are so near an edge that they may meet it.
    fn within(&self) -> (u32, u32);
    /// The point within the other face that meets corner m.
    fn point(&self, m: usize) -> Option<Vec64>;
    /// Which pairs of edges may cross, and for which [`sides`](Self::sides) is called. On small cores these
    /// cross for certain. Bit 4·n + m stands for edge n of the opposite face and edge m of this face;
    /// `back` has the positions of the opposite face's corners.
    fn crossings(&self, back: &Self) -> [u32; 2];
    /// The signed distances of the ends of edge m, times the length of edge n.
    fn sides(&self, n: usize, m: usize) -> [f64; 2];
    /// Whether corner m may meet edge n.
    fn may_meet(&self, n: usize, m: usize) -> bool;
}

/// The places of the bits that are set, the lowest first.
pub(super) fn ones(mut bits: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let n = bits.trailing_zeros() as usize;
        let is_one = bits != 0;
        bits &= bits.wrapping_sub(1);
        is_one.then_some(n)
    })
}

/// The corners with a bit at some edge.
#[inline(always)]
fn any(bits: u32) -> u32 {
    (bits | bits >> 4 | bits >> 8 | bits >> 12) & 15
}

/// The corners within a face and outside of it, given the corners certainly left and right of each edge.
///
/// The lines of all edges have a point of the face on the same side.
#[inline(always)]
pub(super) fn within(all: u32, left: u32, right: u32) -> (u32, u32) {
    (any(all) & !(any(all & !left) & any(all & !right)), any(left) & any(right))
}

/// A bit for each edge of a face, at the first corner of the other.
pub(super) const EACH: u32 = 0x1111;

/// Each corner's bit moves to the corner before it.
#[inline(always)]
pub(super) fn next(bits: u32, last: usize) -> u32 {
    bits >> 1 & (EACH * ((1 << last) - 1)) | (bits & EACH) << last
}

/// Rows and columns of four bits change places.
#[inline(always)]
pub(super) fn transposed(x: u32) -> u32 {
    let change = (x ^ x >> 3) & 0x0a0a;
    let x = x ^ change ^ change << 3;
    let change = (x ^ x >> 6) & 0x00cc;
    x ^ change ^ change << 6
}

/// Solves s·a + t·b = c for s and t, which are not finite if a and b are parallel. The greatest
/// coefficient is the pivot, so that the residual is small even if a and b are nearly parallel.
///
/// # The error
///
/// With the sizes of [`View`]. No coefficient is above M = 2·√3·S, and s and t are from zero to one. Then the
/// residual of the first equation is at most 3·u·M, and of the second 13·u·M. Each of the three coefficients
/// is off by u·M. The place, from two sides of a face, errs by 10·u·S in each coordinate: across the normal by
/// 10·√3·u·S. A coordinate across the normal errs by 3·√3·u·S for the place, and by as much for each of the
/// three corners. So the place is off by less than 59·u·S in one coordinate across the normal, and by less than
/// 94·u·S in the other. That is 111·u·S, below half the tolerance. `view.g` proves it.
#[inline(always)]
pub(super) fn parts<T>(of: fn(f64) -> T, [mut a, mut b]: [[f64; 2]; 2], mut c: [T; 2]) -> [T; 2]
where
    T: Copy + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    let top = |v: [f64; 2]| greatest(v[0].abs(), v[1].abs());
    let is_swapped = top(a) < top(b);
    if is_swapped {
        (a, b) = (b, a);
    }
    if a[0].abs() < a[1].abs() {
        for v in [&mut a, &mut b] {
            v.swap(0, 1);
        }
        c.swap(0, 1);
    }
    let factor = a[1] / a[0];
    let t = (c[1] - of(factor) * c[0]) / of(b[1] - factor * b[0]);
    let s = (c[0] - t * of(b[0])) / of(a[0]);
    if is_swapped { [t, s] } else { [s, t] }
}
