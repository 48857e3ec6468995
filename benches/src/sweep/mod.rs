//! A box that moves past a triangle, beside the peers' shape casts.

mod peers;
mod scenes;

use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Scalar, Triangle};
use septum_kit::fixed::types::{I8F8, I16F16};
use septum_kit::{Rng, Sample};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Pairs;
use crate::session::Group;

pub use peers::{box3d_cast, parry};
pub use scenes::{scene, voorhies, wall};

/// A box at the start, how far it moves, and a triangle.
#[derive(Clone, Copy)]
pub struct Shot {
    pub center: [f32; 3],
    pub half: [f32; 3],
    pub way: [f32; 3],
    pub triangle: [[f32; 3]; 3],
}

/// The same in a scalar.
pub struct Given<S> {
    pub aabb: Aabb<S>,
    pub motion: Motion<S>,
    pub triangle: Triangle<S>,
}

impl Shot {
    pub fn given<S: Scalar>(&self, near: impl Fn(f32) -> S) -> Given<S> {
        let p = |p: [f32; 3]| p.map(&near);
        let [a, b, c] = self.triangle;
        Given {
            aabb: Aabb::from_center_half_extents(p(self.center), p(self.half)).expect("a box"),
            motion: Motion::new(p([0.0; 3]), p(self.way)).expect("finite"),
            triangle: Triangle::new(p(a), p(b), p(c)).expect("finite"),
        }
    }
}

/// A question, and the true time of impact: never, or at that time at the latest.
pub(crate) struct Timed<T> {
    pub(crate) given: T,
    pub(crate) due: Option<f64>,
}

impl<T> Timed<T> {
    /// Whether the answer is a hit that is not late. A hit where none is due also returns `true`.
    fn in_time(&self, t: Option<f64>) -> bool {
        t.is_some_and(|t| self.due.is_none_or(|due| t <= due))
    }
}

#[inline(never)]
fn whether<S: Scalar>(timed: &Timed<Given<S>>, _: &()) -> bool {
    let Given { aabb, motion, triangle } = &timed.given;
    aabb.meets_along(motion, triangle)
}

#[inline(never)]
fn when<S: Sample>(timed: &Timed<Given<S>>, _: &()) -> bool {
    let Given { aabb, motion, triangle } = &timed.given;
    timed.in_time(aabb.first_contact(motion, triangle).map(|first| first.t.approximate()))
}

/// Both our methods in one scalar.
pub(crate) fn ours<S: Sample>(course: &Course<Timed<Given<S>>, ()>) -> Vec<Candidate> {
    vec![
        course.candidate("exact, whether", Promise::Exact, whether),
        course.candidate("exact, when", Promise::Exact, when),
    ]
}

/// A time rounded to the nearest is not late.
fn rounded_down(t: f32) -> f64 {
    t.next_down().into()
}

fn parry_when(timed: &Timed<Shot>, _: &()) -> bool {
    timed.in_time(parry(&timed.given).map(rounded_down))
}

fn box3d_when(timed: &Timed<Shot>, _: &()) -> bool {
    timed.in_time(box3d_cast(&timed.given).map(rounded_down))
}

pub(crate) fn peers(course: &Course<Timed<Shot>, ()>) -> Vec<Candidate> {
    vec![
        course.candidate("parry3d cast_shapes", Promise::Nothing, parry_when),
        course.candidate("box3d-rust shape_cast", Promise::Nothing, box3d_when),
    ]
}

/// Shots, and nothing on the right.
pub(crate) type Scene = Pairs<Shot, ()>;

/// A unit cube near triangles; half of the pairs meet.
pub(crate) fn half() -> Scene {
    let rng = &mut Rng::new(2);
    let mut scene = Scene::default();
    for _ in 0..20_000 {
        scene.push(voorhies(rng), [()]);
    }
    scene
}

fn by_due<T: 'static>(
    name: &'static str,
    scene: &Scene,
    timed: impl Fn(&Shot) -> Timed<T>,
) -> Course<Timed<T>, ()> {
    let pairs = scene.map(timed, |()| ());
    let truth = pairs.answers(|timed, ()| timed.due.is_some());
    Course::new((name, ""), pairs, truth)
}

/// The scene in a scalar, larger by a factor; the truth is that of `f64`, rounded down.
fn course<S: Sample>(name: &'static str, scale: f64, scene: &Scene) -> Course<Timed<Given<S>>, ()> {
    let near = move |x: f32| S::nearest(f64::from(x) * scale);
    by_due(name, scene, |shot| {
        let Given { aabb, motion, triangle } = shot.given(|x| near(x).approximate());
        let due = aabb.first_contact(&motion, &triangle).map(|first| first.t);
        Timed { given: shot.given(near), due }
    })
}

fn shots(scene: &Scene) -> Course<Timed<Shot>, ()> {
    by_due("f32", scene, |shot| {
        let Given { aabb, motion, triangle } = shot.given(f64::from);
        let due = aabb.first_contact(&motion, &triangle).map(|first| first.t);
        Timed { given: *shot, due }
    })
}

pub(crate) fn yardstick(scene: &Scene) -> Candidate {
    shots(scene).candidate("yardstick: parry3d cast_shapes", Promise::Nothing, parry_when)
}

pub(crate) fn groups() -> Vec<Group<Scene>> {
    fn group<S: Sample>(name: &'static str, scale: f64) -> Group<Scene> {
        (name, Box::new(move |scene: &Scene| ours(&course::<S>(name, scale, scene))))
    }
    vec![
        group::<f32>("f32", 1.0),
        ("f32 box3d-rust", Box::new(|scene: &Scene| peers(&shots(scene)).split_off(1)) as _),
        group::<f64>("f64", 1.0),
        group::<I8F8>("I8F8, 15 bits", 32.0),
        group::<I16F16>("I16F16, 18 bits", 1.0),
    ]
}
