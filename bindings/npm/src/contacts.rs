//! The contacts of spheres and capsules with a mesh.

use septum::contact::{ContactWith, InteriorEdges, Part, interior_edges};
use septum::mesh::Probe;
use septum::{Capsule, ShapeError, Sphere, Triangle};

use crate::memory::{LIST, lock, table};
use crate::mesh::{MESHES, State};
use crate::part::number;
use crate::query::{NONE, REFUSED};

/// Lists the contacts of a shape, 13 words each: the triangle, the translation that moves it, the depth,
/// the normal, whether the translation suffices (1) and is held at an interior edge (2), and the
/// point on the triangle with its part. Returns how many there are; -1 if there is no memory for the
/// interior edges, -2 if the shape is refused.
fn list<P: Probe<f32>>(mesh: usize, shape: Result<P, ShapeError>) -> i32
where
    Triangle<f32>: ContactWith<f32, P>,
{
    let Ok(shape) = shape else { return REFUSED };
    let mut meshes = lock(&MESHES);
    let Some(State::Built(tree, interior)) = meshes.get_mut(mesh) else { return 0 };
    let count = tree.mesh().triangles().len();
    if interior.len() < count {
        let scratch = table((0_u32, 0_u8), 3 * count);
        let (Some(mut scratch), Some(mut edges)) = (scratch, table(InteriorEdges::NONE, count))
        else {
            return NONE;
        };
        if interior_edges(&tree.mesh(), &mut scratch, &mut edges).is_err() {
            return NONE;
        }
        *interior = edges;
    }
    let tree = tree.as_tree();
    let Ok(contacts) = tree.contacts(&shape, interior) else { return NONE };
    let mut list = lock(&LIST);
    list.clear();
    for (triangle, contact) in contacts {
        let t = contact.translation;
        let [x, y, z] = t.vector.to_array().map(f32::to_bits);
        let [nx, ny, nz] = t.normal.to_array().map(f32::to_bits);
        let flags = u32::from(t.is_sufficient) | u32::from(contact.is_held) << 1;
        let (place, part) = contact
            .points()
            .first()
            .map_or(([0.0; 3], Part::Face(0)), |point| (point.on_first.to_array(), point.parts[0]));
        let [px, py, pz] = place.map(f32::to_bits);
        let depth = t.depth.to_bits();
        let part = number(part).into();
        list.extend([triangle as u32, x, y, z, depth, nx, ny, nz, flags, px, py, pz, part]);
    }
    (list.len() / 13) as i32
}

/// Lists the contacts of a sphere.
#[unsafe(export_name = "sphere_contacts")]
extern "C" fn sphere_contacts(mesh: usize, x: f32, y: f32, z: f32, radius: f32) -> i32 {
    list(mesh, Sphere::new([x, y, z], radius))
}

/// Lists the contacts of a capsule.
#[unsafe(export_name = "capsule_contacts")]
extern "C" fn capsule_contacts(
    mesh: usize,
    ax: f32,
    ay: f32,
    az: f32,
    bx: f32,
    by: f32,
    bz: f32,
    radius: f32,
) -> i32 {
    list(mesh, Capsule::new([ax, ay, az], [bx, by, bz], radius))
}
