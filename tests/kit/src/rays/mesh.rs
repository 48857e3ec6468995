//! Closed meshes, consistently oriented, with normals outward.

use std::collections::HashMap;

use septum::Triangle;

use crate::{Each, Sample, three};

type Point = [f64; 3];

/// Vertices, and faces that share them.
pub struct Mesh<S> {
    pub vertices: Vec<[S; 3]>,
    pub faces: Vec<[usize; 3]>,
    pub triangles: Vec<Triangle<S>>,
    /// A ball about each patch of [`PATCH`] faces.
    balls: Vec<(Point, f64)>,
}

/// The number of faces that come from one face two subdivisions earlier.
const PATCH: usize = 16;

impl<S: Sample> Mesh<S> {
    /// A regular icosahedron, each face cut into four four times over, with all vertices moved to
    /// the sphere: 5,120 faces.
    pub fn sphere(place: impl Fn(Point) -> [S; 3]) -> Self {
        Self::new(sphere(), place)
    }

    /// The octahedron of points whose coordinates' magnitudes sum to 1, each face
    /// cut into four four times over: 2,048 faces, many of them coplanar.
    pub fn octahedron(place: impl Fn(Point) -> [S; 3]) -> Self {
        Self::new(octahedron(), place)
    }

    fn new((points, faces): Solid, place: impl Fn(Point) -> [S; 3]) -> Self {
        let vertices: Vec<[S; 3]> = points.into_iter().map(place).collect();
        let triangle = |face: &[usize; 3]| {
            let [a, b, c] = face.each(|v| vertices[v]);
            Triangle::new(a, b, c).expect("finite vertices")
        };
        let triangles = faces.iter().map(triangle).collect();
        let balls =
            balls(&faces, &vertices.iter().map(|v| v.each(S::approximate)).collect::<Vec<_>>());
        Self { vertices, faces, triangles, balls }
    }

    /// All triangles that the line might come near, including every triangle within a hundredth of
    /// a patch's size.
    pub fn near(&self, origin: [S; 3], direction: [S; 3]) -> impl Iterator<Item = &Triangle<S>> {
        let (o, d) = (origin.each(S::approximate), direction.each(S::approximate));
        let dot = |a: Point, b: Point| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let square = dot(d, d);
        let meets = move |&(center, radius): &(Point, f64)| {
            let to = three(|i| center[i] - o[i]);
            let across = dot(to, to) - dot(to, d) * dot(to, d) / square;
            across <= radius * radius
        };
        let patches = self.triangles.chunks(PATCH).zip(&self.balls);
        patches.filter(move |(_, ball)| meets(ball)).flat_map(|(patch, _)| patch)
    }
}

/// Points and faces.
type Solid = (Vec<Point>, Vec<[usize; 3]>);

fn sphere() -> Solid {
    let golden = (1.0 + 5_f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for i in 0..3 {
        for (x, y) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
            let mut point = [0.0; 3];
            (point[(i + 1) % 3], point[(i + 2) % 3]) = (x, y);
            points.push(point);
        }
    }
    // The faces are the triples of vertices at a distance of the edge's length.
    let square = |a: Point, b: Point| -> f64 {
        [0, 1, 2].iter().map(|&i| (a[i] - b[i]) * (a[i] - b[i])).sum()
    };
    let adjacent = |a: usize, b: usize| (square(points[a], points[b]) - 4.0).abs() < 1e-9;
    let mut faces = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if adjacent(a, b) && adjacent(b, c) && adjacent(c, a) {
                    faces.push(outward(&points, [a, b, c]));
                }
            }
        }
    }
    let to_sphere = |p: Point| {
        let length = square(p, [0.0; 3]).sqrt();
        p.each(|x| x / length)
    };
    let mut points = points.into_iter().map(to_sphere).collect();
    subdivide(&mut points, &mut faces, 4, to_sphere);
    (points, faces)
}

fn octahedron() -> Solid {
    let mut points = Vec::new();
    for i in 0..3 {
        for x in [1.0, -1.0] {
            let mut point = [0.0; 3];
            point[i] = x;
            points.push(point);
        }
    }
    let mut faces = Vec::new();
    for (x, y, z) in (0..8).map(|n| (n & 1, 2 + (n >> 1 & 1), 4 + (n >> 2))) {
        faces.push(outward(&points, [x, y, z]));
    }
    subdivide(&mut points, &mut faces, 4, |p| p);
    (points, faces)
}

/// The face, oriented so that its normal points away from the origin.
fn outward(points: &[Point], [a, b, c]: [usize; 3]) -> [usize; 3] {
    let [p, q, r] = [a, b, c].each(|k| points[k]);
    let volume = p[0] * (q[1] * r[2] - q[2] * r[1])
        + p[1] * (q[2] * r[0] - q[0] * r[2])
        + p[2] * (q[0] * r[1] - q[1] * r[0]);
    if volume > 0.0 { [a, b, c] } else { [a, c, b] }
}

/// Cuts each face into four, `times` over; the four stay together.
fn subdivide(
    points: &mut Vec<Point>,
    faces: &mut Vec<[usize; 3]>,
    times: usize,
    place: impl Fn(Point) -> Point,
) {
    for _ in 0..times {
        let mut middles = HashMap::new();
        let mut middle = |a: usize, b: usize| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                points.push(place(three(|i| (points[a][i] + points[b][i]) / 2.0)));
                points.len() - 1
            })
        };
        let cut = |&[a, b, c]: &[usize; 3]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        *faces = faces.iter().flat_map(cut).collect();
    }
}

/// A ball around the faces of each patch, a hundredth larger than necessary.
fn balls(faces: &[[usize; 3]], points: &[Point]) -> Vec<(Point, f64)> {
    faces.chunks(PATCH).map(|patch| ball(patch, points)).collect()
}

fn ball(patch: &[[usize; 3]], points: &[Point]) -> (Point, f64) {
    let corners = || patch.iter().flatten().map(|&v| points[v]);
    let count = 3.0 * patch.len() as f64;
    let center = three(|i| corners().map(|p| p[i]).sum::<f64>() / count);
    let distance =
        |p: Point| [0, 1, 2].iter().map(|&i| (p[i] - center[i]).powi(2)).sum::<f64>().sqrt();
    (center, 1.01 * corners().map(distance).fold(0.0, f64::max))
}
