//! `mint`: conversions from and to its interchange types for vectors.

use mint::{Point3, Vector3};

use crate::shape::Vec3;

impl<S> From<Vector3<S>> for Vec3<S> {
    fn from(v: Vector3<S>) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl<S> From<Point3<S>> for Vec3<S> {
    fn from(p: Point3<S>) -> Self {
        Self { x: p.x, y: p.y, z: p.z }
    }
}

impl<S> From<Vec3<S>> for Vector3<S> {
    fn from(v: Vec3<S>) -> Self {
        Self { x: v.x, y: v.y, z: v.z }
    }
}

impl<S> From<Vec3<S>> for Point3<S> {
    fn from(p: Vec3<S>) -> Self {
        Self { x: p.x, y: p.y, z: p.z }
    }
}

impl<S> mint::IntoMint for Vec3<S> {
    type MintType = Vector3<S>;
}
