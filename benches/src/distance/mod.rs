//! Spheres, capsules and points near triangles; the yardstick is parry3d, in `f32`.

mod peers;
mod scenes;

use septum::{Capsule, Sphere, Triangle};
use septum_kit::fixed::types::{I8F8, I16F16};
use septum_kit::spheres::{CapsuleCase, Other, SphereCase};
use septum_kit::{Rng, Sample};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Pairs;
use crate::session::Group;

pub use peers::closest_point;
pub use scenes::{anywhere, capsule_anywhere};

/// A capsule, or a sphere if its ends are equal, and a triangle.
pub(crate) type Near<S> = (CapsuleCase<S>, [[S; 3]; 3]);

/// A query in all scalars: the same cases, each asked in its own way.
pub(crate) trait Query {
    /// The shape in question, in our types.
    type Asked<S: Sample>: 'static;

    /// The shape, and the true answer.
    fn asked<S: Sample>(near: &Near<S>) -> (Self::Asked<S>, bool);
    fn is<S: Sample>(asked: &Self::Asked<S>, triangle: &Triangle<S>) -> bool;
    /// Methods of others; parry3d, the last one in `f32`, is the yardstick.
    fn in_f32(course: &Course<Self::Asked<f32>, Triangle<f32>>) -> Vec<Candidate>;
    fn in_f64(_: &Course<Self::Asked<f64>, Triangle<f64>>) -> Vec<Candidate> {
        Vec::new()
    }
}

/// Whether a sphere overlaps a triangle.
pub(crate) struct OfSphere;
/// Whether a capsule does.
pub(crate) struct OfCapsule;
/// The point of a triangle that is closest to another.
pub(crate) struct Closest;

/// A point, the closest point of the triangle, and how far from that an answer may be.
pub(crate) struct Asked<S> {
    point: [S; 3],
    closest: [f64; 3],
    within: f64,
}

impl<S: Sample> Asked<S> {
    /// # Panics
    /// If the answer in `f64`, against which all are held, is not the rational one.
    fn new(&(CapsuleCase { ends, .. }, triangle): &Near<S>) -> Self {
        let wide = |p: [S; 3]| p.map(S::approximate);
        let other = Other::Triangle(triangle.map(wide));
        let case = SphereCase { center: wide(ends[0]), radius: 0.0, other };
        let found = case.closest().expect("a triangle");
        assert_eq!(case.check_closest(&found), Some(Ok(())), "{case:?}");
        let [a, b, c] = triangle.map(wide);
        let size = (0..3).flat_map(|i| [(b[i] - a[i]).abs(), (c[i] - a[i]).abs()]);
        let size = size.fold(0.0, f64::max);
        let all = triangle.as_flattened().iter();
        let place = |x: &S| (x.moved(1).approximate() - x.approximate()).abs();
        let place = all.flat_map(|x| [place(x), place(&x.moved(-1))]).fold(0.0, f64::max);
        let within = size / 1000.0 + place;
        Self { point: ends[0], closest: found.point.to_array(), within }
    }

    fn is_close(&self, found: [f64; 3]) -> bool {
        (0..3).all(|i| (found[i] - self.closest[i]).abs() <= self.within)
    }
}

fn shape<S: Sample>([a, b, c]: [[S; 3]; 3]) -> Triangle<S> {
    Triangle::new(a, b, c).expect("finite vertices")
}

impl Query for OfSphere {
    type Asked<S: Sample> = Sphere<S>;

    fn asked<S: Sample>(near: &Near<S>) -> (Sphere<S>, bool) {
        let (CapsuleCase { ends: [center, _], radius, .. }, triangle) = *near;
        let case = SphereCase { center, radius, other: Other::Triangle(triangle) };
        (Sphere::new(center, radius).expect("a sphere"), case.truth().is_le())
    }

    #[inline(never)]
    fn is<S: Sample>(sphere: &Sphere<S>, triangle: &Triangle<S>) -> bool {
        sphere.overlaps(triangle)
    }

    fn in_f32(course: &Course<Sphere<f32>, Triangle<f32>>) -> Vec<Candidate> {
        vec![peers::ericson_sphere(course), peers::parry_sphere(course)]
    }

    fn in_f64(course: &Course<Sphere<f64>, Triangle<f64>>) -> Vec<Candidate> {
        vec![peers::ericson_sphere(course)]
    }
}

impl Query for OfCapsule {
    type Asked<S: Sample> = Capsule<S>;

    fn asked<S: Sample>(near: &Near<S>) -> (Capsule<S>, bool) {
        let CapsuleCase { ends: [a, b], radius, .. } = near.0;
        (Capsule::new(a, b, radius).expect("a capsule"), near.0.truth().is_le())
    }

    #[inline(never)]
    fn is<S: Sample>(capsule: &Capsule<S>, triangle: &Triangle<S>) -> bool {
        capsule.overlaps(triangle)
    }

    fn in_f32(course: &Course<Capsule<f32>, Triangle<f32>>) -> Vec<Candidate> {
        vec![peers::parry_capsule(course)]
    }
}

impl Query for Closest {
    type Asked<S: Sample> = Asked<S>;

    fn asked<S: Sample>(near: &Near<S>) -> (Asked<S>, bool) {
        (Asked::new(near), true)
    }

    #[inline(never)]
    fn is<S: Sample>(asked: &Asked<S>, triangle: &Triangle<S>) -> bool {
        let found = triangle.closest_point(asked.point).expect("a finite point");
        asked.is_close(found.point.to_array().map(S::approximate))
    }

    fn in_f32(course: &Course<Asked<f32>, Triangle<f32>>) -> Vec<Candidate> {
        vec![peers::ericson_closest(course), peers::parry_closest(course)]
    }

    fn in_f64(course: &Course<Asked<f64>, Triangle<f64>>) -> Vec<Candidate> {
        vec![peers::ericson_closest(course)]
    }
}

/// Cases in a scalar, with their true answers.
pub(crate) fn course<Q: Query, S: Sample>(
    scalar: &'static str,
    cases: impl IntoIterator<Item = Near<S>>,
) -> Course<Q::Asked<S>, Triangle<S>> {
    let (mut pairs, mut truth) = (Pairs::default(), Vec::new());
    for near in cases {
        let (asked, is) = Q::asked(&near);
        pairs.push(asked, [shape(near.1)]);
        truth.push(is);
    }
    Course::new((scalar, ""), pairs, truth)
}

pub(crate) fn ours<Q: Query, S: Sample>(
    course: &Course<Q::Asked<S>, Triangle<S>>,
) -> Vec<Candidate> {
    vec![course.candidate("exact", Promise::Exact, Q::is::<S>)]
}

/// The cases of a scene in `f64`, to be rounded to each scalar.
pub(crate) type Scene = Pairs<Near<f64>, ()>;

/// Random pairs; few of them overlap.
pub(crate) fn random() -> Scene {
    let rng = &mut Rng::new(0xd15);
    let mut scene = Scene::default();
    for _ in 0..10_000 {
        let case: CapsuleCase<f32> = capsule_anywhere(rng);
        let Other::Triangle(triangle) = case.other else { unreachable!("made so") };
        let wide = |p: [f32; 3]| p.map(f64::from);
        let (ends, triangle) = (case.ends.map(wide), triangle.map(wide));
        let (radius, other) = (case.radius.into(), Other::Triangle(triangle));
        scene.push((CapsuleCase { ends, radius, other }, triangle), [()]);
    }
    scene
}

/// The scene in a scalar, larger by a factor.
fn scaled<Q: Query, S: Sample>(
    name: &'static str,
    scale: f64,
    scene: &Scene,
) -> Course<Q::Asked<S>, Triangle<S>> {
    let near = |x: f64| S::nearest(x * scale);
    let cases = scene.lefts().map(|(case, triangle)| {
        let triangle = triangle.map(|p| p.map(near));
        let (ends, other) = (case.ends.map(|p| p.map(near)), Other::Triangle(triangle));
        (CapsuleCase { ends, radius: near(case.radius), other }, triangle)
    });
    course::<Q, S>(name, cases)
}

pub(crate) fn yardstick<Q: Query>(scene: &Scene) -> Candidate {
    let all = Q::in_f32(&scaled::<Q, f32>("f32", 1.0, scene));
    all.into_iter().last().expect("parry3d").named("yardstick: parry3d")
}

pub(crate) fn groups<Q: Query + 'static>() -> Vec<Group<Scene>> {
    fn group<Q: Query, S: Sample>(name: &'static str, scale: f64) -> Group<Scene> {
        (name, Box::new(move |scene: &Scene| ours::<Q, S>(&scaled::<Q, S>(name, scale, scene))))
    }
    let published = |scene: &Scene| {
        let mut all = Q::in_f32(&scaled::<Q, f32>("f32", 1.0, scene));
        all.truncate(all.len() - 1);
        all.extend(Q::in_f64(&scaled::<Q, f64>("f64", 1.0, scene)));
        all
    };
    vec![
        group::<Q, f32>("f32", 1.0),
        ("as published", Box::new(published)),
        group::<Q, f64>("f64", 1.0),
        group::<Q, I8F8>("I8F8, 15 bits", 32.0),
        group::<Q, I16F16>("I16F16, 18 bits", 1.0),
    ]
}
