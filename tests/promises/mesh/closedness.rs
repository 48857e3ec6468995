//! Which meshes are closed, and which open edge is reported.

use fixed::types::I16F16;
use septum::Vec3;
use septum::mesh::{Mesh, MeshError};
use septum_kit::{Each, Rng};

use super::scenes;

#[test]
fn closed_meshes_are_whatever_their_orientation() {
    let mut rng = Rng::new(84);
    for scene in scenes::closed::<f64>() {
        let mut faces = scene.faces.clone();
        for face in &mut faces {
            if rng.one_in(2) {
                face.swap(0, 1);
            }
        }
        let mut scratch = vec![[0; 2]; 3 * faces.len()];
        let mesh = Mesh::new(&scene.vertices, &faces).expect("a mesh");
        assert_eq!(mesh.check_closed(&mut scratch), Ok(()), "{}", scene.name);
    }
}

/// Without one face its three edges are open, and the first of them is reported.
#[test]
fn an_open_edge_is_named() {
    for scene in scenes::closed::<I16F16>() {
        let mut scratch = vec![[0; 2]; 3 * scene.faces.len()];
        for k in (0..scene.faces.len()).step_by(97) {
            let mut faces = scene.faces.clone();
            let [a, b, c] = faces.remove(k).each(|v| scene.vertices[usize::from(v)].to_array());
            let mut edges = [[a, b], [b, c], [c, a]].each(|mut edge| {
                edge.sort_by(|p, q| p.partial_cmp(q).expect("numbers"));
                edge
            });
            edges.sort_by(|p, q| p.partial_cmp(q).expect("numbers"));
            let open =
                Mesh::new(&scene.vertices, &faces).expect("a mesh").check_closed(&mut scratch);
            let Err(MeshError::OpenEdge { vertices }) = open else { panic!("{open:?}") };
            let named = vertices.each(|v| scene.vertices[v].to_array());
            assert_eq!(named, edges[0], "{}: face {k}", scene.name);
        }
    }
}

/// Vertices at one position are the same: the separate faces of a cube are closed.
#[test]
fn seams_are_closed() {
    let corner = |k: usize| {
        Vec3::from([k & 1, k >> 1 & 1, k >> 2].each(|x| if x == 0 { -0.0 } else { 1.0 }))
    };
    let sides =
        [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let mut vertices: Vec<Vec3<f32>> = sides.as_flattened().iter().map(|&k| corner(k)).collect();
    // Zeros of either sign are the same position.
    vertices[0] = Vec3::splat(0.0);
    let mut faces: Vec<_> = (0..6_u32)
        .flat_map(|s| [[4 * s, 4 * s + 1, 4 * s + 2], [4 * s, 4 * s + 2, 4 * s + 3]])
        .collect();
    // A face of zero area, whose edges cancel.
    faces.push([0, 1, 1]);
    let mut scratch = vec![[0; 2]; 39];
    let check = |vertices: &[Vec3<f32>], scratch: &mut [[u32; 2]]| {
        Mesh::new(vertices, &faces).expect("a mesh").check_closed(scratch)
    };
    assert_eq!(check(&vertices, &mut scratch), Ok(()));
    assert_eq!(check(&vertices, &mut scratch[1..]), Err(MeshError::Length { needed: 39 }));
    vertices[23].x = f32::MIN_POSITIVE + 1.0;
    assert!(matches!(check(&vertices, &mut scratch), Ok(())), "1 + ε is 1");
    vertices[23].x = 1.0_f32.next_up();
    assert!(matches!(check(&vertices, &mut scratch), Err(MeshError::OpenEdge { .. })));
}

/// Of vertices at one position the first are reported, in any order of the faces.
#[test]
fn an_open_seam_is_named_by_the_first() {
    let ends = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let apexes = [[2.0, 1.0, 0.0], [2.0, 0.0, 1.0], [2.0, -1.0, 0.0]];
    let vertices = [ends, ends, ends].concat().into_iter().chain(apexes).map(Vec3::from);
    let vertices: Vec<Vec3<f64>> = vertices.collect();
    let mut faces = [[4_u16, 5, 6], [3, 2, 7], [0, 1, 8]];
    for _ in 0..3 {
        faces.rotate_left(1);
        let mesh = Mesh::new(&vertices, &faces).expect("a mesh");
        let open = mesh.check_closed(&mut [[0; 2]; 9]);
        assert_eq!(open, Err(MeshError::OpenEdge { vertices: [0, 1] }));
    }
}

#[test]
fn a_mesh_names_what_is_wrong() {
    let vertices = [[0.0, 0.0, 0.0], [1.0, f32::NAN, 0.0]].each(Vec3::from);
    assert_eq!(Mesh::new(&vertices, &[[0_u16; 3]]), Err(MeshError::NotFinite { vertex: 1 }));
    let (sound, missing) = (&vertices[..1], [[0_u16; 3], [0, 0, 1]]);
    assert_eq!(Mesh::new(sound, &missing), Err(MeshError::NoSuchVertex { triangle: 1 }));
    let many = vec![[0_u16; 3]; 65_537];
    assert_eq!(Mesh::new(sound, &many), Err(MeshError::TooManyTriangles));
    assert!(Mesh::new(sound, &many[..65_536]).is_ok());
    assert_eq!(Mesh::<f32, u16>::new(&[], &[]).expect("empty").check_closed(&mut []), Ok(()));
}
