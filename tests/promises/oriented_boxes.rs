//! Oriented boxes: valid axes, the points that they contain, and their bounding boxes, compared
//! with integers of any size.

use dashu_int::IBig;
use fixed::types::{I0F8, I0F16, I0F32, I0F64, I1F31, I2F30, I4F60};
use septum::{Obb, ShapeError};
use septum_kit::{Each, Ring, Rng, Sample, for_every_scalar, not_finite, three};

type Point<S> = [S; 3];

/// Centre, axes and half-extents, and a point.
#[derive(Clone, Copy, Debug)]
struct Given<S> {
    center: Point<S>,
    axes: [Point<S>; 3],
    half: Point<S>,
    point: Point<S>,
}

impl<S: Sample> Given<S> {
    fn obb(&self) -> Option<Obb<S>> {
        Obb::from_skewed_axes(self.center, self.axes, self.half).ok()
    }

    /// Every number as a multiple of one power of two, and one in that unit.
    fn whole(&self) -> (Given<IBig>, IBig) {
        let rows = [self.axes.as_slice(), &[self.center, self.half, self.point]].concat();
        let parts = rows.as_flattened().iter().map(|x| x.mantissa_exponent());
        let unit = parts.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0).min(0);
        let number = |x: &S| {
            let (m, e) = x.mantissa_exponent();
            if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
        };
        let row = |p: &Point<S>| p.each_ref().each(number);
        let given = Given {
            center: row(&self.center),
            axes: self.axes.each_ref().each(row),
            half: row(&self.half),
            point: row(&self.point),
        };
        (given, IBig::ONE << unit.unsigned_abs() as usize)
    }

    /// Whether the point is in the box, by Gauss–Jordan elimination.
    fn contains(&self) -> bool {
        let (Given { center, axes: [u, v, w], half, point }, one) = self.whole();
        let mut rows = three(|r: usize| {
            [u[r].clone(), v[r].clone(), w[r].clone(), (&point[r] - &center[r]) * &one]
        });
        for k in 0..3 {
            let pivot = (k..3).find(|&r| rows[r][k] != IBig::ZERO).expect("axes that span space");
            rows.swap(k, pivot);
            let by = rows[k].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(r, _)| *r != k) {
                let factor = row[k].clone();
                *row = [0, 1, 2, 3].each(|c: usize| &row[c] * &by[k] - &by[c] * &factor);
            }
        }
        (0..3).all(|k| {
            let (num, den) = (&rows[k][3], &rows[k][k]);
            num * num <= &half[k] * &half[k] * den * den
        })
    }
}

fn magnitude<S: Sample>(x: S) -> S {
    S::from_ordinal(x.ordinal().saturating_abs())
}

/// A rounded rotation.
fn rotation<S: Sample>(rng: &mut Rng) -> [Point<S>; 3] {
    let [a, b, c] = rng.triple(|rng| rng.real(-3.2, 3.2));
    let ((s, c0), (t, d), (r, e)) = (a.sin_cos(), b.sin_cos(), c.sin_cos());
    [
        [c0 * d, c0 * t * r - s * e, c0 * t * e + s * r],
        [s * d, s * t * r + c0 * e, s * t * e - c0 * r],
        [-t, d * r, d * e],
    ]
    .each(|u| u.each(S::nearest))
}

fn given<S: Sample>(rng: &mut Rng, kind: usize) -> Given<S> {
    let near = |rng: &mut Rng| S::nearest(rng.real(-2.0, 2.0));
    let grid = |rng: &mut Rng| S::whole(rng.whole(-4, 4));
    let any = |rng: &mut Rng| {
        let greatest = S::GREATEST.ordinal();
        S::from_ordinal(rng.whole(-greatest, greatest))
    };
    let tiny = |rng: &mut Rng| S::from_ordinal(rng.whole(-5, 5));
    let number = |rng: &mut Rng| match kind {
        0 | 1 => near(rng),
        2 => grid(rng),
        3 => any(rng),
        _ => tiny(rng),
    };
    let rows = rng.triple(|rng| rng.triple(number));
    let [center, half, mut point] = rows;
    // On the grid, integer multiples of the axes, so that contact is frequent.
    let half = match kind {
        2 => rng.triple(|rng| S::nearest(rng.below(3) as f64)),
        _ => half.each(magnitude),
    };
    let axes = if kind < 2 { rotation(rng) } else { rng.triple(|rng| rng.triple(number)) };
    if kind == 1 {
        // A corner, or a point of a face, as nearly as the scalar allows.
        let s = three(|i: usize| {
            let side = [-1.0, 1.0, rng.real(-1.0, 1.0)][rng.below(3)];
            half[i].approximate() * side
        });
        for (i, p) in point.iter_mut().enumerate() {
            let along: f64 = (0..3).map(|k| s[k] * axes[k][i].approximate()).sum();
            *p = S::nearest(center[i].approximate() + along).moved(rng.whole(-1, 1));
        }
    }
    Given { center, axes, half, point }
}

fn contains<S: Sample>() {
    let mut rng = Rng::new(0x0bb);
    for kind in 0..5 {
        let (mut inside, mut asked) = (0, 0);
        for _ in 0..4_000 {
            let given = given::<S>(&mut rng, kind);
            let Some(obb) = given.obb() else { continue };
            let expected = given.contains();
            assert_eq!(obb.contains(given.point), expected, "{} {given:?}", S::name());
            inside += usize::from(expected);
            asked += 1;
        }
        let mixed = inside > 20 && inside < asked - 20;
        // With random exponents almost no point lies inside.
        assert!(mixed || kind > 2, "{} {kind}: {inside} of {asked}", S::name());
    }
}

/// The bounding box of the eight corners: no number of the scalar lies between it and them.
fn aabb<S: Sample>() {
    let mut rng = Rng::new(0xaabb);
    for kind in 0..5 {
        let mut made = 0;
        for _ in 0..4_000 {
            let given = given::<S>(&mut rng, kind);
            let Some(obb) = given.obb() else { continue };
            let aabb = obb.aabb();
            let ends = aabb.map(|aabb| aabb.min_max().unwrap());
            for i in 0..3 {
                let ends = ends.map(|(min, max)| [min.to_array()[i], max.to_array()[i]]);
                check_ends(&given, i, ends, ends.is_none() && aabb.is_none());
            }
            made += usize::from(aabb.is_some());
        }
        assert!(made > 1_000, "{} {kind}: {made} made", S::name());
    }
}

fn check_ends<S: Sample>(given: &Given<S>, i: usize, ends: Option<[S; 2]>, is_none: bool) {
    // In units of the square of the least exponent.
    let extremes = [S::ZERO.moved(1), S::GREATEST, S::LEAST];
    let (whole, one) = Given { point: extremes, ..*given }.whole();
    let reach: IBig = (0..3)
        .map(|k| {
            let product = &whole.axes[k][i] * &whole.half[k];
            let sign = IBig::from(Ring::sign(&product));
            product * sign
        })
        .sum();
    let center = &whole.center[i] * &one;
    let (low, high) = (&center - &reach, &center + &reach);
    let is_float = S::WHOLE_BITS != S::LEAST.ordinal().unsigned_abs().trailing_zeros();
    let [_, greatest, least] = whole.point.each(|x| x * &one);
    let Some([min, max]) = ends else {
        assert!(is_none && is_float);
        return;
    };
    let value = |x: S| {
        let (whole, finer) = Given { point: [x, extremes[0], x], ..*given }.whole();
        assert_eq!(finer, one);
        &whole.point[0] * &one
    };
    let told = || format!("{} {given:?} {i}: {min:?} to {max:?}", S::name());
    if low < least {
        assert!(!is_float && min == S::LEAST, "{}", told());
    } else {
        assert!(value(min) <= low, "{}", told());
        assert!(min == S::GREATEST || value(min.moved(1)) > low, "{}", told());
    }
    if high > greatest {
        assert!(!is_float && max == S::GREATEST, "{}", told());
    } else {
        assert!(value(max) >= high, "{}", told());
        assert!(max == S::LEAST || value(max.moved(-1)) < high, "{}", told());
    }
}

/// The greatest deviation of dot products from an orthonormal frame's, in eighths of one: the
/// deviation times 8, and one², which it must not exceed.
fn off_frame<S: Sample>(axes: &[Point<S>; 3]) -> (IBig, IBig) {
    let given =
        Given { center: [S::ZERO; 3], axes: *axes, half: [S::ZERO; 3], point: [S::ZERO; 3] };
    let (whole, one) = given.whole();
    let square = &one * &one;
    let mut most = IBig::ZERO;
    for i in 0..3 {
        for j in i..3 {
            let target = if i == j { square.clone() } else { IBig::ZERO };
            let off = (IBig::dot(&whole.axes[i], &whole.axes[j]) - target) * IBig::from(8);
            most = most.max(&off * IBig::from(Ring::sign(&off)));
        }
    }
    (most, square)
}

/// Axes near the tolerance are accepted or refused correctly, except within 2^-12 of it in scalars
/// that the check truncates.
fn check_frames<S: Sample>() {
    let mut rng = Rng::new(0xf2a3e);
    let exact = S::ZERO.moved(1).mantissa_exponent().1;
    let is_exact = exact > -15;
    let (mut taken, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let mut axes = rotation::<S>(&mut rng);
        let (i, j) = (rng.below(3), rng.below(3));
        let x = axes[i][j].approximate() + rng.real(-0.13, 0.13);
        axes[i][j] = S::nearest(x);
        if rng.one_in(20) {
            axes[i][j] = [S::LEAST, S::GREATEST, S::ZERO][rng.below(3)];
        }
        let (off, square) = off_frame(&axes);
        let margin = (&off - &square) * IBig::from(Ring::sign(&(&off - &square)));
        if !is_exact && (margin << 9) < square {
            continue;
        }
        let made = Obb::new([S::ZERO; 3], axes, [S::ZERO; 3]).map(drop);
        let expected = if off <= square { Ok(()) } else { Err(ShapeError::NotOrthonormal) };
        assert_eq!(made, expected, "{} {axes:?}", S::name());
        taken += usize::from(made.is_ok());
        refused += usize::from(made.is_err());
    }
    assert!(taken > 2_000 && refused > 2_000, "{}: {taken} taken, {refused} refused", S::name());
}

fn frames<S: Sample>() {
    check_frames::<S>();
}
for_every_scalar!(contains, aabb, frames);

#[test]
fn frames_with_few_integer_bits() {
    check_frames::<I1F31>();
    check_frames::<I2F30>();
    check_frames::<I4F60>();
}

#[test]
fn a_scalar_without_integer_bits_has_no_unit_vector() {
    fn check<S: Sample>() {
        let (zero, half) = (S::ZERO, S::LEAST);
        let axes = [[half, zero, zero], [zero, half, zero], [zero, zero, half]];
        assert_eq!(Obb::new([zero; 3], axes, [zero; 3]), Err(ShapeError::NoUnitLength));
        assert!(Obb::from_skewed_axes([zero; 3], axes, [S::GREATEST; 3]).is_ok());
    }
    check::<I0F8>();
    check::<I0F16>();
    check::<I0F32>();
    check::<I0F64>();
}

/// The `const` constructor checks what `new` checks.
#[test]
fn boxes_are_made_in_a_const() {
    use fixed::types::{I8F8, I16F16};
    use septum::Vec3;

    macro_rules! check {
        ($scalar:ty, $one:expr) => {{
            const Z: $scalar = <$scalar>::from_bits(0);
            const O: $scalar = $one;
            const AXES: [Vec3<$scalar>; 3] =
                [Vec3::new(O, Z, Z), Vec3::new(Z, O, Z), Vec3::new(Z, Z, O)];
            const CENTER: Vec3<$scalar> = Vec3::new(O, Z, O);
            const HALF: Vec3<$scalar> = Vec3::splat(O);
            static BOX: Obb<$scalar> =
                ShapeError::unwrap(Obb::<$scalar>::const_new(CENTER, AXES, HALF));
            assert_eq!(Ok(BOX), Obb::new(CENTER, AXES, HALF));
            let [u, v, _] = AXES;
            let made = Obb::<$scalar>::const_new(CENTER, [u, v, v], HALF);
            assert_eq!(made, Err(ShapeError::NotOrthonormal));
            let negative = Vec3::new(O, Z, -O);
            let made = Obb::<$scalar>::const_new(CENTER, [u, v, v], negative);
            assert_eq!(made, Err(ShapeError::NegativeHalfExtent));
        }};
    }
    check!(f32, 1.0);
    check!(f64, 1.0);
    check!(fixed::types::I4F4, fixed::types::I4F4::ONE);
    check!(I8F8, I8F8::ONE);
    check!(I16F16, I16F16::ONE);
    check!(fixed::types::I32F32, fixed::types::I32F32::ONE);
    let nan = Vec3::new(0.0, f64::NAN, 0.0);
    let made = Obb::<f64>::const_new(Vec3::splat(0.0), [nan; 3], Vec3::splat(1.0));
    assert_eq!(made, Err(not_finite("axes", Some(0))));
}
