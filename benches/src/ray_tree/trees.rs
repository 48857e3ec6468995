//! Trees over a mesh: ours and the peers'.

use std::error::Error;
use std::time::{Duration, Instant};

use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as ObvhsRay, RayHit};
use obvhs::triangle::Triangle as ObvhsTriangle;
use parry3d::shape::{TriMesh, TriMeshBuilderError, TriMeshFlags};
use septum::mesh::{Mesh, MeshError, OwnedTree, Tree};
use septum::{Scalar, Vec3};

use super::knot;
use crate::peer_shapes::{obvhs_triangle, parry_vector};

/// A tree over triangles in the tree's own order, as in a table, and the time to build it.
///
/// The memory is leaked, so that a tree can be used like any other shape.
///
/// # Errors
/// If the faces form no mesh.
pub fn tree<S: Scalar>(
    vertices: Vec<Vec3<S>>,
    faces: &[[u32; 3]],
) -> Result<(Tree<'static, S, u32>, Duration), MeshError> {
    let start = Instant::now();
    let built = OwnedTree::new(vertices, faces.iter().copied())?;
    let took = start.elapsed();
    let sorted: Vec<_> = built.as_tree().order().map(|i| faces[i]).collect();
    let nodes = built.as_tree().nodes().to_vec();
    let (vertices, _) = built.into_parts();
    let tree = Tree::new(Mesh::new(vertices.leak(), sorted.leak())?, nodes.leak())?;
    Ok((tree, took))
}

/// Builds trees over a knot in turns, and returns the best times of septum and parry3d.
///
/// # Errors
/// If one of them refuses the mesh.
pub fn builds(steps: u32, rounds: u32) -> Result<[Duration; 2], Box<dyn Error>> {
    let (points, faces) = knot(steps);
    let [mut ours, mut parry] = [Duration::MAX; 2];
    for _ in 0..rounds {
        let (vertices, triangles) = (points.clone(), faces.clone());
        let start = Instant::now();
        OwnedTree::<f32>::new(vertices, triangles)?;
        ours = start.elapsed().min(ours);
        let vertices = points.iter().map(|&p| p.into()).collect();
        let triangles = faces.clone();
        let start = Instant::now();
        TriMesh::new(vertices, triangles)?;
        parry = start.elapsed().min(parry);
    }
    Ok([ours, parry])
}

/// The mesh in parry3d's type.
///
/// # Errors
/// If parry3d refuses it.
pub fn parry_mesh(mesh: &Mesh<'_, f32, u32>) -> Result<TriMesh, TriMeshBuilderError> {
    let corners = mesh.vertices().iter().map(|&v| parry_vector(v)).collect();
    TriMesh::with_flags(corners, mesh.triangles().to_vec(), TriMeshFlags::ORIENTED)
}

/// A tree of obvhs from its slowest and best build, with the triangles in its order, as it advises.
pub struct Obvhs<Tree> {
    tree: Tree,
    triangles: Vec<ObvhsTriangle>,
}

impl Obvhs<Bvh2> {
    pub fn bvh2(mesh: &Mesh<'_, f32, u32>) -> Self {
        Self::new(mesh, build_bvh2_from_tris, |tree| &tree.primitive_indices)
    }

    #[inline]
    pub fn is_hit(&self, ray: &ObvhsRay) -> bool {
        let mut hit = RayHit::none();
        self.tree.ray_traverse(*ray, &mut hit, |ray, id| self.triangles[id].intersect(ray))
    }
}

impl Obvhs<CwBvh> {
    pub fn cwbvh(mesh: &Mesh<'_, f32, u32>) -> Self {
        Self::new(mesh, build_cwbvh_from_tris, |tree| &tree.primitive_indices)
    }

    #[inline]
    pub fn is_hit(&self, ray: &ObvhsRay) -> bool {
        let mut hit = RayHit::none();
        self.tree.ray_traverse(*ray, &mut hit, |ray, id| self.triangles[id].intersect(ray))
    }
}

impl<Tree> Obvhs<Tree> {
    fn new(
        mesh: &Mesh<'_, f32, u32>,
        build: impl Fn(&[ObvhsTriangle], BvhBuildParams, &mut Duration) -> Tree,
        order: impl Fn(&Tree) -> &[u32],
    ) -> Self {
        let triangles: Vec<_> = mesh.iter().map(|t| obvhs_triangle(&t)).collect();
        let mut took = Duration::ZERO;
        let tree = build(&triangles, BvhBuildParams::very_slow_build(), &mut took);
        let triangles = order(&tree).iter().map(|&i| triangles[i as usize]).collect();
        Self { tree, triangles }
    }
}
