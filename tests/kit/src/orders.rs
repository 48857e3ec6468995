//! All orders of three things, which must not change a verdict.

use septum::published::akenine_moller::Order;

/// The orders of a triangle's vertices; those with the opposite orientation come last.
pub const VERTEX_ORDERS: [[usize; 3]; 6] =
    [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// The orders of the groups of axes of the published test.
pub const GROUP_ORDERS: [Order; 6] = [
    Order::EdgesFacesNormal,
    Order::EdgesNormalFaces,
    Order::FacesEdgesNormal,
    Order::FacesNormalEdges,
    Order::NormalEdgesFaces,
    Order::NormalFacesEdges,
];
