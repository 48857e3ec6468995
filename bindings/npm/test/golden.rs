//! Prints what test/golden.txt holds: answers of the crate about a stream of cases, a hash for each
//! question. test/golden.test.mjs asks the package the same. Coordinates are coarse, so that many
//! rays go through vertices and many boxes touch.

use std::fs;
use std::ops::ControlFlow;

use septum::contact::{ContactWith, Features, InteriorEdges, Part, contact, interior_edges};
use septum::mesh::{MeshError, OwnedTree, Probe};
use septum::sweep::Motion;
use septum::voxel::{Bits, Grid, Rule, Solid};
use septum::{Aabb, Capsule, Facing, Feature, Hit, Obb, Overlaps, Ray, Sphere, Triangle, Vec3};

const ROUNDS: usize = 500;

/// xorshift (G. Marsaglia, 2003).
struct Stream(u32);

impl Stream {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() >> 8) as usize % n
    }

    /// From -8 to 8, in eighths.
    fn coarse(&mut self) -> [f32; 3] {
        [(); 3].map(|()| (self.below(129) as f32 - 64.0) / 8.0)
    }

    /// From -2 to 2: eighths, or thirds of 65,536ths.
    fn fine(&mut self) -> [f64; 3] {
        let is_coarse = self.below(2) == 0;
        [(); 3].map(|()| {
            let x = (self.next() >> 14) as i32 - 131_072;
            if is_coarse { f64::from(x >> 13) / 8.0 } else { f64::from(x) / 3.0 / 32_768.0 }
        })
    }
}

/// FNV-1a, of 32 bits.
struct Hash {
    hash: u32,
    yes: u32,
}

impl Hash {
    const NEW: Self = Self { hash: 2_166_136_261, yes: 0 };

    fn add(&mut self, word: u32) {
        for byte in word.to_le_bytes() {
            self.hash = (self.hash ^ u32::from(byte)).wrapping_mul(16_777_619);
        }
    }

    fn add_f64(&mut self, x: f64) {
        // Both zeros are one.
        let bits = (x + 0.0).to_bits();
        self.add(bits as u32);
        self.add((bits >> 32) as u32);
    }

    fn add_f32(&mut self, x: f32) {
        self.add((x + 0.0).to_bits());
    }

    fn add_hit(&mut self, triangle: usize, hit: &Hit<f32>) {
        self.add(triangle as u32);
        for x in [hit.t, hit.u, hit.v] {
            self.add(x.to_bits());
        }
        self.add(u32::from(hit.facing == Facing::Front));
    }

    fn print(&self, what: &str) {
        println!("{what}: {} yes, {:08x}", self.yes, self.hash);
    }
}

type Parts = (Vec<[f32; 3]>, Vec<[u32; 3]>);

fn teapot() -> Parts {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/assets/teapot.obj");
    for line in fs::read_to_string(path).unwrap().lines() {
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            ["v", x, y, z] => vertices.push([x, y, z].map(|x| x.parse().unwrap())),
            ["f", a, b, c] => triangles.push([a, b, c].map(|i| i.parse::<u32>().unwrap() - 1)),
            _ => {}
        }
    }
    (vertices, triangles)
}

/// A closed mesh, which crosses itself: a torus of 16 by 16 vertices at random places.
fn torus() -> Parts {
    let mut stream = Stream(7);
    let vertices = (0..256).map(|_| stream.coarse()).collect();
    let at = |i: u32, j: u32| 16 * (i % 16) + j % 16;
    let triangles = (0..16).flat_map(|i| (0..16).map(move |j| (i, j))).flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    (vertices, triangles.collect())
}

/// A ray: a third of them through a vertex.
fn ray(stream: &mut Stream, vertices: &[[f32; 3]]) -> Option<Ray<f32>> {
    let (origin, mut direction) = (stream.coarse(), stream.coarse());
    let vertex = vertices[stream.below(vertices.len())];
    if stream.below(3) == 0 {
        direction = core::array::from_fn(|i| vertex[i] - origin[i]);
    }
    Ray::new(origin, direction).ok()
}

fn a_box(stream: &mut Stream) -> Aabb<f32> {
    Aabb::from_points([stream.coarse(), stream.coarse()].map(Vec3::from)).unwrap()
}

fn meshes(name: &str, (vertices, triangles): Parts) {
    let owned = OwnedTree::new(vertices.clone(), triangles.clone()).unwrap();
    let (tree, mesh) = (owned.as_tree(), owned.mesh());
    let ask = |what: &str, ask: &dyn Fn(&mut Stream, &mut Hash) -> bool| {
        let (mut stream, mut hash) = (Stream(1), Hash::NEW);
        for _ in 0..ROUNDS {
            let yes = ask(&mut stream, &mut hash);
            hash.yes += u32::from(yes);
            hash.add(yes.into());
        }
        hash.print(&format!("{name} {what}"));
    };
    ask("raycast", &|stream, hash| {
        let hit = ray(stream, &vertices).and_then(|ray| tree.first_hit(&ray));
        if let Some((i, hit)) = hit {
            hash.add_hit(i, &hit);
        }
        hit.is_some()
    });
    ask("raycastAny", &|stream, _| {
        ray(stream, &vertices).is_some_and(|ray| tree.is_hit(&ray.with_range(0.25, 0.75).unwrap()))
    });
    ask("raycastAll", &|stream, hash| {
        let Some(ray) = ray(stream, &vertices) else { return false };
        let mut hits: Vec<_> = tree.hits(&ray).collect();
        hits.sort_by(|(i, a), (k, b)| a.t.partial_cmp(&b.t).unwrap().then(i.cmp(k)));
        hits.iter().for_each(|(i, hit)| hash.add_hit(*i, hit));
        !hits.is_empty()
    });
    ask("locate", &|stream, hash| {
        let vertex = vertices[stream.below(vertices.len())];
        let point = stream.coarse();
        let is_vertex = stream.below(8) == 0;
        let winding = tree.winding(if is_vertex { vertex } else { point });
        hash.add(winding.map_or(2, |winding| u32::from(winding % 2 != 0)));
        winding.is_none_or(|winding| winding % 2 != 0)
    });
    ask("trianglesInBox", &|stream, hash| {
        let aabb = a_box(stream);
        let mut found: Vec<_> = tree.overlapping(&aabb).collect();
        found.sort_unstable();
        found.iter().for_each(|&i| hash.add(i as u32));
        !found.is_empty()
    });
    ask("trianglesInSphere", &|stream, hash| {
        let sphere = Sphere::new(stream.coarse(), stream.below(65) as f32 / 16.0).unwrap();
        let mut found: Vec<_> = tree.overlapping(&sphere).collect();
        found.sort_unstable();
        found.iter().for_each(|&i| hash.add(i as u32));
        !found.is_empty()
    });
    ask("boxCast", &|stream, hash| {
        let (aabb, motion) = (a_box(stream), stream.coarse());
        let first = tree.first_contact(&aabb, &Motion::new([0.0; 3], motion).unwrap());
        if let Some((i, first)) = first {
            hash.add(i as u32);
            hash.add(first.t.to_bits());
        }
        first.is_some()
    });
    ask("closestPoint", &|stream, hash| {
        let (point, within) = (stream.coarse(), stream.below(65) as f32 / 16.0);
        let found = if within == 0.0 {
            tree.closest_point(point)
        } else {
            tree.closest_point_within(point, within)
        };
        if let Some((i, closest)) = found {
            hash.add(i as u32);
            closest.point.to_array().into_iter().for_each(|x| hash.add_f32(x));
            hash.add(part(of_triangle(closest.feature)));
        }
        found.is_some()
    });
    ask("sphereCast", &|stream, hash| {
        let sphere = Sphere::new(stream.coarse(), stream.below(65) as f32 / 64.0).unwrap();
        let motion = Motion::new([0.0; 3], stream.coarse()).unwrap();
        let first = tree.first_contact(&sphere, &motion);
        if let Some((i, first)) = first {
            hash.add(i as u32);
            hash.add_f32(first.t);
            hash.add(first.part.map_or(u32::MAX, |feature| part(of_triangle(feature))));
        }
        first.is_some()
    });
    let mut interior = vec![InteriorEdges::NONE; triangles.len()];
    interior_edges(&mesh, &mut vec![(0, 0); 3 * triangles.len()], &mut interior).unwrap();
    ask("sphereContacts", &|stream, hash| {
        let sphere = Sphere::new(stream.coarse(), stream.below(65) as f32 / 16.0).unwrap();
        contacts(&owned, &sphere, &interior, hash)
    });
    ask("capsuleContacts", &|stream, hash| {
        let ends = [stream.coarse(), stream.coarse()];
        let radius = stream.below(65) as f32 / 64.0;
        contacts(&owned, &Capsule::new(ends[0], ends[1], radius).unwrap(), &interior, hash)
    });
    let mut hash = Hash::NEW;
    for resolution in [1, 7, 33, 64] {
        let grid = Grid::around(&mesh.aabb().unwrap(), resolution, 1).unwrap();
        let mut words = vec![0_u32; grid.words::<u32>()];
        let mut lines = vec![0_u32; grid.line_words::<u32>()];
        for is_solid in [false, true] {
            words.fill(0);
            if is_solid {
                let mut solid = Solid::new(&grid, &mut words, &mut lines).unwrap();
                mesh.iter().for_each(|triangle| solid.cross(&triangle));
                solid.finish();
                hash.add(solid.open_rows().count() as u32);
            }
            let mut bits = Bits::new(&grid, &mut words).unwrap();
            mesh.iter().for_each(|triangle| bits.fill(&triangle, Rule::Closed));
            hash.yes += bits.count() as u32;
            words.iter().for_each(|&word| hash.add(word));
        }
    }
    hash.print(&format!("{name} voxelize"));
    let moved = vertices.iter().map(|v| v.map(|x| x + 0.125));
    let other = OwnedTree::new(moved.collect::<Vec<_>>(), triangles.clone()).unwrap();
    let (mut hash, mut pairs) = (Hash::NEW, Vec::new());
    let _ = tree.overlapping_pairs(&other.as_tree(), |i, k| {
        pairs.push([i as u32, k as u32]);
        ControlFlow::<()>::Continue(())
    });
    hash.yes = pairs.len() as u32;
    pairs.as_flattened().iter().for_each(|&i| hash.add(i));
    hash.print(&format!("{name} overlappingPairs"));
    let open = match mesh.check_closed(&mut vec![[0; 2]; 3 * triangles.len()]) {
        Err(MeshError::OpenEdge { vertices }) => format!("{vertices:?}"),
        closed => format!("{closed:?}"),
    };
    println!("{name} openEdge: {open}");
}

/// The package's contacts move the shape, and these the triangle.
fn contacts<P: Probe<f32>>(
    owned: &OwnedTree<f32>,
    shape: &P,
    interior: &[InteriorEdges],
    hash: &mut Hash,
) -> bool
where
    Triangle<f32>: ContactWith<f32, P>,
{
    let mut all: Vec<_> = owned.as_tree().contacts(shape, interior).unwrap().collect();
    all.sort_by_key(|(i, _)| *i);
    for (i, contact) in &all {
        let (t, [point]) = (contact.translation, contact.points()) else { panic!("one point") };
        hash.add(*i as u32);
        t.vector.to_array().into_iter().for_each(|x| hash.add_f32(-x));
        hash.add_f32(t.depth);
        t.normal.to_array().into_iter().for_each(|x| hash.add_f32(-x));
        point.on_first.to_array().into_iter().for_each(|x| hash.add_f32(x));
        hash.add(2 * u32::from(contact.is_held) + u32::from(t.is_sufficient));
        hash.add(part(point.parts[0]));
    }
    !all.is_empty()
}

fn of_triangle(feature: Feature) -> Part {
    match feature {
        Feature::Interior => Part::Face(0),
        Feature::Edge(k) => Part::Edge(k),
        Feature::Vertex(k) => Part::Vertex(k),
    }
}

#[derive(Clone, Copy)]
enum Any {
    Triangle(Triangle<f64>),
    Aabb(Aabb<f64>),
    Obb(Obb<f64>),
    Sphere(Sphere<f64>),
    Capsule(Capsule<f64>),
}

const TURNS: [[f64; 4]; 4] =
    [[0.0, 0.0, 0.6, 0.8], [0.5; 4], [0.1, 0.7, -0.1, 0.7], [0.0, 0.0, 0.0, 1.0]];

fn any(stream: &mut Stream, kind: usize) -> Any {
    let [a, b, c] = [stream.fine(), stream.fine(), stream.fine()];
    let turn = TURNS[stream.below(4)];
    match kind {
        0 => Any::Triangle(Triangle::new(a, b, c).unwrap()),
        1 => Any::Aabb(Aabb::from_points([a, b].map(Vec3::from)).unwrap()),
        2 => Any::Obb(Obb::from_quaternion(a, turn, b.map(f64::abs)).unwrap()),
        3 => Any::Sphere(Sphere::new(a, b[0].abs()).unwrap()),
        _ => Any::Capsule(Capsule::new(a, b, c[0].abs()).unwrap()),
    }
}

fn part(part: Part) -> u32 {
    match part {
        Part::Face(k) => u32::from(k),
        Part::Edge(k) => 16 + u32::from(k),
        Part::Vertex(k) => 32 + u32::from(k),
    }
}

fn add_contact<A: ContactWith<f64, B>, B>(a: &A, b: &B, hash: &mut Hash) {
    let Some(contact) = contact(a, b) else { return };
    let translation = contact.translation;
    translation.vector.to_array().into_iter().for_each(|x| hash.add_f64(x));
    hash.add_f64(translation.depth);
    translation.normal.to_array().into_iter().for_each(|x| hash.add_f64(x));
    let features = match translation.features {
        Features::First(k) => [0, k.into(), 0],
        Features::Second(k) => [1, k.into(), 0],
        Features::Edges(i, k) => [2, i.into(), k.into()],
        Features::Nearest(i, k) => [3, part(i), part(k)],
    };
    features.into_iter().for_each(|k| hash.add(k));
    for point in contact.points() {
        point.on_first.to_array().into_iter().for_each(|x| hash.add_f64(x));
        point.on_second.to_array().into_iter().for_each(|x| hash.add_f64(x));
        hash.add_f64(point.depth);
        point.parts.into_iter().for_each(|k| hash.add(part(k)));
    }
}

fn about<A: Overlaps<B> + ContactWith<f64, B>, B>(a: &A, b: &B, hash: &mut Hash) -> bool {
    add_contact(a, b, hash);
    a.overlaps(b)
}

/// The answer of a pair that the package has.
fn ask(first: &Any, second: &Any, hash: &mut Hash) -> bool {
    macro_rules! each {
        ($($a:ident $b:ident),*) => {
            match (first, second) {
                $((Any::$a(a), Any::$b(b)) => about(a, b, hash),)*
                _ => unreachable!("not in the package"),
            }
        };
    }
    each!(
        Triangle Triangle, Triangle Aabb, Triangle Obb, Aabb Triangle, Aabb Aabb, Aabb Obb,
        Obb Triangle, Obb Aabb, Obb Obb, Sphere Triangle, Sphere Aabb, Capsule Triangle,
        Capsule Aabb, Triangle Sphere, Aabb Sphere, Triangle Capsule, Aabb Capsule
    )
}

fn pairs() {
    let names = ["triangle", "box", "oriented box", "sphere", "capsule"];
    for (i, k) in (0..25).map(|k| (k / 5, k % 5)) {
        if i > 2 && k > 1 || i > 1 && k > 2 {
            continue;
        }
        let (mut stream, mut hash) = (Stream(1), Hash::NEW);
        for _ in 0..ROUNDS {
            let (first, second) = (any(&mut stream, i), any(&mut stream, k));
            let yes = ask(&first, &second, &mut hash);
            hash.yes += u32::from(yes);
            hash.add(yes.into());
        }
        hash.print(&format!("{}, {}", names[i], names[k]));
    }
    for kind in [1, 2, 3] {
        let (mut stream, mut hash) = (Stream(1), Hash::NEW);
        for _ in 0..ROUNDS {
            let (origin, direction) = (stream.fine(), stream.fine());
            let ray = Ray::new(origin, direction);
            let range = match (ray, any(&mut stream, kind)) {
                (Err(_), _) => None,
                (Ok(ray), Any::Aabb(aabb)) => ray.t_range(&aabb),
                (Ok(ray), Any::Obb(obb)) => ray.t_range_obb(&obb),
                (Ok(ray), Any::Sphere(sphere)) => ray.t_range_sphere(&sphere),
                (_, Any::Triangle(_) | Any::Capsule(_)) => None,
            };
            hash.yes += u32::from(range.is_some());
            if let Some((enters, leaves)) = range {
                hash.add_f64(enters);
                hash.add_f64(leaves);
            }
        }
        hash.print(&format!("ray, {}", names[kind]));
    }
}

fn main() {
    meshes("teapot", teapot());
    meshes("torus", torus());
    pairs();
}
