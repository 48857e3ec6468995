//! Spheres, capsules and points near triangles, in regimes of their own.

use fixed::types::I16F16;
use septum::relation::{Relate, Relation};
use septum::{Capsule, Triangle};
use septum_kit::spheres::{CapsuleCase, Other, SphereCase, SphereSet};
use septum_kit::{Rng, Sample};

use super::boxes::{Point, across, along, holds, plus, point};
use super::regimes::{Regime, Ticks, seeded, tens};
use crate::accuracy::{Exam, distances};
use crate::distance::{Closest, Near, OfCapsule, OfSphere, Query};

const SPHERE: &str = "sphere and triangle";
const CAPSULE: &str = "capsule and triangle";
const POINT: &str = "the point of a triangle closest to another";

type Nears<S> = fn(&mut Rng, f64) -> Option<Near<S>>;

impl Regime {
    /// Asks a query about these cases at every step in the range of the scalar.
    fn near<Q: Query + 'static, S: Sample>(
        mut self,
        panel: &'static str,
        scalar: &'static str,
        make: Nears<S>,
    ) -> Self {
        for step in self.steps_in(panel, |rng, at| make(rng, at).is_some()) {
            let ask = move |seed: u64, count: usize| {
                let rng = &mut seeded(seed, step.at);
                let cases = std::iter::repeat_with(|| make(rng, step.at)).take(count);
                distances::<Q, S>(scalar, cases.flatten())
            };
            self.exams.push(Exam { label: step, ask: Box::new(ask) });
        }
        self
    }
}

/// The nearest numbers; a sphere is a capsule whose ends are equal.
fn case<S: Sample>(ends: [Point; 2], radius: f64, triangle: [Point; 3]) -> Near<S> {
    let near = |p: Point| p.map(S::nearest);
    let triangle = triangle.map(near);
    let other = Other::Triangle(triangle);
    (CapsuleCase { ends: ends.map(near), radius: S::nearest(radius), other }, triangle)
}

/// A shape in exact contact by Pythagorean triples; then its radius is moved by `steps` places.
/// The crate itself chooses the cases, because an oracle would take too long; the oracle still
/// decides them.
fn moved<S: Sample>(case: CapsuleCase<S>, rng: &mut Rng, steps: f64) -> Option<Near<S>> {
    let Other::Triangle(triangle) = case.other else { return None };
    let steps = if rng.one_in(2) { steps as i64 } else { -(steps as i64) };
    let radius = case.radius.moved(steps);
    let [a, b, c] = triangle;
    let triangle_itself = Triangle::new(a, b, c).ok()?;
    let capsule = Capsule::new(case.ends[0], case.ends[1], case.radius).ok()?;
    let touches = capsule.relation(&triangle_itself) == Relation::Touching;
    let is_right = touches && radius >= S::ZERO;
    is_right.then_some((CapsuleCase { radius, ..case }, triangle))
}

fn touch<S: Sample>(rng: &mut Rng, steps: f64) -> Option<Near<S>> {
    (0..99).find_map(|_| {
        let SphereCase { center, radius, other } = SphereSet::Touch.case(rng);
        moved(CapsuleCase { ends: [center; 2], radius, other }, rng, steps)
    })
}

fn capsule_touch<S: Sample>(rng: &mut Rng, steps: f64) -> Option<Near<S>> {
    (0..99).find_map(|_| {
        let case = SphereSet::Touch.capsule(rng);
        moved(case, rng, steps)
    })
}

/// A triangle of size `size` at the surface of a capsule of size 1.
fn capsule_small<S: Sample>(rng: &mut Rng, size: f64) -> Option<Near<S>> {
    // On the surface of the capsule as the scalar represents it.
    let held = |x: f64| S::nearest(x).approximate();
    let ends = [(); 2].map(|()| point(rng, 1.0).map(held));
    let radius = held(rng.real(0.25, 0.5));
    let out = across(rng, ends[0], ends[1]);
    let length = out.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);
    let at = plus(along(ends[0], ends[1], rng.real(0.0, 1.0)), out.map(|x| x * radius / length));
    Some(case(ends, radius, [(); 3].map(|()| plus(at, point(rng, size)))))
}

/// The same of a sphere.
fn small<S: Sample>(rng: &mut Rng, size: f64) -> Option<Near<S>> {
    let held = |x: f64| S::nearest(x).approximate();
    let (center, radius) = (point(rng, 1.0).map(held), held(rng.real(0.25, 0.5)));
    let out = point(rng, 1.0);
    let length = out.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);
    let at = plus(center, out.map(|x| x * radius / length));
    Some(case([center; 2], radius, [(); 3].map(|()| plus(at, point(rng, size)))))
}

/// A random triangle and capsule at `distance` from the origin.
fn far<S: Sample>(rng: &mut Rng, distance: f64) -> Option<Near<S>> {
    let sign = |rng: &mut Rng| if rng.one_in(2) { -distance } else { distance };
    let origin = rng.triple(sign);
    let triangle = [(); 3].map(|()| plus(origin, point(rng, 2.0)));
    let ends = [(); 2].map(|()| plus(origin, point(rng, 2.0)));
    holds::<S>(distance + 4.0).then(|| case(ends, rng.real(0.0, 1.0), triangle))
}

pub(super) fn all() -> [Regime; 3] {
    [
        Regime::new(
            "near-touch",
            "Distances: contact",
            "places of the radius from contact, on one side or the other; 0 is exact contact",
            Ticks::Units,
            std::iter::once(0.0).chain((0..=10).map(|n| 4_f64.powi(n))).collect(),
            "Spheres and capsules in whole numbers touch a triangle exactly, at the left, because their \
             distance is the root of a square; then the radius is moved, up or down.",
        )
        .near::<OfSphere, f32>(SPHERE, "f32", touch)
        .near::<OfSphere, f64>(SPHERE, "f64", touch)
        .near::<OfSphere, I16F16>(SPHERE, "I16F16", touch)
        .near::<OfCapsule, f32>(CAPSULE, "f32", capsule_touch)
        .near::<OfCapsule, f64>(CAPSULE, "f64", capsule_touch)
        .near::<OfCapsule, I16F16>(CAPSULE, "I16F16", capsule_touch),
        Regime::new(
            "near-area",
            "Distances: small triangles",
            "size of the triangle, where the sphere and the capsule are of a size of about 1",
            Ticks::Ten(1),
            tens(0, -12, 1),
            "Triangles shrink from left to right, at the surface of a sphere or of a capsule. A \
             closest point is wrong if a coordinate is off by more than a thousandth of the size of \
             the triangle and a place of its greatest coordinate.",
        )
        .near::<OfSphere, f32>(SPHERE, "f32", small)
        .near::<OfSphere, f64>(SPHERE, "f64", small)
        .near::<OfSphere, I16F16>(SPHERE, "I16F16", small)
        .near::<OfCapsule, f32>(CAPSULE, "f32", capsule_small)
        .near::<OfCapsule, f64>(CAPSULE, "f64", capsule_small)
        .near::<OfCapsule, I16F16>(CAPSULE, "I16F16", capsule_small)
        .near::<Closest, f32>(POINT, "f32", small)
        .near::<Closest, f64>(POINT, "f64", small)
        .near::<Closest, I16F16>(POINT, "I16F16", small),
        Regime::new(
            "near-distance",
            "Distances: far from the origin",
            "distance from the origin, where shapes are of a size of about 1",
            Ticks::Ten(1),
            tens(0, 8, 1),
            "The same random shapes, farther and farther away. A closest point is wrong if a \
             coordinate is off by more than a thousandth of the size of the triangle and a place of \
             its greatest coordinate. I16F16 ends at 32,768.",
        )
        .near::<OfSphere, f32>(SPHERE, "f32", far)
        .near::<OfSphere, f64>(SPHERE, "f64", far)
        .near::<OfSphere, I16F16>(SPHERE, "I16F16", far)
        .near::<OfCapsule, f32>(CAPSULE, "f32", far)
        .near::<OfCapsule, f64>(CAPSULE, "f64", far)
        .near::<OfCapsule, I16F16>(CAPSULE, "I16F16", far)
        .near::<Closest, f32>(POINT, "f32", far)
        .near::<Closest, f64>(POINT, "f64", far)
        .near::<Closest, I16F16>(POINT, "I16F16", far),
    ]
}
