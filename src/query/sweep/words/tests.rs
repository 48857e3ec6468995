//! Compares words of every width with exact sums.

use fixed::types::{I0F32, I4F4, I8F8, I16F16};

use crate::arithmetic::{Each, InRaw, WholeWord, Word};
use crate::query::Motion;
use crate::query::sweep::passing::{Misses, Passing};
use crate::query::sweep::time::Meets;
use crate::random::Random;
use crate::robust::WordKernel;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Shapes and motions of numbers of these bits.
fn cases<S: Scalar>(bits: u32, of: impl Fn(i64) -> S, mut check: impl FnMut(Passing<'_, S>)) {
    let rng = &mut Random(u64::from(bits));
    for case in 0..12_000 {
        let kind = case % 4;
        let mut point = || [(); 3].each(|()| rng.of_bits(kind, bits));
        let [a, b, mut c, p, q, from, mut to] = [(); 7].map(|()| point());
        match rng.below(8) {
            // Without area, without motion, along an edge, in the plane.
            0 => c = b,
            1 => to = from,
            2 => to = [0, 1, 2].each(|i| from[i] + (b[i] - a[i]) / 2),
            3 => to = [0, 1, 2].each(|i| from[i] + (b[i] - a[i]) / 4 + (c[i] - a[i]) / 4),
            _ => {}
        }
        let vector = |x: [i64; 3]| x.each(&of);
        let triangle = Triangle::new(vector(a), vector(b), vector(c)).unwrap();
        let [min, max] = [i64::min, i64::max].each(|end| [0, 1, 2].each(|i| end(p[i], q[i])));
        let aabb = if rng.below(2) == 0 {
            Aabb::from_min_max(vector(min), vector(max))
        } else {
            let half = [0, 1, 2].each(|i| (max[i] - min[i]) / 4);
            Aabb::from_center_half_extents(vector(min.each(|x| x / 2)), vector(half))
        };
        let (aabb, motion) = (aabb.unwrap(), Motion::new(vector(from), vector(to)).unwrap());
        check(Passing::new(&triangle, &aabb, &motion));
        check(Passing::reversed(&triangle, &aabb, &motion));
    }
}

/// Both questions, the second in words `V`.
fn check<S, W, V>(bits: u32, of: impl Fn(i64) -> S)
where
    S: Scalar + InRaw + InRaw,
    W: Word,
    V: WholeWord,
{
    let (mut seen, mut met) = ([0; 2], [0; 2]);
    cases(bits, of, |passing| {
        let exactly = passing.exactly();
        let expected = exactly.misses::<S>();
        let shapes = (passing.triangle, passing.aabb, passing.ends());
        let question = Misses(passing);
        assert_eq!(question.narrow::<W>(), Some(expected), "{shapes:?}");
        seen[usize::from(expected)] += 1;
        if !expected {
            let expected = exactly.first_contact::<S>();
            let found = Meets { passing: question.0, last: None }.narrow_volumes::<V>();
            assert_eq!(found, Some(expected), "{shapes:?}");
            met[usize::from(expected.axis.is_some())] += 1;
        }
    });
    assert!(seen.iter().all(|&n| n > 4_000) && met.iter().all(|&n| n > 1_000), "{seen:?} {met:?}");
}

fn clamped(x: i64) -> i32 {
    x.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}

#[test]
fn words_agree_with_exact_sums() {
    check::<I4F4, i32, i16>(7, |x| I4F4::from_bits(x.clamp(-128, 127) as i8));
    check::<I8F8, i32, i32>(15, |x| I8F8::from_bits(x.clamp(-32768, 32767) as i16));
    check::<I16F16, i32, i32>(16, |x| I16F16::from_bits(clamped(x)));
    check::<I16F16, i64, i64>(31, |x| I16F16::from_bits(clamped(x)));
    check::<I0F32, i64, i64>(31, |x| I0F32::from_bits(clamped(x)));
}

/// There is no answer for shapes and motions that a word cannot hold.
#[test]
fn words_leave_what_is_far() {
    let at = |x: i32| [x, 0, 0].each(I16F16::from_bits);
    let is_known = |vertex: i32, min: i32, from: i32, to: i32| {
        let aabb = Aabb::from_min_max(at(min), at(min)).unwrap();
        let (triangle, motion) = (
            Triangle::new(at(vertex), at(0), at(0)).unwrap(),
            Motion::new(at(from), at(to)).unwrap(),
        );
        Misses(Passing::new(&triangle, &aabb, &motion)).narrow::<i32>().is_some()
    };
    let most = (1 << 17) - 1;
    assert!(is_known(most, 0, 0, most) && is_known(most, -most, -most, -most));
    assert!(is_known(0, 0, most, -most) && is_known(0, 0, 1 << 28, (1 << 28) + 1));
    // Differences that wrap to short ones, and long ones.
    for (vertex, min, from, to) in [
        (0, 0, i32::MIN, i32::MAX),
        (0, 0, i32::MAX, i32::MIN),
        (0, i32::MIN, 0, 0),
        (i32::MAX, -1, 0, 0),
        (0, 0, 0, 1 << 30),
        (0, 0, 0, i32::MIN),
        (1 << 28, 0, 0, 1 << 28),
    ] {
        assert!(!is_known(vertex, min, from, to), "{vertex} {min} {from} {to}");
    }
}

/// There is no first contact for shapes whose volumes a word cannot hold.
#[test]
fn words_leave_what_is_far_for_volumes() {
    let at = |x: i32| [x, 0, 0].each(I16F16::from_bits);
    let is_known = |vertex: i32, half: i32| {
        let triangle = Triangle::new(at(vertex), at(0), at(0)).unwrap();
        let aabb = Aabb::from_center_half_extents(at(0), at(half)).unwrap();
        let motion = Motion::new(at(0), at(0)).unwrap();
        let passing = Passing::new(&triangle, &aabb, &motion);
        Meets { passing, last: None }.narrow_volumes::<i32>().is_some()
    };
    let most = (1 << 18) - 1;
    assert!(is_known(most, 0) && is_known(-most - 1, 0) && is_known(0, most / 2));
    // Twice the last extent is the end of the word, and four times it is zero.
    for (vertex, half) in [(most + 1, 0), (-most - 2, 0), (0, most), (0, 1 << 30)] {
        assert!(!is_known(vertex, half), "{vertex} {half}");
    }
}
