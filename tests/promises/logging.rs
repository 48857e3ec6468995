//! Every public type can be logged by `defmt`, and its numbers are sent as numbers.
//!
//! `.ci/firmware` checks the text of a log on the targets: it compares the decoded log of an
//! example with the expected one.
#![cfg(all(feature = "defmt", feature = "heapless"))]

use defmt::Format;
use fixed::FixedI64;
use fixed::types::extra::U64;
use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::contact::{Contact, InteriorEdges, Part, Point, Translation, contact};
use septum::interop::Bounded;
use septum::lanes::{
    Aabbs, CellTriangle, Cells, Hits, NormalTriangles, Ranges, Rays, SlabRays, Triangles,
};
use septum::polygon::Polygon;
use septum::prepared::{HitRay, HitTriangle, PreparedRay, PreparedTriangle};
use septum::published::akenine_moller::Order;
use septum::published::projected::ProjectedTriangle;
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::sweep::{FirstContact, Motion, SphereContact};
use septum::{
    Aabb, Axis, Crossing, Cull, Facing, Feature, Hit, HitRules, Obb, Plane, Ray, Scalar, Segment,
    ShapeError, Side, Triangle, Vec3,
};
use septum_kit::Each;

/// The bytes of a log record; strings are one mocked index each.
fn record(x: &impl Format) -> Vec<u8> {
    defmt::export::fetch_bytes();
    defmt::export::fmt(x);
    defmt::export::fetch_bytes()
}

/// Whether the record contains these numbers, in this order.
fn carries<const L: usize>(x: &impl Format, numbers: impl IntoIterator<Item = [u8; L]>) {
    let record = record(x);
    let mut rest = record.as_slice();
    for number in numbers {
        let at = rest.windows(L).position(|w| w == number);
        rest = &rest[at.unwrap_or_else(|| panic!("{number:?} is not in {record:?}")) + L..];
    }
}

#[test]
fn fixed_point_numbers_go_out_as_floats() {
    let v = [1.5, -0.0625, 7.0];
    carries(&Vec3::from(v.each(I4F4::from_num)), v.each(|x| (x as f32).to_le_bytes()));
    carries(&Vec3::from(v.each(I8F8::from_num)), v.each(|x| (x as f32).to_le_bytes()));
    let v = [0.1, -32768.0, 3.75].each(I16F16::from_num);
    carries(&Vec3::from(v), v.each(|x| x.to_num::<f64>().to_le_bytes()));
    let v = [0.1, -2147483648.0, 1e-9].each(I32F32::from_num);
    carries(&Vec3::from(v), v.each(|x| x.to_num::<f64>().to_le_bytes()));
    let v = [FixedI64::<U64>::from_bits(1); 3];
    carries(&Vec3::from(v), [2_f64.powi(-64).to_le_bytes()]);
}

#[test]
fn floats_go_out_as_they_are() {
    let v = [0.1_f32, f32::NAN, -0.0];
    carries(&Vec3::from(v), v.each(f32::to_le_bytes));
    let v = [0.1_f64, f64::INFINITY, 5e-324];
    carries(&Vec3::from(v), v.each(f64::to_le_bytes));
}

#[test]
fn shapes_carry_all_their_numbers() {
    let n = |numbers: &[f32]| numbers.iter().map(|x| x.to_le_bytes()).collect::<Vec<_>>();
    let (p, q, r) = ([1.0_f32, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let all = |parts: &[[f32; 3]]| n(parts.as_flattened());
    carries(&Triangle::new(p, q, r).unwrap(), all(&[p, q, r]));
    carries(&Polygon::new(&[p, q, r, q].each(Vec3::from)).unwrap(), all(&[p, q, r, q]));
    carries(&Aabb::from_min_max(p, q).unwrap(), all(&[p, q]));
    carries(&Aabb::from_center_half_extents(p, q).unwrap(), all(&[p, q]));
    carries(
        &Obb::new(p, axes.each(Vec3::from), q).unwrap(),
        all(&[p, axes[0], axes[1], axes[2], q]),
    );
    carries(&Plane::from_point_normal(p, q).unwrap(), all(&[p, q]));
    carries(&Plane::from_equation(p, 9.0).unwrap(), n(&[1.0, 2.0, 3.0, 9.0]));
    carries(&Segment::new(p, q).unwrap(), all(&[p, q]));
    carries(&Segment::from_center_half_vector(p, q).unwrap(), all(&[p, q]));
    let ray = Ray::new(p, q).unwrap().with_range(8.0, 9.0).unwrap();
    carries(&ray, n(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 9.0]));
    let hit =
        Hit { t: 1.0_f32, u: 0.25, v: 0.5, facing: Facing::Front, feature: Feature::Interior };
    carries(&hit, n(&[1.0, 0.25, 0.5]));
    let unit = Aabb::from_min_max([0.0_f32; 3], [4.0; 3]).unwrap();
    let on_top = Aabb::from_min_max([0.5, 0.75, 3.75], [3.0, 3.0, 9.0]).unwrap();
    let found = contact(&on_top, &unit).unwrap();
    let of_point = [[0.5, 0.75, 3.75], [0.5, 0.75, 4.0]];
    carries(&found, [n(&[0.0, 0.0, 0.25, 0.25, 0.0, 0.0, 1.0]), all(&of_point)].concat());
    carries(&Motion::new(p, q).unwrap(), all(&[p, q]));
    carries(&FirstContact { t: 0.25_f32, axis: Some(Axis::Normal) }, n(&[0.25]));
    carries(&SphereContact { t: 0.25_f32, part: Some(Feature::Interior) }, n(&[0.25]));
}

#[test]
fn a_bounded_result_carries_what_it_kept_and_how_much_more() {
    let bounded: Bounded<u16, 2> = (7_u16..12).collect();
    assert_eq!((bounded.kept(), bounded.missed()), (&[7, 8][..], 3));
    carries(&bounded, [7_u16.to_le_bytes(), 8_u16.to_le_bytes()]);
    carries(&bounded, [3_u32.to_le_bytes()]);
}

/// Only compiled, not run.
#[test]
fn every_shape_and_answer_can_be_logged() {
    fn can<T: Format>() {}
    fn every<S: Scalar>() {
        can::<(Vec3<S>, Triangle<S>, Polygon<'_, S>, Aabb<S>, Obb<S>, Plane<S>, Segment<S>)>();
        can::<(Ray<S>, Hit<S>, PreparedRay<S>, SlabRay<S>, SlopeRay<S>, ShearedRay<S>)>();
        can::<(NormalTriangle<S>, ProjectedTriangle<S>, PreparedTriangle<S>)>();
        can::<(Triangles<S, 4>, NormalTriangles<S, 4>, Rays<S, 4>, Aabbs<S, 4>)>();
        can::<(Hits<S, 4>, Ranges<S, 4>, SlabRays<S, 4>)>();
        can::<(Cells<S, 4>, CellTriangle<S>)>();
        can::<(HitRay<S>, HitTriangle<S>)>();
        can::<(Translation<S>, Point<S>, Contact<S>)>();
        can::<(Motion<S>, FirstContact<S>, SphereContact<S, Feature>, Crossing<S>)>();
    }
    every::<f32>();
    every::<I16F16>();
    can::<(Axis, Side, Order, Facing, Feature, Cull, HitRules, ShapeError)>();
    can::<(septum::contact::Features, Part, InteriorEdges)>();
    can::<Bounded<u16, 8>>();
    can::<(septum::relation::Relation, septum::mesh::MeshError, septum::voxel::Row)>();
    can::<(septum::voxel::Rule, septum::voxel::GridError, septum::voxel::TooFewWords)>();
}
