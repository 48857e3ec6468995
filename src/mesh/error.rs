use core::fmt;

/// The reason why a mesh or a tree was refused, or a mesh is not closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshError {
    /// A coordinate of a vertex is NaN or infinite.
    NotFinite {
        /// The vertex's index.
        vertex: usize,
    },
    /// A triangle refers to a vertex that does not exist.
    NoSuchVertex {
        /// The triangle's index.
        triangle: usize,
    },
    /// There are more triangles or boxes than the index type can number.
    TooManyTriangles,
    /// A slice has the wrong length.
    Length {
        /// The required length.
        needed: usize,
    },
    /// A list that a tree was to be refitted by does not have each index once.
    Order,
    /// A box of a tree does not enclose everything below it: the tree belongs to another mesh, or
    /// its table is damaged.
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
    /// Returns the mesh or tree in a `const` or a `static`; a refused one is a compile error, as
    /// with [`ShapeError::unwrap`](crate::ShapeError::unwrap).
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
            Self::TooManyTriangles => "there are more triangles or boxes than indices",
            Self::Length { .. } => "a slice has the wrong length",
            Self::Order => "an order has an index twice, or lacks one",
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
            Self::TooManyTriangles | Self::Order => Ok(()),
            Self::Length { needed } => write!(f, ": {needed} are needed"),
            Self::Node { node } => write!(f, ": node {node}"),
            Self::OpenEdge { vertices: [a, b] } => write!(f, ": from vertex {a} to {b}"),
        }
    }
}

impl core::error::Error for MeshError {}
