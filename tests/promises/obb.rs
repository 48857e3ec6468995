//! A triangle against an oriented box: exact for the parallelepiped that the numbers describe.

use fixed::types::{I1F31, I2F30, I2F62, I4F4, I8F8, I16F16, I32F32};
use septum::published;
use septum::{Aabb, Obb, ShapeError, Triangle, Vec3};
use septum_kit::{Each, Oriented, Rng, Sample, for_every_scalar, not_finite};

/// A rounded random rotation, sometimes a skewed or an axis-parallel frame.
fn axes<S: Sample>(rng: &mut Rng) -> [[S; 3]; 3] {
    let mut frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    match rng.below(4) {
        0 => {}
        1 => {
            for row in &mut frame {
                *row = rng.triple(|r| r.real(-1.0, 1.0));
            }
        }
        _ => {
            for (j, k) in [(0, 1), (1, 2), (2, 0)] {
                let (sin, cos) = rng.real(-3.2, 3.2).sin_cos();
                for row in &mut frame {
                    (row[j], row[k]) = (cos * row[j] - sin * row[k], sin * row[j] + cos * row[k]);
                }
            }
        }
    }
    frame.each(|row| row.each(S::nearest))
}

/// Shapes of about `size`. Every third case is on a coarse grid, where contact is common; there the
/// axes are parallel to the coordinate axes or diagonal.
fn question<S: Sample>(rng: &mut Rng, size: f64) -> Oriented<S> {
    let coarse = rng.one_in(3);
    let number = |rng: &mut Rng, low: f64| {
        let x = rng.real(low, size);
        S::nearest(if coarse { (x * 4.0 / size).round() * size / 4.0 } else { x })
    };
    let mut axes = axes(rng);
    if coarse && rng.one_in(2) {
        axes = [[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 1.0]].each(|u| u.each(S::nearest));
    }
    let mut t = [0; 3].each(|_| rng.triple(|r| number(r, -size)));
    if rng.one_in(8) {
        t[2] = t[1];
    }
    Oriented {
        t,
        center: rng.triple(|r| number(r, -size / 2.0)),
        axes,
        half: rng.triple(|r| number(r, 0.0)),
    }
}

/// Sizes for the type: products of axes and lengths, and a few units.
fn sizes<S: Sample>() -> [f64; 3] {
    let greatest = S::GREATEST.approximate();
    [2.0, (greatest / 2.0).min(1e3), (greatest / 2.0).min(1.0)]
}

fn exact<S: Sample>() {
    let mut rng = Rng::new(0x0bb);
    let (mut met, mut asked) = (0, 0);
    for n in 0..30_000 {
        let q = question::<S>(&mut rng, sizes::<S>()[n % 3]);
        let Some(obb) = q.obb() else { continue };
        let expected = q.meets();
        assert_eq!(q.triangle().overlaps(&obb), expected, "{:?} {obb:?}", q.triangle());
        assert!(!expected || q.triangle().may_overlap(&obb), "{:?} {obb:?}", q.triangle());
        (met, asked) = (met + u32::from(expected), asked + 1);
    }
    assert!(asked > 10_000 && met * 5 > asked && met * 5 < 4 * asked, "{met} of {asked}");
}
for_every_scalar!(exact);

/// Both sides of a flip of the true verdict, and cases a step or two away: nearer to contact than
/// the error bound of the first stage.
fn exact_beside_contact<S: Sample>() {
    let mut rng = Rng::new(0xf11b);
    let (mut flips, mut loose) = (0, 0);
    for n in 0..700 {
        let size = sizes::<S>()[n % 3];
        let q = question::<S>(&mut rng, size);
        let (k, i) = (rng.below(3), rng.below(3));
        let at = |x: S| {
            let mut moved = q;
            moved.t[k][i] = x;
            moved
        };
        let (mut here, mut there) = (q.t[k][i], question::<S>(&mut rng, size).t[k][i]);
        if q.obb().is_none() {
            continue;
        }
        let verdict = q.meets();
        if at(there).meets() == verdict {
            continue;
        }
        while here.ordinal().abs_diff(there.ordinal()) > 1 {
            let middle = here.between(there);
            *(if at(middle).meets() == verdict { &mut here } else { &mut there }) = middle;
        }
        flips += 1;
        for steps in -3..=3 {
            let q = at(here.moved(steps));
            let Some(obb) = q.obb() else { continue };
            let (triangle, expected) = (q.triangle(), q.meets());
            assert_eq!(triangle.overlaps(&obb), expected, "{triangle:?} {obb:?}");
            let may = triangle.may_overlap(&obb);
            assert!(may || !expected, "{triangle:?} {obb:?}");
            loose += u32::from(may && !expected);
        }
    }
    // In 8 bits the least step is wider than the error.
    let is_coarse = S::WHOLE_BITS < 8;
    assert!(flips > 50 && (is_coarse || loose > 0), "{flips} flips, {loose} in doubt");
}
for_every_scalar!(exact_beside_contact);

#[test]
fn exact_at_the_extremes_of_f32_and_of_fixed_point() {
    fn extremes<S: Sample>(pick: impl Fn(&mut Rng) -> S) {
        let mut rng = Rng::new(7);
        for _ in 0..3_000 {
            let mut row = || rng.triple(|r| pick(r));
            let q = Oriented {
                t: [row(), row(), row()],
                center: row(),
                axes: [row(), row(), row()],
                half: row(),
            };
            let half = q.half.each(|h| if h < S::ZERO { S::ZERO } else { h });
            let q = Oriented { half, ..q };
            if let Some(obb) = q.obb() {
                assert_eq!(q.triangle().overlaps(&obb), q.meets(), "{:?} {obb:?}", q.triangle());
            }
        }
    }
    fn ends<S: Sample>(rng: &mut Rng) -> S {
        let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
        end.moved(rng.whole(-2, 2))
    }
    extremes::<f32>(ends);
    extremes::<f64>(ends);
    extremes::<I4F4>(ends);
    extremes::<I8F8>(ends);
    extremes::<I16F16>(ends);
    extremes::<I32F32>(ends);
}

#[test]
fn plain_axes_agree_with_the_axis_aligned_box() {
    let mut rng = Rng::new(3);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].each(Vec3::<f32>::from);
    for _ in 0..20_000 {
        let q = question::<f32>(&mut rng, 2.0);
        let obb = Obb::new(q.center, axes, q.half).unwrap();
        let aabb = Aabb::from_center_half_extents(q.center, q.half).unwrap();
        assert_eq!(q.triangle().overlaps(&obb), q.triangle().overlaps(&aabb));
        assert_eq!(
            published::akenine_moller::overlaps_obb(&q.triangle(), &obb),
            published::akenine_moller::overlaps(&q.triangle(), &aabb)
        );
    }
}

#[test]
fn the_transform_is_right_away_from_contact() {
    let mut rng = Rng::new(4);
    let mut wrong = 0;
    for _ in 0..20_000 {
        let q = question::<f64>(&mut rng, 2.0);
        if let Ok(obb) = Obb::new(q.center, q.axes.each(Vec3::from), q.half) {
            wrong += u32::from(
                published::akenine_moller::overlaps_obb(&q.triangle(), &obb)
                    != q.triangle().overlaps(&obb),
            );
        }
    }
    // The rounded method may fail on contacts of the coarse grid, but on little else.
    assert!(wrong < 600, "{wrong}");
}

#[test]
fn a_frame_is_checked() {
    let frame = |u: [f32; 3], v: [f32; 3], n: [f32; 3]| [u, v, n].each(Vec3::from);
    let make = |axes| Obb::new([0.0_f32; 3], axes, [1.0; 3]).map(|_| ());
    let skew = |axes| Obb::from_skewed_axes([0.0_f32; 3], axes, [1.0; 3]).map(|_| ());
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);

    assert_eq!(make(frame(x, y, z)), Ok(()));
    assert_eq!(make(frame(x, y, [0.0, 0.0, -1.0])), Ok(()), "left-handed frames are frames");
    assert_eq!(make(frame(x, y, [0.1, 0.0, 1.0])), Ok(()), "off by less than an eighth");
    assert_eq!(make(frame(x, y, [0.2, 0.0, 1.0])), Err(ShapeError::NotOrthonormal));
    assert_eq!(make(frame(x, y, [0.0, 0.0, 1.1])), Err(ShapeError::NotOrthonormal));
    assert_eq!(make(frame(x, y, y)), Err(ShapeError::NotOrthonormal));
    assert_eq!(make(frame(x, y, [0.0; 3])), Err(ShapeError::NotOrthonormal));
    assert_eq!(make(frame(x, y, [0.0, f32::NAN, 1.0])), Err(not_finite("axes", Some(2))));

    assert_eq!(skew(frame(x, y, [9.0, 0.0, 1e-30])), Ok(()));
    assert_eq!(skew(frame(x, y, [9.0, 5.0, 0.0])), Err(ShapeError::DependentAxes));
    assert_eq!(skew(frame([1e-30, 0.0, 0.0], [0.0, 1e-30, 0.0], [0.0, 0.0, 1e-30])), Ok(()));

    let negative = Obb::new([0.0_f32; 3], frame(x, y, z), [1.0, -1.0, 1.0]);
    assert_eq!(negative.unwrap_err(), ShapeError::NegativeHalfExtent);
    let far = Obb::new([f32::INFINITY, 0.0, 0.0], frame(x, y, z), [1.0; 3]);
    assert_eq!(far.unwrap_err(), not_finite("center", None));
}

/// Of random pairs, half of them disjoint, fewer than one in a thousand.
#[test]
fn a_false_yes_is_rare_in_every_number_of_fraction_bits() {
    fn count<S: Sample>(size: f64) -> (u32, u32) {
        let mut rng = Rng::new(0xfa15e);
        let (mut disjoint, mut wrong) = (0, 0);
        for _ in 0..6_000 {
            let mut point = || rng.triple(|r| S::nearest(r.real(-2.0 * size, 2.0 * size)));
            let triangle = Triangle::new(point(), point(), point()).unwrap();
            let axes = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];
            let axes = axes.each(|u| Vec3::from(u.each(S::nearest)));
            let half = [S::nearest(size / 2.0); 3];
            let obb = Obb::from_skewed_axes([S::ZERO; 3], axes, half).unwrap();
            let (exact, may) = (triangle.overlaps(&obb), triangle.may_overlap(&obb));
            assert!(may || !exact, "{triangle:?}");
            disjoint += u32::from(!exact);
            wrong += u32::from(may && !exact);
        }
        (disjoint, wrong)
    }
    let found = [
        count::<I4F4>(1.0),
        count::<I8F8>(1.0),
        count::<I16F16>(1.0),
        count::<I2F30>(0.5),
        count::<I1F31>(0.4),
        count::<I32F32>(1.0),
        count::<I2F62>(0.5),
    ];
    for (disjoint, wrong) in found {
        assert!(disjoint > 2_000 && wrong < 6, "{found:?}");
    }
}

#[test]
fn unit_vectors_in_thirty_fraction_bits_may_be_away() {
    type Fx = I2F30;
    let axes = [[1.0, 0.0, 0.0], [0.0, 0.8, 0.6], [0.0, -0.6, 0.8]];
    let axes = axes.each(|u| u.each(Fx::nearest));
    let obb = Obb::new([Fx::ZERO; 3], axes, [Fx::nearest(0.1); 3]).unwrap();
    let point = |x: f64, y: f64, z: f64| [x, y, z].each(Fx::nearest);
    let away = Triangle::new(point(0.5, 0.0, 0.0), point(0.5, 0.5, 0.0), point(0.7, 0.0, 0.5));
    assert!(!away.unwrap().may_overlap(&obb));
}

#[test]
fn eight_bits_hold_a_rotation() {
    let turn = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]].each(|u| u.each(I4F4::nearest).into())
    };
    for degrees in 0..360 {
        let axes: [Vec3<I4F4>; 3] = turn(f64::from(degrees));
        assert!(Obb::new([I4F4::ZERO; 3], axes, [I4F4::ONE; 3]).is_ok(), "{degrees}°");
    }
}
