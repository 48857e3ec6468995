//! Every triangle on small grids, degenerate ones included, against rays through
//! the grid: contact of every kind.

use septum_kit::Rng;
use septum_kit::rays::{every_triangle, grid};

/// All triangles, all origins and all directions of {−1, 0, 1}³.
#[test]
fn the_smallest_grid() {
    let points = grid(1);
    let from = |&o: &[f64; 3]| points.iter().filter(|d| **d != [0.0; 3]).map(move |&d| (o, d));
    let rays: Vec<_> = points.iter().flat_map(from).collect();
    let [inside, contacts] = every_triangle(&points, &rays);
    assert!(inside > 10_000 && contacts > 100_000, "{inside}, {contacts}");
}

/// All triangles of {−2, …, 2}³, against a few rays from quarter positions.
#[test]
fn a_larger_grid() {
    let mut rng = Rng::new(61);
    let mut quarter = |most: i64| rng.triple(|rng| rng.whole(-most, most) as f64 / 4.0);
    let rays: Vec<_> = (0..3).map(|_| (quarter(8), quarter(8))).collect();
    let [inside, _] = every_triangle(&grid(2), &rays);
    assert!(inside > 1_000, "{inside}");
}
