//! `serde`: every shape is written in the form in which it was given, and read through its checking
//! constructor. An extra or missing field is an error.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use crate::scalar::Scalar;
use crate::shape::{
    Aabb, AabbForm, Capsule, Obb, Plane, PlaneForm, Ray, Segment, SegmentForm, ShapeError, Sphere,
    Triangle, Vec3,
};

/// The vertices of a triangle, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Triangle")]
struct Vertices<S>([Vec3<S>; 3]);

/// The numbers of an axis-aligned box, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Aabb", rename_all = "snake_case", deny_unknown_fields)]
enum Extent<S> {
    CenterHalfExtents { center: Vec3<S>, half_extents: Vec3<S> },
    MinMax { min: Vec3<S>, max: Vec3<S> },
}

/// The numbers of an oriented box, unchecked. Boxes that [`Obb::new`] accepts are written with
/// `axes`, others with `skewed_axes`; each variant is read through its own constructor.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Obb", rename_all = "snake_case", deny_unknown_fields)]
enum Oriented<S> {
    Axes { center: Vec3<S>, axes: [Vec3<S>; 3], half_extents: Vec3<S> },
    SkewedAxes { center: Vec3<S>, axes: [Vec3<S>; 3], half_extents: Vec3<S> },
}

/// The numbers of a plane, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Plane", rename_all = "snake_case", deny_unknown_fields)]
enum Position<S> {
    PointNormal { point: Vec3<S>, normal: Vec3<S> },
    Equation { normal: Vec3<S>, d: S },
}

/// The numbers of a segment, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Segment", rename_all = "snake_case", deny_unknown_fields)]
enum Course<S> {
    Ends(Vec3<S>, Vec3<S>),
    CenterHalfVector { center: Vec3<S>, half_vector: Vec3<S> },
}

/// The numbers of a ray, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Ray", deny_unknown_fields, bound(deserialize = "S: serde::Deserialize<'de>"))]
struct Path<S> {
    origin: Vec3<S>,
    direction: Vec3<S>,
    // An unbounded end must be written as `null`; a derived `Option` could be left out.
    #[serde(deserialize_with = "Option::deserialize")]
    t_min: Option<S>,
    #[serde(deserialize_with = "Option::deserialize")]
    t_max: Option<S>,
}

/// The numbers of a sphere, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Sphere", deny_unknown_fields)]
struct Ball<S> {
    center: Vec3<S>,
    radius: S,
}

/// The numbers of a capsule, unchecked.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Capsule", deny_unknown_fields)]
struct Pill<S> {
    a: Vec3<S>,
    b: Vec3<S>,
    radius: S,
}

impl<S: Scalar> From<&Triangle<S>> for Vertices<S> {
    fn from(t: &Triangle<S>) -> Self {
        Self(*t.vertices())
    }
}

impl<S: Scalar> TryFrom<Vertices<S>> for Triangle<S> {
    type Error = ShapeError;
    fn try_from(Vertices([a, b, c]): Vertices<S>) -> Result<Self, ShapeError> {
        Self::new(a, b, c)
    }
}

impl<S: Scalar> From<&Aabb<S>> for Extent<S> {
    fn from(aabb: &Aabb<S>) -> Self {
        match *aabb.form() {
            AabbForm::Center { center, half } => {
                Self::CenterHalfExtents { center, half_extents: half }
            }
            AabbForm::Corners { min, max } => Self::MinMax { min, max },
        }
    }
}

impl<S: Scalar> TryFrom<Extent<S>> for Aabb<S> {
    type Error = ShapeError;
    fn try_from(extent: Extent<S>) -> Result<Self, ShapeError> {
        match extent {
            Extent::CenterHalfExtents { center, half_extents } => {
                Self::from_center_half_extents(center, half_extents)
            }
            Extent::MinMax { min, max } => Self::from_min_max(min, max),
        }
    }
}

impl<S: Scalar> From<&Obb<S>> for Oriented<S> {
    fn from(obb: &Obb<S>) -> Self {
        let (center, axes, half_extents) = (obb.center(), *obb.axes(), obb.half_extents());
        if obb.is_orthonormal() {
            Self::Axes { center, axes, half_extents }
        } else {
            Self::SkewedAxes { center, axes, half_extents }
        }
    }
}

impl<S: Scalar> TryFrom<Oriented<S>> for Obb<S> {
    type Error = ShapeError;
    fn try_from(oriented: Oriented<S>) -> Result<Self, ShapeError> {
        match oriented {
            Oriented::Axes { center, axes, half_extents } => Self::new(center, axes, half_extents),
            Oriented::SkewedAxes { center, axes, half_extents } => {
                Self::from_skewed_axes(center, axes, half_extents)
            }
        }
    }
}

impl<S: Scalar> From<&Plane<S>> for Position<S> {
    fn from(plane: &Plane<S>) -> Self {
        let normal = plane.normal();
        match *plane.form() {
            PlaneForm::Point(point) => Self::PointNormal { point, normal },
            PlaneForm::Offset(d) => Self::Equation { normal, d },
        }
    }
}

impl<S: Scalar> TryFrom<Position<S>> for Plane<S> {
    type Error = ShapeError;
    fn try_from(position: Position<S>) -> Result<Self, ShapeError> {
        match position {
            Position::PointNormal { point, normal } => Self::from_point_normal(point, normal),
            Position::Equation { normal, d } => Self::from_equation(normal, d),
        }
    }
}

impl<S: Scalar> From<&Segment<S>> for Course<S> {
    fn from(segment: &Segment<S>) -> Self {
        match *segment.form() {
            SegmentForm::Ends(a, b) => Self::Ends(a, b),
            SegmentForm::Center { center, half } => {
                Self::CenterHalfVector { center, half_vector: half }
            }
        }
    }
}

impl<S: Scalar> TryFrom<Course<S>> for Segment<S> {
    type Error = ShapeError;
    fn try_from(course: Course<S>) -> Result<Self, ShapeError> {
        match course {
            Course::Ends(a, b) => Self::new(a, b),
            Course::CenterHalfVector { center, half_vector } => {
                Self::from_center_half_vector(center, half_vector)
            }
        }
    }
}

impl<S: Scalar> From<&Ray<S>> for Path<S> {
    fn from(ray: &Ray<S>) -> Self {
        Self {
            origin: ray.origin(),
            direction: ray.direction(),
            t_min: ray.t_min(),
            t_max: ray.t_max(),
        }
    }
}

impl<S: Scalar> TryFrom<Path<S>> for Ray<S> {
    type Error = ShapeError;
    fn try_from(path: Path<S>) -> Result<Self, ShapeError> {
        Self::new(path.origin, path.direction)?.with_range(path.t_min, path.t_max)
    }
}

impl<S: Scalar> From<&Sphere<S>> for Ball<S> {
    fn from(sphere: &Sphere<S>) -> Self {
        Self { center: sphere.center(), radius: sphere.radius() }
    }
}

impl<S: Scalar> TryFrom<Ball<S>> for Sphere<S> {
    type Error = ShapeError;
    fn try_from(Ball { center, radius }: Ball<S>) -> Result<Self, ShapeError> {
        Self::new(center, radius)
    }
}

impl<S: Scalar> From<&Capsule<S>> for Pill<S> {
    fn from(capsule: &Capsule<S>) -> Self {
        let (a, b) = capsule.ends();
        Self { a, b, radius: capsule.radius() }
    }
}

impl<S: Scalar> TryFrom<Pill<S>> for Capsule<S> {
    type Error = ShapeError;
    fn try_from(Pill { a, b, radius }: Pill<S>) -> Result<Self, ShapeError> {
        Self::new(a, b, radius)
    }
}

macro_rules! through {
    ($($shape:ident => $form:ident;)*) => {$(
        impl<S: Scalar + Serialize> Serialize for $shape<S> {
            fn serialize<W: Serializer>(&self, to: W) -> Result<W::Ok, W::Error> {
                $form::from(self).serialize(to)
            }
        }

        impl<'de, S: Scalar + Deserialize<'de>> Deserialize<'de> for $shape<S> {
            fn deserialize<R: Deserializer<'de>>(from: R) -> Result<Self, R::Error> {
                $form::deserialize(from)?.try_into().map_err(R::Error::custom)
            }
        }
    )*};
}
through! {
    Triangle => Vertices;
    Aabb => Extent;
    Obb => Oriented;
    Plane => Position;
    Segment => Course;
    Ray => Path;
    Sphere => Ball;
    Capsule => Pill;
}

/// A mesh and its tree are written as the mesh alone: the tree follows from it.
#[cfg(feature = "alloc")]
mod owned {
    use alloc::vec::Vec;

    use super::{Deserialize, Deserializer, Error, Scalar, Serialize, Serializer, Vec3};
    use crate::mesh::{Index, OwnedTree};

    #[derive(serde::Serialize)]
    #[serde(rename = "OwnedTree")]
    struct Lent<'a, S, I> {
        vertices: &'a [Vec3<S>],
        triangles: &'a [[I; 3]],
    }

    #[derive(serde::Deserialize)]
    #[serde(rename = "OwnedTree", deny_unknown_fields)]
    struct Read<S, I> {
        vertices: Vec<Vec3<S>>,
        triangles: Vec<[I; 3]>,
    }

    impl<S: Scalar + Serialize, I: Index + Serialize> Serialize for OwnedTree<S, I> {
        fn serialize<W: Serializer>(&self, to: W) -> Result<W::Ok, W::Error> {
            let mesh = self.mesh();
            Lent { vertices: mesh.vertices(), triangles: mesh.triangles() }.serialize(to)
        }
    }

    impl<'de, S, I> Deserialize<'de> for OwnedTree<S, I>
    where
        S: Scalar + Deserialize<'de>,
        I: Index + Deserialize<'de>,
    {
        fn deserialize<R: Deserializer<'de>>(from: R) -> Result<Self, R::Error> {
            let Read { vertices, triangles } = Read::deserialize(from)?;
            Self::new(vertices, triangles).map_err(R::Error::custom)
        }
    }
}
