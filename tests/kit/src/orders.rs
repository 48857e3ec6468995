//! All orders of three things: none of them changes a verdict.

use septum::published::akenine_moller::Order;

/// Of the vertices of a triangle; those that turn the other way come last.
pub const VERTEX_ORDERS: [[usize; 3]; 6] =
    [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// Of the groups of axes of the published test.
pub const GROUP_ORDERS: [Order; 6] = [
    Order::EdgesFacesNormal,
    Order::EdgesNormalFaces,
    Order::FacesEdgesNormal,
    Order::FacesNormalEdges,
    Order::NormalEdgesFaces,
    Order::NormalFacesEdges,
];
