//! Times voxelization of whole meshes: ours, one test for each voxel, the peers, and as a lower
//! limit clearing the grid and writing its words.

use std::collections::HashSet;
use std::error::Error;
use std::path::PathBuf;

use clap::Parser;
use comfy_table::Table;
use cpu_time::ThreadTime;
use parry3d::math::Vector;
use parry3d::transformation::voxelization::{FillMode, VoxelValue, VoxelizedVolume};
use septum::prepared::PreparedTriangle;
use septum::voxel::{Bits, Grid, Rule};
use septum::{Aabb, Triangle};
use septum_benches::obj;
use septum_kit::voxels::torus_knot;

/// Times voxelization beside its peers, one thread, in one process, taking turns.
///
/// All in f32, with voxels of size one. parry3d's grid is shifted by half a voxel; for it, and for
/// our run beside it, the mesh is shifted too. Each result is compared with the exact voxels of the
/// mesh that the method was given. Times are the best of all rounds, in processor time.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Meshes besides the teapot and the generated ones: OBJ files
    meshes: Vec<PathBuf>,
    /// Voxels along the longest side
    #[arg(short, long, value_delimiter = ',', default_values_t = [64, 128, 256, 512])]
    resolution: Vec<u32>,
    /// Rounds
    #[arg(long, default_value_t = 5)]
    rounds: u32,
}

type Mesh = Vec<[[f32; 3]; 3]>;

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let mut meshes = vec![("teapot".to_string(), obj::teapot())];
    for path in &options.meshes {
        meshes.push(obj::open(path)?);
    }
    meshes.push(("turned cube".into(), turned_cube()));
    meshes.push(("knot of 5,040".into(), torus_knot(210, 12)));
    meshes.push(("knot of 90,000".into(), torus_knot(1500, 30)));

    let mut table = Table::new();
    table.load_preset(comfy_table::presets::ASCII_MARKDOWN);
    table.set_header([
        "mesh",
        "side",
        "voxels",
        "ours, ms",
        "ns/triangle",
        "clear + write",
        "per voxel",
        "parry3d",
        "wrong −/+",
        "meshvox",
        "wrong −/+",
    ]);
    for (name, mesh) in &meshes {
        for &n in &options.resolution {
            table.add_row(row(name, mesh, n, options.rounds));
            eprintln!("{}", table.lines().last().unwrap_or_default());
        }
    }
    println!("How many times as long as ours; voxels missed / set too many.\n\n{table}");
    Ok(())
}

fn row(name: &str, mesh: &[[[f64; 3]; 3]], n: u32, rounds: u32) -> Vec<String> {
    // For parry3d the longest side is n − 1, and voxel k is from k − ½ to k + ½.
    let mesh = placed(mesh, f64::from(n) - 1.0);
    let triangles: Vec<_> =
        mesh.iter().map(|[a, b, c]| Triangle::new(*a, *b, *c).expect("finite")).collect();
    let half = Grid::new([-0.5_f32; 3], [1.0; 3], [n + 1; 3]).expect("a grid");
    let whole = Grid::new([-1.0_f32; 3], [1.0; 3], [n + 1; 3]).expect("a grid");
    let mut words = vec![0_u64; whole.words::<u64>()];

    let exact_half = voxels(&half, &triangles, &mut words);
    let exact_whole = voxels(&whole, &triangles, &mut words);
    let written: Vec<(usize, u64)> =
        words.iter().copied().enumerate().filter(|&(_, word)| word != 0).collect();

    let points: Vec<Vector> =
        mesh.as_flattened().iter().map(|p| Vector::new(p[0], p[1], p[2])).collect();
    let faces: Vec<[u32; 3]> =
        (0..mesh.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let corners: Vec<usize> = (0..3 * mesh.len()).collect();
    let mut best = [f64::INFINITY; 5];
    let (mut by_parry, mut by_meshvox) = (HashSet::new(), HashSet::new());
    for round in 0..rounds {
        time(&mut best[0], || fill(&whole, &triangles, &mut words));
        time(&mut best[1], || {
            words.fill(0);
            written.iter().for_each(|&(at, word)| words[at] = word);
        });
        time(&mut best[2], || per_voxel(&whole, &triangles, &mut words));
        // Slow methods run in fewer rounds if they take seconds.
        if round < 2 || best[3] < 0.5 {
            let mut volume = None;
            time(&mut best[3], || {
                let fill = FillMode::SurfaceOnly;
                volume = Some(VoxelizedVolume::voxelize(&points, &faces, n, fill, false));
            });
            by_parry = volume.map(|volume| of_parry(&volume)).unwrap_or_default();
        }
        if round < 2 || best[4] < 0.5 {
            let mut found = None;
            time(&mut best[4], || {
                found = Some(meshvox::Voxels::voxelize(mesh.as_flattened(), &corners, 1.0));
            });
            by_meshvox = found.map(|found| found.grid_positions).unwrap_or_default();
        }
    }
    per_voxel(&whole, &triangles, &mut words);
    assert!(exact_whole == voxels_of(&whole, &mut words), "a test for each voxel");
    let wrong = |exact: &HashSet<[i32; 3]>, other: &HashSet<[i32; 3]>| {
        format!("{} / {}", exact.difference(other).count(), other.difference(exact).count())
    };
    let times = |k: usize| format!("{:.3}", best[k] / best[0]);
    vec![
        name.to_string(),
        n.to_string(),
        exact_whole.len().to_string(),
        format!("{:.3}", 1e3 * best[0]),
        format!("{:.0}", 1e9 * best[0] / mesh.len() as f64),
        times(1),
        times(2),
        times(3),
        wrong(&exact_half, &by_parry),
        times(4),
        wrong(&exact_whole, &by_meshvox),
    ]
}

/// Twelve large triangles.
fn turned_cube() -> Vec<[[f64; 3]; 3]> {
    let axes = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];
    let corner = |n: usize| {
        let at = |i: usize| if n >> i & 1 == 1 { 1.0 } else { -1.0 };
        [0, 1, 2].map(|c: usize| (0..3).map(|i| at(i) * axes[i][c]).sum())
    };
    let faces =
        [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let of_face =
        |[a, b, c, d]: [usize; 4]| [[a, b, c], [a, c, d]].map(|triangle| triangle.map(corner));
    faces.into_iter().flat_map(of_face).collect()
}

/// Keeps the best time of the work.
fn time(best: &mut f64, work: impl FnOnce()) {
    let start = ThreadTime::now();
    work();
    *best = best.min(start.elapsed().as_secs_f64());
}

/// Moves and scales a mesh to begin at zero and have this longest side.
fn placed(mesh: &[[[f64; 3]; 3]], longest: f64) -> Mesh {
    let points = || mesh.as_flattened().iter();
    let low = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let high = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
    let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let place = |p: [f64; 3]| [0, 1, 2].map(|i| ((p[i] - low[i]) * longest / extent) as f32);
    mesh.iter().map(|t| t.map(place)).collect()
}

fn fill(grid: &Grid<f32>, triangles: &[Triangle<f32>], words: &mut [u64]) {
    words.fill(0);
    let mut bits = Bits::new(grid, words).expect("enough words");
    triangles.iter().for_each(|triangle| bits.fill(triangle, Rule::Closed));
}

/// One test for each voxel, with the fastest such test.
fn per_voxel(grid: &Grid<f32>, triangles: &[Triangle<f32>], words: &mut [u64]) {
    words.fill(0);
    let (size, row_words) = (grid.resolution(), grid.row_words::<u64>());
    for triangle in triangles {
        let prepared = PreparedTriangle::new(triangle);
        let v = triangle.vertices().map(|v| v.to_array());
        let range = |i: usize| {
            let (low, high) =
                (v[0][i].min(v[1][i]).min(v[2][i]), v[0][i].max(v[1][i]).max(v[2][i]));
            let (first, last) = (low.ceil() - 1.0 + 1.0, high.floor() + 1.0);
            (first.max(0.0) as u32, (last as u32).min(size[i] - 1))
        };
        let [x, y, z] = [0, 1, 2].map(range);
        for k in z.0..=z.1 {
            for j in y.0..=y.1 {
                let row = (k * size[1] + j) as usize * row_words;
                for i in x.0..=x.1 {
                    let center = [i, j, k].map(|k| k as f32 - 0.5);
                    let voxel = Aabb::from_center_half_extents(center, [0.5; 3]).expect("a box");
                    if prepared.overlaps(&voxel) {
                        words[row + i as usize / 64] |= 1 << (i % 64);
                    }
                }
            }
        }
    }
}

/// The voxels that are set, by the coordinates of their least corners, rounded up.
fn voxels(grid: &Grid<f32>, triangles: &[Triangle<f32>], words: &mut [u64]) -> HashSet<[i32; 3]> {
    fill(grid, triangles, words);
    voxels_of(grid, words)
}

fn voxels_of(grid: &Grid<f32>, words: &mut [u64]) -> HashSet<[i32; 3]> {
    let start = grid.origin().to_array().map(|x| x.ceil() as i32);
    let [_, ny, _] = grid.resolution();
    let row_words = grid.row_words::<u64>() as u32;
    let mut found = HashSet::new();
    for (at, &word) in words.iter().enumerate() {
        let (at, mut word) = (at as u32, word);
        while word != 0 {
            let x = at % row_words * 64 + word.trailing_zeros();
            let (y, z) = (at / row_words % ny, at / row_words / ny);
            found.insert([0, 1, 2].map(|i| [x, y, z][i] as i32 + start[i]));
            word &= word - 1;
        }
    }
    found
}

fn of_parry(volume: &VoxelizedVolume) -> HashSet<[i32; 3]> {
    let [nx, ny, nz] = volume.resolution();
    let mut found = HashSet::new();
    for (x, y, z) in (0..nx * ny * nz).map(|n| (n % nx, n / nx % ny, n / nx / ny)) {
        if volume.voxel(x, y, z) == VoxelValue::PrimitiveOnSurface {
            found.insert([x, y, z].map(|k| k as i32));
        }
    }
    found
}
