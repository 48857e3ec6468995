//! How two shapes lie to each other.

/// How two closed convex sets lie to each other.
///
/// The *interior* of a shape is what is inside it seen from its own line, plane or space: of a
/// triangle all but its edges, of a segment all but its ends, of a box all but its faces; a
/// point is its own interior. (In the literature: the relative interior.) Two shapes touch if
/// they have a point in common and their interiors have none. That is so exactly if some plane
/// has one on its one side and the other on its other, both of them meet it, and it does not
/// hold all of both (R. T. Rockafellar, *Convex Analysis*, 1970, theorem 11.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Relation {
    /// They have no point in common.
    #[default]
    Disjoint,
    /// They have points in common, but their interiors have none.
    Touching,
    /// Their interiors have a point in common.
    Overlapping,
}
