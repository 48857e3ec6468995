//! The ground: hills of triangles, on a grid.

use fixed::types::I16F16;
use septum::{Aabb, Triangle, Vec3};

/// How many cells the ground has along each side.
pub(crate) const SIDE: i32 = 10;

/// Heights in sixteenths. The pattern repeats.
const HEIGHTS: [[i32; 5]; 5] =
    [[24, 14, 9, 3, 12], [15, 6, 0, 5, 13], [8, 2, 5, 11, 6], [3, 7, 14, 8, 1], [16, 9, 4, 0, 10]];

fn vertex(x: i32, z: i32) -> Vec3<I16F16> {
    let height = HEIGHTS[x.rem_euclid(5) as usize][z.rem_euclid(5) as usize];
    Vec3::new(I16F16::from_num(x), I16F16::from_bits(height << 12), I16F16::from_num(z))
}

/// The two triangles of a cell.
fn cell(x: i32, z: i32) -> [Option<Triangle<I16F16>>; 2] {
    let [a, b, c, d] = [vertex(x, z), vertex(x, z + 1), vertex(x + 1, z), vertex(x + 1, z + 1)];
    [Triangle::new(a, b, c).ok(), Triangle::new(d, c, b).ok()]
}

/// The first triangle of the ground that the box meets.
pub(crate) fn met_by(aabb: &Aabb<I16F16>) -> Option<Triangle<I16F16>> {
    let (min, max) = aabb.min_max()?;
    let cells = |low: I16F16, high: I16F16| {
        (low.to_num::<i32>() - 1).max(0)..=high.to_num::<i32>().min(SIDE - 1)
    };
    for x in cells(min.x, max.x) {
        for z in cells(min.z, max.z) {
            for triangle in cell(x, z).into_iter().flatten() {
                if triangle.overlaps(aabb) {
                    return Some(triangle);
                }
            }
        }
    }
    None
}
