//! No ray passes through a closed mesh without a hit, and by `hit_once` each wall counts exactly
//! once.

use septum::{Facing, Ray};
use septum_kit::rays::{Aim, Count, Mesh, Method, Scene, Shot};
use septum_kit::{Each, Rng, Sample, for_every_scalar, three};

/// In all scenes, toward all targets.
fn every_shot<S: Sample>(check: impl Fn(&Mesh<S>, &Shot<S>, Scene)) {
    for scene in Scene::ALL.into_iter().filter(|scene| scene.misfit::<S>().is_none()) {
        let mesh = scene.mesh::<S>();
        for aim in Aim::ALL {
            for shot in scene.shots(&mesh, aim, 71, 1_000) {
                check(&mesh, &shot, scene);
            }
        }
    }
}

fn nothing_leaks<S: Sample>() {
    every_shot::<S>(|mesh, shot, scene| {
        let [count] = shot.counts(mesh, [Method::Exact]);
        assert!(!shot.leaks(count), "{scene:?}: {count:?}, {shot:?}");
    });
}

/// Woop's test in floats too, though it may count a wall twice.
fn nothing_leaks_when_sheared<S: Sample>() {
    every_shot::<S>(|mesh, shot, scene| {
        let [count] = shot.counts(mesh, [Method::Watertight]);
        assert!(!shot.leaks(count), "{scene:?}: {count:?}, {shot:?}");
    });
}

#[test]
fn nothing_leaks_when_sheared_in_floats() {
    nothing_leaks_when_sheared::<f32>();
    nothing_leaks_when_sheared::<f64>();
}

/// One entry and one exit. Rounding leaves every scene convex enough that a ray deep through it
/// crosses no wall again.
fn each_wall_counts_once<S: Sample>() {
    every_shot::<S>(|mesh, shot, scene| {
        let [count] = shot.counts(mesh, [Method::Once]);
        let expected = Count { front: shot.from_outside.into(), back: 1 };
        assert_eq!(count, expected, "{scene:?}: {shot:?}");
    });
}

/// The same with all triangles, including those that the ray does not come near.
fn the_whole_mesh_counts_once<S: Sample>() {
    for scene in Scene::ALL.into_iter().filter(|scene| scene.misfit::<S>().is_none()) {
        let mesh = scene.mesh::<S>();
        for shot in Aim::ALL.into_iter().flat_map(|aim| scene.shots(&mesh, aim, 72, 50)) {
            let expected = Count { front: shot.from_outside.into(), back: 1 };
            assert_eq!(count_once(&mesh, &shot.ray()), expected, "{scene:?}: {shot:?}");
        }
    }
}

fn count_once<S: Sample>(mesh: &Mesh<S>, ray: &Ray<S>) -> Count {
    let mut count = Count::default();
    for hit in mesh.triangles.iter().filter_map(|triangle| ray.hit_once(triangle)) {
        match hit.facing {
            Facing::Front => count.front += 1,
            Facing::Back => count.back += 1,
        }
    }
    count
}

/// A ray that grazes a mesh enters as often as it leaves, also along its edges and in the plane of
/// its faces; and a ray that starts on it starts inside or outside.
fn entries_are_exits<S: Sample>() {
    let mut rng = Rng::new(73);
    let mut grazed = 0;
    for scene in Scene::ALL.into_iter().filter(|scene| scene.misfit::<S>().is_none()) {
        let mesh = scene.mesh::<S>();
        for _ in 0..1_500 {
            let face = mesh.faces[rng.below(mesh.faces.len())].each(|v| mesh.vertices[v]);
            // Along an edge, or in the plane of two edges, or from one vertex to another.
            let other = mesh.vertices[rng.below(mesh.vertices.len())];
            let (from, to) = if rng.one_in(4) { (face[0], other) } else { (face[0], face[1]) };
            let difference = |p: [S; 3], q: [S; 3]| {
                three(|i| S::nearest(q[i].approximate() - p[i].approximate()))
            };
            let mut direction = difference(from, to);
            if rng.one_in(3) {
                let more = difference(face[1], face[2]);
                direction = [0, 1, 2]
                    .each(|i| S::nearest(2.0 * more[i].approximate() + direction[i].approximate()));
            }
            let Ok(ray) = Ray::new(from, direction) else { continue };
            let line = ray.with_range(None, None).expect("a line");
            let mut count = Count::default();
            let mut ahead = 0;
            for triangle in mesh.near(from, direction) {
                for (ray, sum) in [(&line, None), (&ray, Some(&mut ahead))] {
                    match (ray.hit_once(triangle).map(|hit| hit.facing), sum) {
                        (Some(Facing::Front), None) => count.front += 1,
                        (Some(Facing::Back), None) => count.back += 1,
                        (Some(Facing::Front), Some(ahead)) => *ahead -= 1,
                        (Some(Facing::Back), Some(ahead)) => *ahead += 1,
                        (None, _) => {}
                    }
                }
            }
            assert_eq!(count.front, count.back, "{scene:?}: {line:?}");
            // Ahead of the origin one exit more than entries: it starts inside.
            assert!(ahead == 0 || ahead == 1, "{scene:?}: {ahead}, {ray:?}");
            grazed += u32::from(count.front == 0);
        }
    }
    // Some rays miss, but not all.
    assert!(grazed > 30, "{grazed}");
}

for_every_scalar!(
    nothing_leaks,
    each_wall_counts_once,
    the_whole_mesh_counts_once,
    entries_are_exits
);
