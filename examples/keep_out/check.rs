//! The check: where is the tool, seen from the clamps?

use fixed::types::I16F16;
use septum::Obb;
use septum::mesh::{Mesh, Tree};

use super::clamps::{FACES, NODES, VERTICES};

/// Where the tool is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// It has no point in common with the clamps.
    Outside,
    /// It has a point in common with this face, and perhaps with others.
    Touches(usize),
    /// It touches no face, and all of it is inside.
    Inside,
}

/// The clamps that the tool must keep out of: a tree in flash over all of them.
pub(crate) struct Zone(Tree<'static, I16F16, u16>);

impl Zone {
    /// The zone of the table in flash, if that is sound.
    pub(crate) fn new() -> Option<Self> {
        let mesh = Mesh::new(&VERTICES, &FACES).ok()?;
        Some(Self(Tree::new(mesh, &NODES).ok()?))
    }

    /// Where the tool is.
    ///
    /// A tool that touches no face lies on one side of them all, so that one of its points
    /// decides whether it is inside: its centre. The clamps are closed parts, all oriented
    /// outward, and stand in one another: whatever is in at least one of them has a winding number
    /// that is not zero.
    pub(crate) fn place(&self, tool: &Obb<I16F16>) -> Place {
        match self.0.overlapping(tool).next() {
            Some(face) => Place::Touches(face),
            None if self.0.winding(tool.center()) == Some(0) => Place::Outside,
            None => Place::Inside,
        }
    }
}
