//! Questions about two shapes, in any type of numbers.

use septum::contact::{self, ContactWith, Part};
use septum::sweep::{Motion, Sweep};
use septum::{Axis, Feature, Overlaps, ShapeError};

use crate::number::Number;
use crate::shapes::{
    Aabb, Answer, Closest, Contact, FirstContact, Hit, Obb, Point, Range, Ray, Shape, Sphere,
    SphereContact, Triangle, point,
};

pub(crate) fn overlaps<A, B>(a: Option<&A>, b: Option<&B>) -> Answer
where
    A: Shape<Of: Overlaps<B::Of>>,
    B: Shape,
{
    ask(a, b, |a, b| Ok(a.shape()?.overlaps(&b.shape()?)))
}

pub(crate) fn triangle_closest_point<T: Number>(
    triangle: Option<&Triangle<T>>,
    p: Option<&[T; 3]>,
    closest: Option<&mut Closest<T>>,
) -> Answer {
    find(triangle, p, closest, |triangle, p| Ok(Some(triangle.shape()?.closest_point(point(p))?)))
}

pub(crate) fn ray_triangle<T: Number>(
    ray: Option<&Ray<T>>,
    triangle: Option<&Triangle<T>>,
) -> Answer {
    ask(ray, triangle, |ray, triangle| Ok(ray.shape()?.is_hit(&triangle.shape()?)))
}

pub(crate) fn ray_triangle_hit<T: Number>(
    ray: Option<&Ray<T>>,
    triangle: Option<&Triangle<T>>,
    hit: Option<&mut Hit<T>>,
) -> Answer {
    find(ray, triangle, hit, |ray, triangle| Ok(ray.shape()?.hit(&triangle.shape()?)))
}

pub(crate) fn aabb_cast_triangle<T: Number>(
    aabb: Option<&Aabb<T>>,
    motion: Option<&[T; 3]>,
    triangle: Option<&Triangle<T>>,
    first: Option<&mut FirstContact<T>>,
) -> Answer {
    let Some(motion) = motion else { return Answer::NullPointer };
    find(aabb, triangle, first, |aabb, triangle| {
        let (motion, triangle) = (by(motion)?, triangle.shape()?);
        let first = aabb.shape()?.first_contact(&motion, &triangle);
        Ok(first.map(|first| (first, motion, triangle)))
    })
}

pub(crate) fn contact<T: Number, A, B>(
    a: Option<&A>,
    b: Option<&B>,
    place: Option<&mut Contact<T>>,
) -> Answer
where
    A: Shape<Of: ContactWith<T::Scalar, B::Of>>,
    B: Shape,
{
    find(a, b, place, |a, b| Ok(contact::contact(&a.shape()?, &b.shape()?)))
}

pub(crate) fn sphere_cast<T: Number, B: Shape, C>(
    sphere: Option<&Sphere<T>>,
    motion: Option<&[T; 3]>,
    b: Option<&B>,
    first: Option<&mut SphereContact<T>>,
) -> Answer
where
    septum::Sphere<T::Scalar>: Sweep<B::Of, Scalar = T::Scalar, Contact = C>,
    SphereContact<T>: From<C>,
{
    let Some(motion) = motion else { return Answer::NullPointer };
    find(sphere, b, first, |sphere, b| Ok(sphere.shape()?.first_contact(&by(motion)?, &b.shape()?)))
}

pub(crate) fn ray_sphere_range<T: Number>(
    ray: Option<&Ray<T>>,
    sphere: Option<&Sphere<T>>,
    range: Option<&mut Range<T>>,
) -> Answer {
    find(ray, sphere, range, |ray, sphere| Ok(ray.shape()?.t_range_sphere(&sphere.shape()?)))
}

pub(crate) fn obb_turn<T: Number>(obb: Option<&mut Obb<T>>, quaternion: Option<&[T; 4]>) -> Answer {
    let (Some(obb), Some(quaternion)) = (obb, quaternion) else { return Answer::NullPointer };
    let quaternion = quaternion.map(T::scalar);
    let (center, half) = (point(&obb.center), point(&obb.half_extents));
    match septum::Obb::from_quaternion(center, quaternion, half) {
        Ok(turned) => {
            obb.axes = turned.axes().map(|axis| axis.to_array().map(T::raw));
            Answer::Yes
        }
        Err(error) => error.into(),
    }
}

/// A motion by a vector.
pub(crate) fn by<T: Number>(motion: &[T; 3]) -> Result<Motion<T::Scalar>, ShapeError> {
    Motion::new([<T::Scalar as septum::Scalar>::ZERO; 3], point(motion))
}

fn ask<A, B>(
    a: Option<&A>,
    b: Option<&B>,
    question: impl FnOnce(&A, &B) -> Result<bool, Answer>,
) -> Answer {
    let (Some(a), Some(b)) = (a, b) else { return Answer::NullPointer };
    question(a, b).map_or_else(|error| error, Answer::from)
}

/// Asks, and writes what is found.
fn find<A, B, R, C: From<R>>(
    a: Option<&A>,
    b: Option<&B>,
    place: Option<&mut C>,
    question: impl FnOnce(&A, &B) -> Result<Option<R>, Answer>,
) -> Answer {
    let (Some(a), Some(b), Some(place)) = (a, b, place) else { return Answer::NullPointer };
    match question(a, b) {
        Err(error) => error,
        Ok(None) => Answer::No,
        Ok(Some(found)) => {
            *place = found.into();
            Answer::Yes
        }
    }
}

type Met<S> = (septum::sweep::FirstContact<S>, Motion<S>, septum::Triangle<S>);

impl<T: Number> From<Met<T::Scalar>> for FirstContact<T> {
    fn from((first, motion, triangle): Met<T::Scalar>) -> Self {
        let normal = first.normal(&motion, &triangle).map(|normal| normal.to_array().map(T::raw));
        let axis = match first.axis {
            None => 0,
            Some(Axis::Face(k)) => 1 + k,
            Some(Axis::Normal) => 4,
            Some(Axis::Edge { axis, edge }) => 5 + 3 * axis + edge,
        };
        let zero = T::raw(<T::Scalar as septum::Scalar>::ZERO);
        Self { t: T::raw(first.t), normal: normal.unwrap_or([zero; 3]), axis }
    }
}

impl<T: Number> From<(T::Scalar, T::Scalar)> for Range<T> {
    fn from((enter, leave): (T::Scalar, T::Scalar)) -> Self {
        Self { enter: T::raw(enter), leave: T::raw(leave) }
    }
}

/// No part: the shapes meet at the start.
const AT_START: u8 = 255;

impl<T: Number> From<septum::sweep::SphereContact<T::Scalar, Feature>> for SphereContact<T> {
    fn from(first: septum::sweep::SphereContact<T::Scalar, Feature>) -> Self {
        let part = |part| match part {
            Feature::Interior => Part::Face(0),
            Feature::Edge(k) => Part::Edge(k),
            Feature::Vertex(k) => Part::Vertex(k),
        };
        let part = first.part.map_or(AT_START, |feature| number(part(feature)));
        Self { t: T::raw(first.t), part }
    }
}

impl<T: Number> From<septum::sweep::SphereContact<T::Scalar, [i8; 3]>> for SphereContact<T> {
    fn from(first: septum::sweep::SphereContact<T::Scalar, [i8; 3]>) -> Self {
        let part = first.part.map_or(AT_START, |sides| number(part_of_box(sides)));
        Self { t: T::raw(first.t), part }
    }
}

/// The part of a box that is on these sides.
fn part_of_box([x, y, z]: [i8; 3]) -> Part {
    let is_up = |side: i8| u8::from(side > 0);
    match [x != 0, y != 0, z != 0] {
        [_, false, false] => Part::Face(is_up(x)),
        [false, _, false] => Part::Face(2 + is_up(y)),
        [false, false, _] => Part::Face(4 + is_up(z)),
        [false, ..] => Part::Edge(is_up(y) + 2 * is_up(z)),
        [_, false, _] => Part::Edge(4 + is_up(z) + 2 * is_up(x)),
        [.., false] => Part::Edge(8 + is_up(x) + 2 * is_up(y)),
        _ => Part::Vertex(is_up(x) + 2 * is_up(y) + 4 * is_up(z)),
    }
}

impl<T: Number> From<contact::Contact<T::Scalar>> for Contact<T> {
    fn from(contact: contact::Contact<T::Scalar>) -> Self {
        let zero = T::raw(<T::Scalar as septum::Scalar>::ZERO);
        let none = Point {
            on_first: [zero; 3],
            on_second: [zero; 3],
            depth: zero,
            first_part: 0,
            second_part: 0,
        };
        let translation = &contact.translation;
        let mut made = Self {
            translation: translation.vector.to_array().map(T::raw),
            depth: T::raw(translation.depth),
            normal: translation.normal.to_array().map(T::raw),
            is_sufficient: translation.is_sufficient.into(),
            is_held: contact.is_held.into(),
            point_count: contact.points().len() as u8,
            points: [none; 8],
        };
        for (place, found) in made.points.iter_mut().zip(contact.points()) {
            *place = Point {
                on_first: found.on_first.to_array().map(T::raw),
                on_second: found.on_second.to_array().map(T::raw),
                depth: T::raw(found.depth),
                first_part: number(found.parts[0]),
                second_part: number(found.parts[1]),
            };
        }
        made
    }
}

/// Faces from 0, edges from 16, vertices from 32 on.
fn number(part: Part) -> u8 {
    match part {
        Part::Face(k) => k,
        Part::Edge(k) => 16 + k,
        Part::Vertex(k) => 32 + k,
    }
}
