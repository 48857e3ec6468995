//! Meshes: how they are made, at once or in steps.

use alloc::vec::Vec;

use septum::Vec3;
use septum::contact::InteriorEdges;
use septum::mesh::{MeshError, Node, OwnedTree, OwnedTreeBuilder, Scratch};
use spin::Mutex;

use crate::memory::{Slots, lock, reaches, say, table};

/// A mesh before, while and after its tree is built.
#[allow(clippy::large_enum_variant, reason = "few are in work")]
pub(crate) enum State {
    Raw(Vec<Vec3<f32>>, Vec<[u32; 3]>),
    InWork(OwnedTreeBuilder<f32>),
    /// With the interior edges of each triangle, after the first question about contacts.
    Built(OwnedTree<f32>, Vec<InteriorEdges>),
}

pub(crate) static MESHES: Mutex<Slots<State>> = Mutex::new(Slots::EMPTY);

/// What `ask` answers about a mesh; `missing` if there is none.
pub(crate) fn with<T>(mesh: usize, missing: T, ask: impl FnOnce(&OwnedTree<f32>) -> T) -> T {
    match lock(&MESHES).get(mesh) {
        Some(State::Built(tree, _)) => ask(tree),
        _ => missing,
    }
}

/// The handle of a mesh whose vertices and triangles are still to be written, or -1 if there is no
/// memory for it, its tree and the building of it.
#[unsafe(export_name = "mesh")]
extern "C" fn mesh(vertices: u32, triangles: u32) -> i32 {
    let (v, t) = (u64::from(vertices), u64::from(triangles));
    let per_triangle = size_of::<[u32; 3]>() + size_of::<u32>() + size_of::<Scratch>();
    let bytes = v * size_of::<Vec3<f32>>() as u64 + t * (per_triangle + size_of::<Node>()) as u64;
    if !usize::try_from(bytes).is_ok_and(reaches) {
        return -1;
    }
    match (table(Vec3::splat(0.0), vertices as usize), table([0; 3], triangles as usize)) {
        (Some(vertices), Some(triangles)) => lock(&MESHES).keep(State::Raw(vertices, triangles)),
        _ => -1,
    }
}

/// The address of the vertices, three `f32` each; null if there is no such mesh.
#[unsafe(export_name = "vertices")]
extern "C" fn vertices(mesh: usize) -> *const Vec3<f32> {
    match lock(&MESHES).get(mesh) {
        Some(State::Raw(vertices, _)) => vertices.as_ptr(),
        Some(State::Built(tree, _)) => tree.mesh().vertices().as_ptr(),
        _ => core::ptr::null(),
    }
}

/// The address of the triangles, three `u32` each; null if there is no such mesh.
#[unsafe(export_name = "triangles")]
extern "C" fn triangles(mesh: usize) -> *const [u32; 3] {
    match lock(&MESHES).get(mesh) {
        Some(State::Raw(_, triangles)) => triangles.as_ptr(),
        Some(State::Built(tree, _)) => tree.mesh().triangles().as_ptr(),
        _ => core::ptr::null(),
    }
}

/// Checks what was written, and begins the tree. Returns 0, or 1 with the index of a vertex that is
/// not finite, 2 with that of a triangle that has no such vertex, 3 otherwise; then the mesh is
/// gone.
#[unsafe(export_name = "begin")]
extern "C" fn begin(mesh: usize) -> u32 {
    let mut meshes = lock(&MESHES);
    let Some(State::Raw(vertices, triangles)) = meshes.take(mesh) else { return 3 };
    match OwnedTree::builder(vertices, triangles) {
        Ok(builder) => {
            meshes.put(mesh, State::InWork(builder));
            0
        }
        Err(MeshError::NotFinite { vertex }) => {
            say(0, &[vertex as u32]);
            1
        }
        Err(MeshError::NoSuchVertex { triangle }) => {
            say(0, &[triangle as u32]);
            2
        }
        Err(_) => 3,
    }
}

/// Looks at so many triangles more, and returns the share of the work that is done: 1 if the tree
/// is built.
#[unsafe(export_name = "advance")]
extern "C" fn advance(mesh: usize, triangles: usize) -> f32 {
    let mut meshes = lock(&MESHES);
    let Some(State::InWork(builder)) = meshes.get_mut(mesh) else { return 1.0 };
    if !builder.advance(triangles) {
        return builder.progress().min(0.999);
    }
    if let Some(State::InWork(builder)) = meshes.take(mesh) {
        meshes.put(mesh, State::Built(builder.finish(), Vec::new()));
    }
    1.0
}

/// Gives the memory of a mesh back.
#[unsafe(export_name = "drop_mesh")]
extern "C" fn drop_mesh(mesh: usize) {
    lock(&MESHES).take(mesh);
}

/// Writes the least and the greatest corner of a mesh, and returns 1; 0 if it has no triangle.
#[unsafe(export_name = "bounds")]
extern "C" fn bounds(mesh: usize) -> u32 {
    with(mesh, 0, |tree| {
        let Some((min, max)) = tree.mesh().aabb().and_then(|aabb| aabb.min_max()) else { return 0 };
        say(0, &min.to_array().map(f32::to_bits));
        say(3, &max.to_array().map(f32::to_bits));
        1
    })
}
