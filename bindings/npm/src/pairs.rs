//! Questions about two shapes, in `f64`: JavaScript's own numbers.

use core::sync::atomic::{AtomicU64, Ordering};

use septum::contact::{self, Contact, Features};
use septum::{Aabb, Capsule, Obb, Overlaps, Ray, ShapeError, Sphere, Triangle};

use crate::part::number;

/// The numbers of two shapes from 0 and 16 on, or of an answer.
static SHAPES: [AtomicU64; 96] = [const { AtomicU64::new(0) }; 96];

#[unsafe(export_name = "shapes")]
extern "C" fn shapes() -> *const AtomicU64 {
    SHAPES.as_ptr()
}

fn numbers<const N: usize>(first: usize) -> [f64; N] {
    core::array::from_fn(|k| {
        SHAPES.get(first + k).map_or(0.0, |x| f64::from_bits(x.load(Ordering::Relaxed)))
    })
}

fn say(answer: impl IntoIterator<Item = f64>) {
    for (place, x) in SHAPES.iter().zip(answer) {
        place.store(x.to_bits(), Ordering::Relaxed);
    }
}

/// A shape of the kind that JavaScript names by a number.
enum Shape {
    Triangle(Triangle<f64>),
    Aabb(Aabb<f64>),
    Obb(Obb<f64>),
    Sphere(Sphere<f64>),
    Capsule(Capsule<f64>),
}

/// A triangle (0), a box by its corners (1), an oriented box by its axes (2) or by a quaternion
/// (3), a sphere (4) or a capsule (5).
fn shape(kind: u32, at: usize) -> Result<Shape, ShapeError> {
    let point = |k: usize| numbers::<3>(at + 3 * k);
    Ok(match kind {
        0 => Shape::Triangle(Triangle::new(point(0), point(1), point(2))?),
        1 => Shape::Aabb(Aabb::from_min_max(point(0), point(1))?),
        2 => {
            let axes = [point(2), point(3), point(4)];
            Shape::Obb(Obb::new(point(0), axes, point(1))?)
        }
        3 => Shape::Obb(Obb::from_quaternion(point(0), numbers::<4>(at + 6), point(1))?),
        4 => Shape::Sphere(Sphere::new(point(0), point(1)[0])?),
        _ => Shape::Capsule(Capsule::new(point(0), point(1), point(2)[0])?),
    })
}

/// The negative code of an error.
fn code(error: ShapeError) -> i32 {
    match error {
        ShapeError::NotFinite { .. } => -1,
        ShapeError::NegativeHalfExtent => -2,
        ShapeError::MinAboveMax => -3,
        ShapeError::NotOrthonormal => -4,
        ShapeError::NotUnitQuaternion => -5,
        ShapeError::ZeroDirection => -6,
        ShapeError::EmptyRange => -7,
        _ => NO_PAIR,
    }
}

/// The code of shapes about which there is no such question.
const NO_PAIR: i32 = -8;

/// What `ask` answers, or the code of an error, less 16 if it is about the second shape.
fn about(first: u32, second: u32, ask: impl FnOnce(&Shape, &Shape) -> i32) -> i32 {
    match (shape(first, 0), shape(second, 16)) {
        (Ok(first), Ok(second)) => ask(&first, &second),
        (Err(error), _) => code(error),
        (_, Err(error)) => code(error) - 16,
    }
}

/// A question about two shapes, for each pair that has it.
macro_rules! each {
    ($ask:path, $first:ident, $second:ident: $($a:ident $b:ident),*) => {
        match ($first, $second) {
            $((Shape::$a(a), Shape::$b(b)) => $ask(a, b),)*
            _ => return NO_PAIR,
        }
    };
    ($ask:path, $first:ident, $second:ident) => {
        each!(
            $ask, $first, $second:
            Triangle Triangle, Triangle Aabb, Triangle Obb, Aabb Triangle, Aabb Aabb, Aabb Obb,
            Obb Triangle, Obb Aabb, Obb Obb, Sphere Triangle, Sphere Aabb, Capsule Triangle,
            Capsule Aabb, Triangle Sphere, Aabb Sphere, Triangle Capsule, Aabb Capsule
        )
    };
}

/// Whether two shapes overlap: 0 or 1; -8 of spheres and capsules with each other or with oriented
/// boxes, to keep the module small.
#[unsafe(export_name = "overlaps")]
extern "C" fn overlaps(first: u32, second: u32) -> i32 {
    about(first, second, |first, second| each!(Overlaps::overlaps, first, second).into())
}

/// The contact of two shapes: 0 if there is none, else 1 plus the number of its points; -8 as for
/// [`overlaps`]. The numbers are then the translation, its depth, its normal, whether it suffices,
/// the features, and for each point the place on the first shape, on the second, the depth and the
/// two parts.
#[unsafe(export_name = "contact")]
extern "C" fn contact(first: u32, second: u32) -> i32 {
    about(first, second, |first, second| {
        let contact: Option<Contact<f64>> = each!(contact::contact, first, second);
        let Some(contact) = contact else { return 0 };
        let translation = &contact.translation;
        let features = match translation.features {
            Features::First(face) => [0, face, 0],
            Features::Second(face) => [1, face, 0],
            Features::Edges(one, other) => [2, one, other],
            Features::Nearest(one, other) => [3, number(one), number(other)],
        };
        let head = translation.vector.to_array().into_iter().chain([translation.depth]);
        let head = head.chain(translation.normal.to_array());
        let head = head.chain([f64::from(u8::from(translation.is_sufficient))]);
        let points = contact.points().iter().flat_map(|point| {
            let places = point.on_first.to_array().into_iter().chain(point.on_second.to_array());
            places.chain([point.depth]).chain(point.parts.map(|part| f64::from(number(part))))
        });
        say(head.chain(features.map(f64::from)).chain(points));
        1 + contact.points().len() as i32
    })
}

/// A ray by origin, direction and range.
fn ray() -> Result<Ray<f64>, ShapeError> {
    let [ox, oy, oz, dx, dy, dz, near, far] = numbers::<8>(0);
    // An infinite end on its own side is no end.
    let end = |t: f64, none: f64| (t != none).then_some(t);
    let ends = [end(near, f64::NEG_INFINITY), end(far, f64::INFINITY)];
    Ray::new([ox, oy, oz], [dx, dy, dz])?.with_range(ends[0], ends[1])
}

/// Whether a ray meets a box or a sphere: 0 or 1. The numbers are then where it enters and leaves.
#[unsafe(export_name = "ray_range")]
extern "C" fn ray_range(kind: u32) -> i32 {
    let range = match (ray(), shape(kind, 16)) {
        (Err(error), _) => return code(error),
        (_, Err(error)) => return code(error) - 16,
        (Ok(ray), Ok(Shape::Aabb(aabb))) => ray.t_range(&aabb),
        (Ok(ray), Ok(Shape::Obb(obb))) => ray.t_range_obb(&obb),
        (Ok(ray), Ok(Shape::Sphere(sphere))) => ray.t_range_sphere(&sphere),
        (Ok(_), Ok(_)) => return NO_PAIR,
    };
    range.map_or(0, |(enters, leaves)| {
        say([enters, leaves]);
        1
    })
}
