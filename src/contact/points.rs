//! Where shapes touch after the least translation, by clipping.

use super::body::{Body, Place, Rough, Vec64};
use super::directions::{Direction, cross, dot};
use super::feature::{Axis, Part};
use super::least::Way;
use super::polygon::{Face, MOST, along, corner_of_box, edge_of_box, facing, minus};
use crate::arithmetic::{pick, three, turn};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// A place where two shapes are in each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Point<S> {
    /// On the first shape.
    pub on_first: Vec3<S>,
    /// On the second shape.
    pub on_second: Vec3<S>,
    /// How far they are in each other here, along the normal.
    pub depth: S,
    /// What of the first shape and of the second meets here.
    pub parts: [Part; 2],
}

/// Up to eight points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points<S> {
    points: [Point<S>; MOST],
    count: usize,
}

impl<S: Scalar> Points<S> {
    pub(super) fn as_slice(&self) -> &[Point<S>] {
        self.points.get(..self.count).unwrap_or(&[])
    }
}

/// Finds points, in floats from an origin.
struct Finder<S> {
    origin: Place<S>,
    /// From the origin's first place to the origin.
    offset: Vec64,
    points: Points<S>,
}

impl<S: Scalar> Finder<S> {
    fn at(&self, x: &Vec64) -> Vec3<S> {
        let at = |i: usize| self.origin.0[i].plus_double(x[i] + self.offset[i]);
        Vec3::new(at(0), at(1), at(2))
    }

    /// A point of the shape whose face is not the axis.
    fn add_turned(
        &mut self,
        at: Vec64,
        depth: f64,
        outward: &Vec64,
        mut parts: [Part; 2],
        is_second: bool,
    ) {
        let mut both = [along(&at, depth, outward), at];
        if is_second {
            both.reverse();
            parts.reverse();
        }
        self.add(both, depth, parts);
    }

    fn add(&mut self, [first, second]: [Vec64; 2], depth: f64, parts: [Part; 2]) {
        let (on_first, on_second) = (self.at(&first), self.at(&second));
        if let Some(point) = self.points.points.get_mut(self.points.count) {
            *point = Point { on_first, on_second, depth: S::ZERO.plus_double(depth), parts };
            self.points.count += 1;
        }
    }
}

/// Whether a shape lies farthest on the upper side of each axis; of what lies across, the upper.
fn upper(way: &Way, shape: usize) -> [bool; 3] {
    three(|k| way.along[shape % 2][k] != way.toward(shape).reverse())
}

/// The direction of a way out, by the parts of the shapes that it comes from.
pub(super) fn axis<S: Scalar>(bodies: &[Body<'_, S>; 2], way: &Way) -> Axis {
    let face = |shape: usize, k: usize| {
        let is_triangle = bodies[shape % 2].is_triangle();
        if is_triangle { 0 } else { 2 * k as u8 + u8::from(*pick(&upper(way, shape), k)) }
    };
    let edge = |shape: usize, k: usize| {
        let is_triangle = bodies[shape % 2].is_triangle();
        if is_triangle { k as u8 } else { edge_of_box(k, upper(way, shape)) }
    };
    match way.direction {
        Direction::Face { is_second: false, k } => Axis::First(face(0, k)),
        Direction::Face { is_second: true, k } => Axis::Second(face(1, k)),
        Direction::Sides(i, j) => Axis::Edges(edge(0, i), edge(1, j)),
    }
}

/// An edge: where it begins, what it runs along, and between which ends.
fn edge(shape: &Rough, k: usize, upper: [bool; 3]) -> (Vec64, Vec64, [f64; 2]) {
    let side = *pick(&shape.sides, k);
    if shape.is_triangle {
        return (*pick(&shape.at, k), side, [0.0, 1.0]);
    }
    let (mut flat, h) = (*shape, *pick(&shape.half, k));
    flat.half[turn(k).0] = 0.0;
    (corner_of_box(&flat, upper), side, [-h, h])
}

/// The points of a way out along an axis, which the first shape goes along the normal.
pub(super) fn points<S: Scalar>(
    origin: Place<S>,
    [first, second]: &[Rough; 2],
    way: &Way,
    normal: Vec64,
    axis: Axis,
) -> Points<S> {
    let zero = Vec3::splat(S::ZERO);
    let empty =
        Point { on_first: zero, on_second: zero, depth: S::ZERO, parts: [Part::Face(0); 2] };
    let offset = three(|i| origin.1[i].beyond_in_double(origin.0[i]) * 0.5);
    let points = Points { points: [empty; MOST], count: 0 };
    let mut finder = Finder { origin, offset, points };
    match (axis, way.direction) {
        (Axis::First(face), _) => {
            clip(&mut finder, [first, second], face, &three(|i| -normal[i]), false);
        }
        (Axis::Second(face), _) => clip(&mut finder, [second, first], face, &normal, true),
        (Axis::Edges(a, b), Direction::Sides(i, j)) => {
            let (p, x, x_ends) = edge(first, i, upper(way, 0));
            let (q, y, y_ends) = edge(second, j, upper(way, 1));
            // The lines are nearest to each other where what is between them is across both.
            let (d, n) = (minus(&q, &p), cross(&x, &y));
            let square = dot(&n, &n);
            let within = |t: f64, [least, most]: [f64; 2]| {
                if t > least { if t < most { t } else { most } } else { least }
            };
            let s = within(dot(&cross(&d, &y), &n) / square, x_ends);
            let t = within(dot(&cross(&d, &x), &n) / square, y_ends);
            let both = [along(&p, s, &x), along(&q, t, &y)];
            let depth = dot(&minus(&both[1], &both[0]), &normal);
            finder.add(both, depth, [Part::Edge(a), Part::Edge(b)]);
        }
        (Axis::Edges(..), Direction::Face { .. }) => {}
    }
    finder.points
}

/// Points where the face of one shape, and what the other turns to it, are in each other.
fn clip<S: Scalar>(
    finder: &mut Finder<S>,
    [reference, incident]: [&Rough; 2],
    number: u8,
    outward: &Vec64,
    is_second: bool,
) {
    let theirs = facing(incident, outward);
    let (face, other) = (Face::new(reference, number), Face::new(incident, theirs));
    let depth = |at: &Vec64| -dot(&minus(at, &face.corners[0]), outward);
    face.cut(&other, [number, theirs], outward, |at, parts| {
        let depth = depth(&at);
        if depth >= 0.0 {
            finder.add_turned(at, depth, outward, parts, is_second);
        }
    });
    if finder.points.count == 0 {
        // The corner that lies deepest, where rounding left nothing.
        let (at, part) = other.lowest(outward);
        finder.add_turned(at, depth(&at), outward, [Part::Face(number), part], is_second);
    }
}
