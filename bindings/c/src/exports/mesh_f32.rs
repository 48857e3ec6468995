//! Questions about a mesh, in `float` with indices of 16 bits. build.rs makes those of the other
//! types, and of 32-bit indices, from this file.

use crate::manifolds;
use crate::mesh::{self, Mesh, Tree};
#[allow(unused_imports, reason = "floats need no name")]
use crate::number::*;
use crate::shapes::{
    Aabb, Answer, Capsule, Closest, Contact, FirstContact, Hit, Ray, Sphere, SphereContact,
};

/// Checks a mesh and its tree, once: yes, or the error. `tree` is written only if the answer is
/// yes.
///
/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_open_f32(
    mesh: Option<&Mesh<f32, u16>>,
    tree: *mut Tree<f32, u16>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::open(mesh, tree) }
}

/// Builds a tree over a mesh, whose own nodes are not looked at, in the memory of `nodes`, as many
/// as [`septum_node_count`] says, and of `order`, an index for each triangle: yes, or the error. All
/// three stay where they are for as long as the tree is used. Triangles keep their numbers.
///
/// # Safety
/// Each pointer of the mesh leads to as many elements as the mesh says, for as long as the tree is
/// used. `nodes` has `node_count` elements, and `order` one for each triangle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_build_f32(
    mesh: Option<&Mesh<f32, u16>>,
    nodes: *mut [[u16; 4]; 6],
    node_count: usize,
    order: *mut u16,
    tree: *mut Tree<f32, u16>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::build(mesh, nodes, node_count, order, tree) }
}

/// Whether a closed mesh contains a point, exactly: inside, or on a triangle.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `point` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_contains_f32(
    tree: Option<&Tree<f32, u16>>,
    point: *const f32,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::contains(tree, point.cast::<[f32; 3]>().as_ref()) }
}

/// The first triangle that a ray hits, and the hit: written only if the answer is yes. Exact, as for
/// a single triangle; of several at one point the least triangle.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_first_hit_f32(
    tree: Option<&Tree<f32, u16>>,
    ray: Option<&Ray<f32>>,
    triangle: Option<&mut usize>,
    hit: Option<&mut Hit<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::first_hit(tree, ray, triangle, hit) }
}

/// Whether a ray hits any triangle, exactly.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_is_hit_f32(
    tree: Option<&Tree<f32, u16>>,
    ray: Option<&Ray<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::is_hit(tree, ray) }
}

/// Whether a box overlaps any triangle, exactly; the first in the tree's order is written if the
/// answer is yes.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_aabb_f32(
    tree: Option<&Tree<f32, u16>>,
    aabb: Option<&Aabb<f32>>,
    triangle: Option<&mut usize>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::overlapping(tree, aabb, triangle) }
}

/// Whether a sphere overlaps any triangle, exactly; the first in the tree's order is written if the
/// answer is yes.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_sphere_f32(
    tree: Option<&Tree<f32, u16>>,
    sphere: Option<&Sphere<f32>>,
    triangle: Option<&mut usize>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::overlapping(tree, sphere, triangle) }
}

/// The triangle closest to a point, exactly, and its point, rounded; of several at one distance the
/// least triangle. No if the mesh is empty.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `point` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_closest_point_f32(
    tree: Option<&Tree<f32, u16>>,
    point: *const f32,
    triangle: Option<&mut usize>,
    closest: Option<&mut Closest<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::closest_point(tree, point.cast::<[f32; 3]>().as_ref(), triangle, closest) }
}

/// The first triangle that a box meets as it moves by `motion`, and when: written only if the answer
/// is yes. The verdict is exact, and the time is never late.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_aabb_cast_f32(
    tree: Option<&Tree<f32, u16>>,
    aabb: Option<&Aabb<f32>>,
    motion: *const f32,
    triangle: Option<&mut usize>,
    first: Option<&mut FirstContact<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::aabb_cast(tree, aabb, motion.cast::<[f32; 3]>().as_ref(), triangle, first) }
}

/// The same of a sphere.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_sphere_cast_f32(
    tree: Option<&Tree<f32, u16>>,
    sphere: Option<&Sphere<f32>>,
    motion: *const f32,
    triangle: Option<&mut usize>,
    first: Option<&mut SphereContact<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { mesh::sphere_cast(tree, sphere, motion.cast::<[f32; 3]>().as_ref(), triangle, first) }
}

/// Writes which edges of each triangle are interior: bit k of `interior` for the edge from vertex k
/// to the next. Nothing is to catch on these. `scratch` has three elements for each triangle.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `scratch` has three elements for each triangle, and `interior` one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_interior_edges_f32(
    tree: Option<&Tree<f32, u16>>,
    scratch: *mut [u16; 2],
    interior: *mut u8,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { manifolds::edges(tree, scratch, interior) }
}

/// The contacts of a sphere with all triangles that it penetrates, in the tree's order, and the
/// numbers of these: as many as `count` says, which then says how many there are. Each translation
/// moves the triangle; the sphere moves by its opposite. `interior` may be null.
///
/// # Safety
/// The tree is zero, or was written by a function of this type, and its mesh has not moved.
/// `interior` is null, or has an element for each triangle; `triangles` and `contacts` have `count`
/// elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_sphere_contacts_f32(
    tree: Option<&Tree<f32, u16>>,
    sphere: Option<&Sphere<f32>>,
    interior: *const u8,
    triangles: *mut usize,
    contacts: *mut Contact<f32>,
    count: Option<&mut usize>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { manifolds::contacts(tree, sphere, interior, triangles, contacts, count) }
}

/// The same of a capsule.
///
/// # Safety
/// As for `septum_tree_sphere_contacts_f32`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_tree_capsule_contacts_f32(
    tree: Option<&Tree<f32, u16>>,
    capsule: Option<&Capsule<f32>>,
    interior: *const u8,
    triangles: *mut usize,
    contacts: *mut Contact<f32>,
    count: Option<&mut usize>,
) -> Answer {
    // SAFETY: as the caller promises.
    unsafe { manifolds::contacts(tree, capsule, interior, triangles, contacts, count) }
}
