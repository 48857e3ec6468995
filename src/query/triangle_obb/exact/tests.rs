use fixed::types::{I4F4, I8F8, I16F16};

use crate::arithmetic::{Each, InRaw, WholeWord};
use crate::query::triangle_obb::Disjoint;
use crate::random::Random;
use crate::robust::{Predicate, WordKernel};
use crate::scalar::Scalar;
use crate::shape::{Obb, Triangle};

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
        let expected = question.exact();
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
