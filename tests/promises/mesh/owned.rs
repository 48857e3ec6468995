//! A mesh and its tree in one value, built at once or in steps, beside a tree in borrowed memory.

use septum::Ray;
use septum::mesh::{MeshError, OwnedTree};
use septum_kit::{Rng, Sample};

use super::scenes;

/// The same tree, whatever the steps, and the same answers.
pub(super) fn owned_trees_answer_as_borrowed<S: Sample>() {
    let (mut rng, mut hits) = (Rng::new(97), 0);
    for (n, mut scene) in scenes::all::<S>().into_iter().enumerate() {
        let owned = OwnedTree::new(scene.vertices.clone(), scene.faces.clone()).expect("a mesh");
        let mut steps = OwnedTree::builder(scene.vertices.clone(), scene.faces.clone()).unwrap();
        let (step, mut progress) = ([1, 5, 64][n % 3], 0.0);
        while !steps.advance(step) {
            assert!(progress <= steps.progress() && steps.progress() <= 1.0);
            progress = steps.progress();
        }
        let points: Vec<_> = (0..20).map(|_| scene.point(&mut rng)).collect();
        let name = scene.name;
        let tree = scene.tree();
        for owned in [&owned, &steps.finish(), &owned.clone()] {
            let lent = owned.as_tree();
            assert_eq!(lent.nodes(), tree.nodes(), "{name}");
            assert!(lent.order().eq(tree.order()), "{name}");
            assert_eq!(lent.mesh(), tree.mesh());
            for pair in points.windows(2) {
                assert_eq!(lent.contains(pair[0]), tree.contains(pair[0]));
                let Ok(ray) = Ray::new(pair[0], pair[1]) else { continue };
                assert_eq!(lent.first_hit(&ray), tree.first_hit(&ray));
                hits += usize::from(tree.is_hit(&ray));
            }
        }
        let (vertices, faces) = owned.into_parts();
        assert_eq!((vertices, faces), (scene.vertices, scene.faces));
    }
    assert!(hits > 20, "{hits}");
}

#[test]
fn bad_meshes_are_refused() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0_f32]];
    let refused = |corners: [[f32; 3]; 3], faces: Vec<[u16; 3]>| {
        OwnedTree::new(corners, faces).expect_err("bad")
    };
    let bad = refused(corners, vec![[0, 1, 2], [0, 1, 3]]);
    assert_eq!(bad, MeshError::NoSuchVertex { triangle: 1 });
    let bad = refused([corners[0], [f32::NAN; 3], corners[2]], vec![]);
    assert_eq!(bad, MeshError::NotFinite { vertex: 1 });
    assert_eq!(refused(corners, vec![[0, 1, 2]; 65_537]), MeshError::TooManyTriangles);
}

#[test]
fn threads_share_an_owned_tree() {
    fn shared<T: Clone + Send + Sync + 'static>() {}
    shared::<OwnedTree<f32>>();
    shared::<OwnedTree<f64, u16>>();
    shared::<OwnedTree<fixed::types::I16F16>>();
}
