//! The common parts of tests, fuzz targets and benches: oracles that reach their verdicts by other
//! theorems than the crate, and sets of cases from a seed.
//!
//! | what | oracle | cases |
//! | --- | --- | --- |
//! | triangle and box | [`meets`], [`separates`], [`is_collinear`] | [`Set`], [`Touch`], [`NearMiss`] |
//! | the same: touching or overlapping | [`contact::truth`] | |
//! | triangle and oriented box | [`Oriented::truth`] | [`Oriented::case`] |
//! | triangle, segment or point and triangle | [`flat::FlatCase::truth`] | [`flat::FlatSet`] |
//! | the segment of two triangles | [`flat::FlatCase::check_crossing`]: fractions | |
//! | box and oriented box | [`boxes::BoxCase::meets`] | [`boxes::BoxSet`] |
//! | two axis-aligned boxes, a box and a point | [`aabbs::AabbPair::truth`] | [`aabbs::AabbSet`] |
//! | shapes in each other | [`contacts::ContactCase::check`] | [`contacts::ContactSet`] |
//! | plane and box | [`side`] | |
//! | polygon and box | [`polygons::PolygonCase::meets`], [`polygons::PlanePolygon::meets`] | [`polygons::PolygonSet`] |
//! | line and box | [`lines::LineBox::clip`] | [`lines::LineSet`] |
//! | line and oriented box | [`lines::LineObb::clip`] | [`lines::LineObb::case`] |
//! | ray and triangle | [`rays::crossing`] | [`rays::RaySet`], [`rays::Scene`] |
//! | triangles in a grid | [`voxels::check`] | [`voxels::VoxelScene`] |
//! | triangle or box that moves past a box | [`sweeps::SweepCase::truth`] | [`sweeps::SweepSet`] |
//! | sphere that moves past a triangle or a box | [`spheres::SphereSweep::check`]: the way as a capsule | [`spheres::SphereSweep::of_set`] |
//! | sphere and other shapes | [`spheres::SphereCase::truth`]: Gram determinants | [`spheres::SphereSet`] |
//! | point and mesh | [`rays::winding`] | |
//! | ray and mesh, box that moves past a mesh | [`meshes::MeshRay::truth`] | [`meshes::MeshSet`] |
//! | unit normals | [`is_nearest_to_unit`] | |
//! | lanes | [`Lanes::check`]: one by one | |
//!
//! [`Sample`] is the trait of scalars in tests, and [`Rng`] the only random generator. Oracles
//! first split numbers into mantissa and exponent ([`Parts`]), because code that is not generic is
//! compiled once.

#![cfg_attr(septum_narrow, allow(dead_code, reason = "what only grids need"))]

pub mod aabbs;
mod axes;
pub mod boxes;
mod case;
pub mod contact;
pub mod contacts;
mod exact;
pub mod flat;
mod flip;
mod grid;
#[cfg(feature = "jobs")]
pub mod jobs;
mod lanes;
mod lattice;
pub mod lines;
pub mod meshes;
mod near_miss;
mod normal;
mod oracle;
mod orders;
mod oriented;
mod plane;
pub mod polygons;
mod projection;
pub mod rays;
mod rng;
mod sample;
mod sets;
pub mod spheres;
pub mod sweeps;
mod touch;
// Not for the kernels of 32-bit registers, of which no test here asks grids.
#[cfg(not(septum_narrow))]
pub mod voxels;

pub use axes::{Each, three};
pub use case::{BoxNumbers, Case};
pub use exact::{Parts, compare_sums};
pub use grid::every_triangle_on_the_grid;
pub use lanes::Lanes;
pub use lattice::{Lattice, Ring, Shapes, odd_mantissa};
pub use near_miss::NearMiss;
pub use normal::{Points, compare_with_unit, is_nearest_to_unit, normal_of};
pub use oracle::{is_collinear, meets};
pub use orders::{GROUP_ORDERS, VERTEX_ORDERS, sorted_by_number};
pub use oriented::Oriented;
pub use plane::{Given, side};
pub use projection::separates;
pub use rng::Rng;
pub use sample::Sample;
pub use sets::Set;
pub use touch::Touch;

/// The error about an argument that is not finite.
pub fn not_finite(argument: &'static str, index: Option<usize>) -> septum::ShapeError {
    septum::ShapeError::NotFinite { argument, index }
}

/// Names the fixed-point types in [`for_every_scalar`] and [`with_every_scalar`].
#[doc(hidden)]
pub use fixed;

/// Runs generic checks as one test for each of the scalars, each with a name for its test:
/// `for_scalars!([f32: f32, i8f8: I8F8] one_check, another)`.
#[macro_export]
macro_rules! for_scalars {
    (@ $check:ident [$($name:ident: $scalar:ty),* $(,)?]) => {
        mod $check {
            $(
                #[test]
                fn $name() {
                    super::$check::<$scalar>();
                }
            )*
        }
    };
    ($scalars:tt $($check:ident),* $(,)?) => {
        $($crate::for_scalars!(@ $check $scalars);)*
    };
}

/// Runs generic checks as one test for each scalar.
#[macro_export]
macro_rules! for_every_scalar {
    ($($check:ident),* $(,)?) => {
        $crate::for_scalars!([
            f32: f32,
            f64: f64,
            i4f4: $crate::fixed::types::I4F4,
            i8f8: $crate::fixed::types::I8F8,
            i16f16: $crate::fixed::types::I16F16,
            i32f32: $crate::fixed::types::I32F32,
        ] $($check),*);
    };
}

/// Calls a generic function for each scalar in turn.
#[macro_export]
macro_rules! with_every_scalar {
    ($call:ident) => {
        $call::<f32>();
        $call::<f64>();
        $call::<$crate::fixed::types::I4F4>();
        $call::<$crate::fixed::types::I8F8>();
        $call::<$crate::fixed::types::I16F16>();
        $call::<$crate::fixed::types::I32F32>();
    };
}

/// Tests the examples of docs/ in the repository, which the published crate does not contain.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../../../docs/getting-started.md")]
    struct GettingStarted;
    #[doc = include_str!("../../../docs/motion-and-contact.md")]
    struct MotionAndContact;
    #[doc = include_str!("../../../docs/voxels.md")]
    struct Voxels;
}
