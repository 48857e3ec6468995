//! Trees from tables: valid tables give the same answers, and damaged tables are refused.

use fixed::types::I16F16;
use septum::mesh::{Mesh, MeshError, Node, Tree};
use septum::{Aabb, Ray};
use septum_kit::Rng;

use super::{scenes, sorted};

/// Nodes and triangles of a built tree, both in its order.
fn table<'a>(tree: &Tree<'a, I16F16, u16>) -> (Vec<Node>, Vec<[u16; 3]>) {
    let faces = tree.order().map(|i| tree.mesh().triangles()[i]).collect();
    (tree.nodes().to_vec(), faces)
}

#[test]
fn a_table_answers_as_the_tree_did() {
    let mut rng = Rng::new(85);
    for mut scene in scenes::all::<I16F16>() {
        let points: Vec<_> = (0..40).map(|_| scene.point(&mut rng)).collect();
        let tree = scene.tree();
        let (nodes, faces) = table(&tree);
        let in_order: Vec<_> = tree.order().collect();
        assert_eq!(sorted(tree.order()), (0..faces.len()).collect::<Vec<_>>());
        let mesh = Mesh::new(tree.mesh().vertices(), &faces).expect("a mesh");
        let other = Tree::new(mesh, &nodes).expect("a sound table");
        for p in points {
            assert_eq!(other.contains(p), tree.contains(p));
            let aabb = Aabb::from_center_half_extents(p, [I16F16::ONE; 3]).expect("a box");
            let there = sorted(other.overlapping(&aabb).map(|i| in_order[i]));
            assert_eq!(there, sorted(tree.overlapping(&aabb)));
        }
    }
}

/// With one or more flipped bits, a table is refused or gives the same answers.
#[test]
fn a_broken_table_is_refused() {
    let mut rng = Rng::new(86);
    let mut scene = scenes::closed::<I16F16>().swap_remove(1);
    let (points, rays): (Vec<_>, Vec<_>) = (0..12)
        .map(|_| (scene.point(&mut rng), scene.point(&mut rng)))
        .map(|(p, q)| (p, Ray::new(p, [q[0], q[1], I16F16::ONE]).expect("a ray")))
        .unzip();
    let tree = scene.tree();
    let (nodes, faces) = table(&tree);
    let mesh = Mesh::new(tree.mesh().vertices(), &faces).expect("a mesh");
    let sound = Tree::new(mesh, &nodes).expect("a sound table");
    let (mut refused, mut taken) = (0, 0);
    for k in 0..400 {
        let mut broken = nodes.clone();
        for _ in 0..=k % 3 {
            let node = &mut broken[rng.below(nodes.len())];
            let mut bits = node.to_bits();
            let number = &mut bits[rng.below(6)][rng.below(4)];
            *number = if k % 4 == 0 { rng.bits() as u16 } else { *number ^ 1 << rng.below(16) };
            *node = Node::from_bits(bits);
        }
        match Tree::new(mesh, &broken) {
            Ok(tree) => {
                taken += 1;
                for (p, ray) in points.iter().zip(&rays) {
                    assert_eq!(tree.contains(*p), sound.contains(*p));
                    assert_eq!(tree.first_hit(ray), sound.first_hit(ray));
                }
            }
            Err(error) => {
                assert!(matches!(error, MeshError::Node { .. }), "{error:?}");
                refused += 1;
            }
        }
    }
    assert!(refused > 100 && taken > 20, "{refused} refused, {taken} taken");
}

#[test]
fn a_table_of_another_length_is_refused() {
    let mut scene = scenes::closed::<I16F16>().swap_remove(0);
    let tree = scene.tree();
    let (mut nodes, faces) = table(&tree);
    let mesh = Mesh::new(tree.mesh().vertices(), &faces).expect("a mesh");
    let needed = nodes.len();
    let refusal = Some(MeshError::Length { needed });
    assert_eq!(Tree::new(mesh, &nodes[1..]).err(), refusal);
    nodes.push(Node::EMPTY);
    assert_eq!(Tree::new(mesh, &nodes).err(), refusal);
    assert_eq!(Tree::build(mesh, &mut nodes, &mut []).err(), refusal);
    nodes.pop();
    let refusal = Some(MeshError::Length { needed: faces.len() });
    assert_eq!(Tree::build(mesh, &mut nodes, &mut [0; 3]).err(), refusal);
    // Another mesh's triangles.
    let moved: Vec<_> = mesh.vertices().iter().map(|v| septum::Vec3::new(v.y, v.x, v.z)).collect();
    let other = Mesh::new(&moved, &faces).expect("a mesh");
    assert!(matches!(Tree::new(other, &nodes), Err(MeshError::Node { .. })));
}

/// One tree on every machine: 16-bit coordinates, and an order with defined ties.
#[test]
fn a_tree_fits_a_small_core() {
    let mut scene = scenes::closed::<I16F16>().swap_remove(1);
    let tree = scene.tree();
    let mesh = tree.mesh();
    let bytes =
        size_of_val(mesh.vertices()) + size_of_val(mesh.triangles()) + size_of_val(tree.nodes());
    assert!(mesh.triangles().len() > 960 && bytes < 32 * 1024, "{bytes}");
}
