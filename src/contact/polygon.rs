//! Convex polygons cut by each other, in floats; every corner knows what it is a corner of.
//!
//! I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", *Communications of the ACM* 17,
//! 1974.

use core::mem::swap;

use super::body::{Rough, Vec64};
use super::directions::{cross, dot};
use super::feature::Part;
use crate::arithmetic::{pick, three, turn};

/// So many corners a rectangle has that was cut by another.
pub(super) const MOST: usize = 8;

/// What a side of a cut polygon lies on.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    /// Side k of what is cut.
    Own(u8),
    /// Side k of what cuts.
    Cut(u8),
}

/// A corner, and the side from it to the next.
#[derive(Clone, Copy)]
struct Corner {
    at: Vec64,
    side: Side,
}

/// A face: up to four corners, and what shape they are of.
pub(super) struct Face {
    pub(super) corners: [Vec64; 4],
    pub(super) count: usize,
    parts: [Part; 4],
    sides: [Part; 4],
}

/// The number after this one of so many, in turn.
fn following(n: usize, count: usize) -> usize {
    if n + 1 < count { n + 1 } else { 0 }
}

pub(super) fn minus(a: &Vec64, b: &Vec64) -> Vec64 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + t·b.
pub(super) fn along(a: &Vec64, t: f64, b: &Vec64) -> Vec64 {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// The number of a vertex of a box, or a triangle's.
pub(super) fn vertex_of_box(upper: [bool; 3]) -> u8 {
    u8::from(upper[0]) + 2 * u8::from(upper[1]) + 4 * u8::from(upper[2])
}

/// The number of the edge of a box along axis i.
pub(super) fn edge_of_box(i: usize, upper: [bool; 3]) -> u8 {
    let (i, j, k) = turn(i);
    4 * i as u8 + u8::from(upper[j]) + 2 * u8::from(upper[k])
}

/// A vertex of a box.
pub(super) fn corner_of_box(shape: &Rough, upper: [bool; 3]) -> Vec64 {
    let mut at = shape.at[0];
    for i in 0..3 {
        let h = if upper[i] { shape.half[i] } else { -shape.half[i] };
        at = along(&at, h, &shape.sides[i]);
    }
    at
}

impl Face {
    /// A triangle, or face `number` of a box.
    pub(super) fn new(shape: &Rough, number: u8) -> Self {
        let mut parts = [0, 1, 2, 3].map(Part::Vertex);
        let mut sides = [0, 1, 2, 3].map(Part::Edge);
        if shape.is_triangle {
            let [a, b, c] = shape.at;
            return Self { corners: [a, b, c, c], count: 3, parts, sides };
        }
        let (_, j, k) = turn(usize::from(number / 2));
        let mut corners = [[0.0; 3]; 4];
        let around = [[false, false], [true, false], [true, true], [false, true]];
        for (n, [a, b]) in around.into_iter().enumerate() {
            let mut upper = [number % 2 == 1; 3];
            (upper[j], upper[k]) = (a, b);
            corners[n] = corner_of_box(shape, upper);
            parts[n] = Part::Vertex(vertex_of_box(upper));
            // Along j where the two that follow differ in it.
            sides[n] = Part::Edge(edge_of_box(if n % 2 == 0 { j } else { k }, upper));
        }
        Self { corners, count: 4, parts, sides }
    }

    fn center(&self) -> Vec64 {
        let mut sum = [0.0; 3];
        for corner in self.corners.iter().take(self.count) {
            sum = along(&sum, 1.0 / self.count as f64, corner);
        }
        sum
    }

    /// Calls `found` with each corner of what the sides of this face, taken along its normal, leave
    /// of the other, and with the parts of this and of the other that meet there. The faces have
    /// numbers.
    pub(super) fn cut(
        &self,
        other: &Self,
        faces: [u8; 2],
        normal: &Vec64,
        mut found: impl FnMut(Vec64, [Part; 2]),
    ) {
        let empty = Corner { at: [0.0; 3], side: Side::Own(0) };
        // What is cut, and what is left of it, in turns.
        let (mut corners, mut left) = (&mut [empty; MOST], &mut [empty; MOST]);
        let mut count = other.count;
        for (k, (corner, &at)) in corners.iter_mut().zip(&other.corners).enumerate() {
            *corner = Corner { at, side: Side::Own(k as u8) };
        }
        let center = self.center();
        for k in 0..self.count {
            let from = &self.corners[k % 4];
            let to = &self.corners[following(k, self.count) % 4];
            let mut inward = cross(normal, &minus(to, from));
            if dot(&inward, &minus(&center, from)) < 0.0 {
                inward = three(|i| -inward[i]);
            }
            let mut heights = [0.0; MOST];
            for (height, corner) in heights.iter_mut().zip(corners.iter()).take(count) {
                *height = dot(&inward, &minus(&corner.at, from));
            }
            if heights.iter().take(count).all(|&height| height >= 0.0) {
                continue;
            }
            let mut kept = 0;
            let mut keep = |at: Vec64, side: Side| {
                // With rounding a ninth might come.
                if kept < MOST {
                    left[kept % MOST] = Corner { at, side };
                    kept += 1;
                }
            };
            for n in 0..count {
                let after = following(n, count);
                let (here, next) = (corners[n % MOST], corners[after % MOST]);
                let (a, b) = (heights[n % MOST], heights[after % MOST]);
                let crossing = || along(&here.at, a / (a - b), &minus(&next.at, &here.at));
                if a >= 0.0 {
                    keep(here.at, if a == 0.0 && b < 0.0 { Side::Cut(k as u8) } else { here.side });
                    if a > 0.0 && b < 0.0 {
                        keep(crossing(), Side::Cut(k as u8));
                    }
                } else if b > 0.0 {
                    keep(crossing(), here.side);
                }
            }
            count = kept;
            swap(&mut corners, &mut left);
            if count == 0 {
                return;
            }
        }
        let mut before = corners[(count - 1) % MOST].side;
        for n in 0..count {
            let Corner { at, side } = corners[n % MOST];
            let own = |k: u8| pick4(&other.sides, k);
            let cuts = |k: u8| pick4(&self.sides, k);
            let parts = match (before, side) {
                (Side::Own(_), Side::Own(k)) => [Part::Face(faces[0]), pick4(&other.parts, k)],
                (Side::Own(k), Side::Cut(l)) | (Side::Cut(l), Side::Own(k)) => [cuts(l), own(k)],
                (Side::Cut(k), Side::Cut(l)) => {
                    // The corner between two sides in a row.
                    let after =
                        if following(k.into(), self.count) == usize::from(l) { l } else { k };
                    [pick4(&self.parts, after), Part::Face(faces[1])]
                }
            };
            found(at, parts);
            before = side;
        }
    }

    /// The corner that lies farthest against a direction.
    pub(super) fn lowest(&self, normal: &Vec64) -> (Vec64, Part) {
        let mut lowest = 0;
        for k in 1..self.count {
            if dot(normal, &self.corners[k % 4]) < dot(normal, &self.corners[lowest % 4]) {
                lowest = k;
            }
        }
        (self.corners[lowest % 4], self.parts[lowest % 4])
    }
}

fn pick4(parts: &[Part; 4], k: u8) -> Part {
    parts[usize::from(k) % 4]
}

/// The face of a shape that faces most against a direction.
pub(super) fn facing(shape: &Rough, normal: &Vec64) -> u8 {
    if shape.is_triangle {
        return 0;
    }
    let (mut best, mut number) = (-1.0, 0);
    for i in 0..3 {
        let (i, j, k) = turn(i);
        let w = cross(pick(&shape.sides, j), pick(&shape.sides, k));
        let along = dot(&w, normal);
        let square = along * along / dot(&w, &w);
        if square > best {
            best = square;
            let is_upper = (along < 0.0) == (dot(&w, pick(&shape.sides, i)) > 0.0);
            number = 2 * i as u8 + u8::from(is_upper);
        }
    }
    number
}
