//! A shape in floats: its corners, and its faces and edges along a direction.

use super::body::{Rough, Vec64, cross, dot};
use super::view::{Corner, Four, View};
use crate::arithmetic::{
    Quad, REGISTERS_ARE_WIDE, each, greatest, largest, pick, three, turn, two,
};

/// The squared sine of an angle far above all roundings.
const CLEAR: f64 = f64::from_bits((1023 - 40) << 52);

/// The number of the edge of a box along axis i.
pub(super) fn edge_of_box(i: usize, upper: [bool; 3]) -> u8 {
    let (i, j, k) = turn(i);
    4 * i as u8 + u8::from(upper[j]) + 2 * u8::from(upper[k])
}

/// The vertices at the ends of each edge of a box. A processor does not foresee the branches that would
/// compute them.
const ENDS: [[u8; 2]; 16] = {
    let (mut ends, mut n) = ([[0; 2]; 16], 0);
    while n < 12 {
        let (i, j, k) = turn(n as usize / 4);
        let lower = (n & 1) << j | (n >> 1 & 1) << k;
        ends[n as usize] = [lower, lower | 1 << i];
        n += 1;
    }
    ends
};

/// A shape in floats, and its half-edges.
pub(super) struct Solid<'a> {
    pub(super) rough: &'a Rough,
    pub(super) reach: [Vec64; 3],
    /// An upper bound of the coordinates of all corners.
    pub(super) size: f64,
}

impl<'a> Solid<'a> {
    pub(super) fn new(rough: &'a Rough) -> Self {
        let reach = three(|k| three(|i| rough.half[k] * rough.sides[k][i]));
        let [a, b, c] = three(|k| largest(&rough.at[k]));
        let farthest = greatest(a, greatest(b, c));
        let size = reach.iter().fold(farthest, |size, reach| size + largest(reach));
        Self { rough, reach, size }
    }

    /// The numbers of its faces.
    pub(super) fn faces(&self) -> core::ops::Range<u8> {
        0..if self.rough.is_triangle { 1 } else { 6 }
    }

    /// How far the shape extends in a direction, from the origin.
    #[inline]
    pub(super) fn reach_along(&self, direction: &Vec64) -> f64 {
        let (mut farthest, mut reach) = (f64::NEG_INFINITY, 0.0);
        for k in 0..3 {
            // A box has one place.
            if k == 0 || self.rough.is_triangle {
                farthest = greatest(farthest, dot(&self.rough.at[k], direction));
            }
            reach += dot(&self.reach[k], direction).abs();
        }
        farthest + reach
    }

    /// The corner of a box of this number.
    pub(super) fn corner(&self, vertex: u8) -> Vec64 {
        (0..3).fold(self.rough.at[0], |at, k| {
            let is_upper = vertex >> k & 1 == 1;
            // Small cores multiply by a function, and hosts would choose between two numbers by a branch.
            let signed = |x: f64| match (REGISTERS_ARE_WIDE, is_upper) {
                (true, _) => x * if is_upper { 1.0 } else { -1.0 },
                (false, true) => x,
                (false, false) => -x,
            };
            three(|i| at[i] + signed(self.reach[k][i]))
        })
    }

    /// The corners of a face of a box, on the upper side of its axis or on the lower; j and k are the
    /// next axes.
    #[inline(always)]
    pub(super) fn face(
        &self,
        view: &View,
        [j, k]: [usize; 2],
        is_upper: bool,
        corners: &mut [Corner; 4],
    ) {
        let mut signs = [Four::splat(if is_upper { 1.0 } else { -1.0 }); 3];
        (signs[j % 3], signs[k % 3]) =
            (Four::new([-1.0, 1.0, 1.0, -1.0]), Four::new([-1.0, -1.0, 1.0, 1.0]));
        let at = three(|i| {
            let center = Four::splat(self.rough.at[0][i]);
            (0..3).fold(center, |at, k| at + signs[k] * Four::splat(self.reach[k][i]))
        });
        let (at, flat) = (at.map(Quad::to_array), view.flats(at).map(Quad::to_array));
        for (n, corner) in corners.iter_mut().enumerate() {
            *corner = Corner { at: three(|i| at[i][n]), flat: two(|k| flat[k][n]) };
        }
    }

    /// Whether a face of a box certainly has a normal in floats: its sides are not parallel, by far more
    /// than roundings.
    fn has_normal(&self, number: u8) -> bool {
        let (_, i, j) = turn(usize::from(number / 2));
        let [a, b] = [i, j].map(|k| pick(&self.rough.sides, k));
        let w = cross(a, b);
        dot(&w, &w) > CLEAR * (dot(a, a) * dot(b, b))
    }

    /// The axes of a box, divided by their greatest coordinates.
    fn units(&self) -> [Vec64; 3] {
        each(self.rough.sides, |side| {
            let size = largest(&side);
            three(|i| side[i] / size)
        })
    }

    /// The face most nearly antiparallel to `outward`, the normal of another shape's face, among the faces
    /// that satisfy `is_first`. A triangle is its only face.
    pub(super) fn face_against(&self, outward: &Vec64, is_first: impl Fn(u8) -> bool) -> u8 {
        if self.rough.is_triangle {
            return 0;
        }
        let mut candidates = self.faces().filter(|&n| is_first(n));
        let some = [candidates.next(), candidates.next()];
        if let [Some(number), None] = some {
            // No comparison, and no quotients for it. Without a normal the comparison finds face 0.
            if self.has_normal(number) {
                return number;
            }
        }
        let axes = self.units();
        let (mut first, mut best) = (0, f64::NEG_INFINITY);
        for number in some.into_iter().flatten().chain(candidates) {
            let value = facing(&axes, number, outward);
            if value > best {
                (first, best) = (number, value);
            }
        }
        first
    }

    /// The other faces turned against `outward`.
    pub(super) fn other_faces_against(
        &self,
        outward: &Vec64,
        first: u8,
    ) -> impl Iterator<Item = u8> {
        let axes = self.units();
        self.faces().filter(move |&n| n != first && facing(&axes, n, outward) > 0.0)
    }

    /// The numbers of the edges farthest in a direction and perpendicular to it; for a box, of those along
    /// axis i. `is_end` marks the farthest vertices of a triangle, or the farthest ends of a box's axes.
    pub(super) fn support_edges(
        &self,
        i: u8,
        is_across: [bool; 3],
        is_end: [bool; 3],
    ) -> impl Iterator<Item = u8> + Clone + use<> {
        let is_triangle = self.rough.is_triangle;
        (0..4_u8).filter_map(move |n| {
            if is_triangle {
                let (from, to, _) = turn(n.into());
                let is_edge = *pick(&is_across, from) && *pick(&is_end, from) && *pick(&is_end, to);
                return (n < 3 && is_edge).then_some(n);
            }
            // Within the closure, where a compiler sees that they are below three.
            let (_, j, k) = turn(i.into());
            // No loop over j and k: for size, compilers check their bounds.
            let fits = |k, is_upper| *pick(&is_across, k) || is_upper == *pick(&is_end, k);
            (fits(j, n & 1 == 1) && fits(k, n & 2 == 2)).then_some(4 * i + n)
        })
    }

    /// The ends of an edge.
    pub(super) fn edge(&self, view: &View, number: u8) -> [Corner; 2] {
        if self.rough.is_triangle {
            let (from, to, _) = turn(number.into());
            return two(|end| view.corner(*pick(&self.rough.at, if end == 0 { from } else { to })));
        }
        let ends = ENDS[usize::from(number & 15)];
        two(|end| view.corner(self.corner(ends[end])))
    }
}

/// The signed square of the cosine between the outward normal of a face of a box and −`outward`.
fn facing(axes: &[Vec64; 3], number: u8, outward: &Vec64) -> f64 {
    let (k, i, j) = turn(usize::from(number / 2));
    let w = cross(pick(axes, i), pick(axes, j));
    let cosine = dot(&w, outward);
    let square = cosine * cosine / dot(&w, &w);
    let is_outward = (dot(&w, pick(axes, k)) > 0.0) == (number % 2 == 1);
    if is_outward == (cosine < 0.0) { square } else { -square }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// With one candidate, also where its sides are parallel.
    #[test]
    fn a_single_candidate_is_the_face_that_a_comparison_finds() {
        let mut random = Random(0xface);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut seen = [0; 2];
        for n in 0..4000_u32 {
            let mut sides = [(); 3].map(|()| three(|_| number()));
            if n % 2 == 0 {
                let (by, off) = (number(), number() * 2_f64.powi(-(n as i32 % 64)));
                sides[1] = three(|i| by * sides[0][i] + if n % 3 == 0 { 0.0 } else { off });
            }
            let rough = Rough { is_triangle: false, at: [[0.0; 3]; 3], sides, half: [1.0; 3] };
            let (solid, outward) = (Solid::new(&rough), three(|_| number()));
            for face in 0..6 {
                let value = facing(&solid.units(), face, &outward);
                let expected = if value > f64::NEG_INFINITY { face } else { 0 };
                assert_eq!(solid.face_against(&outward, |other| other == face), expected);
                seen[usize::from(solid.has_normal(face))] += 1;
            }
        }
        assert!(seen[0] > 500 && seen[1] > 9000, "{seen:?}");
    }
}
