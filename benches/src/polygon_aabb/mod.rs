//! Polygon against box; the yardstick is the test of Green and Hatch as published, in `f32`.

mod scenes;

use septum::polygon::Polygon;
use septum::{Aabb, Scalar, Vec3};

use crate::candidate::{Candidate, Course, Promise};
use crate::geometry::{Cell, Point};
use crate::pairs::Pairs;
use crate::session::{Group, Session};
use crate::unit::{F32, F64, Form, I16F16_18, Unit};

pub(crate) use scenes::of_vertices;

/// Polygons, and the cells that each is tested against.
pub type Scene = Pairs<Vec<Point>, Cell>;

/// The numbers of vertices of the scenes' polygons.
pub(crate) const VERTICES: std::ops::RangeInclusive<usize> = 3..=8;

#[inline(never)]
fn exact<S: Scalar>(p: &Polygon<'_, S>, b: &Aabb<S>) -> bool {
    p.overlaps(b)
}

#[inline(never)]
fn as_published<S: Scalar>(p: &Polygon<'_, S>, b: &Aabb<S>) -> bool {
    septum::published::green_hatch::overlaps(p, b)
}

#[inline(never)]
fn each_triangle<S: Scalar>(p: &Polygon<'_, S>, b: &Aabb<S>) -> bool {
    p.triangles().any(|triangle| triangle.overlaps(b))
}

/// The scene in a scalar; the truth is computed from the triangles, in `f64`.
pub(crate) fn course<S: Scalar>(
    scene: &Scene,
    unit: &Unit<S>,
    form: Form,
) -> Course<Polygon<'static, S>, Aabb<S>> {
    let polygon = |points: &Vec<Point>| {
        let vertices: Vec<_> = points.iter().map(|&p| Vec3::from(unit.point(p))).collect();
        // Leaked: a user's program keeps its vertices anyway, and this one ends soon.
        Polygon::new(vertices.leak()).expect("three vertices or more")
    };
    let pairs = scene.map(polygon, |cell| unit.aabb(cell, form));
    let wide = pairs.map(
        |p| p.triangles().map(|t| unit.wide_triangle(&t)).collect::<Vec<_>>(),
        |b| unit.wide_aabb(b),
    );
    let truth = wide.answers(|p, b| p.iter().any(|triangle| triangle.overlaps(b)));
    Course::new((unit.name, form.name()), pairs, truth)
}

/// The test that ratios refer to.
fn yardstick(scene: &Scene) -> Candidate {
    let course = course(scene, &F32, Form::Center);
    course.candidate("yardstick: as published", Promise::Nothing, as_published)
}

/// All our modes in one scalar.
fn ours<S: Scalar>(course: &Course<Polygon<'static, S>, Aabb<S>>) -> Vec<Candidate> {
    vec![
        exact_on(course),
        course.candidate("each triangle", Promise::Exact, each_triangle),
        as_published_on(course),
    ]
}

pub(crate) fn exact_on<S: Scalar>(course: &Course<Polygon<'static, S>, Aabb<S>>) -> Candidate {
    course.candidate("exact", Promise::Exact, exact)
}

pub(crate) fn as_published_on<S: Scalar>(
    course: &Course<Polygon<'static, S>, Aabb<S>>,
) -> Candidate {
    course.candidate("as published", Promise::Nothing, as_published)
}

fn group<S: Scalar>(unit: Unit<S>, form: Form) -> Group<Scene> {
    (unit.name, Box::new(move |scene| ours(&course(scene, &unit, form))))
}

pub fn run(session: &mut Session) {
    let by_form = |form| [group(F32, form), group(F64, form), group(I16F16_18, form)];
    let all: Vec<_> = Form::ALL.into_iter().flat_map(by_form).collect();
    session.measure("polygon/box: 4 vertices", || of_vertices(4), yardstick, &all);
    session.measure("polygon/box: 8 vertices", || of_vertices(8), yardstick, &all);
}
