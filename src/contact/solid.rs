//! A shape in floats: its corners, and its faces and edges along a direction.

use super::against;
use super::body::{Rough, Vec64, cross, dot, flipped};
use super::view::{Corner, Four, View};
use crate::arithmetic::{
    Each, Quad, exp2, exponent, greatest, is_software, largest, multiple, pick, raised,
    short_product, three, turn, two,
};

/// The squared sine of an angle far above all roundings.
const CLEAR: f64 = exp2(-40);

/// The bits of the two axes after axis i.
fn after(i: u8, bits: u8) -> u8 {
    (bits | bits << 3) >> (i + 1) & 3
}

/// The number of the edge of a box along axis i; `upper` has the axes on whose upper side it is, as bits.
pub(super) fn edge_of_box(i: u8, upper: u8) -> u8 {
    4 * i + after(i, upper)
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

/// The vertices of each face of a box, each followed by the next one around the face.
pub(super) const FACES: [[u8; 4]; 8] = {
    let (mut faces, mut n) = ([[0; 4]; 8], 0);
    while n < 6 {
        let (i, j, k) = turn(n / 2);
        let (base, of_j, of_k) = (((n % 2) << i) as u8, 1 << j, 1 << k);
        faces[n] = [base, base | of_j, base | of_j | of_k, base | of_k];
        n += 1;
    }
    faces
};

/// The edge from each of these to the next.
pub(super) const EDGES: [[u8; 4]; 8] = {
    let (mut edges, mut n) = ([[0; 4]; 8], 0);
    while n < 6 {
        let (_, j, k) = turn(n / 2);
        let (of_j, of_k) = ((4 * j + n % 2 * 2) as u8, (4 * k + n % 2) as u8);
        edges[n] = [of_j, of_k + 2, of_j + 1, of_k];
        n += 1;
    }
    edges
};

/// On which side of each axis these vertices are.
const SIDES: [[[f64; 4]; 3]; 8] = {
    let (mut sides, mut n) = ([[[0.0; 4]; 3]; 8], 0);
    while n < 8 * 3 * 4 {
        let (face, k, m) = (n / 12, n / 4 % 3, n % 4);
        sides[face][k][m] = if FACES[face][m] >> k & 1 == 1 { 1.0 } else { -1.0 };
        n += 1;
    }
    sides
};

/// A shape in floats, and its half-edges.
pub(super) struct Solid<'a> {
    pub(super) rough: &'a Rough,
    pub(super) reach: [Vec64; 3],
    /// An upper bound of the coordinates of all corners.
    pub(super) size: f64,
    /// Where floats are functions: the centre of a box and its half-edges in multiples of 2^`unit`, if
    /// `are_words`. Their sums are below 2^53 and so are exact as floats.
    words: [[i64; 3]; 4],
    unit: i32,
    are_words: bool,
}

impl<'a> Solid<'a> {
    pub(super) fn new(rough: &'a Rough) -> Self {
        let mut reach = rough.sides;
        for (reach, &half) in reach.iter_mut().zip(&rough.half) {
            for x in reach {
                *x = short_product(half, *x);
            }
        }
        let [a, b, c] = three(|k| largest(&rough.at[k]));
        let farthest = greatest(a, greatest(b, c));
        let size = reach.iter().fold(farthest, |size, reach| size + largest(reach));
        // Below 2^52 of it.
        let unit = exponent(size) - 1023 - 51;
        let mut new = Self { rough, reach, size, are_words: false, words: [[0; 3]; 4], unit };
        new.are_words = is_software::<f64>() && !rough.is_triangle && new.fill_words();
        new
    }

    /// Whether all numbers are multiples of the unit.
    fn fill_words(&mut self) -> bool {
        let [x, y, z] = &self.reach;
        for (to, v) in self.words.iter_mut().zip([&self.rough.at[0], x, y, z]) {
            for (to, &x) in to.iter_mut().zip(v) {
                let Some(whole) = multiple(x, self.unit) else { return false };
                *to = whole;
            }
        }
        // The sums are normal numbers, by far, and none is a zero below zero.
        let is_negative_zero = |x: &f64| x.to_bits() == 1 << 63;
        (-900..900).contains(&self.unit) && !self.rough.at[0].iter().any(is_negative_zero)
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
        let is_lower = |k: usize| vertex >> k & 1 == 0;
        if self.are_words {
            let [at, x, y, z] = &self.words;
            let along = |v: &[i64; 3], k: usize, i: usize| if is_lower(k) { -v[i] } else { v[i] };
            return three(|i| {
                let sum = at[i] + along(x, 0, i) + along(y, 1, i) + along(z, 2, i);
                if sum == 0 { 0.0 } else { raised(sum as f64, self.unit) }
            });
        }
        (0..3).fold(self.rough.at[0], |at, k| {
            three(|i| at[i] + flipped(self.reach[k][i], is_lower(k)))
        })
    }

    /// The corners of a face of a box.
    #[inline(always)]
    pub(super) fn face(&self, view: &View, number: u8) -> [Corner; 4] {
        let sides = SIDES[usize::from(number & 7)].each(Four::new);
        let at = three(|i| {
            let center = Four::splat(self.rough.at[0][i]);
            (0..3).fold(center, |at, k| at + sides[k] * Four::splat(self.reach[k][i]))
        });
        let (at, flat) = (at.each(Quad::to_array), view.flats(at).each(Quad::to_array));
        let corner = |n: usize| Corner { at: three(|i| at[i][n]), flat: two(|k| flat[k][n]) };
        [corner(0), corner(1), corner(2), corner(3)]
    }

    /// Whether a face of a box certainly has a normal in floats: its sides are not parallel, by far more
    /// than roundings.
    fn has_normal(&self, number: u8) -> bool {
        let (_, i, j) = turn(usize::from(number / 2));
        let [a, b] = [i, j].each(|k| pick(&self.rough.sides, k));
        let w = cross(a, b);
        dot(&w, &w) > CLEAR * (dot(a, a) * dot(b, b))
    }

    /// The axes of a box, divided by their greatest coordinates.
    fn units(&self) -> [Vec64; 3] {
        let mut units = self.rough.sides;
        for side in &mut units {
            let size = largest(side);
            side.iter_mut().for_each(|x| *x /= size);
        }
        units
    }

    /// The face most nearly antiparallel to `outward`, the normal of another shape's face, among those of
    /// the axes in `of`, each on the side that `upper` has; both as bits. A triangle is its only face.
    pub(super) fn face_against(&self, outward: &Vec64, of: u8, upper: u8) -> u8 {
        if self.rough.is_triangle {
            return 0;
        }
        if is_software::<f64>() {
            if let Some(number) = against::face_against(&self.rough.sides, outward, of, upper) {
                return number;
            }
        }
        let number = |k: u8| 2 * k + (upper >> k & 1);
        if !is_software::<f64>() && of.is_power_of_two() {
            // No comparison, and no quotients for it. Without a normal the comparison finds face 0.
            let number = number(of.trailing_zeros() as u8 % 3);
            if self.has_normal(number) {
                return number;
            }
        }
        let axes = self.units();
        let (mut first, mut best) = (0, f64::NEG_INFINITY);
        for k in (0..3).filter(|k| of >> k & 1 == 1) {
            let value = facing(&axes, number(k), outward);
            first = if value > best { number(k) } else { first };
            best = greatest(value, best);
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

    /// The edges farthest in a direction and perpendicular to it, as bits; of a box, of those along
    /// axis i. `ends` has the farthest vertices of a triangle, or the axes of a box whose upper end is farthest.
    pub(super) fn support_edges(&self, i: u8, across: u8, ends: u8) -> u16 {
        if self.rough.is_triangle {
            // From one vertex to the next.
            return u16::from(across & ends & (ends >> 1 | ends << 2));
        }
        let (across, mut edges) = (after(i, across), 1 << after(i, ends));
        if across & 1 != 0 {
            edges |= (edges & 5) << 1 | (edges & 10) >> 1;
        }
        if across & 2 != 0 {
            edges |= edges << 2 & 15 | edges >> 2;
        }
        edges << (4 * i)
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
    flipped(square, is_outward != (cosine < 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// What half words choose is what floats choose, and mostly they choose.
    #[test]
    fn half_words_choose_as_floats() {
        let mut random = Random(0xa9a1);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut certain = 0;
        for n in 0..60_000_u32 {
            let mut sides = [(); 3].each(|()| three(|_| number()));
            let ((i, j, k), off) = (turn(n as usize / 4 % 3), exp2(-(n as i32 / 12 % 16)));
            // Any, nearly a line, nearly flat, or nearly perpendicular.
            match n % 4 {
                0 => {}
                1 => sides[i] = three(|x| sides[j][x] + off * number()),
                2 => sides[i] = three(|x| sides[j][x] + sides[k][x] + off * number()),
                _ => {
                    sides[j] = cross(&sides[i], &sides[k]);
                    sides[k] = cross(&sides[i], &sides[j]).each(|x| x + off * number());
                }
            }
            let normal = |i: usize, k: usize| {
                let w = cross(&sides[i], &sides[k]);
                w.each(|x| x / dot(&w, &w).sqrt())
            };
            // Any way, near a side, or about as far from two normals.
            let outward = match n / 192 % 3 {
                0 => three(|_| number()),
                1 => sides[i].each(|x| x + 0.2 * number()),
                _ => {
                    let (a, b, more) = (normal(i, j), normal(k, i), 1.0 + off * number());
                    three(|x| a[x] + b[x] * more)
                }
            };
            let length = dot(&outward, &outward).sqrt();
            let outward = outward.each(|x| x / length);
            let axes = sides.each(|side| side.each(|x| x / largest(&side)));
            let (of, upper) = (1 + (n / 5 % 7) as u8, (n / 7 % 8) as u8);
            let number = |k: u8| 2 * k + (upper >> k & 1);
            let value = |k: u8| facing(&axes, number(k), &outward);
            let all = (0..3).filter(|k| of >> k & 1 == 1);
            let best = all.reduce(|best, k| if value(k) > value(best) { k } else { best });
            if let Some(found) = against::face_against(&sides, &outward, of, upper) {
                assert_eq!(found, number(best.unwrap()), "{sides:?} {outward:?}");
                certain += 1;
            }
        }
        assert!((30_000..34_000).contains(&certain), "{certain}");
    }

    /// The corners of boxes by words are those by floats, bit by bit.
    #[test]
    fn corners_in_words_are_those_in_floats() {
        let mut random = Random(0xc0de);
        let mut known = 0;
        for n in 0..4000_u32 {
            let tiny = [0, 1000][usize::from(n % 8 == 0)];
            let mut number = |bits: i32| {
                let cut = (random.bits() as i32) >> (random.bits() % 31);
                f64::from(cut) * exp2(-bits) * f64::from(random.bits() % 4 != 0)
            };
            let sides = [(); 3].each(|()| three(|_| number(16 + tiny)));
            let half = three(|_| number(16).abs());
            let rough =
                Rough { is_triangle: false, at: [three(|_| number(17 + tiny)); 3], sides, half };
            let mut solid = Solid::new(&rough);
            if !solid.fill_words() {
                continue;
            }
            known += 1;
            for vertex in 0..8 {
                solid.are_words = false;
                let expected = solid.corner(vertex);
                solid.are_words = true;
                assert_eq!(solid.corner(vertex).each(f64::to_bits), expected.each(f64::to_bits));
            }
        }
        assert!(known > 2000, "{known}");
    }

    /// With one candidate, also where its sides are parallel.
    #[test]
    fn a_single_candidate_is_the_face_that_a_comparison_finds() {
        let mut random = Random(0xface);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut seen = [0; 2];
        for n in 0..4000_u32 {
            let mut sides = [(); 3].each(|()| three(|_| number()));
            if n % 2 == 0 {
                let (by, off) = (number(), number() * 2_f64.powi(-(n as i32 % 64)));
                sides[1] = three(|i| by * sides[0][i] + if n % 3 == 0 { 0.0 } else { off });
            }
            let rough = Rough { is_triangle: false, at: [[0.0; 3]; 3], sides, half: [1.0; 3] };
            let (solid, outward) = (Solid::new(&rough), three(|_| number()));
            for face in 0..6 {
                let value = facing(&solid.units(), face, &outward);
                let expected = if value > f64::NEG_INFINITY { face } else { 0 };
                let (k, side) = (face / 2, face % 2);
                assert_eq!(solid.face_against(&outward, 1 << k, side << k), expected);
                seen[usize::from(solid.has_normal(face))] += 1;
            }
        }
        assert!(seen[0] > 500 && seen[1] > 9000, "{seen:?}");
    }
}
