//! Meshes to voxelize, each with a grid.

use crate::rays::Mesh;
use crate::{Each, Rng, Sample, three};

type Point = [f64; 3];

/// Triangles in a grid, in `f64`, which each scalar rounds.
#[derive(Clone)]
pub struct VoxelScene {
    /// The name of the scene.
    pub name: &'static str,
    /// The triangles.
    pub triangles: Vec<[Point; 3]>,
    /// The least corner of the grid.
    pub origin: Point,
    /// The size of a voxel.
    pub cell: Point,
    /// Voxels along each axis.
    pub resolution: [u32; 3],
}

const TEAPOT: &str = include_str!("../../../../examples/assets/teapot.obj");

impl VoxelScene {
    /// All scenes, with `n` voxels along an axis.
    pub fn all(n: u32) -> Vec<Self> {
        vec![
            Self::around("teapot", teapot(), n),
            Self::around("icosphere", sphere(), n),
            Self::around("torus knot", torus_knot(240, 12), n),
            Self::aligned_cube(n),
            Self::snapped(n),
            Self::slivers(n),
            Self::far(n),
        ]
    }

    /// Closed meshes, small enough for an oracle on each centre. Their vertices are multiples of
    /// 1/64, in some scenes of a half, so that lines meet edges and centres lie on faces.
    pub fn solids(n: u32) -> Vec<Self> {
        let rounded = |t: [Point; 3], per: f64| t.each(|p| p.each(|x| (x * per).round() / per));
        let end = f64::from(n);
        let fitted = |name, mesh: Vec<[Point; 3]>, per: f64| {
            let fit = Self::around(name, mesh, n);
            let to = |p: Point| three(|i| (p[i] - fit.origin[i]) / fit.cell[i]);
            let triangles = fit.triangles.iter().map(|t| rounded(t.each(to), per)).collect();
            Self { name, triangles, ..Self::whole(n) }
        };
        let knot = torus_knot(24, 5);
        let octahedron: Vec<_> = cube(-1.0, 1.0)
            .into_iter()
            .map(|t| t.each(|p| [p[0] + p[1], p[1] - p[0], p[2] + 0.5 * p[1]]))
            .collect();
        vec![
            fitted("knot", knot.clone(), 64.0),
            fitted("knot at halves", knot, 2.0),
            fitted("parallelepiped at halves", octahedron, 2.0),
            Self {
                name: "cubes with faces at centres",
                triangles: [cube(1.5, end - 1.5), cube(2.5, end - 2.0)].concat(),
                ..Self::whole(n)
            },
            Self {
                name: "cube that reaches beyond the grid",
                triangles: cube(-3.0, end - 2.5),
                ..Self::whole(n)
            },
        ]
    }

    /// A grid that ends where the mesh does.
    fn around(name: &'static str, triangles: Vec<[Point; 3]>, n: u32) -> Self {
        let points = || triangles.iter().flatten();
        let least = three(|i| points().map(|p| p[i]).fold(f64::INFINITY, f64::min));
        let greatest = three(|i| points().map(|p| p[i]).fold(f64::MIN, f64::max));
        let cell = three(|i: usize| (greatest[i] - least[i]) / f64::from(n));
        Self { name, triangles, origin: least, cell, resolution: [n; 3] }
    }

    /// A cube whose faces are planes of the grid, and a smaller one in it.
    fn aligned_cube(n: u32) -> Self {
        let end = f64::from(n);
        let (a, b) = ((end / 4.0).floor(), (end / 2.0).floor());
        let triangles = [cube(1.0, end - 1.0), cube(a, b)].concat();
        Self { name: "aligned cube", triangles, ..Self::whole(n) }
    }

    /// A sphere with its vertices on corners of the grid.
    fn snapped(n: u32) -> Self {
        let half = f64::from(n) / 2.0;
        let snap = |p: Point| p.each(|x| (half + x * (half - 1.0)).round());
        let triangles = sphere().into_iter().map(|t| t.each(snap)).collect();
        Self { name: "snapped", triangles, ..Self::whole(n) }
    }

    /// Long triangles with almost no area, some with none.
    fn slivers(n: u32) -> Self {
        let (rng, end) = (&mut Rng::new(7), f64::from(n));
        let sliver = |_| {
            let (a, b) = (rng.triple(|r| r.real(0.0, end)), rng.triple(|r| r.real(0.0, end)));
            let (part, off) = (rng.real(0.0, 1.0), rng.real(-1e-7, 1e-7));
            let c = three(|i| a[i] + part * (b[i] - a[i]) + off * end);
            if rng.one_in(4) { [a, b, b] } else { [a, b, c] }
        };
        Self { name: "slivers", triangles: (0..60).map(sliver).collect(), ..Self::whole(n) }
    }

    /// A sphere at a distance of ten thousand times its size.
    fn far(n: u32) -> Self {
        let away = |p: Point| [p[0] + 20_000.0, p[1] - 20_000.0, p[2] + 20_000.0];
        let triangles = sphere().into_iter().map(|t| t.each(away)).collect();
        Self::around("far", triangles, n)
    }

    /// An empty grid of unit voxels from zero on.
    fn whole(n: u32) -> Self {
        let (origin, cell) = ([0.0; 3], [1.0; 3]);
        Self { name: "", triangles: Vec::new(), origin, cell, resolution: [n; 3] }
    }

    /// Whether the scalar has the range and the precision for grid and mesh.
    pub fn fits<S: Sample>(&self) -> bool {
        let holds = |x: f64| {
            let is_in_range = x <= S::GREATEST.approximate();
            is_in_range && (S::nearest(x).approximate() - x).abs() < 0.05 * self.cell[0]
        };
        let ends = three(|i: usize| {
            [self.origin[i], self.origin[i] + self.cell[i] * f64::from(self.resolution[i])]
        });
        let cell = S::nearest(self.cell[0]).approximate() / self.cell[0];
        ends.as_flattened().iter().all(|&x| holds(x)) && (cell - 1.0).abs() < 0.01
    }
}

/// The Utah teapot: 992 triangles.
fn teapot() -> Vec<[Point; 3]> {
    let numbers = |line: &str| -> Vec<f64> {
        line.split_whitespace().skip(1).filter_map(|word| word.parse().ok()).collect()
    };
    let lines = |key: &'static str| TEAPOT.lines().filter(move |line| line.starts_with(key));
    let points: Vec<Point> =
        lines("v ").map(numbers).filter_map(|v| v.first_chunk().copied()).collect();
    let mut triangles = Vec::new();
    for face in lines("f ").map(numbers) {
        let corners: Vec<Point> = face.iter().map(|&i| points[i as usize - 1]).collect();
        triangles.extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
    }
    triangles
}

fn sphere() -> Vec<[Point; 3]> {
    let mesh = Mesh::<f64>::sphere(|p| p);
    mesh.triangles.iter().map(|t| t.vertices().each(|v| v.to_array())).collect()
}

/// A tube along a (2, 3) torus knot: twice `along` times `around` triangles.
pub fn torus_knot(along: usize, around: usize) -> Vec<[Point; 3]> {
    use std::f64::consts::TAU;
    let center = |s: f64| {
        let (angle, turn) = (2.0 * TAU * s, 3.0 * TAU * s);
        let r = 2.0 + turn.cos();
        [r * angle.cos(), r * angle.sin(), turn.sin()]
    };
    let minus = |a: Point, b: Point| three(|i: usize| a[i] - b[i]);
    let cross =
        |a: Point, b: Point| [(1, 2), (2, 0), (0, 1)].each(|(j, k)| a[j] * b[k] - a[k] * b[j]);
    let unit = |a: Point| {
        let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
        a.each(|x| x / length)
    };
    let point = |i: usize, j: usize| {
        let s = (i % along) as f64 / along as f64;
        let (at, next) = (center(s), center(s + 1e-4));
        let ahead = minus(next, at);
        let side = unit(cross(ahead, at));
        let up = unit(cross(side, ahead));
        let (sin, cos) = (TAU * (j % around) as f64 / around as f64).sin_cos();
        three(|k: usize| at[k] + 0.4 * (cos * side[k] + sin * up[k]))
    };
    let mut triangles = Vec::with_capacity(2 * along * around);
    for i in 0..along {
        for j in 0..around {
            let [a, b] = [point(i, j), point(i + 1, j)];
            let [c, d] = [point(i + 1, j + 1), point(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

/// The surface of a cube, closed, with its normals outward.
fn cube(from: f64, to: f64) -> Vec<[Point; 3]> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        for (level, out) in [(from, false), (to, true)] {
            let corner = |u: f64, v: f64| {
                let mut p = [level; 3];
                (p[j], p[k]) = (u, v);
                p
            };
            let [a, b] = [corner(from, from), corner(to, from)];
            let [c, d] = [corner(to, to), corner(from, to)];
            let two = if out { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] };
            triangles.extend(two);
        }
    }
    triangles
}
