//! Every triangle on the grid {−2, …, 2}³, degenerate ones included, against a family of boxes:
//! 125³ triples of vertices for each box, in every scalar. The oracle runs once for three vertices,
//! the crate for all six orders in `f32`, and in the other scalars for one of them in turn.

use septum_kit::{BoxNumbers, every_triangle_on_the_grid};

fn every_triangle(aabb: BoxNumbers<f64>) {
    let met = every_triangle_on_the_grid(aabb);
    // 333,375 triples. A box met by all or by none would show little.
    assert!(met > 0 && met < 333_375, "{met}");
}

#[test]
fn unit_box() {
    every_triangle(BoxNumbers::Center([0.0; 3], [0.5; 3]));
}

#[test]
fn unit_box_by_corners() {
    every_triangle(BoxNumbers::Corners([-0.5; 3], [0.5; 3]));
}

#[test]
fn grid_cell_with_all_corners_on_the_grid() {
    every_triangle(BoxNumbers::Corners([0.0; 3], [1.0; 3]));
}

#[test]
fn oblong_off_centre() {
    every_triangle(BoxNumbers::Center([0.5, -0.25, 1.0], [1.5, 0.25, 0.75]));
}

#[test]
fn flat() {
    every_triangle(BoxNumbers::Corners([-1.0, -1.0, 0.5], [1.0, 2.0, 0.5]));
}

#[test]
fn flat_on_the_grid() {
    every_triangle(BoxNumbers::Center([0.0, 1.0, 0.0], [1.0, 0.0, 0.5]));
}

#[test]
fn segment() {
    every_triangle(BoxNumbers::Corners([-1.0, 0.25, 0.5], [1.5, 0.25, 0.5]));
}

#[test]
fn point() {
    every_triangle(BoxNumbers::Center([0.5, 0.5, -0.5], [0.0; 3]));
}

#[test]
fn point_on_the_grid() {
    every_triangle(BoxNumbers::Corners([1.0, 0.0, -1.0], [1.0, 0.0, -1.0]));
}

#[test]
fn in_a_corner_of_the_grid() {
    every_triangle(BoxNumbers::Corners([1.5, 1.0, 1.25], [3.0, 3.0, 3.0]));
}
