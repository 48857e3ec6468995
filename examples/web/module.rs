//! The export of the module for a triangle and a box.
#![allow(unsafe_code, reason = "an export")]

use fixed::types::I8F8;
use septum::published;
use septum::{Aabb, Axis, Scalar, Triangle};

use crate::numbers::ask;

/// All answers about the numbers, which are a, b, c, centre and half-extents, as `f32` (0) or I8F8
/// (1):
///
/// | bits | |
/// | --- | --- |
/// | 0 | they are a triangle and a box; else nothing is set |
/// | 1 | `overlaps` |
/// | 2 | `overlaps_rounded` |
/// | 3, 4 | `may_overlap`, `overlaps_as_published`, in `f32` only |
/// | 5 to 8 | 1 + the number of `separating_axis` in `Axis::ALL`, or 0 |
/// | 16 to 28 | `is_separated_by`, for each of `Axis::ALL` |
#[unsafe(export_name = "answers")]
extern "C" fn answers(scalar: u32) -> u32 {
    match scalar {
        0 => about(f32::from_bits, |t, aabb| {
            [t.may_overlap(aabb), published::akenine_moller::overlaps(t, aabb)]
        }),
        _ => about(|bits| I8F8::from_bits(bits as i16), |_, _| [false; 2]),
    }
    .unwrap_or(0)
}

fn about<S: Scalar>(
    read: impl Fn(u32) -> S,
    more: impl Fn(&Triangle<S>, &Aabb<S>) -> [bool; 2],
) -> Option<u32> {
    let point = |k: usize| [0, 1, 2].map(|i| read(ask(3 * k + i)));
    let triangle = Triangle::new(point(0), point(1), point(2)).ok()?;
    let aabb = Aabb::from_center_half_extents(point(3), point(4)).ok()?;
    let [conservative, published] = more(&triangle, &aabb);
    let (exact, rounded) =
        (triangle.overlaps(&aabb), published::shared_normal::overlaps(&triangle, &aabb));
    let witness = triangle.separating_axis(&aabb);
    let number = Axis::ALL.iter().position(|&axis| Some(axis) == witness);
    Some(
        bits([true, exact, rounded, conservative, published])
            | number.map_or(0, |k| k as u32 + 1) << 5
            | bits(Axis::ALL.map(|axis| triangle.is_separated_by(&aabb, axis))) << 16,
    )
}

/// The first is the lowest.
fn bits<const N: usize>(all: [bool; N]) -> u32 {
    all.iter().rev().fold(0, |bits, &bit| bits << 1 | u32::from(bit))
}
