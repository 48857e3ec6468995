//! All orders of three things, which must not change a verdict; and the order of numbers.

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

/// All of them, in the order of a number of each; those of one number as they come. Only numbers are
/// sorted, because sorting is much code for each type that is sorted.
pub fn sorted_by_number<T: Clone>(
    all: impl IntoIterator<Item = T>,
    number: impl Fn(&T) -> usize,
) -> Vec<T> {
    let all: Vec<T> = all.into_iter().collect();
    order(all.iter().map(number).collect()).into_iter().map(|k| all[k].clone()).collect()
}

fn order(numbers: Vec<usize>) -> Vec<usize> {
    let mut order: Vec<usize> = (0..numbers.len()).collect();
    order.sort_by_key(|&k| numbers[k]);
    order
}
