//! Constructors make valid shapes, refuse invalid ones for the right reason, also in a `const`, and
//! never panic.

use dashu_int::IBig;
use septum::interop::FixedPoint;
use septum::{Aabb, Obb, Plane, Ray, Segment, ShapeError, Triangle, Vec3};

use super::triangle_obb::axes;
use crate::bytes::Bytes;
use crate::scalars::{FixedCheck, run_fixed};
use crate::shapes::{Point, Shapes};
use crate::told::told;
use septum_kit::{Ring, Sample};

/// Every constructor, on numbers that may be NaN or infinite.
pub fn constructors(data: &[u8]) {
    let mut bytes = Bytes::new(data);
    match bytes.below(20) {
        0 | 1 => {
            let rows = floats(&mut Shapes::new(bytes), f32::NAN, f32::INFINITY);
            check(&rows);
            check_constants_f32(&rows);
        }
        2 | 3 => {
            let rows = floats(&mut Shapes::new(bytes), f64::NAN, f64::INFINITY);
            check(&rows);
            check_constants_f64(&rows);
        }
        n => run_fixed::<Fixed>(n - 4, bytes),
    }
}

/// Rows of numbers: three axes and other vectors.
type Rows<S> = [Point<S>; 6];

struct Fixed;

impl FixedCheck for Fixed {
    fn check<S: Sample + FixedPoint>(shapes: &mut Shapes<'_, S>) {
        check(&rows(shapes));
    }
}

fn rows<S: Sample>(shapes: &mut Shapes<'_, S>) -> Rows<S> {
    let [u, v, w] = axes(shapes);
    [u, v, w, shapes.point(), shapes.point(), shapes.point()]
}

/// The same rows with one or two numbers replaced by NaN or an infinity.
fn floats<S: Sample>(shapes: &mut Shapes<'_, S>, nan: S, infinity: S) -> Rows<S> {
    let mut rows = rows(shapes);
    for _ in 0..shapes.bytes.below(3) {
        let bad = [nan, infinity, S::ZERO.minus(infinity)][shapes.bytes.below(3)];
        rows[shapes.bytes.below(6)][shapes.bytes.below(3)] = bad;
    }
    rows
}

/// The first error whose condition holds.
fn first_of(reasons: &[(bool, ShapeError)]) -> Option<ShapeError> {
    reasons.iter().find(|(holds, _)| *holds).map(|(_, error)| *error)
}

fn check<S: Sample>(rows: &Rows<S>) {
    let [u, v, w, p, q, r] = *rows;
    let bad = |arguments: &[(&'static str, Point<S>)]| {
        let bad = arguments.iter().find(|(_, row)| row.iter().any(|x| !x.is_finite()));
        let argument = bad.map_or("", |(argument, _)| argument);
        (bad.is_some(), ShapeError::NotFinite { argument, index: None })
    };
    let is_zero = |p: Point<S>| p == [S::ZERO; 3];
    let told = || told::<S>(rows);
    let is_negative = q.iter().any(|x| *x < S::ZERO);
    let negative = (is_negative, ShapeError::NegativeHalfExtent);

    let made = Triangle::new(p, q, r).err();
    assert_eq!(made, first_of(&[bad(&[("a", p), ("b", q), ("c", r)])]), "{}", told());
    let made = Aabb::from_center_half_extents(p, q).err();
    let bad_numbers = bad(&[("center", p), ("half_extents", q)]);
    assert_eq!(made, first_of(&[bad_numbers, negative]), "{}", told());
    let above = ((0..3).any(|i| p[i] > q[i]), ShapeError::MinAboveMax);
    let made = Aabb::from_min_max(p, q).err();
    assert_eq!(made, first_of(&[bad(&[("min", p), ("max", q)]), above]), "{}", told());
    let made = Segment::new(p, q).err();
    assert_eq!(made, first_of(&[bad(&[("a", p), ("b", q)])]), "{}", told());
    let made = Segment::from_center_half_vector(p, q).err();
    assert_eq!(made, first_of(&[bad(&[("center", p), ("half_vector", q)])]), "{}", told());
    let zero = (is_zero(q), ShapeError::ZeroNormal);
    let made = Plane::from_point_normal(p, q).err();
    assert_eq!(made, first_of(&[bad(&[("point", p), ("normal", q)]), zero]), "{}", told());
    let made = Plane::from_equation(q, p[0]).err();
    assert_eq!(made, first_of(&[bad(&[("d", [p[0]; 3]), ("normal", q)]), zero]), "{}", told());

    let zero = (is_zero(q), ShapeError::ZeroDirection);
    let ray = Ray::new(p, q);
    assert_eq!(ray.err(), first_of(&[bad(&[("origin", p), ("direction", q)]), zero]), "{}", told());
    if let Ok(ray) = ray {
        let made = ray.with_range(r[0], r[1]).err();
        let empty = (r[0] > r[1], ShapeError::EmptyRange);
        let bad_ends = bad(&[("t_min", [r[0]; 3]), ("t_max", [r[1]; 3])]);
        assert_eq!(made, first_of(&[bad_ends, empty]), "{}", told());
        let made = ray.with_range(None, r[1]).err();
        assert_eq!(made, first_of(&[bad(&[("t_max", [r[1]; 3])])]), "{}", told());
    }

    let mut bad = bad(&[("center", p), ("half_extents", q)]);
    if let (false, Some(i)) =
        (bad.0, [u, v, w].iter().position(|u| u.iter().any(|x| !x.is_finite())))
    {
        bad = (true, ShapeError::NotFinite { argument: "axes", index: Some(i) });
    }
    let (spans, is_orthonormal) = if bad.0 { (false, None) } else { frame([u, v, w]) };
    let vectors = [u, v, w].map(Vec3::from);
    let made = Obb::from_skewed_axes(p, vectors, q).err();
    let dependent = (!spans, ShapeError::DependentAxes);
    assert_eq!(made, first_of(&[bad, negative, dependent]), "{}", told());
    let made = Obb::new(p, vectors, q).err();
    let no_unit = (!holds_unit_vectors::<S>(), ShapeError::NoUnitLength);
    // If the oracle is in doubt, the crate's answer counts.
    let is_askew = is_orthonormal.map_or(made == Some(ShapeError::NotOrthonormal), |is| !is);
    let askew = (is_askew, ShapeError::NotOrthonormal);
    assert_eq!(made, first_of(&[bad, negative, no_unit, askew]), "{}", told());
}

/// Whether the type holds 1 and −1, or one of them: its greatest number is at least a half.
fn holds_unit_vectors<S: Sample>() -> bool {
    let (mantissa, exponent) = S::GREATEST.mantissa_exponent();
    exponent >= 0
        || IBig::from(mantissa) * IBig::from(2) >= IBig::ONE << exponent.unsigned_abs() as usize
}

/// Whether the axes span space, and whether their dot products are within an eighth of an
/// orthonormal frame's. `None` if a dot product is within 2^-20 of the limit, where not every type
/// is checked exactly.
fn frame<S: Sample>(axes: [Point<S>; 3]) -> (bool, Option<bool>) {
    let parts = axes.map(|u| u.map(S::mantissa_exponent));
    let exponents = parts.iter().flatten().filter(|x| x.0 != 0).map(|x| x.1);
    let unit = exponents.min().unwrap_or(0).min(0);
    let axes = parts.map(|u| {
        u.map(|(m, e)| if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize })
    });
    let spans = IBig::dot(&axes[0], &IBig::cross(&axes[1], &axes[2])) != IBig::ZERO;
    // An eighth of one, times 2^20.
    let eighth = IBig::ONE << (17 - 2 * unit) as usize;
    let doubt = IBig::ONE << (-2 * unit) as usize;
    let are_within = |most: &IBig| {
        (0..9).all(|n| {
            let (i, j) = (n / 3, n % 3);
            let target = &eighth * IBig::from(if i == j { 8 } else { 0 });
            let off = (IBig::dot(&axes[i], &axes[j]) << 20) - target;
            -most <= off && off <= *most
        })
    };
    let (surely, maybe) = (are_within(&(&eighth - &doubt)), are_within(&(&eighth + &doubt)));
    (spans, (surely == maybe).then_some(surely))
}

/// Compares the `const` constructors, which generic code cannot call.
macro_rules! check_constants {
    ($name:ident, $scalar:ty) => {
        fn $name(rows: &Rows<$scalar>) {
            let [p, q, r] = [rows[3], rows[4], rows[5]].map(Vec3::from);
            assert_eq!(Triangle::<$scalar>::const_new(p, q, r), Triangle::new(p, q, r));
            assert_eq!(Aabb::<$scalar>::const_new(p, q), Aabb::from_min_max(p, q));
            let half = Aabb::<$scalar>::const_from_center_half_extents(p, q);
            assert_eq!(half, Aabb::from_center_half_extents(p, q));
            assert_eq!(Segment::<$scalar>::const_new(p, q), Segment::new(p, q));
            assert_eq!(Ray::<$scalar>::const_new(p, q), Ray::new(p, q));
            assert_eq!(Plane::<$scalar>::const_new(q, p.x), Plane::from_equation(q, p.x));
        }
    };
}
check_constants!(check_constants_f32, f32);
check_constants!(check_constants_f64, f64);
