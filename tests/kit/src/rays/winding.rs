//! The oracle for inside and outside: the winding number of triangles about a point. It uses a ray
//! that meets no edge; the crate looks along an axis and perturbs the point.

use septum::{Facing, Feature};

use super::{RayCase, crossing};
use crate::{BoxNumbers, Case, Rng, Sample, meets};

/// The winding number of closed triangles about a point; `None` if one of them contains it.
pub fn winding<S: Sample>(triangles: &[[[S; 3]; 3]], point: [S; 3], rng: &mut Rng) -> Option<i32> {
    let aabb = BoxNumbers::Corners(point, point);
    let contains = |&vertices: &[[S; 3]; 3]| {
        let is_within = (0..3).all(|i| {
            vertices.iter().any(|v| v[i] <= point[i]) && vertices.iter().any(|v| v[i] >= point[i])
        });
        is_within && meets(&Case { vertices, aabb })
    };
    if triangles.iter().any(contains) {
        return None;
    }
    loop {
        let most = if S::WHOLE_BITS < 15 { 7 } else { 120 };
        let direction = rng.triple(|rng| S::nearest(rng.whole(-most, most) as f64 / 16.0));
        if direction == [S::ZERO; 3] {
            continue;
        }
        if let Some(winding) = along(triangles, point, direction) {
            return Some(winding);
        }
    }
}

/// The same, unless the ray meets an edge.
fn along<S: Sample>(triangles: &[[[S; 3]; 3]], p: [S; 3], direction: [S; 3]) -> Option<i32> {
    let mut winding = 0;
    for &vertices in triangles {
        let Some(truth) = crossing(&RayCase::new(p, direction, vertices)) else { continue };
        if truth.feature != Feature::Interior {
            return None;
        }
        winding += if truth.facing == Facing::Back { 1 } else { -1 };
    }
    Some(winding)
}
