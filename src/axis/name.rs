/// One of the 13 axes that can separate a triangle from an axis-aligned box.
///
/// For a triangle abc, edge 0 is b − a, edge 1 is c − b, edge 2 is a − c. The
/// names follow Akenine-Möller: bullet 1 of his paper is [`Face`](Self::Face),
/// bullet 2 [`Normal`](Self::Normal), bullet 3 [`Edge`](Self::Edge).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// A face normal of the box: coordinate axis 0, 1 or 2.
    Face(u8),
    /// The normal of the triangle.
    Normal,
    /// The cross product of coordinate axis `axis` and triangle edge `edge`.
    Edge {
        /// The coordinate axis, 0, 1 or 2.
        axis: u8,
        /// The edge of the triangle, 0, 1 or 2.
        edge: u8,
    },
}

impl Axis {
    /// All 13, in the order in which a witness is looked for.
    pub const ALL: [Self; 13] = [
        Self::Face(0),
        Self::Face(1),
        Self::Face(2),
        Self::Normal,
        Self::Edge { axis: 0, edge: 0 },
        Self::Edge { axis: 0, edge: 1 },
        Self::Edge { axis: 0, edge: 2 },
        Self::Edge { axis: 1, edge: 0 },
        Self::Edge { axis: 1, edge: 1 },
        Self::Edge { axis: 1, edge: 2 },
        Self::Edge { axis: 2, edge: 0 },
        Self::Edge { axis: 2, edge: 1 },
        Self::Edge { axis: 2, edge: 2 },
    ];
}
