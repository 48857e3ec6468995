//! A triangle or a face of a box, seen along the normal of a contact.

use super::body::{Vec64, dot};
use super::sides::Flat;
use super::solid::{EDGES, FACES, Solid};
use super::view::{Corner, Edge, View};
use crate::arithmetic::{REGISTERS_ARE_WIDE, pick};

/// The most corners that a face has.
pub(super) const CORNERS: usize = 4;

/// A triangle, or a face of a box.
pub(super) struct Face {
    pub(super) corners: [Corner; CORNERS],
    vertices: [u8; CORNERS],
    edges: [u8; CORNERS],
    count: usize,
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

    /// How many corners and edges it has.
    pub(super) fn count(&self) -> usize {
        self.count
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
