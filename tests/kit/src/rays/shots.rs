//! Shots through closed meshes, and the hits that a method finds.

use septum::{Facing, Ray};

use super::{Mesh, Method};
use crate::{Each, Rng, Sample, three};

/// A mesh, and its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// A sphere of radius 8 about the origin.
    Sphere,
    /// The same about a point 10⁴ away along each axis.
    Far,
    /// The sphere times 2⁻²⁰.
    Tiny,
    /// A sphere with even integer coordinates: exact midpoints of edges.
    Whole,
    /// An octahedron with even integer coordinates; most faces are coplanar with their neighbours.
    Octahedron,
}

/// The targets of the rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    Interiors,
    /// Random points of edges; in integer coordinates, exactly their midpoints.
    Edges,
    /// Vertices; in integer coordinates, exactly.
    Vertices,
}

impl Aim {
    pub const ALL: [Self; 3] = [Self::Interiors, Self::Edges, Self::Vertices];

    pub fn name(self) -> &'static str {
        match self {
            Self::Interiors => "interiors",
            Self::Edges => "edges",
            Self::Vertices => "vertices",
        }
    }
}

/// A ray that starts inside the mesh or goes right through it.
#[derive(Clone, Copy, Debug)]
pub struct Shot<S> {
    pub origin: [S; 3],
    pub direction: [S; 3],
    pub from_outside: bool,
}

/// Hits of one ray on a mesh, by the side hit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    pub front: u32,
    pub back: u32,
}

/// The radius of a mesh in integer coordinates. Shots start within three times the radius, which
/// the scalar's range includes.
fn whole_radius<S: Sample>() -> f64 {
    if S::WHOLE_BITS < 15 { 32.0 } else { 4096.0 }
}

impl Scene {
    pub const ALL: [Self; 5] = [Self::Sphere, Self::Far, Self::Tiny, Self::Whole, Self::Octahedron];

    pub fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Far => "at 10⁴",
            Self::Tiny => "tiny",
            Self::Whole => "whole",
            Self::Octahedron => "octahedron",
        }
    }

    /// The reason why the scalar cannot hold this scene, if it cannot.
    pub fn misfit<S: Sample>(self) -> Option<&'static str> {
        match self {
            Self::Octahedron => None,
            _ if S::WHOLE_BITS < 15 => Some("too few places for so many vertices"),
            Self::Far if S::nearest(2e4).approximate() != 2e4 => Some("ends before 10⁴"),
            Self::Tiny if S::nearest(1.0 / 4096.0 / 1e6) == S::ZERO => {
                Some("too few places below 2⁻²⁰")
            }
            _ => None,
        }
    }

    fn is_whole(self) -> bool {
        matches!(self, Self::Whole | Self::Octahedron)
    }

    /// Centre and radius; integers for meshes with integer coordinates.
    fn size<S: Sample>(self) -> (f64, f64) {
        match self {
            Self::Sphere => (0.0, 8.0),
            Self::Far => (1e4, 8.0),
            Self::Tiny => (0.0, 8.0 / 1_048_576.0),
            Self::Whole | Self::Octahedron => (0.0, whole_radius::<S>()),
        }
    }

    /// The scalar's number at this place.
    fn place<S: Sample>(self, x: f64) -> S {
        let (center, radius) = self.size::<S>();
        if self.is_whole() {
            // An even integer, so that half of it is an integer too.
            return S::whole(2 * (x * radius / 2.0).round() as i64);
        }
        S::nearest(center + radius * x)
    }

    /// The mesh.
    pub fn mesh<S: Sample>(self) -> Mesh<S> {
        let place = |p: [f64; 3]| p.each(|x| self.place(x));
        if self == Self::Octahedron { Mesh::octahedron(place) } else { Mesh::sphere(place) }
    }

    /// `count` shots through the mesh, the same for the same seed: half of them from outside, and
    /// every fourth through the centre. All pass through points deep inside.
    pub fn shots<S: Sample>(
        self,
        mesh: &Mesh<S>,
        aim: Aim,
        seed: u64,
        count: usize,
    ) -> Vec<Shot<S>> {
        let rng = &mut Rng::new(seed ^ ((self as u64) << 8 | aim as u64 | 128) << 48);
        (0..count).map(|_| self.shot(mesh, aim, rng)).collect()
    }

    fn shot<S: Sample>(self, mesh: &Mesh<S>, aim: Aim, rng: &mut Rng) -> Shot<S> {
        // A ball of a third of the radius, which is inside the octahedron too.
        let to_center = if rng.one_in(4) { 0.0 } else { 0.33 };
        let inside: [S; 3] = rng.triple(|rng| self.place(rng.real(-1.0, 1.0) * to_center));
        let face = mesh.faces[rng.below(mesh.faces.len())];
        let [a, b, c] = face.each(|v| mesh.vertices[v].each(S::approximate));
        let (p, q) = (rng.real(0.0, 0.5), rng.real(0.0, 0.5));
        let edge = if self.is_whole() { 0.5 } else { p + q };
        let (inner, target) = (inside.each(S::approximate), |i: usize| match aim {
            Aim::Interiors => a[i] + p * (b[i] - a[i]) + q * (c[i] - a[i]),
            Aim::Edges => a[i] + edge * (b[i] - a[i]),
            Aim::Vertices => a[i],
        });
        let outward = |i: usize| target(i) - inner[i];
        let from_outside = rng.one_in(2);
        if !from_outside {
            let direction = three(|i| S::nearest(outward(i)));
            return Shot { origin: inside, direction, from_outside };
        }
        let beyond = if self.is_whole() { 1.0 } else { rng.real(0.2, 1.0) };
        let origin = three(|i| S::nearest(target(i) + beyond * outward(i)));
        let direction = three(|i| S::nearest(target(i) - origin[i].approximate()));
        Shot { origin, direction, from_outside }
    }
}

impl<S: Sample> Shot<S> {
    /// The ray.
    pub fn ray(&self) -> Ray<S> {
        Ray::new(self.origin, self.direction).expect("a direction")
    }

    /// Hits by each of the methods on the triangles near the ray.
    pub fn counts<const N: usize>(&self, mesh: &Mesh<S>, methods: [Method; N]) -> [Count; N] {
        let ray = self.ray();
        let mut counts = [Count::default(); N];
        for triangle in mesh.near(self.origin, self.direction) {
            for (count, method) in counts.iter_mut().zip(methods) {
                match method.ask(&ray, triangle).map(|hit| hit.facing) {
                    Some(Facing::Front) => count.front += 1,
                    Some(Facing::Back) => count.back += 1,
                    None => {}
                }
            }
        }
        counts
    }

    /// Whether the shot passed a wall without a hit.
    pub fn leaks(&self, count: Count) -> bool {
        count.back == 0 || self.from_outside && count.front == 0
    }

    /// Whether the shot hit more than one triangle on entering or leaving.
    pub fn doubles(&self, count: Count) -> bool {
        count.back > 1 || count.front > u32::from(self.from_outside)
    }
}
