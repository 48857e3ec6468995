//! The functions in `benches/native/`, behind safe types.

#![allow(unsafe_code)]

use std::ffi::c_void;

use septum::mesh::Mesh;
use septum::{Obb, Vec3};

pub(super) type Pointer = *mut c_void;

// Each reads what its pointers point to and keeps no pointer; those named `new` return a value to
// be freed once, and those named `free` free it.
unsafe extern "C" {
    fn jolt_boxes_overlap(first: *const JoltBox, second: *const JoltBox) -> bool;
    fn jolt_ray_triangle(ray: *const [f32; 4], triangle: *const [f32; 4]) -> f32;
    fn bullet_new(numbers: *const f32) -> Pointer;
    fn bullet_free(this: Pointer);
    fn bullet_contact(first: Pointer, second: Pointer) -> f32;
    fn embree_new(
        vertices: *const f32,
        vertex_count: usize,
        triangles: *const u32,
        triangle_count: usize,
        is_robust: bool,
    ) -> Pointer;
    fn embree_free(this: Pointer);
    fn embree_first_hit(this: Pointer, ray: *const f32) -> bool;
    fn embree_any_hit(this: Pointer, ray: *const f32) -> bool;
    fn tinybvh_new(triangles: *const f32, count: usize) -> Pointer;
    fn tinybvh_free(this: Pointer);
    fn tinybvh_ray_new(ray: *const f32) -> Pointer;
    fn tinybvh_ray_free(this: Pointer);
    fn tinybvh_first_hit(this: Pointer, ray: Pointer) -> bool;
    fn tinybvh_any_hit(this: Pointer, ray: Pointer) -> bool;
}

/// A value of the other side, freed with this one.
pub(super) struct Owned(pub(super) Pointer, pub(super) unsafe extern "C" fn(Pointer));

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: from the `new` that belongs to this `free`, and only here is it freed.
        unsafe { (self.1)(self.0) }
    }
}

/// Three numbers, and the last again, as Jolt's vectors have it.
fn vector(v: Vec3<f32>) -> [f32; 4] {
    [v.x, v.y, v.z, v.z]
}

/// Jolt's `OrientedBox`: the columns of a matrix, and the half-extents.
#[repr(C, align(16))]
pub struct JoltBox {
    columns: [[f32; 4]; 4],
    half: [f32; 4],
}

impl JoltBox {
    pub fn new(obb: &Obb<f32>) -> Self {
        let [u, v, w] = obb.axes().map(|u| [u.x, u.y, u.z, 0.0]);
        let c = obb.center();
        Self { columns: [u, v, w, [c.x, c.y, c.z, 1.0]], half: vector(obb.half_extents()) }
    }

    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        // SAFETY: both are laid out as the function reads them.
        unsafe { jolt_boxes_overlap(self, other) }
    }
}

/// Vectors of Jolt.
#[repr(C, align(16))]
pub struct JoltVectors<const N: usize>([[f32; 4]; N]);

impl<const N: usize> JoltVectors<N> {
    pub fn new(vectors: [Vec3<f32>; N]) -> Self {
        Self(vectors.map(vector))
    }
}

/// Jolt's `RayTriangle`.
#[inline]
pub fn jolt_t(ray: &JoltVectors<2>, triangle: &JoltVectors<3>) -> Option<f32> {
    // SAFETY: the function reads two vectors and three.
    let t = unsafe { jolt_ray_triangle(ray.0.as_ptr(), triangle.0.as_ptr()) };
    (t < f32::MAX).then_some(t)
}

/// Bullet's `btBoxShape` and its place.
pub struct BulletBox(Owned);

impl BulletBox {
    pub fn new(obb: &Obb<f32>) -> Self {
        let [u, v, w] = *obb.axes();
        let rows = [obb.center(), u, v, w, obb.half_extents()].map(Vec3::to_array);
        // SAFETY: the function reads fifteen numbers.
        Self(Owned(unsafe { bullet_new(rows.as_flattened().as_ptr()) }, bullet_free))
    }

    /// The depth of the deepest point, by `btBoxBoxDetector`.
    pub fn contact(&self, other: &Self) -> Option<f64> {
        // SAFETY: both are boxes.
        let depth = unsafe { bullet_contact(self.0.0, other.0.0) };
        (depth > f32::NEG_INFINITY).then_some(f64::from(depth))
    }
}

/// A scene of embree.
pub struct Embree(Owned);

impl Embree {
    pub fn new(mesh: &Mesh<'_, f32, u32>, is_robust: bool) -> Self {
        let vertices: Vec<_> = mesh.vertices().iter().map(|v| v.to_array()).collect();
        let triangles = mesh.triangles();
        let (v, t) = (vertices.as_flattened().as_ptr(), triangles.as_flattened().as_ptr());
        // SAFETY: three numbers to a vertex, three indices to a triangle.
        let scene = unsafe { embree_new(v, vertices.len(), t, triangles.len(), is_robust) };
        Self(Owned(scene, embree_free))
    }

    #[inline]
    pub fn first_hit(&self, ray: &[f32; 6]) -> bool {
        // SAFETY: a scene, and six numbers.
        unsafe { embree_first_hit(self.0.0, ray.as_ptr()) }
    }

    #[inline]
    pub fn any_hit(&self, ray: &[f32; 6]) -> bool {
        // SAFETY: as above.
        unsafe { embree_any_hit(self.0.0, ray.as_ptr()) }
    }
}

/// A tree of tinybvh, eight boxes to a node.
pub struct TinyTree(Owned);

/// A ray of tinybvh, with reciprocals.
pub struct TinyRay(Owned);

impl TinyRay {
    pub fn new(ray: &[f32; 6]) -> Self {
        // SAFETY: the function reads six numbers.
        Self(Owned(unsafe { tinybvh_ray_new(ray.as_ptr()) }, tinybvh_ray_free))
    }
}

impl TinyTree {
    pub fn new(mesh: &Mesh<'_, f32, u32>) -> Self {
        let corners = mesh.iter().flat_map(|t| t.vertices().map(Vec3::to_array));
        let numbers: Vec<f32> = corners.flatten().collect();
        // SAFETY: nine numbers to a triangle.
        let tree = unsafe { tinybvh_new(numbers.as_ptr(), numbers.len() / 9) };
        Self(Owned(tree, tinybvh_free))
    }

    #[inline]
    pub fn first_hit(&self, ray: &TinyRay) -> bool {
        // SAFETY: a tree and a ray.
        unsafe { tinybvh_first_hit(self.0.0, ray.0.0) }
    }

    #[inline]
    pub fn any_hit(&self, ray: &TinyRay) -> bool {
        // SAFETY: as above.
        unsafe { tinybvh_any_hit(self.0.0, ray.0.0) }
    }
}
