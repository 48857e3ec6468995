//! The check: the position of the tool relative to the clamps.

use fixed::types::I16F16;
use septum::Obb;
use septum::mesh::{Mesh, Tree};

use super::clamps::{FACES, NODES, VERTICES};

/// The position of the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// It has no point in common with the clamps.
    Outside,
    /// It has a point in common with this face, and perhaps with other faces.
    Touches(usize),
    /// It touches no face, and lies entirely inside a clamp.
    Inside,
}

/// The clamps that the tool must keep out of: a tree in flash over all of them.
pub(crate) struct Zone(Tree<'static, I16F16, u16>);

impl Zone {
    /// The zone from the table in flash, if the table is valid.
    pub(crate) fn new() -> Option<Self> {
        let mesh = Mesh::new(&VERTICES, &FACES).ok()?;
        Some(Self(Tree::new(mesh, &NODES).ok()?))
    }

    /// The position of the tool.
    ///
    /// A tool that touches no face lies on one side of every face, so its centre alone decides
    /// whether it is inside. The clamps are closed parts, all oriented outward, and overlap each
    /// other: a point inside at least one of them has a winding number other than zero.
    pub(crate) fn place(&self, tool: &Obb<I16F16>) -> Place {
        match self.0.overlapping(tool).next() {
            Some(face) => Place::Touches(face),
            None if self.0.winding(tool.center()) == Some(0) => Place::Outside,
            None => Place::Inside,
        }
    }
}
