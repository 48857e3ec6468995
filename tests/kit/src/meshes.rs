//! Meshes of a few triangles, with rays and with boxes that move. The answer of a tree is compared
//! with the answers of the oracles for each triangle.

use std::cmp::Ordering;

use septum::mesh::{Mesh, Node, Tree};
use septum::sweep::FirstContact;
use septum::{Ray, Vec3};

use crate::case::{BoxNumbers, Case};
use crate::rays::{Fraction, RayCase, crossing};
use crate::sample::Sample;
use crate::sweeps::SweepCase;
use crate::{Each, rng::Rng, sorted_by_number, three};

type Point<S> = [S; 3];

/// Vertices, and triangles between them.
#[derive(Clone, Debug)]
pub struct Faces<S> {
    pub vertices: Vec<Point<S>>,
    pub faces: Vec<[u16; 3]>,
}

/// A ray and a mesh.
#[derive(Clone, Debug)]
pub struct MeshRay<S> {
    pub mesh: Faces<S>,
    pub origin: Point<S>,
    pub direction: Point<S>,
    pub range: [Option<S>; 2],
}

/// A box that moves past a mesh.
#[derive(Clone, Debug)]
pub struct MeshSweep<S> {
    pub mesh: Faces<S>,
    pub aabb: BoxNumbers<S>,
    pub way: [Point<S>; 2],
}

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshSet {
    /// Some or all t overflow: they are infinite, or the end of fixed point.
    Beyond,
    /// Many t round to one number, such as zero.
    Near,
    /// Whole numbers: many triangles are hit in one point.
    Grid,
}

impl<S: Sample> Faces<S> {
    fn triangle(&self, face: usize) -> [Point<S>; 3] {
        self.faces[face].each(|v| self.vertices[usize::from(v)])
    }

    /// Lends the mesh with a tree.
    fn with_tree<T>(&self, ask: impl FnOnce(&Tree<'_, S, u16>) -> T) -> T {
        let vertices: Vec<Vec3<S>> = self.vertices.iter().map(|&v| v.into()).collect();
        let mut nodes = vec![Node::EMPTY; Node::count_for(self.faces.len())];
        let mut order = vec![0; self.faces.len()];
        let mesh = Mesh::new(&vertices, &self.faces).expect("a mesh");
        ask(&Tree::build(mesh, &mut nodes, &mut order).expect("room"))
    }
}

impl<S: Sample> MeshRay<S> {
    fn case(&self, face: usize) -> RayCase<S> {
        let [t_min, t_max] = self.range;
        let vertices = self.mesh.triangle(face);
        RayCase { origin: self.origin, direction: self.direction, vertices, t_min, t_max }
    }

    /// Whether there is such a ray.
    pub fn is_valid(&self) -> bool {
        self.case(0).is_valid()
    }

    /// The triangles that the ray hits, each with its t, sorted by t and then by index.
    pub fn truth(&self) -> Vec<(usize, Fraction)> {
        let faces = 0..self.mesh.faces.len();
        let hit = |face| Some((face, crossing(&self.case(face))?.t));
        let mut hits: Vec<_> = faces.filter_map(hit).collect();
        in_order(&mut hits);
        hits
    }

    /// Checks the answers of a tree, and how the hits compare. Returns the number of hits, and the
    /// number of pairs of hits whose t differ but round to one number.
    ///
    /// # Panics
    /// Where an answer is wrong.
    pub fn check(&self) -> [usize; 2] {
        let truth = self.truth();
        let ray: Ray<S> = self.case(0).ray();
        let of = |face: usize| self.case(face).triangle();
        let told = || format!("{} {self:?}", S::name());
        let mut alike = 0;
        for (k, (a, t)) in truth.iter().enumerate() {
            for (b, s) in &truth[..k] {
                let (p, q) = (of(*a), of(*b));
                let expected = t.compare_with(s);
                assert_eq!(ray.compare_hits(&p, &q), Some(expected), "{a} {b}: {}", told());
                assert_eq!(ray.compare_hits(&q, &p), Some(expected.reverse()), "{}", told());
                if expected != Ordering::Equal
                    && ray.hit(&p).map(|h| h.t) == ray.hit(&q).map(|h| h.t)
                {
                    alike += 1;
                }
            }
        }
        self.mesh.with_tree(|tree| {
            let with_hit = |face: usize| (face, ray.hit(&of(face)).expect("it is hit"));
            let first = truth.first().map(|&(face, _)| with_hit(face));
            assert_eq!(tree.first_hit(&ray), first, "{}", told());
            let found = sorted_by_number(tree.hits(&ray), |hit| hit.0);
            let expected = truth.iter().map(|&(face, _)| with_hit(face));
            assert_eq!(found, sorted_by_number(expected, |hit| hit.0), "{}", told());
            assert_eq!(tree.is_hit(&ray), !truth.is_empty(), "{}", told());
        });
        [truth.len(), alike]
    }
}

/// By t and then by index.
fn in_order(hits: &mut [(usize, Fraction)]) {
    hits.sort_by(|a, b| a.1.compare_with(&b.1));
}

impl<S: Sample> MeshSweep<S> {
    /// Checks the first contact that a tree finds, and returns it.
    ///
    /// # Panics
    /// Where an answer is wrong.
    pub fn check(&self) -> Option<(usize, FirstContact<S>)> {
        let [from, to] = self.way;
        let mut sweep = None;
        let mut first: Option<(usize, FirstContact<S>)> = None;
        for face in 0..self.mesh.faces.len() {
            let case = Case { vertices: self.mesh.triangle(face), aabb: self.aabb };
            // A box that moves one way is a triangle that moves the other way.
            let one = sweep.insert(SweepCase { case, way: [to, from] });
            if let Some(found) = one.check() {
                if first.is_none_or(|(_, first)| found.t < first.t) {
                    first = Some((face, found));
                }
            }
        }
        let motion = sweep?.motion().reversed();
        let aabb = self.aabb.shape().expect("a box");
        let found = self.mesh.with_tree(|tree| tree.first_contact(&aabb, &motion));
        assert_eq!(found, first, "{} {self:?}", S::name());
        first
    }
}

impl MeshSet {
    pub const ALL: [Self; 3] = [Self::Beyond, Self::Near, Self::Grid];

    /// Roughly the greatest coordinate.
    fn size<S: Sample>(self) -> f64 {
        match self {
            Self::Beyond => S::GREATEST.approximate() / 4.0,
            Self::Near => S::ZERO.moved(9).approximate(),
            Self::Grid => S::GREATEST.approximate().min(4.0),
        }
    }

    fn number<S: Sample>(self, rng: &mut Rng) -> S {
        let size = self.size::<S>();
        match self {
            Self::Beyond => {
                S::nearest(size * rng.whole(-4, 4) as f64 / 4.0).moved(rng.whole(-9, 9))
            }
            Self::Near => S::from_ordinal(rng.whole(-9, 9)),
            Self::Grid => S::nearest(size * rng.whole(-3, 3) as f64 / 4.0),
        }
    }

    /// A few triangles between few vertices, so that a line hits many of them.
    fn faces<S: Sample>(self, rng: &mut Rng) -> Faces<S> {
        let vertices: Vec<_> =
            (0..rng.whole(3, 8)).map(|_| rng.triple(|rng| self.number(rng))).collect();
        let count = if rng.one_in(16) { rng.whole(13, 30) } else { rng.whole(2, 9) };
        let vertex = |rng: &mut Rng| rng.below(vertices.len()) as u16;
        let faces = (0..count).map(|_| rng.triple(vertex)).collect();
        Faces { vertices, faces }
    }

    /// A ray or a line through a triangle, along an axis or nearly so.
    pub fn ray<S: Sample>(self, rng: &mut Rng) -> MeshRay<S> {
        loop {
            let mesh = self.faces::<S>(rng);
            let [a, b, c] = mesh.triangle(rng.below(mesh.faces.len()));
            let (u, v) = (rng.real(0.0, 0.5), rng.real(0.0, 0.5));
            let mut origin = three(|i: usize| {
                let [a, b, c] = [a, b, c].each(|p| p[i].approximate());
                S::nearest((1.0 - u - v) * a + u * b + v * c)
            });
            let (axis, sign) = (rng.below(3), [-1.0, 1.0][rng.below(2)]);
            let size = self.size::<S>();
            origin[axis] = S::nearest(sign * size * [0.5, 1.0, 1.5, 3.5][rng.below(4)]);
            let length = match self {
                Self::Beyond => 2_f64.powi(-(rng.whole(1, 9) as i32)),
                Self::Near => S::GREATEST.approximate() * rng.real(0.0, 1.0),
                Self::Grid => size * rng.whole(1, 4) as f64 / 4.0,
            };
            let mut direction = [S::ZERO; 3];
            direction[axis] = S::nearest(length * if rng.one_in(2) { sign } else { -sign });
            if rng.one_in(3) {
                direction[(axis + 1) % 3] = S::nearest(length * rng.real(-0.25, 0.25));
            }
            let range = if rng.one_in(3) { [Some(S::ZERO), None] } else { [None, None] };
            let case = MeshRay { mesh, origin, direction, range };
            if case.is_valid() {
                return case;
            }
        }
    }

    /// A box and a way of the size of the mesh.
    pub fn sweep<S: Sample>(self, rng: &mut Rng) -> MeshSweep<S> {
        let mesh = self.faces::<S>(rng);
        let mut point = || rng.triple(|rng| self.number::<S>(rng));
        let (center, from, mut to) = (point(), point(), point());
        let half = rng.triple(|rng| S::nearest(self.size::<S>() * rng.whole(0, 4) as f64 / 16.0));
        let axis = rng.below(3);
        if rng.one_in(2) {
            to[axis] = from[axis];
        }
        MeshSweep { mesh, aabb: BoxNumbers::Center(center, half), way: [from, to] }
    }
}
