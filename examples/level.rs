//! A level from an OBJ file: its bounds, a pick by a ray, and its voxels.
use glam::Vec3;
use septum::Ray;
use septum::mesh::OwnedTree;
use septum::voxel::{Grid, Solid};

struct Level {
    ground: OwnedTree<f32>,
}

fn load(path: &str) -> Result<Level, Box<dyn std::error::Error>> {
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for tobj::Model { mesh, .. } in tobj::load_obj(path, &tobj::GPU_LOAD_OPTIONS)?.0 {
        let first = vertices.len() as u32;
        vertices.extend(mesh.positions.chunks_exact(3).map(|p| [0, 1, 2].map(|k| p[k] as f32)));
        faces.extend(mesh.indices.chunks_exact(3).map(|i| [0, 1, 2].map(|k| first + i[k])));
    }
    Ok(Level { ground: OwnedTree::new(vertices, faces)? })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("examples/assets/teapot.obj".into());
    let Level { ground } = load(&path)?;
    let aabb = ground.mesh().aabb().ok_or("no triangles")?;
    let (min, max) = aabb.min_max().ok_or("no corners")?;
    let (min, max) = (Vec3::from(min.to_array()), Vec3::from(max.to_array()));
    println!("from {min} to {max}");
    let ray = Ray::new((2.0 * max - min).to_array(), (min - max).to_array())?;
    let picked = ground.as_tree().first_hit(&ray).map(|(face, hit)| (face, hit.t));
    println!("face and t of the first hit: {picked:?}");

    let grid = Grid::around(&aabb, 16, 0)?;
    let (mut words, mut lines) =
        (vec![0_u64; grid.words::<u64>()], vec![0; grid.line_words::<u64>()]);
    let mut solid = Solid::new(&grid, &mut words, &mut lines)?;
    ground.mesh().iter().for_each(|triangle| solid.cross(&triangle));
    solid.finish();
    solid.bits().iter().for_each(|[x, y, z]| println!("{x} {y} {z}"));
    Ok(())
}
