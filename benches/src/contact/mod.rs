//! Contacts of oriented boxes; the yardstick is parry3d's manifold, in `f32`.

mod peers;

use std::hint::black_box;

use septum::Obb;
use septum::contact::{contact, least_translation};
use septum_kit::Sample;
use septum_kit::fixed::types::{I8F8, I16F16};

use crate::candidate::{Candidate, Course, Promise};
use crate::native;
use crate::obb_obb::Turned;
use crate::pairs::Pairs;
use crate::session::Group;

#[cfg(feature = "native")]
pub(crate) use peers::in_form;
pub use peers::{of_contact, of_manifold};
pub(crate) use peers::{parry_contact, parry_manifold};

/// Two shapes and their true depth; `None` if they have no contact.
pub(crate) struct Sunk<T> {
    pub(crate) pair: [T; 2],
    pub(crate) depth: Option<f64>,
}

impl<T> Sunk<T> {
    /// Whether the answer is a contact, with a depth right within a thousandth and the scalar's
    /// least number. A contact where there is none also returns `true`.
    fn is_right(&self, depth: Option<f64>, least: f64) -> bool {
        depth.is_some_and(|said| {
            self.depth.is_none_or(|depth| (said - depth).abs() <= depth / 1000.0 + least)
        })
    }
}

impl<S: Sample> Sunk<Obb<S>> {
    fn is_told(&self, depth: Option<S>) -> bool {
        self.is_right(depth.map(S::approximate), S::ZERO.moved(1).approximate())
    }
}

#[inline(never)]
fn translation<S: Sample>(sunk: &Sunk<Obb<S>>, _: &()) -> bool {
    let [first, second] = &sunk.pair;
    sunk.is_told(least_translation(first, second).map(|t| t.depth))
}

#[inline(never)]
fn with_points<S: Sample>(sunk: &Sunk<Obb<S>>, _: &()) -> bool {
    let [first, second] = &sunk.pair;
    sunk.is_told(contact(first, second).map(|c| black_box(c).translation.depth))
}

/// Both our methods in one scalar.
pub(crate) fn ours<S: Sample>(course: &Course<Sunk<Obb<S>>, ()>) -> Vec<Candidate> {
    vec![
        course.candidate("exact, translation", Promise::Exact, translation),
        course.candidate("exact, with points", Promise::Exact, with_points),
    ]
}

/// Pairs of boxes, and nothing on the right.
pub(crate) type Scene = Pairs<[Turned; 2], ()>;

fn obb<S: Sample>(near: impl Fn(f64) -> S, b: &Turned) -> Obb<S> {
    let at = |p: [f64; 3]| p.map(&near);
    Obb::new(at(b.center), b.axes.map(|u| u.map(S::nearest)), at(b.half)).expect("a frame")
}

/// The numbers as `f64`, which holds them.
fn wide<S: Sample>(obb: &Obb<S>) -> Obb<f64> {
    let wide = |p: septum::Vec3<S>| p.to_array().map(S::approximate);
    Obb::from_skewed_axes(wide(obb.center()), obb.axes().map(wide), wide(obb.half_extents()))
        .expect("it was a box before")
}

/// Randomly rotated boxes; half of the pairs overlap.
pub(crate) fn half() -> Scene {
    let rng = &mut fastrand::Rng::with_seed(45);
    let mut scene = Scene::default();
    for k in 0..10_000 {
        loop {
            let pair = [(); 2].map(|()| Turned::random(rng, std::f64::consts::TAU));
            let [b, c] = pair.each_ref().map(|b| obb(|x| x, b));
            if least_translation(&b, &c).is_some() == (k % 2 == 0) {
                scene.push(pair, [()]);
                break;
            }
        }
    }
    scene
}

/// The scene in a scalar, larger by a factor; the truth is that of `f64`.
fn course<S: Sample>(name: &'static str, scale: f64, scene: &Scene) -> Course<Sunk<Obb<S>>, ()> {
    let pairs = scene.map(
        |pair| {
            let pair = pair.each_ref().map(|b| obb(|x| S::nearest(x * scale), b));
            let [first, second] = pair.each_ref().map(wide);
            Sunk { pair, depth: least_translation(&first, &second).map(|t| t.depth) }
        },
        |()| (),
    );
    let truth = pairs.answers(|sunk, ()| sunk.depth.is_some());
    Course::new((name, ""), pairs, truth)
}

pub(crate) fn yardstick(scene: &Scene) -> Candidate {
    parry_manifold(&course::<f32>("f32", 1.0, scene), "yardstick: parry3d manifold")
}

pub(crate) fn groups() -> Vec<Group<Scene>> {
    fn group<S: Sample>(name: &'static str, scale: f64) -> Group<Scene> {
        (name, Box::new(move |scene: &Scene| ours(&course::<S>(name, scale, scene))))
    }
    let native = |scene: &Scene| native::contacts(&course::<f32>("f32", 1.0, scene));
    vec![
        group::<f32>("f32", 1.0),
        ("f32 native", Box::new(native)),
        group::<f64>("f64", 1.0),
        group::<I8F8>("I8F8, 15 bits", 32.0),
        group::<I16F16>("I16F16, 18 bits", 1.0),
    ]
}
