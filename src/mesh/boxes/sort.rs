//! The order of boxes in a tree.

use crate::arithmetic::three;
use crate::mesh::Index;
use crate::mesh::grid::Grid;
use crate::mesh::node::{Cell, LEAF, Layout};
use crate::scalar::Scalar;

/// Sorts the boxes so that neighbours are close in space: each node cuts its boxes in two along the
/// axis on which they spread most, and each half again. `cell` is the grid box of a box.
pub(super) fn sort<S: Scalar, I: Index>(
    grid: &Grid<S>,
    layout: &Layout,
    order: &mut [I],
    cell: impl Fn(usize) -> Cell,
) {
    for node in 0..layout.nodes {
        let (children, below) = (layout.children(node), layout.below(node));
        let ends = three(|k| {
            let place = children.start + k;
            if place < children.end { layout.below(place).end } else { below.end }
        });
        let Some(all) = order.get_mut(below.clone()) else { continue };
        let [first, half, third] = ends.map(|end| (end - below.start).min(all.len()));
        cut(grid, all, half, &cell);
        let (left, right) = all.split_at_mut(half);
        cut(grid, left, first, &cell);
        cut(grid, right, third - half, &cell);
    }
    order.chunks_mut(LEAF).for_each(<[I]>::sort_unstable);
}

/// Moves to the front the `count` boxes that come first along the axis on which all of them spread
/// most. Ties are broken by index.
fn cut<S: Scalar, I: Index>(
    grid: &Grid<S>,
    order: &mut [I],
    count: usize,
    cell: &impl Fn(usize) -> Cell,
) {
    if count == 0 || count >= order.len() {
        return;
    }
    // Twice the centre of a box.
    let middles = |i: &I| {
        let cell = cell(i.get());
        three(|k| u32::from(cell.low[k]) + u32::from(cell.high[k]))
    };
    let (mut low, mut high) = ([u32::MAX; 3], [0; 3]);
    for middle in order.iter().map(middles) {
        for k in 0..3 {
            low[k] = low[k].min(middle[k]);
            high[k] = high[k].max(middle[k]);
        }
    }
    let spread = three(|k| grid.size(k, high[k] - low[k]));
    let axis = (1..3).fold(0, |best, k| if spread[k] > spread[best] { k } else { best });
    order.select_nth_unstable_by_key(count, |i| (middles(i)[axis], *i));
}
