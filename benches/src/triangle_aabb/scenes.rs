//! The workloads: triangles, each with boxes to test.

use fastrand::Rng;

use crate::geometry::{Cell, Point, random_triangle};
use crate::pairs::Pairs;

/// The number of pairs in a scene, at least.
const PAIRS: usize = 100_000;

const UNIT_CUBE: Cell = Cell { center: [0.0; 3], half: [0.5; 3] };

/// Triangles, each with the cells that it is tested against.
pub type Scene = Pairs<[Point; 3], Cell>;

/// Triangles with vertices uniform in [−2, 2]³ against the unit cube around the
/// origin: Voorhies' experiment, and the paper's.
pub fn voorhies() -> Scene {
    let mut rng = Rng::with_seed(1);
    let triangles = (0..PAIRS).map(|_| random_triangle(&mut rng)).collect();
    Scene::all_against(triangles, vec![UNIT_CUBE])
}

/// For random triangles, every cube of 1/8 of the longest side of the bounding
/// box that lies in it.
pub fn voxel() -> Scene {
    let mut rng = Rng::with_seed(2);
    let mut scene = Scene::default();
    while scene.len() < PAIRS {
        let triangle = random_triangle(&mut rng);
        scene.push(triangle, cubes_within(&triangle));
    }
    scene
}

fn cubes_within(triangle: &[Point; 3]) -> impl Iterator<Item = Cell> {
    let (min, max) = bounding_box(triangle);
    let extent: Point = std::array::from_fn(|i| max[i] - min[i]);
    let side = extent.into_iter().fold(0.0, f64::max) / 8.0;
    let count = extent.map(|e| (e / side) as usize);
    cubes(count, move |i, n| min[i] + side * n as f64, side)
}

/// The same, in whole blocks of thirty-two cubes.
pub fn many_boxes() -> Scene {
    let mut rng = Rng::with_seed(2);
    let mut scene = Scene::default();
    while scene.len() < PAIRS {
        let triangle = random_triangle(&mut rng);
        let cubes: Vec<_> = cubes_within(&triangle).collect();
        scene.push(triangle, cubes.as_chunks::<32>().0.as_flattened().to_vec());
    }
    scene
}

/// Vertices on the integer grid {−4…4}³ and cubes of side 2 on it: contacts of
/// every kind.
pub fn grid() -> Scene {
    let mut rng = Rng::with_seed(3);
    let mut scene = Scene::default();
    let mut point = || [0; 3].map(|_| f64::from(rng.i8(-4..=4)));
    for _ in 0..PAIRS {
        let triangle = [point(), point(), point()];
        scene.push(triangle, [Cell { center: point(), half: [1.0; 3] }]);
    }
    scene
}

/// Walls and floors with vertices at voxel corners, as in scenes built of blocks, against the
/// voxels on either side: every plane axis touches, and so do many edges.
pub fn walls() -> Scene {
    let mut rng = Rng::with_seed(4);
    let mut scene = Scene::default();
    while scene.len() < PAIRS {
        let normal = rng.usize(0..3);
        let corner = [0; 3].map(|_| f64::from(rng.i8(-8..=8)));
        let sides = [0; 2].map(|_| f64::from(rng.u8(1..=8)));
        let mut triangle = [corner; 3];
        triangle[1][(normal + 1) % 3] += sides[0];
        triangle[2][(normal + 2) % 3] += sides[1];
        let (min, max) = bounding_box(&triangle);
        let count = std::array::from_fn(|i| (max[i] - min[i]) as usize + 2);
        scene.push(triangle, cubes(count, |i, n| min[i] - 1.0 + n as f64, 1.0));
    }
    scene
}

/// Triangles in the plane of a face of the box, with coordinates spread over 80 powers of two.
/// Every one touches the plane of that face, and no integer type holds all its coordinates, so
/// exact sums must decide.
pub fn spread() -> Scene {
    let mut rng = Rng::with_seed(5);
    let mut coordinate = || (rng.f64() - 0.5).signum() * 2_f64.powf(1.0 - 80.0 * rng.f64());
    let mut vertex = || [0.5, coordinate(), coordinate()];
    let triangles = (0..PAIRS / 10).map(|_| [vertex(), vertex(), vertex()]).collect();
    Scene::all_against(triangles, vec![UNIT_CUBE])
}

pub fn bounding_box(triangle: &[Point; 3]) -> (Point, Point) {
    let fold = |f: fn(f64, f64) -> f64| {
        let [a, b, c] = triangle;
        std::array::from_fn(|i| f(f(a[i], b[i]), c[i]))
    };
    (fold(f64::min), fold(f64::max))
}

/// A block of cubes, where `least(i, n)` is the low side of the n-th along axis i.
fn cubes(
    [nx, ny, nz]: [usize; 3],
    least: impl Fn(usize, usize) -> f64 + Copy,
    side: f64,
) -> impl Iterator<Item = Cell> {
    let half = side / 2.0;
    let cell = move |n: [usize; 3]| Cell {
        center: std::array::from_fn(|i| least(i, n[i]) + half),
        half: [half; 3],
    };
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| cell([x, y, z]))))
}
