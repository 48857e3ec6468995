//! The check: where is the tool, seen from the mesh?

use fixed::types::I16F16;
use septum::interop::Bounded;
use septum::{Aabb, Obb, Ray, Triangle, Vec3};

use super::teapot::{FACES, PARTS, VERTICES};

/// How many touched faces are named. The others are counted.
pub(crate) const ROOM: usize = 4;

/// Where the tool is.
#[derive(Debug, PartialEq)]
pub(crate) enum Place {
    /// It has no point in common with the mesh or its inside.
    Outside,
    /// It has a point in common with these faces.
    Touches(Bounded<u16, ROOM>),
    /// It touches no face, and all of it is inside this part of the mesh.
    Inside(usize),
}

/// Where the tool is. The tool lies within `around`.
///
/// A tool that touches no face lies on one side of them all, so that one of its
/// points decides whether it is inside: its centre.
pub(crate) fn place(tool: &Obb<I16F16>, around: &Aabb<I16F16>) -> Option<Place> {
    let touched = touched_by(tool, around);
    if touched.total() > 0 {
        return Some(Place::Touches(touched));
    }
    Some(part_around(tool.center())?.map_or(Place::Outside, Place::Inside))
}

/// The faces that the tool touches. Most are not even near.
fn touched_by(tool: &Obb<I16F16>, around: &Aabb<I16F16>) -> Bounded<u16, ROOM> {
    let is_touched = |&(_, face): &(u16, &[u16; 3])| {
        triangle(face).is_some_and(|t| t.overlaps(around) && t.overlaps(tool))
    };
    (0..).zip(&FACES).filter(is_touched).map(|(i, _)| i).collect()
}

/// The part of the mesh that a point is inside of, if there is one. The point lies
/// on no face.
///
/// Every part is closed, so that a ray from a point inside crosses it an odd number
/// of times. Through an edge or a vertex it crosses several faces at once;
/// `hit_once` counts them as one crossing. Parts may overlap: each is asked.
fn part_around(point: Vec3<I16F16>) -> Option<Option<usize>> {
    let (zero, one) = (I16F16::ZERO, I16F16::ONE);
    let up = Ray::new(point, [zero, one, zero]).ok()?;
    let crosses = |face: &&[u16; 3]| {
        is_in_column(face, point) && triangle(face).is_some_and(|t| up.hit_once(&t).is_some())
    };
    let is_inside = |part: &core::ops::Range<usize>| {
        FACES[part.clone()].iter().filter(crosses).count() % 2 == 1
    };
    Some(PARTS.iter().position(is_inside))
}

/// Whether a point is above or below the face's bounding box, or in it. An upward
/// ray misses all other faces, and comparisons cost less than the ray.
fn is_in_column(face: &[u16; 3], point: Vec3<I16F16>) -> bool {
    let [a, b, c] = face.map(vertex);
    let is_between =
        |a: I16F16, b: I16F16, c: I16F16, x: I16F16| a.min(b).min(c) <= x && x <= a.max(b).max(c);
    is_between(a.x, b.x, c.x, point.x) && is_between(a.z, b.z, c.z, point.z)
}

/// The face as a triangle. There is one for every face: each fixed-point number is
/// a valid coordinate.
fn triangle(face: &[u16; 3]) -> Option<Triangle<I16F16>> {
    let [a, b, c] = face.map(vertex);
    Triangle::new(a, b, c).ok()
}

fn vertex(i: u16) -> Vec3<I16F16> {
    VERTICES[usize::from(i)]
}
