//! The queries in any number type.

use std::hint::black_box;

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::contact::contact;
use septum::polygon::Polygon;
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Scalar, Triangle, Vec3};

use crate::kind::Kind;
use crate::question::{Question, across, around, capsule, middle, sphere, turned};
use crate::scene::{Query, Scene};

/// A scalar with rounding from `f64`. A fixed-point type stands for all types of its width, because
/// verdicts and stages depend on the raw bits alone.
pub(crate) trait Coordinate: Scalar {
    fn nearest(x: f64, frac: u32) -> Self;

    /// The nearest number to a component of a unit vector, in units of one, whatever the number of
    /// fraction bits of the type that this one stands for.
    fn direction(x: f64) -> Self;
}

impl Coordinate for f32 {
    fn nearest(x: f64, _: u32) -> Self {
        x as Self
    }

    fn direction(x: f64) -> Self {
        x as Self
    }
}

impl Coordinate for f64 {
    fn nearest(x: f64, _: u32) -> Self {
        x
    }

    fn direction(x: f64) -> Self {
        x
    }
}

/// The raw bits. The caller has checked that they fit.
fn raw(x: f64, bits: u32, frac: u32) -> i64 {
    Kind::raw(x, bits, frac).expect("a type that holds the scene") as i64
}

impl Coordinate for I4F4 {
    fn nearest(x: f64, frac: u32) -> Self {
        Self::from_bits(raw(x, 8, frac) as i8)
    }

    fn direction(x: f64) -> Self {
        Self::from_num(x)
    }
}

impl Coordinate for I8F8 {
    fn nearest(x: f64, frac: u32) -> Self {
        Self::from_bits(raw(x, 16, frac) as i16)
    }

    fn direction(x: f64) -> Self {
        Self::from_num(x)
    }
}

impl Coordinate for I16F16 {
    fn nearest(x: f64, frac: u32) -> Self {
        Self::from_bits(raw(x, 32, frac) as i32)
    }

    fn direction(x: f64) -> Self {
        Self::from_num(x)
    }
}

impl Coordinate for I32F32 {
    fn nearest(x: f64, frac: u32) -> Self {
        Self::from_bits(raw(x, 64, frac))
    }

    fn direction(x: f64) -> Self {
        Self::from_num(x)
    }
}

/// The shapes of a query, rounded.
fn shapes<S: Coordinate>(scene: &Scene, query: Query, frac: u32) -> (Triangle<S>, Aabb<S>) {
    let [a, b, c, min, max] = scene.points(query).map(|p| p.map(|x| S::nearest(x, frac)));
    let triangle = Triangle::new(a, b, c).expect("the scene is finite");
    (triangle, Aabb::from_min_max(min, max).expect("rounding keeps the order"))
}

fn overlaps<S: Coordinate>(scene: &Scene, query: Query, frac: u32) -> bool {
    let (triangle, aabb) = shapes::<S>(scene, query, frac);
    triangle.overlaps(&aabb)
}

/// A function to time: it runs all queries, and counts the pairs that meet.
pub(crate) type Asking = Box<dyn Fn() -> usize>;

fn asking<S: Coordinate>(scene: &Scene, queries: &[Query], frac: u32) -> Asking {
    let pairs: Vec<_> = queries.iter().map(|&q| shapes::<S>(scene, q, frac)).collect();
    match scene.question {
        Question::Overlap => Box::new(move || count(&pairs, |(t, b)| t.overlaps(b))),
        Question::Turned => {
            let turned = |&query| turned(scene, query, |x| S::nearest(x, frac), S::direction);
            let turned: Vec<_> = pairs.into_iter().zip(queries.iter().map(turned)).collect();
            Box::new(move || count(&turned, |((t, _), b)| t.overlaps(b)))
        }
        Question::Triangle => {
            let across = |&query| across(scene, query, |x| S::nearest(x, frac));
            let across: Vec<_> = pairs.into_iter().zip(queries.iter().map(across)).collect();
            Box::new(move || count(&across, |((t, _), other)| t.overlaps(other)))
        }
        Question::Polygon => {
            let corners: Vec<_> = pairs.iter().map(|(t, b)| (*t.vertices(), *b)).collect();
            let meets = |(corners, b): &([Vec3<S>; 3], Aabb<S>)| {
                Polygon::new(corners).is_ok_and(|polygon| polygon.overlaps(b))
            };
            Box::new(move || count(&corners, meets))
        }
        Question::Boxes => {
            let turned = |&query| turned(scene, query, |x| S::nearest(x, frac), S::direction);
            let boxes = pairs.iter().map(|(t, _)| around(t));
            let boxes: Vec<_> = boxes.zip(queries.iter().map(turned)).collect();
            Box::new(move || count(&boxes, |(a, b)| a.overlaps(b)))
        }
        Question::Sphere => {
            let sphere = |&query| sphere(scene, query, |x| S::nearest(x, frac));
            let spheres: Vec<_> = pairs.into_iter().zip(queries.iter().map(sphere)).collect();
            Box::new(move || count(&spheres, |((t, _), sphere)| sphere.overlaps(t)))
        }
        Question::Capsule => {
            let capsule = |&query| capsule(scene, query, |x| S::nearest(x, frac));
            let capsules: Vec<_> = pairs.into_iter().zip(queries.iter().map(capsule)).collect();
            Box::new(move || count(&capsules, |((t, _), capsule)| capsule.overlaps(t)))
        }
        Question::Closest => {
            let middle = |&query| middle(scene, query, |x| S::nearest(x, frac));
            let points: Vec<_> = pairs.into_iter().zip(queries.iter().map(middle)).collect();
            Box::new(move || count(&points, |((t, _), p)| black_box(t.closest_point(*p)).is_ok()))
        }
        Question::Contact => Box::new(move || count(&pairs, |(t, b)| contact(b, t).is_some())),
        Question::Sweep(_) => {
            let motion = |&query| {
                let [from, to] = scene.places(query).map(|p| p.map(|x| S::nearest(x, frac)));
                Motion::new(from, to).expect("the scene is finite")
            };
            let moving: Vec<_> = pairs.into_iter().zip(queries.iter().map(motion)).collect();
            Box::new(move || count(&moving, |((t, b), m)| b.first_contact(m, t).is_some()))
        }
    }
}

fn count<T>(all: &[T], meet: impl Fn(&T) -> bool) -> usize {
    all.iter().filter(|one| meet(black_box(one))).count()
}

impl Kind {
    /// Whether they overlap, exactly, on the shapes of the query as the type has them.
    pub(crate) fn overlaps(self, scene: &Scene, query: Query) -> bool {
        match self {
            Self::Fixed { bits: ..=8, frac } => overlaps::<I4F4>(scene, query, frac),
            Self::Fixed { bits: ..=16, frac } => overlaps::<I8F8>(scene, query, frac),
            Self::Fixed { bits: ..=32, frac } => overlaps::<I16F16>(scene, query, frac),
            Self::Fixed { frac, .. } => overlaps::<I32F32>(scene, query, frac),
            Self::F32 => overlaps::<f32>(scene, query, 0),
            Self::F64 => overlaps::<f64>(scene, query, 0),
        }
    }

    /// A function that runs all queries, on shapes rounded beforehand.
    pub(crate) fn asking(self, scene: &Scene, queries: &[Query]) -> Asking {
        match self {
            Self::Fixed { bits: ..=8, frac } => asking::<I4F4>(scene, queries, frac),
            Self::Fixed { bits: ..=16, frac } => asking::<I8F8>(scene, queries, frac),
            Self::Fixed { bits: ..=32, frac } => asking::<I16F16>(scene, queries, frac),
            Self::Fixed { frac, .. } => asking::<I32F32>(scene, queries, frac),
            Self::F32 => asking::<f32>(scene, queries, 0),
            Self::F64 => asking::<f64>(scene, queries, 0),
        }
    }
}

/// The number of queries for which each type's verdict differs from `f64`'s.
pub(crate) fn changes(
    scene: &Scene,
    kinds: &[Kind],
    queries: impl Iterator<Item = Query>,
) -> Vec<u64> {
    let mut changed = vec![0; kinds.len()];
    for query in queries {
        let truth = Kind::F64.meets(scene, query);
        for (changed, kind) in changed.iter_mut().zip(kinds) {
            *changed += u64::from(kind.meets(scene, query) != truth);
        }
    }
    changed
}
