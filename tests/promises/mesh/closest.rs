//! The triangle closest to a point, by exact distances from all triangles.

use septum::mesh::Mesh;
use septum_kit::spheres::{Other, SphereCase, Squared};
use septum_kit::{Each, Rng, Sample};

use super::scenes;

/// The first of the triangles closest to a point, and its distance.
fn closest<S: Sample>(mesh: &Mesh<'_, S, u16>, center: [S; 3]) -> Option<(usize, Squared)> {
    let mut best: Option<(usize, Squared)> = None;
    for (i, triangle) in mesh.iter().enumerate() {
        let other = Other::Triangle(triangle.vertices().each(|v| v.to_array()));
        let squared = SphereCase { center, radius: S::ZERO, other }.squared();
        if best.as_ref().is_none_or(|(_, least)| squared.compare_squared(least).is_lt()) {
            best = Some((i, squared));
        }
    }
    best
}

pub(super) fn points_are_closest_as_one_by_one<S: Sample>() {
    let (mut rng, mut within) = (Rng::new(92), [0; 2]);
    for mut scene in scenes::all::<S>() {
        let count = if scene.faces.len() > 500 { 4 } else { 10 };
        let points: Vec<_> = (0..count).map(|_| scene.point(&mut rng)).collect();
        let name = scene.name;
        let tree = scene.tree();
        let mesh = tree.mesh();
        for p in points {
            let expected = closest(mesh, p);
            let found = tree.closest_point(p);
            let index = expected.as_ref().map(|(i, _)| *i);
            assert_eq!(found.map(|(i, _)| i), index, "{name}: {p:?}");
            let Some((i, squared)) = expected else { continue };
            let of_triangle = mesh.triangle(i).and_then(|t| t.closest_point(p).ok());
            assert_eq!(found.map(|(_, closest)| closest), of_triangle, "{name}: {p:?}");
            let apart = mesh.triangle(i).and_then(|t| t.distance_squared(p).ok());
            let sign = |apart| if tree.contains(p) { S::ZERO.minus(apart) } else { apart };
            assert_eq!(tree.signed_distance_squared(p), apart.map(sign), "{name}: {p:?}");
            // Within the distance, rounded, and numbers next to that.
            let distance = S::nearest(squared.root());
            for distance in [-1, 0, 1].each(|by| distance.moved(by)) {
                let is_within =
                    distance >= S::ZERO && squared.compare(&[distance.mantissa_exponent()]).is_le();
                let found_within = tree.closest_point_within(p, distance);
                let expected = found.filter(|_| is_within);
                assert_eq!(found_within, expected, "{name}: {p:?} {distance:?}");
                within[usize::from(is_within)] += 1;
            }
        }
    }
    assert!(within.iter().all(|&n| n > 60), "{within:?}");
}

#[test]
fn nothing_is_closest_to_a_point_that_is_none() {
    let mut scene = scenes::closed::<f32>().swap_remove(0);
    let tree = scene.tree();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(tree.closest_point([0.0, bad, 0.0]), None);
        assert_eq!(tree.closest_point_within([0.0; 3], bad), None);
    }
    assert_eq!(tree.closest_point_within([0.0; 3], -1.0), None);
}
