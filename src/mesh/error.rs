use core::fmt;

/// Why there is no mesh, no tree, or no closed mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshError {
    /// A coordinate of this vertex is NaN or infinite.
    NotFinite {
        /// Its index.
        vertex: usize,
    },
    /// This triangle has a vertex that there is not.
    NoSuchVertex {
        /// The triangle's index.
        triangle: usize,
    },
    /// There are more triangles than the type of indices can tell apart.
    TooManyTriangles,
    /// A slice has another length than it should have.
    Length {
        /// How long it should be.
        needed: usize,
    },
    /// A box of a tree does not enclose what is below it: the tree is not that of the mesh,
    /// or its table is broken.
    Node {
        /// The index of the node that has the box.
        node: usize,
    },
    /// An edge belongs to an odd number of triangles.
    OpenEdge {
        /// The indices of its two vertices.
        vertices: [usize; 2],
    },
}

impl MeshError {
    /// The mesh, for a `const` or a `static`, where a bad mesh is an error of the compiler, as
    /// by [`ShapeError::unwrap`](crate::ShapeError::unwrap).
    ///
    /// # Panics
    /// If there is an error and it is called at run time. Match on the result there.
    #[must_use]
    #[track_caller]
    pub const fn unwrap<T: Copy>(made: Result<T, Self>) -> T {
        match made {
            Ok(made) => made,
            Err(error) => panic!("{}", error.message()),
        }
    }

    const fn message(self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "a coordinate is NaN or infinite",
            Self::NoSuchVertex { .. } => "a triangle has a vertex that there is not",
            Self::TooManyTriangles => "there are more triangles than indices",
            Self::Length { .. } => "a slice has the wrong length",
            Self::Node { .. } => "a box does not enclose what is below it",
            Self::OpenEdge { .. } => "an edge belongs to an odd number of triangles",
        }
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())?;
        match *self {
            Self::NotFinite { vertex } => write!(f, ": vertex {vertex}"),
            Self::NoSuchVertex { triangle } => write!(f, ": triangle {triangle}"),
            Self::TooManyTriangles => Ok(()),
            Self::Length { needed } => write!(f, ": {needed} are needed"),
            Self::Node { node } => write!(f, ": node {node}"),
            Self::OpenEdge { vertices: [a, b] } => write!(f, ": from vertex {a} to {b}"),
        }
    }
}

impl core::error::Error for MeshError {}
