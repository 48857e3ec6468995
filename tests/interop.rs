//! Shapes survive a round trip through `serde` and `mint`, and what is read is
//! checked as what is made.
#![cfg(all(feature = "serde", feature = "mint"))]

use std::fmt::Debug;

use fixed::types::I16F16;
use septum::{Aabb, Obb, Plane, Ray, Segment, Triangle, Vec3};
use serde::{Serialize, de::DeserializeOwned};

fn survives<T: Serialize + DeserializeOwned + PartialEq + Debug>(shape: &T) {
    let text = serde_json::to_string(shape).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), shape, "{text}");
}

#[test]
fn shapes_round_trip_in_the_form_given() {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0]].map(Vec3::from);
    survives(&Triangle::new([0.1, 0.2, 0.3], [1e-40, 2.0, 3.0], [-0.0, 5.0, 1e300]).unwrap());
    survives(&Aabb::from_min_max([0.1_f32; 3], [0.7; 3]).unwrap());
    survives(&Aabb::from_center_half_extents([0.1_f32; 3], [0.7; 3]).unwrap());
    survives(&Obb::from_skewed_axes([0.5; 3], axes, [1.0, 2.0, 0.0]).unwrap());
    survives(&Plane::from_equation([0.0, 0.0, 2.0], -0.5).unwrap());
    survives(&Plane::from_point_normal([0.0, 0.1, 2.0], [3.0, 0.0, 0.0]).unwrap());
    survives(&Segment::new([0.1, 0.2, 0.3], [-0.0, 5.0, 1e300]).unwrap());
    survives(&Segment::from_center_half_vector([0.1_f32; 3], [-0.7; 3]).unwrap());
    let ray = Ray::new([0.1, 0.2, 0.3], [0.0, 1e-300, 3.0]).unwrap();
    survives(&ray);
    survives(&ray.with_range(None, 0.7).unwrap());
    let fx = |x: f64| [I16F16::from_num(x), I16F16::MIN, I16F16::MAX];
    survives(&Triangle::new(fx(0.1), fx(2.0), fx(-3.5)).unwrap());
}

#[test]
fn what_is_read_is_checked() {
    let flipped = r#"{"min_max":{"min":{"x":1,"y":0,"z":0},"max":{"x":0,"y":1,"z":1}}}"#;
    let error = serde_json::from_str::<Aabb<f32>>(flipped).unwrap_err();
    assert!(error.to_string().contains("least corner lies above"), "{error}");

    let no_normal = r#"{"equation":{"normal":{"x":0,"y":0,"z":-0.0},"d":1}}"#;
    let error = serde_json::from_str::<Plane<f64>>(no_normal).unwrap_err();
    assert!(error.to_string().contains("normal is zero"), "{error}");

    let still = r#"{"origin":{"x":0,"y":0,"z":0},"direction":{"x":0,"y":-0.0,"z":0},
        "t_min":0,"t_max":null}"#;
    let error = serde_json::from_str::<Ray<f64>>(still).unwrap_err();
    assert!(error.to_string().contains("direction is zero"), "{error}");

    let flat = r#"{"center":{"x":0,"y":0,"z":0},"half_extents":{"x":1,"y":1,"z":1},
        "axes":[{"x":1,"y":0,"z":0},{"x":0,"y":1,"z":0},{"x":1,"y":1,"z":0}]}"#;
    let error = serde_json::from_str::<Obb<f64>>(flat).unwrap_err();
    assert!(error.to_string().contains("linearly dependent"), "{error}");
}

#[test]
fn mint_vectors_make_shapes() {
    let point = |x| mint::Point3 { x, y: 0.0, z: 1.0 };
    let t = Triangle::new(point(0.0), point(1.0), [0.0, 1.0, 1.0]).unwrap();
    let back: mint::Vector3<f64> = t.vertices()[1].into();
    assert_eq!(back, mint::Vector3 { x: 1.0, y: 0.0, z: 1.0 });
}
