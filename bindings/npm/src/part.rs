//! Parts of shapes as numbers: faces from 0, edges from 16, vertices from 32 on.

#[cfg(feature = "mesh")]
use septum::Feature;
use septum::contact::Part;

pub(crate) fn number(part: Part) -> u8 {
    match part {
        Part::Face(k) => k,
        Part::Edge(k) => 16 + k,
        Part::Vertex(k) => 32 + k,
    }
}

#[cfg(feature = "mesh")]
pub(crate) fn number_of_feature(feature: Feature) -> u8 {
    match feature {
        Feature::Interior => 0,
        Feature::Edge(k) => 16 + k,
        Feature::Vertex(k) => 32 + k,
    }
}
