//! Surfaces of triangles: the interior edges, which catch no sliding box and no capsule.

use septum::contact::{Contact, Features, InteriorEdges, contact, contact_in_mesh, interior_edges};
use septum::mesh::{Mesh, MeshError, OwnedTree};
use septum::{Aabb, Capsule, Obb, Sphere, Triangle, Vec3};
use septum_kit::{Each, Rng, three};

type Point = [f32; 3];

fn edges(vertices: &[Point], triangles: &[[u16; 3]]) -> Vec<InteriorEdges> {
    let vertices: Vec<_> = vertices.iter().copied().map(Vec3::from).collect();
    let mesh = Mesh::new(&vertices, triangles).unwrap();
    let mut edges = vec![InteriorEdges::ALL; triangles.len()];
    interior_edges(&mesh, &mut vec![(0, 0); 3 * triangles.len()], &mut edges).unwrap();
    edges
}

const NONE: InteriorEdges = InteriorEdges::NONE;

/// Whether the first edge of two triangles that share it is interior, for each of the two.
fn on_first_edge(apex: Point, second: [u16; 3]) -> [bool; 2] {
    let vertices = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], apex];
    let all = edges(&vertices, &[[0, 1, 2], second]);
    let k = (0..3).find(|&k| second[k] != 3 && second[(k + 1) % 3] != 3).unwrap();
    assert!([1, 2].iter().all(|&k| !all[0].contains(k)));
    [all[0].contains(0), all[1].contains(k)]
}

#[test]
fn flat_and_concave_edges_are_interior() {
    // Consistently oriented: level, above and below.
    for turn in [[1, 0, 3], [0, 3, 1], [3, 1, 0]] {
        assert_eq!(on_first_edge([0.3, -1.0, 0.0], turn), [true; 2]);
        assert_eq!(on_first_edge([0.3, -1.0, 1e-30], turn), [true; 2]);
        assert_eq!(on_first_edge([0.3, 0.5, 1e-30], turn), [true; 2]);
        assert_eq!(on_first_edge([0.3, -1.0, -1e-30], turn), [false; 2]);
        // Folded back onto the first triangle.
        assert_eq!(on_first_edge([0.3, 1.0, 0.0], turn), [false; 2]);
        // Of zero area.
        assert_eq!(on_first_edge([0.5, 0.0, 0.0], turn), [false; 2]);
    }
    // Opposite orientations: neither side is up, but level triangles are still level.
    assert_eq!(on_first_edge([0.3, -1.0, 0.0], [0, 1, 3]), [true; 2]);
    assert_eq!(on_first_edge([0.3, -1.0, 1.0], [0, 1, 3]), [false; 2]);
    assert_eq!(on_first_edge([0.3, -1.0, -1.0], [0, 1, 3]), [false; 2]);
    assert_eq!(on_first_edge([0.3, 1.0, 0.0], [0, 1, 3]), [false; 2]);
}

#[test]
fn an_edge_is_known_by_its_ends() {
    let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let diagonal =
        [InteriorEdges::new([false, false, true]), InteriorEdges::new([true, false, false])];
    assert_eq!(edges(&square, &[[0, 1, 2], [0, 2, 3]]), diagonal);
    let seam = [square.as_slice(), &[[-0.0; 3], [1.0, 1.0, 0.0]]].concat();
    assert_eq!(edges(&seam, &[[0, 1, 2], [4, 5, 3]]), diagonal);
    // Three triangles at an edge are no surface, and two equal triangles are not either.
    assert_eq!(edges(&square, &[[0, 1, 2], [0, 2, 3], [0, 2, 3]])[0], NONE);
    assert_eq!(edges(&square, &[[0, 1, 2], [0, 1, 2]]), [NONE; 2]);
    let vertices = square.each(Vec3::from);
    let mesh = Mesh::new(&vertices, &[[0_u16, 1, 2]]).unwrap();
    let short = |scratch: usize, into: usize| {
        interior_edges(&mesh, &mut vec![(0, 0); scratch], &mut vec![NONE; into])
    };
    assert_eq!(short(2, 1), Err(MeshError::Length { needed: 3 }));
    assert_eq!(short(3, 0), Err(MeshError::Length { needed: 1 }));
    assert_eq!(short(9, 9), Ok(()));
}

/// A floor of cells in a plane z = a·x + b·y, each of two triangles, with displaced inner vertices;
/// and its interior edges.
fn floor(rng: &mut Rng, [a, b]: [f32; 2]) -> (OwnedTree<f32, u16>, Vec<InteriorEdges>) {
    const CELLS: u16 = 6;
    let mut vertices = Vec::new();
    for i in 0..=CELLS {
        for j in 0..=CELLS {
            let mut place = |n: u16| {
                let is_inner = i % CELLS != 0 && j % CELLS != 0;
                // Less than a quarter of a cell, so that all triangles face up.
                let off = if is_inner { rng.whole(-3, 3) } else { 0 };
                f32::from(n) - 3.0 + off as f32 / 16.0
            };
            let (x, y) = (place(i), place(j));
            vertices.push([x, y, a * x + b * y]);
        }
    }
    let at = |i, j| i * (CELLS + 1) + j;
    let mut triangles = Vec::new();
    for i in 0..CELLS {
        for j in 0..CELLS {
            let [p, q, r, s] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            triangles.extend(if rng.one_in(2) {
                [[p, q, r], [p, r, s]]
            } else {
                [[p, q, s], [q, r, s]]
            });
        }
    }
    let interior = edges(&vertices, &triangles);
    (OwnedTree::new(vertices, triangles).unwrap(), interior)
}

/// Slides boxes over floors, and returns how often a box without the mesh's edges would be caught.
fn slide(starts: usize, seed: u64) -> usize {
    let mut rng = Rng::new(seed);
    let (mut caught, mut rests) = (0, 0);
    for n in 0..starts {
        // In quarters, so that the floor is exactly planar.
        let slope = [0, 1].each(|_| if n % 2 == 0 { 0.0 } else { rng.whole(-3, 3) as f32 / 4.0 });
        let (floor, interior) = floor(&mut rng, slope);
        let size = (slope[0] * slope[0] + slope[1] * slope[1] + 1.0).sqrt();
        let up = [-slope[0] / size, -slope[1] / size, 1.0 / size];
        let half = rng.triple(|rng| rng.real(0.2, 0.7) as f32);
        let along = rng.real(0.0, 6.3).sin_cos();
        let (s, c) = (along.0 as f32, along.1 as f32);
        let turned = [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
        let (mut x, mut y) = (rng.real(-1.2, 1.2) as f32, rng.real(-1.2, 1.2) as f32);
        let step = [rng.real(-0.1, 0.1) as f32, rng.real(-0.1, 0.1) as f32];
        for _ in 0..5 {
            (x, y) = (x + step[0], y + step[1]);
            let depth = rng.real(0.001, 0.02) as f32;
            let is_turned = n % 3 != 0;
            let axes = if is_turned {
                turned
            } else {
                [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            };
            let reach: f32 = (0..3)
                .map(|k| half[k] * (0..3).map(|i| axes[k][i] * up[i]).sum::<f32>().abs())
                .sum();
            let center = [x, y, slope[0] * x + slope[1] * y + (reach - depth) * size];
            let obb = Obb::new(center, axes, half).unwrap();
            let aabb = Aabb::from_center_half_extents(center, half).unwrap();
            let tree = floor.as_tree();
            let found: Vec<_> = if is_turned {
                tree.contacts(&obb, &interior).unwrap().collect()
            } else {
                tree.contacts(&aabb, &interior).unwrap().collect()
            };
            let is_up = |c: &Contact<f32>| {
                let n = c.translation.normal.to_array();
                // The triangle is moved down.
                (0..3).map(|i| n[i] * up[i]).sum::<f32>() < -0.999_999
            };
            for (i, found) in found {
                let t = tree.mesh().triangle(i).unwrap();
                assert!(is_up(&found), "{found:?} {t:?} {obb:?}");
                assert!(found.translation.depth < 0.05 && !found.points().is_empty(), "{found:?}");
                let alone = if is_turned { contact(&t, &obb) } else { contact(&t, &aabb) };
                let alone = alone.expect("the same verdict");
                assert!(found.is_held || is_up(&alone), "{found:?} {alone:?}");
                caught += usize::from(!is_up(&alone));
                rests += 1;
            }
        }
    }
    assert!(rests > starts, "{rests}");
    caught
}

#[test]
fn nothing_is_caught_on_a_floor() {
    assert!(slide(60, 0x51de) > 5);
}

/// `cargo test --release --test promises contacts -- --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn nothing_is_caught_on_ten_thousand_floors() {
    println!("held to the normal: {}", slide(10_000, 0x51df));
}

/// A capsule or a sphere over a floor has contacts along its normal only; the deepest is as deep as
/// the lower end of the capsule. Returns how often a triangle alone would have caught it.
fn roll(starts: usize, seed: u64) -> usize {
    let mut rng = Rng::new(seed);
    let mut caught = 0;
    for n in 0..starts {
        let slope = [0, 1].each(|_| if n % 2 == 0 { 0.0 } else { rng.whole(-3, 3) as f32 / 4.0 });
        let (floor, interior) = floor(&mut rng, slope);
        let size = (slope[0] * slope[0] + slope[1] * slope[1] + 1.0).sqrt();
        let up = [-slope[0] / size, -slope[1] / size, 1.0 / size];
        let tree = floor.as_tree();
        for k in 0..20 {
            let (radius, depth) = (rng.real(0.2, 0.6) as f32, rng.real(0.001, 0.1) as f32);
            let [x, y] = [(); 2].each(|()| rng.real(-1.2, 1.2) as f32);
            let low = [x, y, slope[0] * x + slope[1] * y + (radius - depth) * size];
            let mut high = rng.triple(|rng| rng.real(-0.8, 0.8) as f32);
            // Across the floor's normal, along it, or anywhere above.
            let down = (0..3).map(|i| high[i] * up[i]).sum::<f32>();
            let lift = [0.0, -down, 1.0 - down][k % 3].max(-down);
            high = three(|i: usize| low[i] + high[i] + lift * up[i]);
            let capsule = Capsule::new(low, if n % 3 == 0 { low } else { high }, radius).unwrap();
            let is_up = |c: &Contact<f32>| {
                let normal = c.translation.normal.to_array();
                (0..3).map(|i| normal[i] * up[i]).sum::<f32>() < -0.999_999
            };
            let mut deepest = 0.0_f32;
            for (_, found) in tree.contacts(&capsule, &interior).unwrap() {
                assert!(is_up(&found) && !found.is_held, "{found:?} {capsule:?}");
                deepest = deepest.max(found.translation.depth);
            }
            assert!((deepest - depth).abs() < 1e-5, "{deepest} {depth} {capsule:?}");
            for t in tree.overlapping(&capsule).map(|i| tree.mesh().triangle(i).unwrap()) {
                caught += usize::from(contact(&t, &capsule).is_some_and(|c| !is_up(&c)));
            }
        }
    }
    caught
}

#[test]
fn no_capsule_is_caught_on_a_floor() {
    assert!(roll(60, 0x0ba1) > 100);
}

/// A capsule whose axis crosses a triangle leaves along its normal, if the nearest way out leads
/// across an interior edge.
#[test]
fn a_capsule_that_crosses_is_held() {
    let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]).unwrap();
    let through = Capsule::new([1.0, 0.25, -1.0], [1.0, 0.25, 3.0], 0.5).unwrap();
    let alone = contact(&t, &through).unwrap();
    assert_eq!(alone.translation.vector.to_array(), [0.0, 0.75, 0.0]);
    assert_eq!(alone.translation.features, Features::Edges(0, 0));
    for edges in [InteriorEdges::ALL, InteriorEdges::new([true, false, false])] {
        let held = contact_in_mesh(&t, edges, &through).unwrap();
        assert_eq!(held.translation.vector.to_array(), [0.0, 0.0, -1.5]);
        assert!(held.is_held && held.translation.features == Features::First(0));
        let [point] = held.points() else { panic!("{held:?}") };
        assert_eq!(point.on_first.to_array(), [1.0, 0.0, 0.0]);
    }
    let other = contact_in_mesh(&t, InteriorEdges::new([false, true, true]), &through).unwrap();
    assert!(!other.is_held && other.translation == alone.translation);
    // Beside the first edge, and beyond the second vertex: along its first edge, or between both.
    let ball = |center: [f32; 3]| Sphere::new(center, 0.5).unwrap();
    for edges in 0..8 {
        let edges = InteriorEdges::new([edges & 1 == 1, edges & 2 == 2, edges & 4 == 4]);
        let beside = contact_in_mesh(&t, edges, &ball([1.0, -0.25, 0.0]));
        assert_eq!(beside.is_none(), edges.contains(0));
        let along = contact_in_mesh(&t, edges, &ball([4.25, 0.0, 0.0]));
        assert_eq!(along.is_none(), edges.contains(1));
        let beyond = contact_in_mesh(&t, edges, &ball([4.25, -0.125, 0.125]));
        assert_eq!(beyond.is_none(), edges.contains(0) || edges.contains(1));
    }
}

/// Without interior edges no contact is held, and a triangle of zero area holds none.
#[test]
fn only_interior_edges_hold() {
    let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]).unwrap();
    let across =
        |x: f32, y: f32| Aabb::from_min_max([x, y, -0.5], [x + 1.0, y + 1.0, 0.5]).unwrap();
    let over_first = across(1.0, -0.875);
    for edges in 0..8 {
        let edges = InteriorEdges::new([edges & 1 == 1, edges & 2 == 2, edges & 4 == 4]);
        let found = contact_in_mesh(&t, edges, &over_first).unwrap();
        assert_eq!(found.is_held, edges.contains(0));
        let expected = if edges.contains(0) { [0.0, 0.0, -0.5] } else { [0.0, 0.125, 0.0] };
        assert_eq!(found.translation.vector.to_array(), expected);
        // At the first vertex, sideways: across the third edge, and along the first.
        let beside = contact_in_mesh(&t, edges, &across(-0.875, 1.0)).unwrap();
        assert_eq!(beside.is_held, edges.contains(2));
        // At the second vertex: outward across the first edge, and inward from the second.
        let axes = [[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
        let turned = Obb::new([4.225, -0.3, 0.0], axes, [0.5; 3]).unwrap();
        let off = contact_in_mesh(&t, edges, &turned).unwrap();
        assert_eq!(off.is_held, edges.contains(0));
    }
    let line = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 0.0, 0.0]).unwrap();
    assert!(contact(&line, &over_first).is_some());
    assert!(contact_in_mesh(&line, InteriorEdges::NONE, &over_first).is_some());
    assert!(contact_in_mesh(&line, InteriorEdges::ALL, &over_first).is_none());
}
