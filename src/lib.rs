//! Exact overlap and ray queries for triangles and boxes.
//!
//! septum answers whether a triangle meets a box, where a ray hits a triangle, and related
//! questions about segments, planes, oriented boxes and whole meshes. Its answers are exact for
//! every valid input, in `f32`, `f64` and the signed types of the [`fixed`] crate of up to 64 bits.
//! It uses no epsilon, no allocator and no `std`, and it gives the same bits on every machine.
//!
//! ```
//! use septum::{Aabb, Triangle};
//!
//! let cell = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])?;
//! let t = Triangle::new([0.0, 3.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0])?;
//! assert!(t.overlaps(&cell)); // touches the corner (1, 1, 1), and touching is overlap
//!
//! let off = Triangle::new([0.0, 3.0000000000000004, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0])?;
//! assert!(!off.overlaps(&cell)); // one unit in the last place farther off
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
#![cfg_attr(feature = "fixed", doc = "```")]
#![cfg_attr(not(feature = "fixed"), doc = "```ignore")]
//! use fixed::types::I16F16;
//! use septum::{Feature, Ray, Triangle};
//!
//! let at = |p: [f32; 3]| p.map(I16F16::from_num);
//! let ray = Ray::new(at([0.5, 0.5, 3.0]), at([0.0, 0.0, -2.0]))?;
//! let t = Triangle::new(at([0.0; 3]), at([1.0, 0.0, 0.0]), at([0.0, 1.0, 0.0]))?;
//! let hit = ray.hit(&t).unwrap();
//! assert_eq!(hit.t, I16F16::from_num(1.5)); // in units of the direction
//! assert_eq!(hit.feature, Feature::Edge(1)); // in the middle of the long edge
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! # Which query
//!
//! Each link in the second column leads to the geometry, numerics, range and cost of that pair. All
//! shapes are closed sets: touching is overlap. For generic code, the trait [`Overlaps`] has
//! `overlaps` and `may_overlap`; both take the shapes in either order.
//!
//! | question | exact | never misses |
//! | --- | --- | --- |
//! | triangle, axis-aligned box | [`overlaps`][triangle-aabb] | [`may_overlap`][triangle-aabb] |
//! | triangle, oriented box | [`overlaps`][triangle-obb] | [`may_overlap`][triangle-obb] |
//! | polygon, box | [`overlaps`][polygon-aabb] | the same |
//! | triangle, triangle | [`overlaps`][triangle-triangle] | [`may_overlap`][triangle-triangle] |
//! | segment, triangle | [`overlaps`][segment-triangle] | [`may_overlap`][segment-triangle] |
//! | box, box | [`overlaps`][aabb-aabb] | the same |
//! | box or oriented box, oriented box | [`overlaps`][obb-obb] | [`may_overlap`][obb-obb] |
//! | plane, box | [`overlaps`][plane-aabb], [`side_of`](Plane::side_of) | the same |
//! | segment, box | [`overlaps`][segment-aabb] | [`may_overlap`][segment-aabb] |
//! | ray, box | [`overlaps`][ray-aabb], [`t_range`](Ray::t_range), [`crossings`](Ray::crossings) | [`may_overlap`][ray-aabb] |
//! | ray or segment, oriented box | [`overlaps`][ray-obb], [`t_range_obb`](Ray::t_range_obb), [`crossings_obb`](Ray::crossings_obb) | [`may_overlap`][ray-obb] |
//! | ray, sphere or capsule | [`overlaps`][sphere-ray], [`t_range_sphere`](Ray::t_range_sphere), [`t_range_capsule`](Ray::t_range_capsule) | the same |
//! | triangle, many boxes | [`PreparedTriangle::overlaps`](prepared::PreparedTriangle::overlaps) | |
//! | many rays, many triangles | [`HitRay::hit`](prepared::HitRay::hit), [`HitRay::is_hit`](prepared::HitRay::is_hit) | |
//! | ray, many boxes | [`PreparedRay::overlaps`](prepared::PreparedRay::overlaps) | [`SlabRay::may_overlap`](published::slabs::SlabRay::may_overlap) |
//! | point, box or triangle | [`Aabb::contains`], [`Obb::contains`], [`Triangle::contains`] | |
//! | sphere or capsule; a distance compared with a number | [`overlaps`][sphere-triangle], [`contains`](Sphere::contains); [`overlaps`][capsule-triangle], [`contains`](Capsule::contains) | the same |
//! | closest point, squared distance | [`Triangle::closest_point`], [`Triangle::distance_squared`], the same of [`Segment`] and [`Aabb`]; of a mesh [`closest_point`](mesh::Tree::closest_point) | |
//! | ray, triangle | [`hit`](Ray::hit), [`is_hit`](Ray::is_hit), [`hit_once`](Ray::hit_once), [`hit_with`](Ray::hit_with); [`compare_hits`](Ray::compare_hits) | |
//! | ray, many triangles | [`lanes::Triangles::hit`] | |
//! | mesh and shape (sphere, capsule: all within a distance), ray or second mesh (BVH) | [`overlapping`](mesh::Tree::overlapping), [`first_hit`](mesh::Tree::first_hit), [`overlapping_pairs`](mesh::Tree::overlapping_pairs) | |
//! | point, closed mesh | [`contains`](mesh::Tree::contains), [`winding`](mesh::Tree::winding) | |
//! | two shapes: disjoint, touching or overlapping | [`relation`] | |
//! | shapes and meshes near the origin, with less code | [`near`] | |
//! | two shapes, spheres and capsules too: minimum translation (penetration depth), contact points | [`contact`] | |
//! | moving box, sphere or triangle: time of impact | [`meets_along`](sweep::Sweep::meets_along), [`first_contact`](sweep::Sweep::first_contact); on a mesh [`first_contact`](mesh::Tree::first_contact) | |
//! | the same: last place without overlap | [`last_free`](sweep::Sweep::last_free), [`relation_along`](sweep::Sweep::relation_along); on a mesh [`last_free`](mesh::Tree::last_free) | |
//! | many moving boxes: all pairs, and those near a box, a ray or a moving box | [`broad_phase`] | |
//! | triangle, grid of voxels | [`voxel::Grid::rows`], [`voxel::Bits::fill`]; interior of a mesh: [`voxel::Solid`] | |
//! | segment or ray, grid | [`voxel::Grid::walk_segment`], [`voxel::Grid::walk_ray`] | |
//! | triangle, box: the separating axis | [`separating_axis`](Triangle::separating_axis), [`is_separated_by`](Triangle::is_separated_by) | |
//! | one triangle | [`is_degenerate`](Triangle::is_degenerate), [`unit_normal`](Triangle#method.unit_normal) | |
//! | oriented box: its bounding box | | [`Obb::aabb`] |
//!
//! [triangle-aabb]: Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>
//! [triangle-obb]: Triangle#impl-Overlaps<Obb<S>>-for-Triangle<S>
//! [polygon-aabb]: polygon::Polygon#impl-Overlaps<Aabb<S>>-for-Polygon<'_,+S>
//! [triangle-triangle]: Triangle#impl-Overlaps<Triangle<S>>-for-Triangle<S>
//! [segment-triangle]: Segment#impl-Overlaps<Triangle<S>>-for-Segment<S>
//! [aabb-aabb]: Aabb#impl-Overlaps<Aabb<S>>-for-Aabb<S>
//! [obb-obb]: Obb#impl-Overlaps<Obb<S>>-for-Obb<S>
//! [plane-aabb]: Plane#impl-Overlaps<Aabb<S>>-for-Plane<S>
//! [segment-aabb]: Segment#impl-Overlaps<Aabb<S>>-for-Segment<S>
//! [capsule-triangle]: Capsule#impl-Overlaps<Triangle<S>>-for-Capsule<S>
//! [sphere-ray]: Sphere#impl-Overlaps<Ray<S>>-for-Sphere<S>
//! [sphere-triangle]: Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>
//! [ray-aabb]: Ray#impl-Overlaps<Aabb<S>>-for-Ray<S>
//! [ray-obb]: Ray#impl-Overlaps<Obb<S>>-for-Ray<S>
//!
//! [`published`] has the methods of the literature as published; these round, and sometimes
//! give a wrong answer. [`lanes`] holds queries about many shapes at once, and [`mesh`] has a
//! bounding-volume hierarchy for whole meshes.
//!
//! # Scalars and ranges
//!
//! An answer is exact over the whole range of a type; only the time depends on the input. The
//! table says which inputs the fast first stages decide, and which arithmetic decides the rest.
//! It is for axis-aligned boxes; oriented boxes have [their own limits][triangle-obb].
//!
//! | scalar | fast | elsewhere |
//! | --- | --- | --- |
//! | `f32` | spans of 2⁻³² to 2⁴⁰, not within rounding of contact | `f64`, integers |
//! | `f64` | spans of 2⁻³²⁰ to 2³²⁰, not within rounding of contact | integers |
//! | `FixedI8`, `FixedI16` | always | |
//! | `FixedI32` | coordinates below 2²⁸ units in the last place | wider integers; on 32-bit cores exact sums, except for triangle/box and ray/triangle |
//! | `FixedI64` | coordinates below 2⁶⁰ units in the last place | wider integers |
//!
//! A narrower fixed-point type is faster and takes less code. Triangles and oriented boxes in
//! fixed point share one first stage in 32-bit words, whatever the type.
//!
//! # Promises and limits
//!
//! * A constructor refuses invalid input with a [`ShapeError`]: NaN, infinities, a negative
//!   half-extent, a least corner above the greatest. A triangle may be a segment or a point, and
//!   a box may be flat.
//! * A query on a shape does not panic, and fixed point does not overflow.
//! * `may_overlap` may answer `true` for shapes a hair apart, never `false` for shapes that
//!   meet. For axis-aligned boxes in fixed point of up to 32 bits it is the exact test.
//! * t, u and v are rounded: [`Ray::hit`] gives the error in each scalar.
//! * Every machine, build and optimisation level gives the same bits. Floats must be IEEE 754
//!   with subnormals, which excludes x87 and machines that flush subnormals to zero.
//! * Time depends on the input. Exact sums take up to a thousand times as long as the first
//!   stage.
//! * `const_new` makes shapes for tables in flash: see [`Triangle::const_new`].
//!
//! # Features
//!
//! | feature | what it adds | default |
//! | --- | --- | --- |
//! | `fixed` | the signed types of the [`fixed`] crate of up to 64 bits as scalars | yes |
//! | `simd` | vector instructions for triangles, boxes and rays; no answer changes | yes |
//! | `alloc` | `mesh::OwnedTree`: a mesh and its tree in one value, to keep in a struct | no |
//! | `libm` | [`unit_normal`](Triangle#method.unit_normal) in floats, within 0.51 ulp in `f32` and 6 in `f64` | no |
//! | `micromath` | `unit_normal_fast` in `f32`: a few percent off, cheap without an FPU | no |
//! | `heapless` | `interop::Bounded` and `interop::touched`: results of bounded size | no |
//! | `defmt` | `defmt::Format` for every shape, answer and error | no |
//! | `mint` | conversions from and to the vectors of `mint` | no |
//! | `serde` | serialization; a shape is checked when it is read | no |
//! | `small` | smaller code: only the first and the last stage of each cascade; no answer changes | no |
//!
//! A program for a host that uses floats alone builds in less time without fixed point:
//! `default-features = false, features = ["simd"]`.
//!
//! The minimum Rust version is 1.85; with `heapless` 1.87; with `simd`, on machines with vector
//! instructions, 1.89.
//!
//! [`fixed`]: https://docs.rs/fixed
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![warn(missing_docs)]
// Without `fixed` no scalar uses the kernels in machine words.
#![cfg_attr(not(feature = "fixed"), allow(dead_code))]

#[cfg(feature = "alloc")]
extern crate alloc;

// The order of modules sets the order of methods on the shapes' pages: constructors, `overlaps`,
// exact queries, the rest; and on the page of `Tree`.
mod shape;

mod query;

pub mod mesh;

mod arithmetic;
pub mod broad_phase;
pub mod contact;
pub mod interop;
pub mod lanes;
pub mod near;
pub mod polygon {
    //! Polygons of three or more vertices, in the caller's memory, against boxes.
    //!
    //! ```
    //! use septum::polygon::Polygon;
    //! use septum::{Aabb, Vec3};
    //!
    //! let hexagon = [[2, 0, 0], [2, 2, 1], [1, 2, 2], [0, 1, 2], [0, 0, 1], [1, 0, 0]];
    //! let hexagon = hexagon.map(|p| Vec3::from(p.map(f64::from)));
    //! let polygon = Polygon::new(&hexagon)?;
    //! let cell = |x, y, z| Aabb::from_min_max([x, y, z], [x + 1.0, y + 1.0, z + 1.0]).unwrap();
    //! assert!(polygon.overlaps(&cell(0.0, 0.0, 1.0)));
    //! assert!(!polygon.overlaps(&cell(0.0, 1.0, 0.0)));
    //! # Ok::<(), septum::ShapeError>(())
    //! ```
    //! The test against an axis-aligned box is exact. For every other query, use the polygon's
    //! [`triangles`](Polygon::triangles).

    pub use crate::shape::Polygon;
}
pub mod prepared {
    //! Shapes prepared for many queries: the same exact answers, faster.
    //!
    //! [`PreparedRay`] is for one ray and many boxes, [`PreparedTriangle`] for one triangle and many
    //! boxes, [`HitRay`] and [`HitTriangle`] for many rays and many triangles.
    //!
    //! ```
    //! use septum::prepared::PreparedRay;
    //! use septum::{Aabb, Ray};
    //!
    //! let ray = PreparedRay::new(&Ray::new([-1.0_f32, 0.5, 0.5], [1.0, 0.0, 0.0])?);
    //! let cells: [_; 4] = core::array::from_fn(|k| {
    //!     let y = k as f32 * 0.25;
    //!     Aabb::from_min_max([0.0, y, 0.0], [1.0, y + 0.25, 1.0]).unwrap()
    //! });
    //! assert_eq!(cells.map(|cell| ray.overlaps(&cell)), [false, true, true, false]);
    //! # Ok::<(), septum::ShapeError>(())
    //! ```

    pub use crate::query::{HitRay, HitTriangle, PreparedRay, PreparedTriangle};
}
pub mod published;
#[cfg(test)]
mod random;
pub mod relation {
    //! Whether two shapes are disjoint, touch or overlap, exactly.
    //!
    //! [`overlaps`](crate::Overlaps::overlaps) is `true` for shapes that touch. [`Relate::relation`]
    //! also says whether their interiors meet.
    //!
    //! ```
    //! use septum::relation::{Relate, Relation};
    //! use septum::{Aabb, Triangle};
    //!
    //! let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    //! let on_top = Triangle::new([0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0])?;
    //! assert_eq!(on_top.relation(&cell), Relation::Touching);
    //! let next = Triangle::new([1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0])?;
    //! assert_eq!(on_top.relation(&next), Relation::Touching); // they share an edge
    //! let across = Triangle::new([0.5, 0.5, 0.0], [0.5, 0.5, 2.0], [2.0, 2.0, 2.0])?;
    //! assert_eq!(across.relation(&cell), Relation::Overlapping);
    //! # Ok::<(), septum::ShapeError>(())
    //! ```
    //!
    //! | pair | |
    //! | --- | --- |
    //! | triangle | triangle, segment, axis-aligned box, oriented box, sphere, capsule |
    //! | axis-aligned box | axis-aligned box, oriented box, triangle, sphere, capsule |
    //! | oriented box | oriented box, axis-aligned box, triangle |
    //! | segment | triangle, sphere, capsule |
    //! | sphere | sphere, capsule, triangle, segment, axis-aligned box, plane, ray |
    //! | capsule | capsule, sphere, triangle, segment, axis-aligned box, plane |
    //! | triangle [near](crate::near) the origin, in fixed point | axis-aligned box near the origin |

    pub use crate::query::{Relate, Relation};
}
mod robust;
mod scalar;
pub mod sweep;
pub mod voxel;

pub use query::{Axis, Closest, Crossing, Cull, Facing, Feature, HasAxes, Hit, HitRules, Side};
pub use scalar::Scalar;
pub use shape::{
    Aabb, Capsule, Obb, Overlaps, Plane, Ray, Segment, ShapeError, Sphere, Triangle, Vec3,
};

/// Tests the README's examples.
#[cfg(all(doctest, feature = "fixed"))]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
