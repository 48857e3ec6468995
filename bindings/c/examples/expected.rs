//! Prints the expected output of examples/check.c, computed by the crate itself; with the argument
//! `mesh` prints examples/mesh.h.

use std::fmt::Debug;

use fixed::types::{I8F8, I16F16};
use septum::contact::{
    Contact, ContactWith, InteriorEdges, Part, Translation, contact, interior_edges,
};
use septum::mesh::{Mesh, Node, Probe, Tree};
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Axis, Capsule, Facing, Feature, Hit, Obb, Ray, Scalar, Sphere, Triangle, Vec3};

const ROUNDS: usize = 256;
const HASH: u32 = 2_166_136_261;

/// xorshift (G. Marsaglia, 2003).
struct Stream(u32);

impl Stream {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// From -2 to 2, in 65,536ths.
    fn point(&mut self) -> [i32; 3] {
        [(); 3].map(|()| (self.next() >> 14) as i32 - 131_072)
    }
}

fn add(hash: u32, word: u32) -> u32 {
    word.to_le_bytes().iter().fold(hash, |h, &b| (h ^ u32::from(b)).wrapping_mul(16_777_619))
}

/// A torus with four sides in both directions: vertices in 65,536ths, and faces.
fn torus() -> ([[i32; 3]; 16], [[u16; 3]; 32]) {
    const QUARTERS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    let (mut vertices, mut faces) = ([[0; 3]; 16], [[0; 3]; 32]);
    for i in 0..4 {
        for j in 0..4 {
            let ([x, y], [out, up]) = (QUARTERS[i], QUARTERS[j]);
            let radius = 81_920 + 32_768 * out;
            vertices[4 * i + j] = [x * radius, y * radius, 32_768 * up];
            let at = |i: usize, j: usize| (4 * (i % 4) + j % 4) as u16;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            faces[2 * (4 * i + j)] = [a, b, c];
            faces[2 * (4 * i + j) + 1] = [a, c, d];
        }
    }
    (vertices, faces)
}

/// The faces of the torus in the tree's order, and the tree's nodes.
fn sorted<S: Scalar>(vertices: &[Vec3<S>]) -> ([[u16; 3]; 32], [Node; 3]) {
    let (_, faces) = torus();
    let (mut nodes, mut order) = ([Node::EMPTY; 3], [0; 32]);
    let mesh = Mesh::new(vertices, &faces).unwrap();
    mesh.check_closed(&mut [[0; 2]; 96]).unwrap();
    Tree::build(mesh, &mut nodes, &mut order).unwrap();
    (order.map(|i| faces[usize::from(i)]), nodes)
}

/// A table in C.
fn table(name: &str, rows: &impl Debug) -> String {
    format!("#define {name} {}\n", format!("{rows:?}").replace('[', "{").replace(']', "}"))
}

fn print_tables<S: Scalar>(name: &str, from: fn(i32) -> S) {
    let (faces, nodes) = sorted(&torus().0.map(|v| Vec3::from(v.map(from))));
    print!("{}", table(&format!("TRIANGLES_{name}"), &faces));
    print!("{}", table(&format!("NODES_{name}"), &nodes.map(Node::to_bits)));
}

fn print_mesh() {
    println!("/* Made by expected.rs: a torus, and a tree over it for each type of numbers. */");
    let vertices = torus().0.map(|[x, y, z]| format!("V({x}, {y}, {z})")).join(", ");
    println!("#define VERTICES {{{vertices}}}");
    print_tables("i8f8", |x| I8F8::from_bits((x / 256) as i16));
    print_tables("i16f16", I16F16::from_bits);
    print_tables("f32", |x| x as f32 / 65_536.0);
}

fn check<S: Scalar>(name: &str, from: fn(i32) -> S, bits: fn(S) -> u32) {
    let queries = [
        "triangle_aabb",
        "triangle_obb",
        "ray_aabb",
        "ray_triangle",
        "ray_triangle_hit",
        "contains",
        "triangle_triangle",
        "first_hit",
        "is_hit",
        "tree_aabb",
        "aabb_cast",
        "aabb_cast_triangle",
        "contact",
        "turned_contact",
        "sphere_triangle",
        "sphere_aabb",
        "capsule_triangle",
        "capsule_aabb",
        "closest_point",
        "tree_closest",
        "tree_sphere",
        "sphere_contact",
        "sphere_aabb_contact",
        "capsule_contact",
        "capsule_aabb_contact",
        "ray_sphere_range",
        "sphere_cast_triangle",
        "sphere_cast_aabb",
        "tree_sphere_cast",
        "sphere_contacts",
        "capsule_contacts",
    ];
    let vertices = torus().0.map(|v| Vec3::from(v.map(from)));
    let (faces, nodes) = sorted(&vertices);
    let tree = Tree::new(Mesh::new(&vertices, &faces).unwrap(), &nodes).unwrap();
    let (mut nodes, mut order) = ([Node::EMPTY; 3], [0; 32]);
    let built = Mesh::new(&vertices, &faces).unwrap();
    let built = Tree::build(built, &mut nodes, &mut order).unwrap();
    let mut interior = [InteriorEdges::NONE; 32];
    interior_edges(built.mesh(), &mut [(0, 0); 96], &mut interior).unwrap();
    for (query, called) in queries.iter().enumerate() {
        let (mut stream, mut hash, mut yes) = (Stream(1), HASH, 0);
        for round in 0..ROUNDS {
            let mut point = || stream.point().map(from);
            let triangle = Triangle::new(point(), point(), point()).unwrap();
            let (p, q) = (point(), point());
            let least: [S; 3] = core::array::from_fn(|k| if q[k] < p[k] { q[k] } else { p[k] });
            let most: [S; 3] = core::array::from_fn(|k| if q[k] < p[k] { p[k] } else { q[k] });
            let aabb = Aabb::from_min_max(least, most).unwrap();
            let axes = [[39_322, 52_429, 0], [-52_429, 39_322, 0], [0, 0, 65_536]];
            let half = [65_536, 32_768, 16_384].map(from);
            let center = point();
            let obb = Obb::new(center, axes.map(|axis| axis.map(from)), half).unwrap();
            let (origin, towards) = (point(), stream.point());
            let (direction, radius) = (towards.map(from), from(towards[0].abs()));
            let ray = Ray::new(origin, direction).unwrap();
            let other = Triangle::new(least, most, center).unwrap();
            let quaternion = [from(32_768); 4];
            let turned = Obb::from_quaternion(triangle.vertices()[1], quaternion, half).unwrap();
            let motion = Motion::new([S::ZERO; 3], direction).unwrap();
            let sphere = Sphere::new(center, radius).unwrap();
            let capsule = Capsule::new(origin, center, radius).unwrap();
            let (mut found, mut first, mut met, mut closest) = (99, None, None, None);
            let ball = Sphere::new(center, from(16_384)).unwrap();
            let (mut hit, mut swept, mut range, mut all) = (None, None, None, None);
            let answer = match query {
                0 => triangle.overlaps(&aabb),
                1 => triangle.overlaps(&obb),
                2 => ray.overlaps(&aabb),
                3 => ray.is_hit(&triangle),
                5 if round % 4 == 0 => tree.contains(vertices[round / 4 % 16]),
                5 => {
                    let Vec3 { x, y, z } = triangle.vertices()[0];
                    tree.contains([x, y, if round % 4 == 1 { S::ZERO } else { z }])
                }
                4 => {
                    hit = ray.hit(&triangle);
                    hit.is_some()
                }
                6 => triangle.overlaps(&other),
                7 => built.first_hit(&ray).is_some_and(|(i, there)| {
                    (found, hit) = (i as u32, Some(there));
                    true
                }),
                8 => built.is_hit(&ray),
                9 => built.overlapping(&aabb).next().is_some_and(|i| {
                    found = i as u32;
                    true
                }),
                10 => built.first_contact(&aabb, &motion).is_some_and(|(i, there)| {
                    (found, first) = (i as u32, Some(there));
                    true
                }),
                11 => {
                    first = aabb.first_contact(&motion, &triangle);
                    first.is_some()
                }
                12 => {
                    met = contact(&triangle, &aabb);
                    met.is_some()
                }
                13 => {
                    met = contact(&obb, &turned);
                    met.is_some()
                }
                14 => sphere.overlaps(&triangle),
                15 => sphere.overlaps(&aabb),
                16 => capsule.overlaps(&triangle),
                17 => capsule.overlaps(&aabb),
                18 => {
                    closest = triangle.closest_point(center).ok();
                    true
                }
                19 => built.closest_point(origin).is_some_and(|(i, there)| {
                    (found, closest) = (i as u32, Some(there));
                    true
                }),
                20 => built.overlapping(&sphere).next().is_some_and(|i| {
                    found = i as u32;
                    true
                }),
                21..=24 => {
                    met = match query {
                        21 => contact(&sphere, &triangle),
                        22 => contact(&sphere, &aabb),
                        23 => contact(&capsule, &triangle),
                        _ => contact(&capsule, &aabb),
                    };
                    met.is_some()
                }
                25 => {
                    range = ray.t_range_sphere(&sphere);
                    range.is_some()
                }
                26 => ball.first_contact(&motion, &triangle).is_some_and(|first| {
                    swept = Some((first.t, first.part.map_or(255, of_triangle)));
                    true
                }),
                27 => ball.first_contact(&motion, &aabb).is_some_and(|first| {
                    swept = Some((first.t, first.part.map_or(255, of_box)));
                    true
                }),
                28 => built.first_contact(&ball, &motion).is_some_and(|(i, first)| {
                    found = i as u32;
                    swept = Some((first.t, first.part.map_or(255, of_triangle)));
                    true
                }),
                29 => !all.insert(contacts(&built, &sphere, &interior)).is_empty(),
                _ => !all.insert(contacts(&built, &capsule, &interior)).is_empty(),
            };
            yes += u32::from(answer);
            let numbers = hit.map_or([0; 4], |hit| words(&hit, bits));
            hash = numbers.iter().fold(add(hash, u32::from(answer)), |hash, &word| add(hash, word));
            if query < 7 {
                continue;
            }
            hash = add(add(hash, found), bits(first.map_or(S::ZERO, |first| first.t)));
            hash = add(hash, first.and_then(|first| first.axis).map_or(0, number));
            let at = closest.map_or([S::ZERO; 3], |closest| closest.point.to_array());
            let at = if query > 17 { &at[..] } else { &[] };
            hash = at.iter().fold(hash, |hash, &x| add(hash, bits(x)));
            hash = add(hash, closest.map_or(0, |closest| self::feature(closest.feature)));
            hash = met.iter().fold(hash, |hash, contact| add_contact(hash, contact, bits));
            if query > 24 {
                let (enter, leave) = range.unwrap_or((S::ZERO, S::ZERO));
                let (t, part) = swept.unwrap_or((S::ZERO, 0));
                let many = all.as_ref().map_or(4, Vec::len) as u32;
                let words = [bits(enter), bits(leave), bits(t), part, many];
                hash = words.iter().fold(hash, |hash, &word| add(hash, word));
            }
            for (i, contact) in all.iter().flatten().take(4) {
                hash = add_contact(add(hash, *i as u32), contact, bits);
                hash = add(hash, contact.is_held.into());
            }
        }
        println!("{name} {called} yes: {yes}, hash {hash:x}");
    }
}

type InMesh<S> = Vec<(usize, Contact<S>)>;

fn contacts<S: Scalar, P: Probe<S>>(
    tree: &Tree<'_, S, u16>,
    shape: &P,
    interior: &[InteriorEdges],
) -> InMesh<S>
where
    Triangle<S>: ContactWith<S, P>,
{
    tree.contacts(shape, interior).unwrap().collect()
}

fn add_contact<S: Scalar>(hash: u32, contact: &Contact<S>, bits: fn(S) -> u32) -> u32 {
    let Translation { depth, vector, .. } = contact.translation;
    let numbers = [depth, vector.x, vector.y, vector.z];
    let hash = numbers.iter().fold(hash, |hash, &x| add(hash, bits(x)));
    contact.points().iter().fold(hash, |hash, point| {
        let [first, second] = point.parts.map(part);
        add(add(hash, bits(point.depth)), first << 8 | second)
    })
}

fn of_triangle(feature: Feature) -> u32 {
    part(match feature {
        Feature::Interior => Part::Face(0),
        Feature::Edge(k) => Part::Edge(k),
        Feature::Vertex(k) => Part::Vertex(k),
    })
}

/// By the table of `Part`: of each axis, the sides on it and on the two after it.
fn of_box(sides: [i8; 3]) -> u32 {
    let up = sides.map(|side| u8::from(side == 1));
    let flat: Vec<u8> = (0..3).filter(|&i| sides[usize::from(i)] == 0).collect();
    let after = |i: u8, k: u8| up[usize::from((i + k) % 3)];
    part(match flat[..] {
        [] => Part::Vertex(up[0] + 2 * up[1] + 4 * up[2]),
        [i] => Part::Edge(4 * i + after(i, 1) + 2 * after(i, 2)),
        [i, k] => {
            let axis = 3 - i - k;
            Part::Face(2 * axis + up[usize::from(axis)])
        }
        _ => panic!("no side"),
    })
}

fn number(axis: Axis) -> u32 {
    match axis {
        Axis::Face(k) => 1 + u32::from(k),
        Axis::Normal => 4,
        Axis::Edge { axis, edge } => 5 + 3 * u32::from(axis) + u32::from(edge),
    }
}

fn part(part: Part) -> u32 {
    match part {
        Part::Face(k) => u32::from(k),
        Part::Edge(k) => 16 + u32::from(k),
        Part::Vertex(k) => 32 + u32::from(k),
    }
}

fn feature(feature: Feature) -> u32 {
    match feature {
        Feature::Interior => 0,
        Feature::Edge(k) => 1 + u32::from(k),
        Feature::Vertex(k) => 4 + u32::from(k),
    }
}

fn words<S: Copy>(hit: &Hit<S>, bits: fn(S) -> u32) -> [u32; 4] {
    let front = u32::from(hit.facing == Facing::Front);
    [bits(hit.t), bits(hit.u), bits(hit.v), front << 8 | feature(hit.feature)]
}

fn main() {
    if std::env::args().nth(1).is_some_and(|what| what == "mesh") {
        return print_mesh();
    }
    check("i8f8", |x| I8F8::from_bits((x / 256) as i16), |x| i32::from(x.to_bits()) as u32);
    check("i16f16", I16F16::from_bits, |x| x.to_bits() as u32);
    check("f32", |x| x as f32 / 65_536.0, f32::to_bits);
    let halves =
        |x: f64| ((x.to_bits() >> 32) as u32).wrapping_mul(31).wrapping_add(x.to_bits() as u32);
    check("f64", |x| f64::from(x) / 65_536.0, halves);
    println!("errors are told");
}
