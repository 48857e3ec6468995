//! Meshes for the tests.

use septum::Vec3;
use septum::mesh::{Mesh, Node, Tree};
use septum_kit::{Each, Rng, Sample, rays, three};

use crate::examples::teapot;

/// Vertices and faces, and memory for a tree.
pub(super) struct Scene<S> {
    pub(super) name: &'static str,
    pub(super) vertices: Vec<Vec3<S>>,
    pub(super) faces: Vec<[u16; 3]>,
    nodes: Vec<Node>,
    order: Vec<u16>,
    /// Its approximate position and size.
    pub(super) middle: [f64; 3],
    pub(super) size: f64,
}

impl<S: Sample> Scene<S> {
    pub(super) fn new(name: &'static str, vertices: &[[f64; 3]], faces: Vec<[u16; 3]>) -> Self {
        let ends = |i: usize| {
            let all = || vertices.iter().map(|v| v[i]);
            (all().fold(f64::MAX, f64::min), all().fold(f64::MIN, f64::max))
        };
        let (mut middle, mut size) = ([0.0; 3], 0.0_f64);
        if !vertices.is_empty() {
            let ends = three(ends);
            middle = ends.each(|(low, high)| low / 2.0 + high / 2.0);
            size = ends.iter().map(|(low, high)| high / 2.0 - low / 2.0).fold(0.0, f64::max);
        }
        Self {
            name,
            vertices: vertices.iter().map(|v| v.each(S::nearest).into()).collect(),
            nodes: vec![Node::EMPTY; Node::count_for(faces.len())],
            order: vec![0; faces.len()],
            faces,
            middle,
            size,
        }
    }

    pub(super) fn mesh(&self) -> Mesh<'_, S, u16> {
        Mesh::new(&self.vertices, &self.faces).expect("a mesh")
    }

    /// The mesh with its tree.
    pub(super) fn tree(&mut self) -> Tree<'_, S, u16> {
        let Self { vertices, faces, nodes, order, .. } = self;
        Tree::build(Mesh::new(vertices, faces).expect("a mesh"), nodes, order).expect("room")
    }

    /// A point near the mesh: a vertex, the midpoint of an edge or of a face as nearly as the type
    /// allows, or a random point, seldom far away.
    pub(super) fn point(&self, rng: &mut Rng) -> [S; 3] {
        let at = |v: u16| self.vertices[usize::from(v)].to_array().each(S::approximate);
        let mean = |points: &[[f64; 3]]| {
            three(|i| points.iter().map(|p| p[i] / points.len() as f64).sum::<f64>())
        };
        let kind = if self.faces.is_empty() { 5 } else { rng.below(8) };
        if kind < 4 {
            let face = self.faces[rng.below(self.faces.len())].each(at);
            return match kind {
                0 => face[0],
                1 => mean(&face[..2]),
                2 => mean(&face),
                // A vertex's coordinate on a single axis.
                _ => {
                    let mut p = self.anywhere(rng, 1.0);
                    let i = rng.below(3);
                    p[i] = face[0][i];
                    p
                }
            }
            .each(S::nearest);
        }
        let reach = if kind == 7 { 40.0 } else { 1.2 };
        self.anywhere(rng, reach).each(S::nearest)
    }

    fn anywhere(&self, rng: &mut Rng, reach: f64) -> [f64; 3] {
        three(|i| self.middle[i] + self.size * reach * rng.real(-1.0, 1.0))
    }
}

/// Scenes whose vertices the type can represent: the [`closed`] meshes, and open ones.
pub(super) fn all<S: Sample>() -> Vec<Scene<S>> {
    let mut scenes = closed::<S>();
    let mut rng = Rng::new(91);
    let unit = if S::WHOLE_BITS < 15 { 0.5 } else { 8.0 };
    let mut soup = |name, n: usize, vertex: &mut dyn FnMut(&mut Rng, usize) -> [f64; 3]| {
        let vertices: Vec<_> = (0..3 * n).map(|k| vertex(&mut rng, k)).collect();
        let faces = (0..n as u16).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        scenes.push(Scene::new(name, &vertices, faces));
    };
    soup("nothing", 0, &mut |_, _| [0.0; 3]);
    soup("one", 1, &mut |rng, _| rng.triple(|rng| rng.real(-unit, unit)));
    soup("five", 5, &mut |rng, _| rng.triple(|rng| rng.real(-unit, unit)));
    soup("one point", 40, &mut |_, _| [unit; 3]);
    soup("anywhere", 150, &mut |rng, _| rng.triple(|rng| rng.real(-unit, unit)));
    soup("on a grid", 150, &mut |rng, _| rng.triple(|rng| rng.whole(-4, 4) as f64 * unit / 4.0));
    // Long and thin triangles, some of them segments or points.
    let mut from = [0.0; 3];
    soup("slivers", 150, &mut |rng, k| {
        if k % 3 != 1 {
            let by = if k % 3 == 0 { unit } else { unit / 512.0 };
            let base = if k % 3 == 0 { [0.0; 3] } else { from };
            let thin = rng.below(3);
            let moved = three(|i| base[i] + if i == thin { 0.0 } else { rng.real(-by, by) });
            from = moved;
            return moved;
        }
        from = rng.triple(|rng| rng.real(-unit, unit));
        from
    });
    // Flat as a floor, at the greatest and the least numbers, and small beside zero.
    soup("floor", 150, &mut |rng, _| [rng.real(-unit, unit), unit / 2.0, rng.real(-unit, unit)]);
    let (least, greatest) = (S::LEAST.approximate(), S::GREATEST.approximate());
    soup("whole range", 60, &mut |rng, _| {
        rng.triple(|rng| [least, greatest, 0.0, greatest / 2.0, 1.0][rng.below(5)])
    });
    soup("far out", 60, &mut |rng, _| {
        rng.triple(|rng| greatest * (1.0 - rng.real(0.0, 1.0) / 4096.0))
    });
    soup("tiny", 60, &mut |rng, _| {
        rng.triple(|rng| {
            rng.real(-9.0, 9.0) * 2_f64.powi(if S::WHOLE_BITS > 40 { -30 } else { -146 })
        })
    });
    // Everything else is countless steps of their grids away.
    soup("floor at zero", 60, &mut |rng, _| [rng.real(-unit, unit), 0.0, rng.real(-unit, unit)]);
    soup("residues of a turn", 60, &mut |rng, _| {
        [rng.real(-unit, unit), rng.real(-unit, unit), 6e-17 * rng.real(-1.0, 1.0)]
    });
    scenes
}

/// Closed meshes. One has parts with adjacent faces, one lies on an integer grid.
pub(super) fn closed<S: Sample>() -> Vec<Scene<S>> {
    let narrow = |faces: &[[usize; 3]]| -> Vec<[u16; 3]> {
        faces.iter().map(|face| face.each(|v| v as u16)).collect()
    };
    let octahedron = rays::Mesh::<f64>::octahedron(|p| p.each(|x| x * 32.0));
    let scale = if S::WHOLE_BITS < 15 { 1.0 / 8.0 } else { 1.0 };
    let mut scenes = vec![Scene::new(
        "octahedron",
        &octahedron.vertices.iter().map(|v| v.each(|x| x * scale)).collect::<Vec<_>>(),
        narrow(&octahedron.faces),
    )];
    if S::WHOLE_BITS >= 15 {
        let teapot: Vec<_> =
            teapot::VERTICES.iter().map(|v| v.to_array().each(f64::from)).collect();
        scenes.push(Scene::new("teapot", &teapot, teapot::FACES.to_vec()));
    }
    if S::WHOLE_BITS >= 24 {
        let far: Vec<_> =
            octahedron.vertices.iter().map(|v| three(|i| v[i] / 16.0 + 10_000.1)).collect();
        scenes.push(Scene::new("far", &far, narrow(&octahedron.faces)));
    }
    scenes
}
