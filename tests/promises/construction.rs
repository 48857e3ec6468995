//! Valid and invalid input of constructors: every error of every constructor, and input at the edge
//! of validity.

use fixed::types::{I0F8, I8F8, I16F16, I32F32};
use septum::polygon::Polygon;
use septum::sweep::Motion;
use septum::{Aabb, Obb, Plane, Ray, Scalar, Segment, ShapeError, Triangle, Vec3};
use septum_kit::{Each, Sample, for_every_scalar, not_finite};

const X: [f32; 3] = [1.0, 0.0, 0.0];
const Y: [f32; 3] = [0.0, 1.0, 0.0];
const Z: [f32; 3] = [0.0, 0.0, 1.0];
const NOT_FINITE: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

fn axes(axes: [[f32; 3]; 3]) -> [Vec3<f32>; 3] {
    axes.each(Vec3::from)
}

/// Calls `make` with each number in turn replaced by NaN or an infinity, and the rest 1. The error names
/// the argument that has the number.
fn names_each(arguments: &[&str], make: impl Fn(&[f32]) -> Result<(), ShapeError>) {
    let n: usize = arguments.iter().map(|argument| size(argument)).sum();
    for bad in NOT_FINITE {
        let mut i = 0;
        for argument in arguments {
            for _ in 0..size(argument) {
                let mut numbers = vec![1.0; n];
                numbers[i] = bad;
                let error = make(&numbers).unwrap_err();
                assert!(matches!(error, ShapeError::NotFinite { .. }), "{numbers:?}: {error}");
                assert_eq!(error.to_string(), format!("a number is NaN or infinite: {argument}"));
                i += 1;
            }
        }
    }
}

/// How many numbers an argument has.
fn size(argument: &str) -> usize {
    if ["d", "t_min", "t_max"].contains(&argument) { 1 } else { 3 }
}

fn row(x: &[f32], r: usize) -> [f32; 3] {
    [x[3 * r], x[3 * r + 1], x[3 * r + 2]]
}

fn vec(x: &[f32], r: usize) -> Vec3<f32> {
    row(x, r).into()
}

#[test]
fn not_finite_numbers_are_named() {
    let (abc, by_center, corners) = (["a", "b", "c"], ["center", "half_extents"], ["min", "max"]);
    names_each(&abc, |x| Triangle::new(row(x, 0), row(x, 1), row(x, 2)).map(drop));
    names_each(&abc, |x| Triangle::<f32>::const_new(vec(x, 0), vec(x, 1), vec(x, 2)).map(drop));
    names_each(&by_center, |x| Aabb::from_center_half_extents(row(x, 0), row(x, 1)).map(drop));
    names_each(&by_center, |x| {
        Aabb::<f32>::const_from_center_half_extents(vec(x, 0), vec(x, 1)).map(drop)
    });
    names_each(&corners, |x| Aabb::from_min_max(row(x, 0), row(x, 1)).map(drop));
    names_each(&corners, |x| Aabb::<f32>::const_new(vec(x, 0), vec(x, 1)).map(drop));
    let points = ["points[0]", "points[1]", "points[2]"];
    names_each(&points, |x| Aabb::from_points([row(x, 0), row(x, 1), row(x, 2)]).map(drop));
    names_each(&["point", "normal"], |x| Plane::from_point_normal(row(x, 0), row(x, 1)).map(drop));
    names_each(&["normal", "d"], |x| Plane::from_equation(row(x, 0), x[3]).map(drop));
    names_each(&["normal", "d"], |x| Plane::<f32>::const_new(vec(x, 0), x[3]).map(drop));
    let vertices = ["vertices[0]", "vertices[1]", "vertices[2]", "vertices[3]"];
    let four = |x: &[f32]| [vec(x, 0), vec(x, 1), vec(x, 2), vec(x, 3)];
    names_each(&vertices, |x| Polygon::new(&four(x)).map(drop));
    names_each(&vertices, |x| Polygon::<f32>::const_new(&four(x)).map(drop));
    names_each(&abc[..2], |x| Segment::new(row(x, 0), row(x, 1)).map(drop));
    names_each(&abc[..2], |x| Segment::<f32>::const_new(vec(x, 0), vec(x, 1)).map(drop));
    let half_vector = ["center", "half_vector"];
    names_each(&half_vector, |x| Segment::from_center_half_vector(row(x, 0), row(x, 1)).map(drop));
    names_each(&["origin", "direction"], |x| Ray::new(row(x, 0), row(x, 1)).map(drop));
    names_each(&["origin", "direction"], |x| Ray::<f32>::const_new(vec(x, 0), vec(x, 1)).map(drop));
    let ray = Ray::new([0.0; 3], X).unwrap();
    names_each(&["t_min", "t_max"], |x| ray.with_range(x[0], x[1]).map(drop));
    names_each(&["from", "to"], |x| Motion::new(row(x, 0), row(x, 1)).map(drop));
    let obb = ["center", "axes[0]", "axes[1]", "axes[2]", "half_extents"];
    let frame = |x: &[f32]| [vec(x, 1), vec(x, 2), vec(x, 3)];
    names_each(&obb, |x| Obb::new(row(x, 0), frame(x), row(x, 4)).map(drop));
    names_each(&obb, |x| Obb::<f32>::const_new(vec(x, 0), frame(x), vec(x, 4)).map(drop));
    names_each(&obb, |x| Obb::from_skewed_axes(row(x, 0), frame(x), row(x, 4)).map(drop));
}

#[test]
fn not_finite_in_f64() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let v = Vec3::new(0.0, bad, 0.0);
        assert_eq!(Triangle::new(v, v, v), Err(not_finite("a", None)));
        assert_eq!(Triangle::<f64>::const_new(v, v, v), Err(not_finite("a", None)));
        assert_eq!(Aabb::from_min_max(v, v), Err(not_finite("min", None)));
        assert_eq!(Aabb::<f64>::const_new(v, v), Err(not_finite("min", None)));
    }
}

/// If two errors apply, `const` and ordinary constructors report the same one.
#[test]
fn not_finite_comes_first() {
    let (below, nan) = (Vec3::new(-1.0, 1.0, 1.0), Vec3::new(0.0, 0.0, f32::NAN));
    let first = Err(not_finite("center", None));
    assert_eq!(Aabb::from_center_half_extents(nan, below), first);
    assert_eq!(Aabb::<f32>::const_from_center_half_extents(nan, below), first);
    let first = Err(not_finite("min", None));
    assert_eq!(Aabb::from_min_max(nan, below), first);
    assert_eq!(Aabb::<f32>::const_new(nan, below), first);
}

fn negative_half_extent<S: Sample>() {
    let zero = [S::ZERO; 3];
    for negative in [S::ZERO.moved(-1), S::LEAST] {
        for i in 0..3 {
            let mut half = zero;
            half[i] = negative;
            let made = Aabb::from_center_half_extents(zero, half);
            assert_eq!(made, Err(ShapeError::NegativeHalfExtent));
        }
    }
    assert!(Aabb::from_center_half_extents(zero, zero).is_ok());
    assert!(Aabb::from_center_half_extents([S::LEAST; 3], [S::GREATEST; 3]).is_ok());
}

fn min_above_max<S: Sample>() {
    for (low, high) in [(S::ZERO, S::ZERO.moved(1)), (S::LEAST, S::GREATEST)] {
        assert!(Aabb::from_min_max([low; 3], [high; 3]).is_ok());
        assert!(Aabb::from_min_max([low; 3], [low; 3]).is_ok());
        for i in 0..3 {
            let (mut min, max) = ([low; 3], [low; 3]);
            min[i] = high;
            assert_eq!(Aabb::from_min_max(min, max), Err(ShapeError::MinAboveMax));
        }
    }
}

/// Shapes return the numbers that they were given.
fn shapes_keep_their_numbers<S: Sample>() {
    let number = |n: i64| S::whole(n);
    let [a, b, c] = [[1, 2, 3], [4, 5, 6], [7, 8, 9]].each(|v| Vec3::from(v.each(number)));
    assert_eq!(Triangle::new(a, b, c).unwrap().vertices(), &[a, b, c]);
    let aabb = Aabb::from_center_half_extents(a, b).unwrap();
    assert_eq!(aabb.center_half_extents(), Some((a, b)));
    let aabb = Aabb::from_min_max(a, b).unwrap();
    assert_eq!((aabb.center_half_extents(), aabb.min_max()), (None, Some((a, b))));
}

for_every_scalar!(negative_half_extent, min_above_max, shapes_keep_their_numbers);

#[test]
fn axes_that_are_no_frame() {
    let new = |frame: [[f32; 3]; 3]| Obb::new([0.0; 3], axes(frame), [1.0; 3]).map(drop);
    assert_eq!(new([X, Y, Z]), Ok(()));
    assert_eq!(new([Y, X, Z]), Ok(())); // left-handed is a frame too
    assert_eq!(new([X, Y, [0.0; 3]]), Err(ShapeError::NotOrthonormal));
    assert_eq!(new([X, Y, [0.0, 0.0, 2.0]]), Err(ShapeError::NotOrthonormal));
    assert_eq!(new([X, X, Z]), Err(ShapeError::NotOrthonormal));
    assert_eq!(new([X, Y, [0.3, 0.0, 0.95]]), Err(ShapeError::NotOrthonormal));
    let negative = Obb::new([0.0; 3], axes([X, Y, Z]), [1.0, -1.0, 1.0]);
    assert_eq!(negative, Err(ShapeError::NegativeHalfExtent));
}

#[test]
fn axes_that_do_not_span() {
    let new = |frame| Obb::from_skewed_axes([0.0; 3], axes(frame), [1.0; 3]).map(drop);
    assert_eq!(new([X, [1.0, 1.0, 0.0], [1.0, 1.0, 1e-30]]), Ok(()));
    assert_eq!(new([X, Y, [0.0; 3]]), Err(ShapeError::DependentAxes));
    assert_eq!(new([X, Y, [1.0, 1.0, 0.0]]), Err(ShapeError::DependentAxes));
    assert_eq!(new([X, X, Z]), Err(ShapeError::DependentAxes));
    let negative = Obb::from_skewed_axes([0.0; 3], axes([X, Y, Z]), [1.0, 1.0, -1.0]);
    assert_eq!(negative, Err(ShapeError::NegativeHalfExtent));
}

#[test]
fn a_plane_has_a_normal() {
    let zero = [0.0, -0.0, 0.0];
    assert_eq!(Plane::from_point_normal(X, zero), Err(ShapeError::ZeroNormal));
    assert_eq!(Plane::from_equation(zero, 1.0), Err(ShapeError::ZeroNormal));
    let tiny = [0.0, f32::from_bits(1), 0.0];
    assert!(Plane::from_point_normal(X, tiny).is_ok() && Plane::from_equation(tiny, 1.0).is_ok());
}

#[test]
fn minus_zero_is_no_negative_half_extent() {
    assert!(Aabb::from_center_half_extents([0.0; 3], [-0.0; 3]).is_ok());
    assert!(Aabb::from_min_max([0.0; 3], [-0.0; 3]).is_ok());
    assert!(Aabb::<f32>::const_new(Vec3::splat(0.0), Vec3::splat(-0.0)).is_ok());
}

const fn valid<T: Copy>(made: Result<T, ShapeError>) -> T {
    match made {
        Ok(shape) => shape,
        Err(_) => panic!("not a shape"),
    }
}

macro_rules! in_flash {
    ($($name:ident, $scalar:ty, $low:expr, $high:expr;)*) => {$(
        #[test]
        fn $name() {
            const LOW: Vec3<$scalar> = Vec3::splat($low);
            const HIGH: Vec3<$scalar> = Vec3::splat($high);
            const TRIANGLE: Triangle<$scalar> = valid(Triangle::<$scalar>::const_new(LOW, HIGH, LOW));
            const CELL: Aabb<$scalar> = valid(Aabb::<$scalar>::const_new(LOW, HIGH));
            const FLIPPED: Result<Aabb<$scalar>, ShapeError> = Aabb::<$scalar>::const_new(HIGH, LOW);
            static VERTICES: [Vec3<$scalar>; 4] = [LOW, HIGH, LOW, LOW];
            static POLYGON: Polygon<'_, $scalar> =
                valid(Polygon::<$scalar>::const_new(&VERTICES));
            assert_eq!(Ok(POLYGON), Polygon::new(&VERTICES));
            assert!(POLYGON.overlaps(&CELL));
            for few in 0..3 {
                let few = Polygon::<$scalar>::const_new(&VERTICES[..few]);
                assert_eq!(few, Err(ShapeError::TooFewVertices));
            }
            assert_eq!(Ok(TRIANGLE), Triangle::new(LOW, HIGH, LOW));
            assert_eq!(Ok(CELL), Aabb::from_min_max(LOW, HIGH));
            assert_eq!(FLIPPED, Err(ShapeError::MinAboveMax));
            assert!(TRIANGLE.overlaps(&CELL));
        }
    )*};
}
in_flash! {
    f32_in_flash, f32, -1.0, f32::MAX;
    f64_in_flash, f64, -1.0, f64::MAX;
    i8_in_flash, I0F8, I0F8::MIN, I0F8::MAX;
    i16_in_flash, I8F8, I8F8::MIN, I8F8::MAX;
    i32_in_flash, I16F16, I16F16::MIN, I16F16::MAX;
    i64_in_flash, I32F32, I32F32::MIN, I32F32::MAX;
}

/// Each error has a message of its own.
#[test]
fn errors_are_told() {
    let errors = [
        not_finite("a", None),
        not_finite("b", None),
        not_finite("axes", Some(1)),
        ShapeError::NegativeHalfExtent,
        ShapeError::MinAboveMax,
        ShapeError::DependentAxes,
        ShapeError::NotOrthonormal,
        ShapeError::NotUnitQuaternion,
        ShapeError::ZeroNormal,
    ];
    let told: std::collections::HashSet<String> = errors.iter().map(ToString::to_string).collect();
    assert!(told.len() == errors.len() && told.iter().all(|text| text.len() > 10), "{told:?}");
}

/// Generic code needs no bound other than `Scalar`.
fn unit_cell<S: Scalar>(size: S) -> Result<Aabb<S>, ShapeError> {
    Aabb::from_min_max([S::ZERO; 3], [size; 3])
}

#[test]
fn one_bound_is_enough() {
    assert!(unit_cell(1.0_f32).is_ok() && unit_cell(I8F8::ONE).is_ok());
    assert_eq!(unit_cell(f64::NAN), Err(not_finite("max", None)));
}

#[test]
fn boxes_by_centre_and_planes_are_made_in_a_const_and_checked() {
    const HALF: Vec3<I16F16> = Vec3::splat(I16F16::ONE);
    const CELL: Result<Aabb<I16F16>, ShapeError> =
        Aabb::<I16F16>::const_from_center_half_extents(Vec3::splat(I16F16::ZERO), HALF);
    assert_eq!(CELL, Aabb::from_center_half_extents([I16F16::ZERO; 3], HALF));
    let backwards = Aabb::<I16F16>::const_from_center_half_extents(HALF, Vec3::splat(I16F16::MIN));
    assert_eq!(backwards, Err(ShapeError::NegativeHalfExtent));
    let backwards = Aabb::<f32>::const_from_center_half_extents(Vec3::splat(0.0), vec3_last(-1.0));
    assert_eq!(backwards, Err(ShapeError::NegativeHalfExtent));
    let far =
        Aabb::<f64>::const_from_center_half_extents(Vec3::splat(f64::INFINITY), Vec3::splat(1.0));
    assert_eq!(far, Err(not_finite("center", None)));
    assert!(
        Aabb::<f32>::const_from_center_half_extents(Vec3::splat(1.0), Vec3::splat(-0.0)).is_ok()
    );

    const FLOOR: Result<Plane<f32>, ShapeError> = Plane::<f32>::const_new(vec3_last(2.0), -0.5);
    assert_eq!(FLOOR, Plane::from_equation([0.0, 0.0, 2.0], -0.5));
    assert_eq!(Plane::<f32>::const_new(vec3_last(-0.0), 1.0), Err(ShapeError::ZeroNormal));
    assert_eq!(Plane::<f32>::const_new(vec3_last(1.0), f32::NAN), Err(not_finite("d", None)));
    let none = Plane::<I8F8>::const_new(Vec3::splat(I8F8::ZERO), I8F8::ONE);
    assert_eq!(none, Err(ShapeError::ZeroNormal));
    assert!(Plane::<I8F8>::const_new(Vec3::splat(I8F8::DELTA), I8F8::ONE).is_ok());
}

const fn vec3_last(z: f32) -> Vec3<f32> {
    Vec3::new(0.0, 0.0, z)
}

#[test]
fn zero_direction() {
    for zero in [0.0_f32, -0.0] {
        let still = Vec3::splat(zero);
        assert_eq!(Ray::new([1.0; 3], still), Err(ShapeError::ZeroDirection));
        assert_eq!(Ray::<f32>::const_new(Vec3::splat(1.0), still), Err(ShapeError::ZeroDirection));
    }
    let still = Vec3::splat(I8F8::ZERO);
    assert_eq!(Ray::new(still, still), Err(ShapeError::ZeroDirection));
    assert_eq!(Ray::<I8F8>::const_new(still, still), Err(ShapeError::ZeroDirection));
    // The type's least positive number is a valid direction, and a segment may be a point.
    assert!(Ray::new([0.0_f32; 3], [0.0, 0.0, f32::from_bits(1)]).is_ok());
    assert!(Ray::<f32>::const_new(Vec3::splat(0.0), Vec3::new(0.0, -1e-45, 0.0)).is_ok());
    assert!(Segment::new(still, still).is_ok());
}

fn empty_range<S: Sample>() {
    let ray = Ray::new([S::ZERO; 3], [S::GREATEST; 3]).unwrap();
    assert_eq!((ray.t_min(), ray.t_max()), (Some(S::ZERO), None));
    let above = S::ZERO.moved(1);
    assert_eq!(ray.with_range(above, S::ZERO), Err(ShapeError::EmptyRange));
    assert_eq!(ray.with_range(S::GREATEST, S::LEAST), Err(ShapeError::EmptyRange));
    let point = ray.with_range(above, above).unwrap();
    assert_eq!((point.t_min(), point.t_max()), (Some(above), Some(above)));
    assert!(ray.with_range(S::LEAST, None).is_ok() && ray.with_range(None, S::LEAST).is_ok());
}
for_every_scalar!(empty_range);

#[test]
fn a_shape_gives_back_what_it_was_made_of() {
    let (p, q) = (Vec3::new(1.0, -2.5, 3.0), Vec3::new(4.0, 5.0, 6.0));
    assert_eq!(format!("{p:?}"), "(1.0, -2.5, 3.0)");
    let plane = Plane::from_point_normal(p, q).unwrap();
    assert_eq!((plane.point(), plane.normal(), plane.offset()), (Some(p), q, None));
    let plane = Plane::from_equation(q, 0.5).unwrap();
    assert_eq!((plane.point(), plane.normal(), plane.offset()), (None, q, Some(0.5)));
    let segment = Segment::new(p, q).unwrap();
    assert_eq!((segment.ends(), segment.center_half_vector()), (Some((p, q)), None));
    let segment = Segment::from_center_half_vector(p, q).unwrap();
    assert_eq!((segment.ends(), segment.center_half_vector()), (None, Some((p, q))));
}
