//! `serde`: every shape is written in the form in which it was given, and read through its checking
//! constructor. An extra or missing field is an error.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use crate::scalar::Scalar;
use crate::shape::{
    Aabb, AabbForm, Capsule, Obb, Plane, Ray, Segment, SegmentForm, ShapeError, Sphere, Triangle,
    Vec3,
};

/// The numbers of a shape, unchecked.
trait Form: Sized {
    type Shape;

    fn of(shape: &Self::Shape) -> Self;
    fn shape(self) -> Result<Self::Shape, ShapeError>;
}

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

impl<S: Scalar> Form for Vertices<S> {
    type Shape = Triangle<S>;

    fn of(t: &Triangle<S>) -> Self {
        Self(*t.vertices())
    }

    fn shape(self) -> Result<Triangle<S>, ShapeError> {
        let Self([a, b, c]) = self;
        Triangle::new(a, b, c)
    }
}

impl<S: Scalar> Form for Extent<S> {
    type Shape = Aabb<S>;

    fn of(aabb: &Aabb<S>) -> Self {
        match *aabb.form() {
            AabbForm::Center { center, half } => {
                Self::CenterHalfExtents { center, half_extents: half }
            }
            AabbForm::Corners { min, max } => Self::MinMax { min, max },
        }
    }

    fn shape(self) -> Result<Aabb<S>, ShapeError> {
        match self {
            Self::CenterHalfExtents { center, half_extents } => {
                Aabb::from_center_half_extents(center, half_extents)
            }
            Self::MinMax { min, max } => Aabb::from_min_max(min, max),
        }
    }
}

impl<S: Scalar> Form for Oriented<S> {
    type Shape = Obb<S>;

    fn of(obb: &Obb<S>) -> Self {
        let (center, axes, half_extents) = (obb.center(), *obb.axes(), obb.half_extents());
        if obb.is_orthonormal() {
            Self::Axes { center, axes, half_extents }
        } else {
            Self::SkewedAxes { center, axes, half_extents }
        }
    }

    fn shape(self) -> Result<Obb<S>, ShapeError> {
        match self {
            Self::Axes { center, axes, half_extents } => Obb::new(center, axes, half_extents),
            Self::SkewedAxes { center, axes, half_extents } => {
                Obb::from_skewed_axes(center, axes, half_extents)
            }
        }
    }
}

impl<S: Scalar> Form for Position<S> {
    type Shape = Plane<S>;

    fn of(plane: &Plane<S>) -> Self {
        let normal = plane.normal();
        match plane.point() {
            Some(point) => Self::PointNormal { point, normal },
            None => Self::Equation { normal, d: plane.numbers().1 },
        }
    }

    fn shape(self) -> Result<Plane<S>, ShapeError> {
        match self {
            Self::PointNormal { point, normal } => Plane::from_point_normal(point, normal),
            Self::Equation { normal, d } => Plane::from_equation(normal, d),
        }
    }
}

impl<S: Scalar> Form for Course<S> {
    type Shape = Segment<S>;

    fn of(segment: &Segment<S>) -> Self {
        match *segment.form() {
            SegmentForm::Ends(a, b) => Self::Ends(a, b),
            SegmentForm::Center { center, half } => {
                Self::CenterHalfVector { center, half_vector: half }
            }
        }
    }

    fn shape(self) -> Result<Segment<S>, ShapeError> {
        match self {
            Self::Ends(a, b) => Segment::new(a, b),
            Self::CenterHalfVector { center, half_vector } => {
                Segment::from_center_half_vector(center, half_vector)
            }
        }
    }
}

impl<S: Scalar> Form for Path<S> {
    type Shape = Ray<S>;

    fn of(ray: &Ray<S>) -> Self {
        Self {
            origin: ray.origin(),
            direction: ray.direction(),
            t_min: ray.t_min(),
            t_max: ray.t_max(),
        }
    }

    fn shape(self) -> Result<Ray<S>, ShapeError> {
        Ray::new(self.origin, self.direction)?.with_range(self.t_min, self.t_max)
    }
}

impl<S: Scalar> Form for Ball<S> {
    type Shape = Sphere<S>;

    fn of(sphere: &Sphere<S>) -> Self {
        Self { center: sphere.center(), radius: sphere.radius() }
    }

    fn shape(self) -> Result<Sphere<S>, ShapeError> {
        let Self { center, radius } = self;
        Sphere::new(center, radius)
    }
}

impl<S: Scalar> Form for Pill<S> {
    type Shape = Capsule<S>;

    fn of(capsule: &Capsule<S>) -> Self {
        let (a, b) = capsule.ends();
        Self { a, b, radius: capsule.radius() }
    }

    fn shape(self) -> Result<Capsule<S>, ShapeError> {
        let Self { a, b, radius } = self;
        Capsule::new(a, b, radius)
    }
}

macro_rules! through {
    ($($shape:ident => $form:ident;)*) => {$(
        impl<S: Scalar + Serialize> Serialize for $shape<S> {
            fn serialize<W: Serializer>(&self, to: W) -> Result<W::Ok, W::Error> {
                $form::of(self).serialize(to)
            }
        }

        impl<'de, S: Scalar + Deserialize<'de>> Deserialize<'de> for $shape<S> {
            fn deserialize<R: Deserializer<'de>>(from: R) -> Result<Self, R::Error> {
                $form::deserialize(from)?.shape().map_err(R::Error::custom)
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

    #[derive(serde::Serialize, serde::Deserialize)]
    #[serde(rename = "OwnedTree", deny_unknown_fields)]
    struct Parts<V, T> {
        vertices: V,
        triangles: T,
    }

    impl<S: Scalar + Serialize, I: Index + Serialize> Serialize for OwnedTree<S, I> {
        fn serialize<W: Serializer>(&self, to: W) -> Result<W::Ok, W::Error> {
            let mesh = self.mesh();
            Parts { vertices: mesh.vertices(), triangles: mesh.triangles() }.serialize(to)
        }
    }

    impl<'de, S, I> Deserialize<'de> for OwnedTree<S, I>
    where
        S: Scalar + Deserialize<'de>,
        I: Index + Deserialize<'de>,
    {
        fn deserialize<R: Deserializer<'de>>(from: R) -> Result<Self, R::Error> {
            let Parts { vertices, triangles } = Parts::<Vec<Vec3<S>>, Vec<_>>::deserialize(from)?;
            Self::new(vertices, triangles).map_err(R::Error::custom)
        }
    }
}
