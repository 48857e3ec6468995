//! The functions for C. Each is written out, because cbindgen reads the source before macros are
//! expanded.

use septum::ShapeError;

use crate::number::{I8F8, I16F16, Number};
use crate::shapes::{Aabb, Answer, Hit, Obb, Ray, Triangle};

fn triangle_aabb<T: Number>(triangle: Option<&Triangle<T>>, aabb: Option<&Aabb<T>>) -> Answer {
    ask(triangle, aabb, |triangle, aabb| Ok(triangle.shape()?.overlaps(&aabb.shape()?)))
}

fn triangle_obb<T: Number>(triangle: Option<&Triangle<T>>, obb: Option<&Obb<T>>) -> Answer {
    ask(triangle, obb, |triangle, obb| Ok(triangle.shape()?.overlaps(&obb.shape()?)))
}

fn ray_aabb<T: Number>(ray: Option<&Ray<T>>, aabb: Option<&Aabb<T>>) -> Answer {
    ask(ray, aabb, |ray, aabb| Ok(ray.shape()?.overlaps(&aabb.shape()?)))
}

fn ray_triangle<T: Number>(ray: Option<&Ray<T>>, triangle: Option<&Triangle<T>>) -> Answer {
    ask(ray, triangle, |ray, triangle| Ok(ray.shape()?.is_hit(&triangle.shape()?)))
}

fn ray_triangle_hit<T: Number>(
    ray: Option<&Ray<T>>,
    triangle: Option<&Triangle<T>>,
    hit: Option<&mut Hit<T>>,
) -> Answer {
    let Some(place) = hit else { return Answer::NullPointer };
    ask(ray, triangle, |ray, triangle| {
        let hit = ray.shape()?.hit(&triangle.shape()?);
        if let Some(hit) = hit {
            *place = hit.into();
        }
        Ok(hit.is_some())
    })
}

fn ask<A, B>(
    a: Option<&A>,
    b: Option<&B>,
    question: impl FnOnce(&A, &B) -> Result<bool, ShapeError>,
) -> Answer {
    let (Some(a), Some(b)) = (a, b) else { return Answer::NullPointer };
    question(a, b).map_or_else(Answer::from, Answer::from)
}

/// Whether a triangle overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    triangle_aabb(triangle, aabb)
}

/// Whether a triangle overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_i16f16(
    triangle: Option<&Triangle<I16F16>>,
    aabb: Option<&Aabb<I16F16>>,
) -> Answer {
    triangle_aabb(triangle, aabb)
}

/// Whether a triangle overlaps an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_aabb_f32(
    triangle: Option<&Triangle<f32>>,
    aabb: Option<&Aabb<f32>>,
) -> Answer {
    triangle_aabb(triangle, aabb)
}

/// Whether a triangle overlaps an oriented box, exactly for the numbers given.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_obb_i8f8(
    triangle: Option<&Triangle<I8F8>>,
    obb: Option<&Obb<I8F8>>,
) -> Answer {
    triangle_obb(triangle, obb)
}

/// Whether a triangle overlaps an oriented box, exactly for the numbers given.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_obb_i16f16(
    triangle: Option<&Triangle<I16F16>>,
    obb: Option<&Obb<I16F16>>,
) -> Answer {
    triangle_obb(triangle, obb)
}

/// Whether a triangle overlaps an oriented box, exactly for the numbers given.
#[unsafe(no_mangle)]
pub extern "C" fn septum_triangle_obb_f32(
    triangle: Option<&Triangle<f32>>,
    obb: Option<&Obb<f32>>,
) -> Answer {
    triangle_obb(triangle, obb)
}

/// Whether a ray meets an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_aabb_i8f8(
    ray: Option<&Ray<I8F8>>,
    aabb: Option<&Aabb<I8F8>>,
) -> Answer {
    ray_aabb(ray, aabb)
}

/// Whether a ray meets an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_aabb_i16f16(
    ray: Option<&Ray<I16F16>>,
    aabb: Option<&Aabb<I16F16>>,
) -> Answer {
    ray_aabb(ray, aabb)
}

/// Whether a ray meets an axis-aligned box, exactly.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_aabb_f32(ray: Option<&Ray<f32>>, aabb: Option<&Aabb<f32>>) -> Answer {
    ray_aabb(ray, aabb)
}

/// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_i8f8(
    ray: Option<&Ray<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
) -> Answer {
    ray_triangle(ray, triangle)
}

/// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_i16f16(
    ray: Option<&Ray<I16F16>>,
    triangle: Option<&Triangle<I16F16>>,
) -> Answer {
    ray_triangle(ray, triangle)
}

/// Whether a ray hits a triangle, exactly. A degenerate triangle is never hit.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_f32(
    ray: Option<&Ray<f32>>,
    triangle: Option<&Triangle<f32>>,
) -> Answer {
    ray_triangle(ray, triangle)
}

/// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
/// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_hit_i8f8(
    ray: Option<&Ray<I8F8>>,
    triangle: Option<&Triangle<I8F8>>,
    hit: Option<&mut Hit<I8F8>>,
) -> Answer {
    ray_triangle_hit(ray, triangle, hit)
}

/// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
/// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_hit_i16f16(
    ray: Option<&Ray<I16F16>>,
    triangle: Option<&Triangle<I16F16>>,
    hit: Option<&mut Hit<I16F16>>,
) -> Answer {
    ray_triangle_hit(ray, triangle, hit)
}

/// Finds where a ray hits a triangle, and writes `hit` only if the answer is yes. The verdict is
/// exact; t, u and v are rounded to the nearest in fixed point, and within 2 ulp in `float`.
#[unsafe(no_mangle)]
pub extern "C" fn septum_ray_triangle_hit_f32(
    ray: Option<&Ray<f32>>,
    triangle: Option<&Triangle<f32>>,
    hit: Option<&mut Hit<f32>>,
) -> Answer {
    ray_triangle_hit(ray, triangle, hit)
}
