//! Unit normals: correctly rounded in fixed point, accurate within the bound in floats.

use dashu_int::IBig;
use septum::interop::FixedPoint;
use septum::{Triangle, Vec3};

use crate::bytes::Bytes;
use crate::scalars::{FixedCheck, run_fixed};
use crate::shapes::Shapes;
use crate::told::told;
use septum_kit::{Points, Sample, compare_with_unit, is_nearest_to_unit, normal_of};

/// `unit_normal`, `unit_normal`, `unit_normal_fast`.
pub fn unit_normal(data: &[u8]) {
    let mut bytes = Bytes::new(data);
    match bytes.below(20) {
        0 | 1 => {
            let points = Shapes::new(bytes).triangle();
            // Hundredths of the last place.
            check_float::<f32>(&points, 51, |t| t.unit_normal());
            check_micromath(&points);
        }
        2 | 3 => {
            let points = Shapes::new(bytes).triangle();
            check_float::<f64>(&points, 600, |t| t.unit_normal());
        }
        n => run_fixed::<Integer>(n - 4, bytes),
    }
}

fn triangle<S: Sample>(points: &Points<S>) -> Triangle<S> {
    let [a, b, c] = *points;
    Triangle::new(a, b, c).expect("finite vertices")
}

struct Integer;

impl FixedCheck for Integer {
    fn check<S: Sample + FixedPoint>(shapes: &mut Shapes<'_, S>) {
        let points = shapes.triangle();
        let (n, square) = normal_of(&points);
        let found = triangle(&points).unit_normal();
        let told = || told::<S>(&(found, points));
        assert_eq!(found.is_none(), square == IBig::ZERO, "{}", told());
        let Some(found) = found else { return };
        for (x, n) in found.to_array().into_iter().zip(&n) {
            assert!(is_nearest_to_unit(x, n, &square), "{}", told());
        }
    }
}

/// Each component is within `hundredths` hundredths of its last place.
fn check_float<S: Sample>(
    points: &Points<S>,
    hundredths: i32,
    find: impl Fn(&Triangle<S>) -> Option<Vec3<S>>,
) {
    let (n, square) = normal_of(points);
    let found = find(&triangle(points));
    let told = || told::<S>(&(found, points));
    assert_eq!(found.is_none(), square == IBig::ZERO, "{}", told());
    let Some(found) = found else { return };
    for (x, n) in found.to_array().into_iter().zip(&n) {
        assert!(x.is_finite(), "{}", told());
        let (m, e) = x.mantissa_exponent();
        // In fractions of 2^-10 of the last place, rounded up.
        let (fine, bound) = (IBig::from(m) << 10, hundredths * 1024 / 100 + 1);
        let low = compare_with_unit(&(&fine - bound), e - 10, n, &square);
        let high = compare_with_unit(&(&fine + bound), e - 10, n, &square);
        assert!(low.is_le() && high.is_ge(), "{}", told());
    }
}

/// About 1 long, or `None`.
fn check_micromath(points: &Points<f32>) {
    if let Some(n) = triangle(points).unit_normal_fast() {
        let square: f64 = n.to_array().iter().map(|&x| f64::from(x).powi(2)).sum();
        assert!((0.93..1.08).contains(&square), "{}", told::<f32>(&(n, points)));
    }
}
