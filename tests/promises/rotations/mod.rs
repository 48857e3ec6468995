//! Oriented boxes from rotations, compared with integers of any size: the error of each component,
//! and of the frame.

mod oracle;

use dashu_int::IBig;
use dashu_int::ops::Abs;
use fixed::types::{I0F16, I1F7, I1F63, I2F30, I4F4, I5F3, I8F8, I16F0, I16F16, I32F32};
use septum::{Obb, ShapeError, Vec3};
use septum_kit::{Each, Parts, Rng, Sample, not_finite};

use oracle::{Frame, UNIT, by_hamilton, by_steps, one, power_of_two, times, value};

/// The permitted error of a component: half a unit of its last place, plus this power of two.
#[derive(Clone, Copy)]
struct Allowed {
    /// The fraction bits of a fixed-point type.
    fraction: Option<i32>,
    /// Whether a half of the float's last place is allowed.
    half: bool,
    more: Option<i32>,
    greatest: Parts,
}

impl Allowed {
    fn for_component(&self, (_, e): Parts) -> IBig {
        let half = match self.fraction {
            Some(bits) => power_of_two(-bits - 1),
            None if self.half => power_of_two((e - 1).max(-UNIT)),
            None => IBig::ZERO,
        };
        half + self.more.map_or(IBig::ZERO, power_of_two)
    }
}

/// Each component is within the permitted error, and so are the dot products of the axes.
fn check_frame(found: &Frame<Parts>, truth: &Frame<IBig>, allowed: Allowed, told: &str) -> f64 {
    let (mut greatest, mut most) = (IBig::ZERO, 0.0_f64);
    let one = one();
    for (found, truth) in found.as_flattened().iter().zip(truth.as_flattened()) {
        let may = allowed.for_component(*found);
        let off = (value(*found) - truth).abs();
        // Types without a number 1 use the greatest number.
        let is_cut = *found == allowed.greatest && value(*found) < one && *truth > value(*found);
        assert!(off <= may || is_cut, "{told}: {found:?} of {truth:?}");
        let share = (&off >> 100).to_f64().value() / (&may >> 100).to_f64().value();
        most = most.max(if is_cut { 0.0 } else { share });
        greatest = greatest.max(if is_cut { off } else { may });
    }
    // 2√3·h + 3·h², with √3 < 1.7321.
    let h = greatest;
    let room = (&h * IBig::from(34_642)) / IBig::from(10_000) + times(&h, &h) * IBig::from(3) + 1;
    for i in 0..3 {
        for j in 0..3 {
            let dot: IBig = (0..3).map(|k| times(&value(found[i][k]), &value(found[j][k]))).sum();
            let should = if i == j { one.clone() } else { IBig::ZERO };
            assert!((dot - should).abs() <= &room + 3, "{told}: axes {i} and {j}");
        }
    }
    most
}

/// The input numbers in the scalar, and the axes computed from them.
type Made<const K: usize> = ([Parts; K], Frame<Parts>);

/// A type, as functions that are not generic.
struct Type {
    name: String,
    by_quaternion: fn([f64; 4]) -> Result<Made<4>, ShapeError>,
    by_turns: fn([f64; 3]) -> Made<3>,
    quaternion: Allowed,
    turns: Allowed,
}

fn axes_of<S: Sample>(obb: &Obb<S>) -> Frame<Parts> {
    obb.axes().each(|axis| axis.to_array().each(S::mantissa_exponent))
}

impl Type {
    fn new<S: Sample>(fraction: Option<i32>, quaternion: Option<i32>, turns: i32) -> Self {
        let half = S::name() == "f32";
        let greatest = S::GREATEST.mantissa_exponent();
        Self {
            name: S::name(),
            by_quaternion: |q| {
                let q = q.each(S::nearest);
                let obb = Obb::from_quaternion([S::ZERO; 3], q, [S::GREATEST; 3])?;
                Ok((q.each(S::mantissa_exponent), axes_of(&obb)))
            },
            by_turns: |turns| {
                let turns = turns.each(S::nearest);
                let obb = Obb::from_turns([S::ZERO; 3], turns, [S::GREATEST; 3]).unwrap();
                (turns.each(S::mantissa_exponent), axes_of(&obb))
            },
            quaternion: Allowed { fraction, half, more: quaternion, greatest },
            turns: Allowed { fraction, half, more: Some(turns), greatest },
        }
    }

    fn all() -> [Self; 8] {
        [
            Self::new::<f32>(None, Some(-50), -48),
            Self::new::<f64>(None, Some(-50), -48),
            Self::new::<I4F4>(Some(4), None, -25),
            Self::new::<I1F7>(Some(7), None, -25),
            Self::new::<I16F16>(Some(16), None, -25),
            Self::new::<I2F30>(Some(30), None, -57),
            Self::new::<I32F32>(Some(32), None, -57),
            Self::new::<I1F63>(Some(63), None, -57),
        ]
    }
}

/// The numbers of a quaternion: of any direction, along an axis or nearly, with two equal
/// components.
fn quaternion(rng: &mut Rng, round: usize) -> [f64; 4] {
    let mut q = [(); 4].each(|()| rng.real(-1.0, 1.0));
    match round % 4 {
        0 => q[rng.below(4)] = 0.0,
        1 => {
            for _ in 0..3 {
                q[rng.below(4)] *= 2_f64.powi(-(rng.below(40) as i32));
            }
        }
        2 => q[rng.below(4)] = q[rng.below(4)],
        _ => {}
    }
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Not quite of length one, which makes no difference within the tolerance.
    let length = length * if round % 3 == 0 { rng.real(0.93, 1.07) } else { 1.0 };
    q.each(|x| x / length)
}

#[test]
fn a_quaternion_makes_the_nearest_frame() {
    let types = Type::all();
    let mut most = [0.0_f64; 8];
    let rng = &mut Rng::new(0x9a7e);
    let mut asked = 0;
    for round in 0..1_500 {
        let q = quaternion(rng, round);
        for (most, kind) in most.iter_mut().zip(&types) {
            let told = format!("{} {q:?}", kind.name);
            let Ok((q, found)) = (kind.by_quaternion)(q) else { continue };
            let truth = by_hamilton(&q.each(value));
            *most = most.max(check_frame(&found, &truth, kind.quaternion, &told));
            asked += 1;
        }
    }
    assert!(asked > 10_000, "{asked}");
    // The bounds are nearly reached, except in f64, whose bound is for the worst case.
    assert!(most.iter().enumerate().all(|(i, &m)| m > if i == 1 { 0.1 } else { 0.9 }), "{most:?}");
}

#[test]
fn turns_make_a_frame_within_the_bound() {
    let types = Type::all();
    let mut most = [0.0_f64; 8];
    let rng = &mut Rng::new(0x7a45);
    for round in 0..400 {
        let mut turns = rng.triple(|rng| rng.real(-3.0, 3.0));
        if round % 2 == 0 {
            turns[rng.below(3)] = 0.0;
            turns[rng.below(3)] = rng.below(17) as f64 / 16.0;
        }
        for (most, kind) in most.iter_mut().zip(&types) {
            let (turns, found) = (kind.by_turns)(turns);
            let told = format!("{} {turns:?}", kind.name);
            let truth = by_steps(&turns.each(value));
            *most = most.max(check_frame(&found, &truth, kind.turns, &told));
        }
    }
    // The bounds are nearly reached, except where they are for the worst case.
    let least = |i| if matches!(i, 1 | 7) { 0.04 } else { 0.9 };
    assert!(most.iter().enumerate().all(|(i, &m)| m > least(i)), "{most:?}");
}

/// Every quaternion of I4F4 gives the nearest components.
#[test]
fn every_quaternion_of_four_bits() {
    let (mut taken, mut refused) = (0, 0);
    let range = -18_i32..=18;
    for x in range.clone() {
        for (y, z, w) in [(0, 0, 1), (1, 0, 0), (0, 1, 0), (1, 1, 1), (-1, 1, 2)] {
            for (a, b) in range.clone().flat_map(|a| range.clone().map(move |b| (a, b))) {
                let q = [x, y * a + z * b, z * a + w * b, w * a + y * b];
                let square: i32 = q.iter().map(|x| x * x).sum();
                let number = q.each(|x| I4F4::from_bits(x.clamp(-100, 100) as i8));
                let made = Obb::from_quaternion([I4F4::ZERO; 3], number, [I4F4::ONE; 3]);
                assert_eq!(made.is_ok(), (192..=320).contains(&square), "{q:?}");
                let Ok(made) = made else {
                    assert_eq!(made, Err(ShapeError::NotUnitQuaternion));
                    refused += 1;
                    continue;
                };
                taken += 1;
                // `new` accepts the frame too.
                assert_eq!(Obb::new(made.center(), *made.axes(), made.half_extents()), Ok(made));
                let truth = by_hamilton(&q.each(IBig::from));
                for (axis, truth) in made.axes().iter().zip(truth) {
                    for (found, truth) in axis.to_array().into_iter().zip(truth) {
                        let off: IBig = IBig::from(found.to_bits()) * (one() / 16) - &truth;
                        // No component is a midpoint of two numbers: the reduced denominator of a
                        // rotation's component is no multiple of 8.
                        assert!(off.abs() < one() / 32, "{q:?}: {made:?}");
                    }
                }
            }
        }
    }
    assert!(taken > 1_000 && refused > 1_000, "{taken} {refused}");
}

/// Quarter turns are exact, in any number and order.
fn quarters<S: Sample>() {
    let [zero, one] = [0.0, 1.0].each(S::nearest);
    for n in 0..512_i32 {
        let quarters = [n % 8 - 4, n / 8 % 8 - 4, n / 64 - 4];
        let turns = quarters.each(|n| S::nearest(f64::from(n) * 0.25));
        let found = Obb::from_turns([zero; 3], turns, [one; 3]).unwrap();
        let mut axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        for (i, n) in quarters.into_iter().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            for axis in &mut axes {
                for _ in 0..n.rem_euclid(4) {
                    let negative = S::nearest(-axis[k].approximate());
                    (axis[j], axis[k]) = (negative, axis[j]);
                }
            }
        }
        assert_eq!(found.axes(), &axes.each(Vec3::from), "{quarters:?}");
    }
}

#[test]
fn quarters_are_exact() {
    quarters::<f32>();
    quarters::<f64>();
    quarters::<I4F4>();
    quarters::<I16F16>();
    quarters::<I32F32>();
}

#[test]
fn what_is_no_rotation_is_refused() {
    let by = |q| Obb::from_quaternion([0.0; 3], q, [1.0_f32; 3]).map(drop);
    assert_eq!(by([0.0, 0.0, 0.0, 1.0]), Ok(()));
    assert_eq!(by([0.0; 4]), Err(ShapeError::NotUnitQuaternion));
    assert_eq!(by([1.0; 4]), Err(ShapeError::NotUnitQuaternion));
    assert_eq!(by([f32::MAX; 4]), Err(ShapeError::NotUnitQuaternion));
    assert_eq!(by([0.0, 0.0, 1.12, 0.0]), Err(ShapeError::NotUnitQuaternion));
    assert_eq!(by([0.0, 0.0, 1.1, 0.0]), Ok(()));
    let most = Obb::from_quaternion([0.0; 3], [f64::MAX; 4], [1.0; 3]);
    assert_eq!(most, Err(ShapeError::NotUnitQuaternion));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for i in 0..4 {
            let mut q = [0.5; 4];
            q[i] = bad;
            assert_eq!(by(q), Err(not_finite("quaternion", Some(i))));
            let mut turns = [0.5; 3];
            turns[i % 3] = bad;
            let made = Obb::from_turns([0.0; 3], turns, [1.0; 3]);
            assert_eq!(made, Err(not_finite("turns", None)));
            let made = Obb::from_turns(turns, [0.0; 3], [1.0; 3]);
            assert_eq!(made, Err(not_finite("center", None)));
        }
    }
    let negative = Obb::from_turns([0.0_f32; 3], [0.0; 3], [1.0, -1.0, 1.0]);
    assert_eq!(negative, Err(ShapeError::NegativeHalfExtent));
    // All numbers at the ends of a type.
    for ends in [[I1F63::MIN; 4], [I1F63::MAX; 4]] {
        let made = Obb::from_quaternion([I1F63::ZERO; 3], ends, [I1F63::MAX; 3]);
        assert_eq!(made, Err(ShapeError::NotUnitQuaternion));
    }
    let none = [I0F16::ZERO; 3];
    assert_eq!(Obb::from_turns(none, none, none), Err(ShapeError::NoUnitLength));
    let q = [I0F16::MIN; 4];
    assert_eq!(Obb::from_quaternion(none, q, none), Err(ShapeError::NoUnitLength));
    // Eighths cannot represent every frame.
    let mut no_frames = 0;
    for n in 0..17_i32.pow(4) {
        let q =
            [n % 17, n / 17 % 17, n / 289 % 17, n / 4913].each(|x| I5F3::from_bits(x as i8 - 8));
        match Obb::from_quaternion([I5F3::ZERO; 3], q, [I5F3::ONE; 3]) {
            Ok(made) => {
                assert_eq!(Obb::new(made.center(), *made.axes(), made.half_extents()), Ok(made));
            }
            Err(error) => no_frames += u32::from(error == ShapeError::NotOrthonormal),
        }
    }
    assert!(no_frames > 100, "{no_frames}");
    // Integers can represent quarter turns.
    let made = Obb::from_turns([I16F0::ZERO; 3], [I16F0::ONE; 3], [I16F0::ONE; 3]).unwrap();
    assert_eq!(made.axes()[2].z, I16F0::ONE);
    assert!(Obb::from_turns([I8F8::ZERO; 3], [I8F8::MIN; 3], [I8F8::ONE; 3]).is_ok());
}
