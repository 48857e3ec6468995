//! The voxels of the teapot, which the page must also find: each voxel near each triangle is
//! tested, and each centre.

use std::collections::HashSet;

use septum::Vec3;
use septum::mesh::{Node, Tree};
use septum::voxel::{Bits, Grid, Solid};

use crate::voxels::{self, Mesh};

/// For each resolution, the number of voxels along each axis, on the surface, and on the surface or
/// inside.
const GOLDEN: &str = include_str!("../test/teapot.csv");

fn teapot() -> (Vec<Vec3<f32>>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for line in include_str!("../../assets/teapot.obj").lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["v", x, y, z] => vertices.push([x, y, z].map(|x| x.parse().unwrap()).into()),
            ["f", a, b, c] => {
                triangles.push([a, b, c].map(|i| i.parse::<u32>().unwrap() - 1));
            }
            _ => panic!("{line}"),
        }
    }
    (vertices, triangles)
}

/// The voxels on the surface, by testing each triangle against each voxel of its box.
fn surface(mesh: &Mesh<'_>, grid: &Grid<f32>) -> HashSet<[u32; 3]> {
    let (origin, cell) = (grid.origin().to_array(), grid.cell().to_array());
    let mut set = HashSet::new();
    for triangle in mesh.iter() {
        let corners = triangle.vertices().map(Vec3::to_array);
        let range = [0, 1, 2].map(|i| {
            let places = corners.map(|corner| (corner[i] - origin[i]) / cell[i]);
            let least = places.into_iter().fold(f32::INFINITY, f32::min);
            let greatest = places.into_iter().fold(f32::NEG_INFINITY, f32::max);
            // One more voxel on both sides.
            (least - 2.0).max(0.0) as u32..((greatest + 2.0) as u32).min(grid.resolution()[i])
        });
        let [xs, ys, zs] = range;
        for z in zs {
            for y in ys.clone() {
                for x in xs.clone() {
                    if triangle.overlaps(&grid.voxel([x, y, z]).unwrap()) {
                        set.insert([x, y, z]);
                    }
                }
            }
        }
    }
    set
}

/// The page's counts: the voxels on the surface, the voxels on the surface or inside, and the open
/// rows.
fn counts(mesh: &Mesh<'_>, grid: &Grid<f32>) -> (u64, u64, HashSet<[u32; 2]>) {
    let all = 0..mesh.triangles().len();
    let mut words = vec![0_u32; grid.words::<u32>()];
    let mut bits = Bits::new(grid, &mut words).unwrap();
    voxels::fill(&mut bits, mesh, all.clone());
    let surface = bits.count();

    let mut lines = vec![0_u32; grid.line_words::<u32>()];
    let mut solid = Solid::new(grid, &mut words, &mut lines).unwrap();
    voxels::cross(&mut solid, mesh, all.clone());
    solid.finish();
    let open = solid.open_rows().collect();
    let mut bits = Bits::new(grid, &mut words).unwrap();
    voxels::fill(&mut bits, mesh, all);
    (surface, bits.count(), open)
}

#[test]
fn the_voxels_of_the_teapot_are_those_of_each_question() {
    let (vertices, triangles) = teapot();
    let mesh = Mesh::new(&vertices, &triangles).unwrap();
    let mut nodes = vec![Node::EMPTY; Node::count_for(triangles.len())];
    let mut order = vec![0; triangles.len()];
    let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();

    let mut table = vec!["resolution,x,y,z,surface,solid,open".to_string()];
    for resolution in [1, 16, 64, 100] {
        let grid = voxels::grid_around(&mesh, resolution).unwrap();
        let mut set = surface(&mesh, &grid);
        let on_surface = set.len();
        let (on_it, on_it_or_inside, open) = counts(&mesh, &grid);
        assert_eq!(on_surface as u64, on_it, "{resolution}");
        let [nx, ny, nz] = grid.resolution();
        // A row that does not close has no inside.
        let rows = (0..ny * nz).map(|k| [k % ny, k / ny]).filter(|row| !open.contains(row));
        for [x, y, z] in rows.flat_map(|[y, z]| (0..nx).map(move |x| [x, y, z])) {
            let (min, max) = grid.voxel([x, y, z]).unwrap().min_max().unwrap();
            let (min, max) = (min.to_array(), max.to_array());
            if tree.contains([0, 1, 2].map(|i| 0.5 * (min[i] + max[i]))) {
                set.insert([x, y, z]);
            }
        }
        assert_eq!(set.len() as u64, on_it_or_inside, "{resolution}");
        table.push(format!("{resolution},{nx},{ny},{nz},{on_it},{on_it_or_inside},{}", open.len()));
    }
    assert_eq!(table.join("\n"), GOLDEN.trim_end(), "test/teapot.csv");
}

/// The planes enclose the mesh, wherever it is; and meshes that no grid holds are refused.
#[test]
fn a_grid_encloses_its_mesh() {
    let mut refused = 0;
    for (k, far) in [0.0_f32, 1.0, -1e3, 3e4, 1e6, 1e9].into_iter().enumerate() {
        for resolution in 1..=64 {
            let corner = |x: f32, y: f32, z: f32| Vec3::new(far + x, y - far, z);
            let vertices = [corner(0.1, 0.0, 0.0), corner(0.7, 1.1, 0.0), corner(0.0, 0.3, 0.9)];
            let mesh = Mesh::new(&vertices, &[[0, 1, 2]]).unwrap();
            let Ok(grid) = voxels::grid_around(&mesh, resolution) else {
                refused += 1;
                assert!(k > 3, "{far} {resolution}");
                continue;
            };
            let size = grid.resolution();
            let ends = [grid.voxel([0; 3]), grid.voxel(size.map(|n| n - 1))];
            let [from, to] = ends.map(|voxel| voxel.unwrap().min_max().unwrap());
            for vertex in vertices.map(Vec3::to_array) {
                let (from, to) = (from.0.to_array(), to.1.to_array());
                assert!((0..3).all(|i| from[i] <= vertex[i] && vertex[i] <= to[i]), "{far}");
            }
            assert!(size.iter().max().unwrap().abs_diff(resolution) <= 2, "{far} {size:?}");
        }
    }
    assert!(refused > 64);
}
