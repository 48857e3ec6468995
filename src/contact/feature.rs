//! Parts of shapes, by number.

/// A part of a triangle, of a box, or of a sphere or a capsule.
///
/// A part's number depends only on the order in which the shape's numbers were given. It is
/// therefore the same in each frame of a simulation, and a solver recognises a point by the two
/// parts that meet there.
///
/// | | triangle | box |
/// | --- | --- | --- |
/// | face | 0 | 2·i on the lower side of axis i, 2·i + 1 on the upper |
/// | edge | k, from vertex k to the next | 4·i + a + 2·b: along axis i, on the upper side of the next axis if a is 1, of the one after that if b is |
/// | vertex | k | a + 2·b + 4·c: on the upper side of the first axis if a is 1, of the second if b is, of the third if c is |
///
/// A sphere is vertex 0. A capsule has edge 0, and vertices 0 and 1 at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Part {
    /// A face.
    Face(u8),
    /// An edge.
    Edge(u8),
    /// A vertex.
    Vertex(u8),
}

/// The parts of the shapes that determine the direction of a translation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Features {
    /// The normal of this face of the first shape.
    First(u8),
    /// The normal of this face of the second shape.
    Second(u8),
    /// The cross product of an edge of the first shape and one of the second.
    Edges(u8, u8),
    /// The way between the nearest points of these parts, of a shape and of a sphere or a capsule.
    Nearest(Part, Part),
}
