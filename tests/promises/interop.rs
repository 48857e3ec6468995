//! Shapes survive a round trip through `serde` and `mint`, and constructors check what is read.
#![cfg(all(feature = "serde", feature = "mint"))]

use septum_kit::Each;
use std::fmt::Debug;

use fixed::types::I16F16;
use septum::mesh::OwnedTree;
use septum::{Aabb, Obb, Plane, Ray, Segment, Triangle, Vec3};
use serde::{Serialize, de::DeserializeOwned};

fn survives<T: Serialize + DeserializeOwned + PartialEq + Debug>(shape: &T) {
    let text = serde_json::to_string(shape).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), shape, "{text}");
}

#[test]
fn shapes_round_trip_in_the_form_given() {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0]].each(Vec3::from);
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

    let flat = r#"{"skewed_axes":{"center":{"x":0,"y":0,"z":0},
        "half_extents":{"x":1,"y":1,"z":1},
        "axes":[{"x":1,"y":0,"z":0},{"x":0,"y":1,"z":0},{"x":1,"y":1,"z":0}]}}"#;
    let error = serde_json::from_str::<Obb<f64>>(flat).unwrap_err();
    assert!(error.to_string().contains("linearly dependent"), "{error}");
    let error = serde_json::from_str::<Obb<f64>>(&flat.replace("skewed_", "")).unwrap_err();
    assert!(error.to_string().contains("not orthonormal"), "{error}");
}

/// Rotations are read through `new`, parallelepipeds through `from_skewed_axes`.
#[test]
fn boxes_with_axes_say_which_they_are() {
    let axes = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let skewed = [[0.0, 1.0, 0.0], [-1.0, 0.5, 0.0], [0.0, 0.0, 1.0]];
    let text = |obb: Obb<f32>| serde_json::to_string(&obb).unwrap();
    let rotation = text(Obb::new([1.0; 3], axes, [2.0; 3]).unwrap());
    assert!(rotation.starts_with(r#"{"axes":{"#), "{rotation}");
    let skewed = text(Obb::from_skewed_axes([1.0; 3], skewed, [2.0; 3]).unwrap());
    assert!(skewed.starts_with(r#"{"skewed_axes":{"#), "{skewed}");
}

/// Every field must be present under its name, and no other.
#[test]
fn fields_are_neither_left_out_nor_misspelt() {
    fn refuses<T: DeserializeOwned + Debug>(text: &str, why: &str) {
        let error = serde_json::from_str::<T>(text).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
    let (x, ray) = (r#"{"x":1,"y":0,"z":0}"#, r#""origin":X,"direction":X"#);
    let read = |text: &str| format!("{{{ray},{text}}}").replace('X', x);
    assert!(serde_json::from_str::<Ray<f32>>(&read(r#""t_min":null,"t_max":null"#)).is_ok());
    refuses::<Ray<f32>>(&read(r#""t_max":null"#), "missing field `t_min`");
    refuses::<Ray<f32>>(&read(r#""t_min":0"#), "missing field `t_max`");
    refuses::<Ray<f32>>(&read(r#""tmin":0,"t_min":0,"t_max":null"#), "unknown field `tmin`");

    refuses::<Vec3<f32>>(r#"{"x":1,"y":0,"z":0,"w":1}"#, "unknown field `w`");
    for text in [
        r#"{"min_max":{"min":X,"max":X,"e":0}}"#,
        r#"{"center_half_extents":{"center":X,"half_extents":X,"e":0}}"#,
    ] {
        refuses::<Aabb<f32>>(&text.replace('X', x), "unknown field `e`");
    }
    let text = r#"{"equation":{"normal":X,"d":1,"e":1}}"#.replace('X', x);
    refuses::<Plane<f32>>(&text, "unknown field `e`");
    let text = r#"{"center_half_vector":{"center":X,"half_vector":X,"e":1}}"#.replace('X', x);
    refuses::<Segment<f32>>(&text, "unknown field `e`");
    let text = r#"{"axes":{"center":X,"half_extents":X,"axes":[X,X,X],"e":1}}"#.replace('X', x);
    refuses::<Obb<f32>>(&text, "unknown field `e`");
}

/// A mesh with its tree is written as the mesh, and a mesh that `new` refuses is not read.
#[test]
fn owned_trees_are_read_through_their_constructor() {
    let corners = [[0.0_f32; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let faces = [[0_u32, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [3, 1, 0]];
    let tree = OwnedTree::new(corners, faces).unwrap();
    let text = serde_json::to_string(&tree).unwrap();
    let read: OwnedTree<f32> = serde_json::from_str(&text).unwrap();
    assert_eq!(read.mesh(), tree.mesh());
    assert_eq!(read.as_tree().nodes(), tree.as_tree().nodes());
    assert!(read.as_tree().order().eq(tree.as_tree().order()));

    let refused = |from: &str, to: &str, why: &str| {
        assert!(text.contains(from));
        let bad = serde_json::from_str::<OwnedTree<f32>>(&text.replacen(from, to, 1));
        let error = bad.unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    };
    refused("[3,1,0]", "[3,1,4]", "a triangle has a vertex that there is not: triangle 4");
    refused("0.0", "1e39", "a coordinate is NaN or infinite: vertex 0");
    refused("\"vertices\"", "\"points\"", "unknown field `points`");
    refused("\"triangles\"", "\"nodes\":[],\"triangles\"", "unknown field `nodes`");
}

#[test]
fn mint_vectors_make_shapes() {
    let point = |x| mint::Point3 { x, y: 0.0, z: 1.0 };
    let t = Triangle::new(point(0.0), point(1.0), [0.0, 1.0, 1.0]).unwrap();
    let back: mint::Vector3<f64> = t.vertices()[1].into();
    assert_eq!(back, mint::Vector3 { x: 1.0, y: 0.0, z: 1.0 });
}
