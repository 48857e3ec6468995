//! What the tests and the accuracy example share: an oracle that reaches its
//! verdict by another theorem than the crate, and sets of cases, from a seed.

// Every test is a crate of its own and uses a part of this.
#![allow(dead_code, unused_imports, unused_macros)]

mod case;
mod flip;
mod lanes;
mod lattice;
mod normal;
mod oracle;
mod oriented;
mod plane;
mod projection;
pub(crate) mod rays;
mod rng;
mod scalar;
mod sets;
mod touch;

pub(crate) use case::{BoxNumbers, Case};
pub(crate) use lanes::Lanes;
pub(crate) use lattice::{Lattice, Ring, Shapes, odd_mantissa};
pub(crate) use normal::{Points, compare_with_unit, is_nearest_to_unit, normal_of};
pub(crate) use oracle::{is_collinear, meets};
pub(crate) use oriented::Oriented;
pub(crate) use plane::{Given, side};
pub(crate) use projection::separates;
pub(crate) use rng::Rng;
pub(crate) use scalar::Sample;
pub(crate) use sets::Set;
pub(crate) use touch::Touch;

/// Runs generic checks as one test for each scalar.
macro_rules! for_every_scalar {
    ($($check:ident),* $(,)?) => {$(
        mod $check {
            #[test]
            fn f32() {
                super::$check::<f32>();
            }
            #[test]
            fn f64() {
                super::$check::<f64>();
            }
            #[test]
            fn i4f4() {
                super::$check::<fixed::types::I4F4>();
            }
            #[test]
            fn i8f8() {
                super::$check::<fixed::types::I8F8>();
            }
            #[test]
            fn i16f16() {
                super::$check::<fixed::types::I16F16>();
            }
            #[test]
            fn i32f32() {
                super::$check::<fixed::types::I32F32>();
            }
        }
    )*};
}
pub(crate) use for_every_scalar;
