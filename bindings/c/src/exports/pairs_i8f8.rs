//! Questions about two shapes, in `I8F8`. tests/header.rs makes the files of the other types from
//! this one, because cbindgen reads the source before macros are expanded.
#[allow(unused_imports, reason = "floats need no name")]
use crate::number::*;
use crate::queries;
use crate::shapes::{
    Aabb, Answer, Capsule, Closest, Contact, FirstContact, Hit, Obb, Range, Ray, Sphere,
    SphereContact, Triangle,
};

/// Whether a triangle overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    queries::triangle_aabb(triangle, aabb)
}

/// Whether a triangle overlaps an oriented box, exactly for the numbers given.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_obb_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    obb: Option<&Obb<I8F8>>,
) -> Answer {
    queries::triangle_obb(triangle, obb)
}

/// Whether two triangles overlap, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_triangle_i8f8(
    first: Option<&Triangle<I8F8>>,
    second: Option<&Triangle<I8F8>>,
) -> Answer {
    queries::triangle_triangle(first, second)
}

/// Whether a sphere overlaps a triangle, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_triangle_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
) -> Answer {
    queries::sphere_triangle(sphere, triangle)
}

/// Whether a sphere overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_aabb_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    queries::sphere_aabb(sphere, aabb)
}

/// Whether a capsule overlaps a triangle, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_triangle_i8f8(
    capsule: Option<&Capsule<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
) -> Answer {
    queries::capsule_triangle(capsule, triangle)
}

/// Whether a capsule overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_aabb_i8f8(
    capsule: Option<&Capsule<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    queries::capsule_aabb(capsule, aabb)
}

/// Writes the point of a triangle closest to a point, each coordinate rounded once: yes, or the
/// error.
///
/// # Safety
/// `point` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_triangle_closest_point_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    point: *const I8F8,
    closest: Option<&mut Closest<I8F8>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let point = unsafe { point.cast::<[I8F8; 3]>().as_ref() };
    queries::triangle_closest_point(triangle, point, closest)
}

/// Whether a ray meets an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_aabb_i8f8(
    ray: Option<&Ray<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    queries::ray_aabb(ray, aabb)
}

/// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_i8f8(
    ray: Option<&Ray<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
) -> Answer {
    queries::ray_triangle(ray, triangle)
}

/// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
/// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in floats.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_hit_i8f8(
    ray: Option<&Ray<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
    hit: Option<&mut Hit<I8F8>>,
) -> Answer {
    queries::ray_triangle_hit(ray, triangle, hit)
}

/// When a box that moves by `motion` first meets a triangle; writes `first` only if the answer is
/// yes. The verdict is exact, and the time is never late.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_aabb_cast_triangle_i8f8(
    aabb: Option<&Aabb<I8F8>>,
    motion: *const I8F8,
    triangle: Option<&Triangle<I8F8>>,
    first: Option<&mut FirstContact<I8F8>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[I8F8; 3]>().as_ref() };
    queries::aabb_cast_triangle(aabb, motion, triangle, first)
}

/// The least translation that moves a triangle out of a box, and where they meet; writes `contact`
/// only if the answer is yes. Shapes that only touch have no contact.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_contact_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::triangle_aabb_contact(triangle, aabb, contact)
}

/// The same of two oriented boxes: of the first out of the second.
#[unsafe(no_mangle)]
pub extern "C" fn septum_obb_obb_contact_i8f8(
    first: Option<&Obb<I8F8>>,
    second: Option<&Obb<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::obb_obb_contact(first, second, contact)
}

/// The same of a sphere and a triangle: of the sphere out of the triangle, with one point.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_triangle_contact_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::sphere_triangle_contact(sphere, triangle, contact)
}

/// The same of a sphere and an axis-aligned box.
#[unsafe(no_mangle)]
pub extern "C" fn septum_sphere_aabb_contact_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::sphere_aabb_contact(sphere, aabb, contact)
}

/// The same of a capsule and a triangle.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_triangle_contact_i8f8(
    capsule: Option<&Capsule<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::capsule_triangle_contact(capsule, triangle, contact)
}

/// The same of a capsule and an axis-aligned box.
#[unsafe(no_mangle)]
pub extern "C" fn septum_capsule_aabb_contact_i8f8(
    capsule: Option<&Capsule<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
    contact: Option<&mut Contact<I8F8>>,
) -> Answer {
    queries::capsule_aabb_contact(capsule, aabb, contact)
}

/// When a sphere that moves by `motion` first meets a triangle; writes `first` only if the answer is
/// yes. The verdict is exact, and the time is never late.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_sphere_cast_triangle_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    motion: *const I8F8,
    triangle: Option<&Triangle<I8F8>>,
    first: Option<&mut SphereContact<I8F8>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[I8F8; 3]>().as_ref() };
    queries::sphere_cast_triangle(sphere, motion, triangle, first)
}

/// The same past an axis-aligned box.
///
/// # Safety
/// `motion` leads to three numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_sphere_cast_aabb_i8f8(
    sphere: Option<&Sphere<I8F8>>,
    motion: *const I8F8,
    aabb: Option<&Aabb<I8F8>>,
    first: Option<&mut SphereContact<I8F8>>,
) -> Answer {
    // SAFETY: as the caller promises.
    let motion = unsafe { motion.cast::<[I8F8; 3]>().as_ref() };
    queries::sphere_cast_aabb(sphere, motion, aabb, first)
}

/// Where a ray enters a sphere and leaves it; writes `range` only if the answer is yes. The verdict is
/// exact; both numbers are rounded outward.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_sphere_range_i8f8(
    ray: Option<&Ray<I8F8>>,
    sphere: Option<&Sphere<I8F8>>,
    range: Option<&mut Range<I8F8>>,
) -> Answer {
    queries::ray_sphere_range(ray, sphere, range)
}

/// Writes the axes of a box that is turned by a unit quaternion x, y, z, w. Its centre and its
/// half-extents must be set.
///
/// # Safety
/// `quaternion` leads to four numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn septum_obb_turn_i8f8(
    obb: Option<&mut Obb<I8F8>>,
    quaternion: *const I8F8,
) -> Answer {
    // SAFETY: as the caller promises.
    queries::obb_turn(obb, unsafe { quaternion.cast::<[I8F8; 4]>().as_ref() })
}
