use fixed::types::{I4F4, I8F8, I16F16};

use super::{ExactParallelepiped, InSums};
use crate::arithmetic::{Each, InRaw, WholeWord};
use crate::query::triangle_obb::Disjoint;
use crate::random::Random;
use crate::robust::{Predicate, Uncertain, WordKernel};
use crate::scalar::Scalar;
use crate::shape::{Obb, Triangle};

/// The answer of exact sums alone.
fn in_sums<S: Scalar>(question: &Disjoint<'_, S>) -> bool {
    let (triangle, obb) = (question.triangle.points(), question.obb.numbers());
    ExactParallelepiped::<InSums<S>>::new(triangle, obb).answer::<Uncertain>()
}

/// Words agree with exact sums, for numbers of so many bits and lengths with so many zeros below
/// them. Returns how often words answer: always, unless differences wrap around.
fn check<S: Scalar + InRaw, W: WholeWord>(bits: u32, zeros: u32, of: impl Fn(i64) -> S) -> u32 {
    let mut random = Random(1);
    let (mut asked, mut answered, mut apart) = (0, 0, 0);
    for case in 0..2_000 {
        let mut point = || [(); 3].each(|()| random.of_bits(case % 3, bits));
        let axes = [(); 3].each(|()| point().each(&of));
        let half = point().each(|x| of((x >> 2).abs() << zeros));
        let mut vector = || point().each(|x| of(x << zeros));
        let (center, triangle) = (vector(), Triangle::new(vector(), vector(), vector()));
        let triangle = triangle.unwrap();
        let Ok(obb) = Obb::from_skewed_axes(center, axes, half) else { continue };
        let question = Disjoint::new(&triangle, &obb);
        let expected = in_sums(&question);
        assert_eq!(question.exact(), expected, "{triangle:?} {obb:?}");
        let found = question.narrow_volumes::<W>();
        // Differences of these wrap around.
        let is_far = bits + zeros > 30 && found.is_none();
        assert!(is_far || found == Some(expected), "{found:?} {triangle:?} {obb:?}");
        asked += 1;
        answered += u32::from(found.is_some());
        apart += u32::from(expected);
    }
    assert!(asked > 1_000 && (asked / 20..asked).contains(&apart), "{apart} of {asked}");
    answered
}

#[test]
fn words_agree_with_exact_sums() {
    check::<I4F4, i16>(7, 0, |x| I4F4::from_bits(x as i8));
    check::<I8F8, i32>(15, 0, |x| I8F8::from_bits(x as i16));
    check::<I16F16, i32>(18, 0, |x| I16F16::from_bits(x as i32));
    check::<I16F16, i32>(18, 10, |x| I16F16::from_bits(x as i32));
    check::<I16F16, i32>(3, 24, |x| I16F16::from_bits(x as i32));
    assert_eq!(check::<I16F16, i32>(3, 28, |x| I16F16::from_bits(x as i32)), 0, "wraps: is far");
    check::<I16F16, i64>(31, 0, |x| I16F16::from_bits(x as i32));
}

/// A wrapped difference would pass as a short one if all zeros were removed.
#[test]
fn wrapped_differences_stay_far() {
    let at = |p: [i32; 3]| p.each(|x| I16F16::from_bits(x << 28));
    let triangle = Triangle::new(at([7, -1, -1]), at([-8, -1, -1]), at([-8, -1, 0])).unwrap();
    let (zero, one) = (I16F16::ZERO, I16F16::ONE);
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let obb = Obb::new(at([-1; 3]), axes, at([0; 3])).unwrap();
    let question = Disjoint::new(&triangle, &obb);
    assert_eq!((question.exact(), question.narrow_volumes::<i32>()), (false, None));
}

/// A look at cut numbers before exact sums changes no answer: of shapes of all sizes, from all distances
/// relative to their size, that touch or nearly do.
#[test]
fn cut_numbers_agree_with_exact_sums() {
    let (mut random, mut apart) = (Random(7), 0);
    for case in 0..4_000 {
        let mut whole = |bits: u32| random.of_bits(i64::from(case % 4), bits) as f64;
        let size = crate::arithmetic::exp2(([0, -160, 160, -250, 200][case as usize % 5]) - 3);
        let far = [0.0, 1000.0, 1e8, 1e16][case as usize / 5 % 4] * size;
        let axes = if case % 3 == 0 {
            [[0.0, 1.0, 0.0], [-1.0, 6.1e-17, 0.0], [0.0, 1e-30, 1.0]]
        } else {
            [(); 3].each(|()| [(); 3].each(|()| whole(8) / 256.0))
        };
        let half = [(); 3].each(|()| whole(3).abs() * size);
        let mut point = || [(); 3].each(|()| whole(4) * 0.1 * size + far);
        let center = point();
        // A vertex on a face of the box, as rounded.
        let mut touch = point();
        touch[0] = center[0] + half[1];
        let Ok(triangle) = Triangle::new(touch, point(), point()) else { continue };
        let Ok(obb) = Obb::from_skewed_axes(center, axes, half) else { continue };
        let question = Disjoint::new(&triangle, &obb);
        let expected = in_sums(&question);
        assert_eq!(question.exact(), expected, "{triangle:?} {obb:?}");
        apart += u32::from(expected);
    }
    assert!((500..3_500).contains(&apart), "{apart}");
}

/// On hosts too, words answer for shapes of 64 bits on a grid.
#[test]
fn grids_of_long_numbers_fit_words() {
    use crate::arithmetic::{REGISTERS_ARE_WIDE, SMALL_CODE};
    use fixed::types::I32F32;

    let at = |p: [i64; 3]| p.each(|x| I32F32::from_bits(x << 30));
    let obb = Obb::from_skewed_axes(
        at([4, 4, 4]),
        [at([0, 4, 0]), at([-4, 0, 0]), at([0, 0, 4])],
        at([4; 3]),
    );
    let obb = obb.unwrap();
    for (x, is_apart) in [(7, false), (8, false), (9, true)] {
        let triangle = Triangle::new(at([x, 1, 2]), at([x, 5, 1]), at([x + 3, 2, 9])).unwrap();
        let answer = Predicate::in_words(&Disjoint::new(&triangle, &obb), false);
        let expected = (REGISTERS_ARE_WIDE && !SMALL_CODE || x != 8).then_some(is_apart);
        assert_eq!(answer, expected, "{x}");
    }
}
