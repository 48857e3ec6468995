//! The check: where is the tool, seen from the mesh?

use core::ops::Range;

use fixed::types::I16F16;
use septum::interop::Bounded;
use septum::mesh::{Mesh, Node, Tree};
use septum::{Obb, Vec3};

use super::teapot::{FACES, NODES, PARTS, VERTICES};

/// How many touched faces are named. The others are counted.
pub(crate) const ROOM: usize = 4;

/// Where the tool is.
#[derive(Debug, PartialEq)]
pub(crate) enum Place {
    /// It has no point in common with the mesh or its inside.
    Outside,
    /// It has a point in common with these faces.
    Touches(Bounded<u16, ROOM>),
    /// It touches no face, and all of it is inside this part of the mesh.
    Inside(usize),
}

/// The mesh that the tool must keep out of: a tree over each of its parts.
pub(crate) struct Zone([Tree<'static, I16F16, u16>; PARTS.len()]);

impl Zone {
    /// The zone of the table in flash, if that is sound.
    pub(crate) fn new() -> Option<Self> {
        let mut next = 0;
        // Parts follow one another, and so do their nodes.
        let mut tree = |part: &Range<usize>| {
            let first = next;
            next += Node::count_for(part.len());
            let mesh = Mesh::new(&VERTICES, FACES.get(part.clone())?).ok()?;
            Tree::new(mesh, NODES.get(first..next)?).ok()
        };
        let [a, b, c, d] = &PARTS;
        Some(Self([tree(a)?, tree(b)?, tree(c)?, tree(d)?]))
    }

    /// Where the tool is.
    ///
    /// A tool that touches no face lies on one side of them all, so that one of its
    /// points decides whether it is inside: its centre.
    pub(crate) fn place(&self, tool: &Obb<I16F16>) -> Place {
        let touched = self.touched_by(tool);
        if touched.total() > 0 {
            return Place::Touches(touched);
        }
        self.part_around(tool.center()).map_or(Place::Outside, Place::Inside)
    }

    /// The faces that the tool touches.
    fn touched_by(&self, tool: &Obb<I16F16>) -> Bounded<u16, ROOM> {
        let parts = self.0.iter().zip(&PARTS);
        let faces =
            parts.flat_map(|(tree, part)| tree.overlapping(tool).map(|i| (part.start + i) as u16));
        faces.collect()
    }

    /// The part of the mesh that a point is inside of, if there is one. Parts may overlap:
    /// each is asked.
    fn part_around(&self, point: Vec3<I16F16>) -> Option<usize> {
        self.0.iter().position(|tree| tree.contains(point))
    }
}
