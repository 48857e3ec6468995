//! Shapes and answers for C.

use septum::{Facing, Feature, ShapeError};

use crate::number::Number;

/// A triangle. It may be a segment or a point.
#[repr(C)]
pub struct Triangle<T> {
    pub a: [T; 3],
    pub b: [T; 3],
    pub c: [T; 3],
}

/// An axis-aligned box by its least and greatest corner. It may be flat.
#[repr(C)]
pub struct Aabb<T> {
    pub min: [T; 3],
    pub max: [T; 3],
}

/// An oriented box: axes are three unit vectors at right angles to each other.
#[repr(C)]
pub struct Obb<T> {
    pub center: [T; 3],
    pub axes: [[T; 3]; 3],
    pub half_extents: [T; 3],
}

/// A ball: all points within the radius of the centre. The radius may be zero.
#[repr(C)]
pub struct Sphere<T> {
    pub center: [T; 3],
    pub radius: T,
}

/// All points within the radius of the segment from a to b. The radius may be zero.
#[repr(C)]
pub struct Capsule<T> {
    pub a: [T; 3],
    pub b: [T; 3],
    pub radius: T,
}

/// A ray, from origin + t_min · direction to origin + t_max · direction. The direction may have any
/// length except zero. The least number of the type as t_min, and the greatest as t_max, mean an
/// unbounded end; in floats these are the infinities. A range of [0, 0], which a structure has that
/// was initialised without one, is an error; a segment has [0, 1].
#[repr(C)]
pub struct Ray<T> {
    pub origin: [T; 3],
    pub direction: [T; 3],
    pub t_min: T,
    pub t_max: T,
}

/// A hit of a ray on a triangle. `t` is the distance along the ray in units of its direction; `u`
/// and `v` are the barycentric coordinates of b and c. `is_front` is 1 if a, b, c go
/// counterclockwise seen from the ray's origin. `feature` is 0 for the interior, 1, 2, 3 for the
/// edges ab, bc, ca, and 4, 5, 6 for the vertices a, b, c.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<T> {
    pub t: T,
    pub u: T,
    pub v: T,
    pub is_front: u8,
    pub feature: u8,
}

/// The point of a triangle closest to another point, rounded. `feature` says on which vertex or edge
/// the exact point lies, in the numbers of a hit.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest<T> {
    pub point: [T; 3],
    pub feature: u8,
}

/// When a moving box first meets a triangle. `t` is the part of the motion until then, from 0 to 1;
/// in a type that ends below 1 the greatest number. `normal` is the outward normal of the obstacle,
/// of any length; in fixed point it is rounded, and wraps where the product of two edges is beyond the
/// type. `axis` is 0, with a normal of zero, if they meet at the start; 1 to 3 for the
/// faces of the box, 4 for the triangle's normal, and 5 + 3·i + k for coordinate axis i × edge k.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstContact<T> {
    pub t: T,
    pub normal: [T; 3],
    pub axis: u8,
}

/// When a moving sphere first meets a triangle or a box. `t` is the part of the motion until then, as
/// for a box that moves. `part` is the face, edge or vertex at the point of contact, in the numbers
/// of a contact, and 255 if they meet at the start.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereContact<T> {
    pub t: T,
    pub part: u8,
}

/// Where a ray enters a shape and leaves it, in units of its direction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range<T> {
    pub enter: T,
    pub leave: T,
}

/// A point of a contact, on each shape. A part is 0 to 5 for a face, 16 and more for an edge, 32
/// and more for a vertex.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<T> {
    pub on_first: [T; 3],
    pub on_second: [T; 3],
    pub depth: T,
    pub first_part: u8,
    pub second_part: u8,
}

/// The translation that moves the first shape out of the second. Only `point_count` points are
/// meant. `is_sufficient` is 0 if a coordinate of the translation is beyond the type. `is_held` is 1
/// if an interior edge of a mesh holds it to the triangle's normal.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<T> {
    pub translation: [T; 3],
    pub depth: T,
    pub normal: [T; 3],
    pub is_sufficient: u8,
    pub is_held: u8,
    pub point_count: u8,
    pub points: [Point<T>; 8],
}

/// An answer, or an error, which is negative: `septum_text` says it in words.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    No = 0,
    Yes = 1,
    /// A pointer is null.
    NullPointer = -1,
    /// A coordinate is NaN or infinite.
    NotFinite = -2,
    /// A half-extent is negative.
    NegativeHalfExtent = -3,
    /// The least corner of a box lies above its greatest.
    MinAboveMax = -4,
    /// The axes of a box are not unit vectors at right angles.
    NotOrthonormal = -5,
    /// A ray's direction is zero.
    ZeroDirection = -6,
    /// A range ends before it begins.
    EmptyRange = -7,
    /// A triangle of a mesh refers to a vertex that does not exist.
    NoSuchVertex = -8,
    /// A mesh has the wrong number of nodes for its tree.
    WrongNodeCount = -9,
    /// A box of a tree does not enclose everything below it.
    BrokenTree = -10,
    /// A tree was not opened.
    NotOpen = -11,
    /// A mesh has more triangles than 16-bit indices can number.
    TooManyTriangles = -12,
    /// A ray has the range [0, 0].
    NoRange = -13,
    /// A quaternion has not the length one.
    NotUnitQuaternion = -14,
    /// A radius is negative.
    NegativeRadius = -15,
}

impl From<bool> for Answer {
    fn from(yes: bool) -> Self {
        if yes { Self::Yes } else { Self::No }
    }
}

impl From<ShapeError> for Answer {
    fn from(error: ShapeError) -> Self {
        match error {
            ShapeError::NegativeHalfExtent => Self::NegativeHalfExtent,
            ShapeError::MinAboveMax => Self::MinAboveMax,
            ShapeError::DependentAxes | ShapeError::NotOrthonormal | ShapeError::NoUnitLength => {
                Self::NotOrthonormal
            }
            ShapeError::NotUnitQuaternion => Self::NotUnitQuaternion,
            ShapeError::ZeroDirection => Self::ZeroDirection,
            ShapeError::EmptyRange => Self::EmptyRange,
            ShapeError::NegativeRadius => Self::NegativeRadius,
            _ => Self::NotFinite,
        }
    }
}

/// A shape of C, as the crate's.
pub(crate) trait Shape {
    type Of;

    fn shape(&self) -> Result<Self::Of, Answer>;
}

impl<T: Number> Shape for Triangle<T> {
    type Of = septum::Triangle<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        Ok(septum::Triangle::new(point(&self.a), point(&self.b), point(&self.c))?)
    }
}

impl<T: Number> Shape for Aabb<T> {
    type Of = septum::Aabb<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        Ok(septum::Aabb::from_min_max(point(&self.min), point(&self.max))?)
    }
}

impl<T: Number> Shape for Obb<T> {
    type Of = septum::Obb<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        let [u, v, w] = &self.axes;
        let axes = [point(u), point(v), point(w)];
        Ok(septum::Obb::new(point(&self.center), axes, point(&self.half_extents))?)
    }
}

impl<T: Number> Shape for Sphere<T> {
    type Of = septum::Sphere<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        Ok(septum::Sphere::new(point(&self.center), self.radius.scalar())?)
    }
}

impl<T: Number> Shape for Capsule<T> {
    type Of = septum::Capsule<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        Ok(septum::Capsule::new(point(&self.a), point(&self.b), self.radius.scalar())?)
    }
}

impl<T: Number> Shape for Ray<T> {
    type Of = septum::Ray<T::Scalar>;

    fn shape(&self) -> Result<Self::Of, Answer> {
        let ray = septum::Ray::new(point(&self.origin), point(&self.direction))?;
        let zero = <T::Scalar as septum::Scalar>::ZERO;
        let end = |t: T, unbounded: T| (t != unbounded).then(|| t.scalar());
        let [start, greatest] = T::UNBOUNDED;
        let (from, to) = (end(self.t_min, start), end(self.t_max, greatest));
        if from == Some(zero) && to == Some(zero) {
            return Err(Answer::NoRange);
        }
        Ok(ray.with_range(from, to)?)
    }
}

impl<T: Number> From<septum::Hit<T::Scalar>> for Hit<T> {
    fn from(hit: septum::Hit<T::Scalar>) -> Self {
        let is_front = u8::from(hit.facing == Facing::Front);
        let [t, u, v] = [hit.t, hit.u, hit.v].map(T::raw);
        Self { t, u, v, is_front, feature: number(hit.feature) }
    }
}

impl<T: Number> From<septum::Closest<T::Scalar>> for Closest<T> {
    fn from(closest: septum::Closest<T::Scalar>) -> Self {
        let point = closest.point.to_array().map(T::raw);
        Self { point, feature: number(closest.feature) }
    }
}

fn number(feature: Feature) -> u8 {
    match feature {
        Feature::Interior => 0,
        Feature::Edge(k) => 1 + k,
        Feature::Vertex(k) => 4 + k,
    }
}

pub(crate) fn point<T: Number>(p: &[T; 3]) -> [T::Scalar; 3] {
    let [x, y, z] = *p;
    [x.scalar(), y.scalar(), z.scalar()]
}
