//! A scene in the types that one candidate takes.

use std::hint::black_box;
use std::ops::Range;

use septum::{Aabb, Scalar, Triangle};

use crate::scene::{Cell, Point, Scene};

/// Triangles of one type against boxes of another.
pub struct Data<T, B> {
    triangles: Vec<T>,
    boxes: Vec<B>,
    spans: Vec<Range<usize>>,
}

impl<T, B> Data<T, B> {
    /// The number of pairs that the test finds to overlap.
    ///
    /// The test is called through a pointer that the compiler cannot see
    /// through, so every candidate pays for one call and no loop is merged.
    pub fn count(&self, test: fn(&T, &B) -> bool) -> usize {
        let test = black_box(test);
        let mut count = 0;
        for (triangle, span) in self.triangles.iter().zip(&self.spans) {
            for aabb in &self.boxes[span.clone()] {
                count += usize::from(test(triangle, aabb));
            }
        }
        count
    }

    /// Each answer, in the order of the scene.
    pub fn answers(&self, test: impl Fn(&T, &B) -> bool) -> Vec<bool> {
        let test = &test;
        let pairs = self.triangles.iter().zip(&self.spans);
        pairs.flat_map(|(t, s)| self.boxes[s.clone()].iter().map(move |b| test(t, b))).collect()
    }

    /// The same scene in other types.
    pub fn map<U, C>(&self, triangle: impl Fn(&T) -> U, aabb: impl Fn(&B) -> C) -> Data<U, C> {
        Data {
            triangles: self.triangles.iter().map(triangle).collect(),
            boxes: self.boxes.iter().map(aabb).collect(),
            spans: self.spans.clone(),
        }
    }
}

/// How a box is given.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Center,
    Corners,
}

impl Form {
    pub const ALL: [Self; 2] = [Self::Center, Self::Corners];

    pub fn name(self) -> &'static str {
        match self {
            Self::Center => "centre",
            Self::Corners => "corners",
        }
    }
}

/// A scalar, and the scale at which a scene is brought into it.
#[derive(Clone, Copy)]
pub struct Unit<S> {
    pub name: &'static str,
    pub scale: f64,
    /// The scalar nearest to a number.
    pub near: fn(f64) -> S,
    /// The scalar as an `f64`, which holds all those used here without rounding.
    pub value: fn(S) -> f64,
}

impl<S: Scalar> Unit<S> {
    /// The scene in this scalar; coordinates are rounded to it here, before
    /// anything is asked or timed.
    pub fn data(&self, scene: &Scene, form: Form) -> Data<Triangle<S>, Aabb<S>> {
        let point = |p: Point| p.map(|x| (self.near)(x * self.scale));
        let triangle = |[a, b, c]: &[Point; 3]| {
            Triangle::new(point(*a), point(*b), point(*c)).expect("coordinates are finite")
        };
        let aabb = |Cell { center: c, half: h }: &Cell| match form {
            Form::Center => Aabb::from_center_half_extents(point(*c), point(*h)),
            Form::Corners => {
                let corner = |sign: f64| point(std::array::from_fn(|i| c[i] + sign * h[i]));
                Aabb::from_min_max(corner(-1.0), corner(1.0))
            }
        };
        Data {
            triangles: scene.triangles.iter().map(triangle).collect(),
            boxes: scene.cells.iter().map(|c| aabb(c).expect("cells are boxes")).collect(),
            spans: scene.spans.clone(),
        }
    }

    /// What is true of these very numbers: the exact test in `f64`.
    pub fn truth(&self, data: &Data<Triangle<S>, Aabb<S>>) -> Vec<bool> {
        let wide = |p: septum::Vec3<S>| p.to_array().map(self.value);
        let triangle = |t: &Triangle<S>| {
            let [a, b, c] = t.vertices().map(wide);
            Triangle::new(a, b, c).expect("coordinates are finite")
        };
        let aabb = |b: &Aabb<S>| match (b.center_half_extents(), b.min_max()) {
            (Some((c, h)), _) => Aabb::from_center_half_extents(wide(c), wide(h)),
            (_, Some((min, max))) => Aabb::from_min_max(wide(min), wide(max)),
            _ => unreachable!("a box has one form or the other"),
        };
        data.map(triangle, |b| aabb(b).expect("cells are boxes")).answers(|t, b| t.overlaps(b))
    }
}
