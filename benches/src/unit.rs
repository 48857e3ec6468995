//! The scalars, and a scene's shapes in them.

use fixed::types::{I8F8, I16F16, I32F32};
use septum::{Aabb, Ray, Scalar, Segment, Triangle, Vec3};

use crate::geometry::{Cell, Line, Point};

/// A scalar, and the scale at which a scene is brought into it.
#[derive(Clone, Copy)]
pub struct Unit<S> {
    pub name: &'static str,
    pub scale: f64,
    /// Converts a number to the nearest scalar.
    pub near: fn(f64) -> S,
    /// Converts a scalar to `f64`, without rounding for all scalars used here.
    pub value: fn(S) -> f64,
}

pub const F32: Unit<f32> = Unit { name: "f32", scale: 1.0, near: |x| x as f32, value: f64::from };
pub const F64: Unit<f64> = Unit { name: "f64", scale: 1.0, near: |x| x, value: |x| x };

// The bits used by scenes that extend to 2.

pub const I8F8_15: Unit<I8F8> =
    Unit { name: "I8F8, 15 bits", scale: 32.0, near: I8F8::strict_from_num, value: I8F8::to_num };
pub const I16F16_18: Unit<I16F16> = Unit {
    name: "I16F16, 18 bits",
    scale: 1.0,
    near: I16F16::strict_from_num,
    value: I16F16::to_num,
};
pub const I16F16_26: Unit<I16F16> = Unit { name: "I16F16, 26 bits", scale: 256.0, ..I16F16_18 };
pub const I32F32_34: Unit<I32F32> = Unit {
    name: "I32F32, 34 bits",
    scale: 1.0,
    near: I32F32::strict_from_num,
    value: I32F32::to_num,
};

/// How a box is given.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Form {
    Center,
    Corners,
}

impl Form {
    pub const ALL: [Self; 2] = [Self::Center, Self::Corners];

    pub fn name(self) -> &'static str {
        match self {
            Self::Center => "centre",
            Self::Corners => "corners",
        }
    }
}

/// Rounding happens here, before any test or timing.
impl<S: Scalar> Unit<S> {
    pub fn point(&self, p: Point) -> [S; 3] {
        p.map(|x| (self.near)(x * self.scale))
    }

    pub fn triangle(&self, &[a, b, c]: &[Point; 3]) -> Triangle<S> {
        let vertices = (self.point(a), self.point(b), self.point(c));
        Triangle::new(vertices.0, vertices.1, vertices.2).expect("coordinates are finite")
    }

    pub fn aabb(&self, &Cell { center, half }: &Cell, form: Form) -> Aabb<S> {
        let corner = |sign: f64| self.point(std::array::from_fn(|i| center[i] + sign * half[i]));
        let aabb = match form {
            Form::Center => Aabb::from_center_half_extents(self.point(center), self.point(half)),
            Form::Corners => Aabb::from_min_max(corner(-1.0), corner(1.0)),
        };
        aabb.expect("cells are boxes")
    }

    pub fn ray(&self, line: &Line) -> Ray<S> {
        let (origin, direction) = (self.point(line.origin), self.point(line.direction));
        Ray::new(origin, direction).expect("directions are long enough for every scalar")
    }

    /// The points of the line with t from 0 to 1.
    pub fn segment(&self, line: &Line) -> Segment<S> {
        let half = line.direction.map(|x| x / 2.0);
        let center = std::array::from_fn(|i| line.origin[i] + half[i]);
        Segment::from_center_half_vector(self.point(center), self.point(half))
            .expect("coordinates are finite")
    }

    // The very same shapes in `f64`.

    fn wide(&self, p: Vec3<S>) -> [f64; 3] {
        p.to_array().map(self.value)
    }

    pub fn wide_triangle(&self, triangle: &Triangle<S>) -> Triangle<f64> {
        let [a, b, c] = triangle.vertices().map(|p| self.wide(p));
        Triangle::new(a, b, c).expect("coordinates are finite")
    }

    pub fn wide_aabb(&self, aabb: &Aabb<S>) -> Aabb<f64> {
        let wide = |p| self.wide(p);
        let wide = match (aabb.center_half_extents(), aabb.min_max()) {
            (Some((c, h)), _) => Aabb::from_center_half_extents(wide(c), wide(h)),
            (_, Some((min, max))) => Aabb::from_min_max(wide(min), wide(max)),
            _ => unreachable!("a box has one form or the other"),
        };
        wide.expect("cells are boxes")
    }

    pub fn wide_ray(&self, ray: &Ray<S>) -> Ray<f64> {
        Ray::new(self.wide(ray.origin()), self.wide(ray.direction())).expect("it was a ray before")
    }

    pub fn wide_segment(&self, segment: &Segment<S>) -> Segment<f64> {
        let (center, half) = segment.center_half_vector().expect("made so");
        Segment::from_center_half_vector(self.wide(center), self.wide(half))
            .expect("coordinates are finite")
    }
}
