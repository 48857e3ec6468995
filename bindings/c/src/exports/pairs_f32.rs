//! Questions about two shapes, in `float`. build.rs makes those of the other types from this file.

#[allow(unused_imports, reason = "floats need no name")]
use crate::number::*;
use crate::queries;
use crate::shapes::{
    Aabb, Answer, Capsule, Closest, Contact, FirstContact, Hit, Obb, Range, Ray, Sphere,
    SphereContact, Triangle,
};

/// Whether a triangle overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_f32(
    triangle: Option<&Triangle<f32>>,
    aabb: Option<&Aabb<f32>>,
) -> Answer {
    queries::overlaps(triangle, aabb)
}

/// Whether a triangle overlaps an oriented box, exactly for the numbers given.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_obb_f32(
    triangle: Option<&Triangle<f32>>,
    obb: Option<&Obb<f32>>,
) -> Answer {
    queries::overlaps(triangle, obb)
}

/// Whether two triangles overlap, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_triangle_f32(
    first: Option<&Triangle<f32>>,
    second: Option<&Triangle<f32>>,
) -> Answer {
    queries::overlaps(first, second)
}

/// Whether a sphere overlaps a triangle, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_triangle_f32(
    sphere: Option<&Sphere<f32>>,
    triangle: Option<&Triangle<f32>>,
) -> Answer {
    queries::overlaps(sphere, triangle)
}

/// Whether a sphere overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_aabb_f32(
    sphere: Option<&Sphere<f32>>,
    aabb: Option<&Aabb<f32>>,
) -> Answer {
    queries::overlaps(sphere, aabb)
}

/// Whether a capsule overlaps a triangle, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_triangle_f32(
    capsule: Option<&Capsule<f32>>,
    triangle: Option<&Triangle<f32>>,
) -> Answer {
    queries::overlaps(capsule, triangle)
}

/// Whether a capsule overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_aabb_f32(
    capsule: Option<&Capsule<f32>>,
    aabb: Option<&Aabb<f32>>,
) -> Answer {
    queries::overlaps(capsule, aabb)
}

/// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
/// error.
///
/// # Safety
/// `point` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_triangle_closest_point_f32(
    triangle: Option<&Triangle<f32>>,
    point: *const f32,
    closest: Option<&mut Closest<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let point = unsafe { point.cast::<[f32; 3]>().as_ref() };
    queries::triangle_closest_point(triangle, point, closest)
}

/// Whether a ray meets an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_aabb_f32(ray: Option<&Ray<f32>>, aabb: Option<&Aabb<f32>>) -> Answer {
    queries::overlaps(ray, aabb)
}

/// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_f32(
    ray: Option<&Ray<f32>>,
    triangle: Option<&Triangle<f32>>,
) -> Answer {
    queries::ray_triangle(ray, triangle)
}

/// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
/// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_hit_f32(
    ray: Option<&Ray<f32>>,
    triangle: Option<&Triangle<f32>>,
    hit: Option<&mut Hit<f32>>,
) -> Answer {
    queries::ray_triangle_hit(ray, triangle, hit)
}

/// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
/// yes. The verdict is exact, and the time is never late.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_aabb_cast_triangle_f32(
    aabb: Option<&Aabb<f32>>,
    motion: *const f32,
    triangle: Option<&Triangle<f32>>,
    first: Option<&mut FirstContact<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[f32; 3]>().as_ref() };
    queries::aabb_cast_triangle(aabb, motion, triangle, first)
}

/// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
/// only if the answer is yes. Shapes that only touch have no contact.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_contact_f32(
    triangle: Option<&Triangle<f32>>,
    aabb: Option<&Aabb<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(triangle, aabb, contact)
}

/// The same of two oriented boxes: of the first out of the second.
#[unsafe(no_mangle)]
pub extern "C" fn septum_obb_obb_contact_f32(
    first: Option<&Obb<f32>>,
    second: Option<&Obb<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(first, second, contact)
}

/// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_triangle_contact_f32(
    sphere: Option<&Sphere<f32>>,
    triangle: Option<&Triangle<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(sphere, triangle, contact)
}

/// The same of a sphere and an axis-aligned box.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_aabb_contact_f32(
    sphere: Option<&Sphere<f32>>,
    aabb: Option<&Aabb<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(sphere, aabb, contact)
}

/// The same of a capsule and a triangle.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_triangle_contact_f32(
    capsule: Option<&Capsule<f32>>,
    triangle: Option<&Triangle<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(capsule, triangle, contact)
}

/// The same of a capsule and an axis-aligned box.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_aabb_contact_f32(
    capsule: Option<&Capsule<f32>>,
    aabb: Option<&Aabb<f32>>,
    contact: Option<&mut Contact<f32>>,
) -> Answer {
    queries::contact(capsule, aabb, contact)
}

/// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
/// yes. The verdict is exact, and the time is never late.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_sphere_cast_triangle_f32(
    sphere: Option<&Sphere<f32>>,
    motion: *const f32,
    triangle: Option<&Triangle<f32>>,
    first: Option<&mut SphereContact<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[f32; 3]>().as_ref() };
    queries::sphere_cast(sphere, motion, triangle, first)
}

/// The same past an axis-aligned box.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_sphere_cast_aabb_f32(
    sphere: Option<&Sphere<f32>>,
    motion: *const f32,
    aabb: Option<&Aabb<f32>>,
    first: Option<&mut SphereContact<f32>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[f32; 3]>().as_ref() };
    queries::sphere_cast(sphere, motion, aabb, first)
}

/// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
/// exact; both numbers are rounded outward.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_sphere_range_f32(
    ray: Option<&Ray<f32>>,
    sphere: Option<&Sphere<f32>>,
    range: Option<&mut Range<f32>>,
) -> Answer {
    queries::ray_sphere_range(ray, sphere, range)
}

/// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
/// half-extents must be set.
///
/// # Safety
/// `quaternion` leads to four numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_obb_turn_f32(
    obb: Option<&mut Obb<f32>>,
    quaternion: *const f32,
) -> Answer {
    // SAFETY: as the caller promises.
    queries::obb_turn(obb, unsafe { quaternion.cast::<[f32; 4]>().as_ref() })
}
