//! The point of a mesh that is closest to another.

use septum::Vec3;

use crate::memory::say;
use crate::mesh::with;
use crate::part::number_of_feature;
use crate::query::NONE;

/// The index of the triangle that is closest to a point, and no farther than a distance, or -1. An
/// infinite distance is no limit. The numbers are then the closest point, and its part.
#[unsafe(export_name = "closest")]
extern "C" fn closest(mesh: usize, x: f32, y: f32, z: f32, within: f32) -> i32 {
    let point = Vec3::new(x, y, z);
    with(mesh, NONE, |tree| {
        let tree = tree.as_tree();
        let found = if within.is_infinite() {
            tree.closest_point(point)
        } else {
            tree.closest_point_within(point, within)
        };
        found.map_or(NONE, |(i, closest)| {
            say(0, &closest.point.to_array().map(f32::to_bits));
            say(3, &[number_of_feature(closest.feature).into()]);
            i as i32
        })
    })
}
