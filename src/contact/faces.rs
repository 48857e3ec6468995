//! A triangle or a face of a box, seen along the normal of a contact.

use super::body::{Vec64, dot};
use super::sides::Flat;
use super::solid::{Solid, edge_of_box, vertex_of_box};
use super::view::{Corner, Edge, View};
use crate::arithmetic::{pick, turn};

/// The most corners that a face has.
pub(super) const CORNERS: usize = 4;

/// A triangle, or a face of a box.
pub(super) struct Face {
    pub(super) corners: [Corner; CORNERS],
    edges: [u8; CORNERS],
    count: usize,
    pub(super) number: u8,
    /// The corners in words, if the view has a unit.
    pub(super) words: Option<[Flat; CORNERS]>,
}

impl Face {
    /// The triangle, or face `number` of the box.
    pub(super) fn new(view: &View, shape: &Solid, number: u8) -> Self {
        let corners = [Corner { at: [0.0; 3], flat: [0.0; 2], vertex: 0 }; CORNERS];
        let mut face = Self { corners, edges: [0, 1, 2, 2], count: 3, number, words: None };
        if shape.is_triangle {
            for (k, corner) in face.corners.iter_mut().enumerate() {
                let k = k.min(2);
                *corner = view.corner(*pick(&shape.at, k), k as u8);
            }
        } else {
            face.count = CORNERS;
            let (i, j, k) = turn(usize::from(number / 2));
            for n in 0..CORNERS {
                let mut upper = [false; 3];
                (upper[i], upper[j], upper[k]) = (number % 2 == 1, n == 1 || n == 2, n >= 2);
                // The edge runs along j if this corner and the next differ in j.
                face.edges[n] = edge_of_box(if n % 2 == 0 { j } else { k }, upper);
                face.corners[n] = view.corner(shape.corner(upper), vertex_of_box(upper));
            }
        }
        if let Some(unit) = view.unit {
            let words = face.words.insert([[0; 2]; CORNERS]);
            for (word, corner) in words.iter_mut().zip(&face.corners) {
                *word = unit.flat(&corner.flat);
            }
        }
        face
    }

    /// The corner after corner n.
    pub(super) fn next(&self, n: usize) -> usize {
        if n + 1 < self.count { n + 1 } else { 0 }
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = &Corner> {
        self.corners.iter().take(self.count)
    }

    pub(super) fn edges(&self) -> impl Iterator<Item = Edge<'_>> {
        (0..self.count).map(|n| self.edge(n))
    }

    /// How many corners and edges it has.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(super) fn corner(&self, n: usize) -> &Corner {
        &self.corners[n % CORNERS]
    }

    /// The ends of edge n.
    pub(super) fn ends(&self, n: usize) -> [&Corner; 2] {
        [self.corner(n), self.corner(self.next(n))]
    }

    pub(super) fn edge(&self, n: usize) -> Edge<'_> {
        Edge { ends: self.ends(n), number: self.edges[n % CORNERS] }
    }

    /// The corner farthest against a direction.
    pub(super) fn lowest(&self, outward: &Vec64) -> Corner {
        let mut lowest = self.corners[0];
        for corner in self.corners() {
            if dot(outward, &corner.at) < dot(outward, &lowest.at) {
                lowest = *corner;
            }
        }
        lowest
    }
}
