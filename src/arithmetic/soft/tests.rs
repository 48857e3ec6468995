use super::{Divisor, ROOT_ROUNDOFFS, Slack, Soft, inverse, root, whole};
use crate::arithmetic::{Double, Each};
use crate::random::Random;

#[test]
fn roots_of_floats_err_by_two_roundoffs() {
    for n in (1..1_u32 << 26).step_by(9973) {
        let x = f64::from(n);
        for scale in [1.0, 2_f64.powi(-301), 2_f64.powi(300)] {
            let off = (root(x * scale * (x * scale)) - x * scale).abs();
            assert!(off <= f64::from(ROOT_ROUNDOFFS) * f64::EPSILON / 2.0 * x * scale, "{x}");
        }
    }
}

fn number(x: u64) -> Soft {
    Soft::of_limbs(&[x]).unwrap()
}

/// Whether it is exactly x.
fn is(number: Soft, x: u64) -> bool {
    let (m, exponent) = number.upper();
    number.slack == 0 && whole(m, exponent, true) == u128::from(x)
}

#[test]
fn short_numbers_stay_exact() {
    for a in [1, 2, 3, 5, 12, 1 << 20, 99_999] {
        for b in [1, 4, 7, 1 << 31, 65_537] {
            assert!(is(number(a).times(number(b)), a * b));
            assert!(is(number(a).plus(number(b)), a + b));
            assert!(is(number(a * b).over(number(b)), a));
            assert!(is(number(a * a).root(), a));
        }
    }
    assert!(number(2).root().slack == 1 && number(1).over(number(3)).slack > 0);
}

#[test]
fn exact_numbers_in_two_words_have_the_bits_of_whole_numbers() {
    let mut random = Random(0x2bad);
    let mut held = 0;
    for n in 0..10_000 {
        let (a, b) = (random.bits() >> (16 + n % 40), random.bits() >> (16 + n % 47));
        let x = Double::difference(a as f64 * 2_f64.powi(12), b as f64);
        if x.high == 0.0 {
            continue;
        }
        let whole = (i128::from(a) << 12) - i128::from(b);
        let size = whole.unsigned_abs();
        let expected = Soft::of_limbs(&[size as u64, (size >> 64) as u64]);
        assert_eq!(x.in_soft(), expected, "{a} {b}");
        let fine = Double { high: x.high, low: x.low + x.high * 2_f64.powi(-70) };
        held += u32::from(fine.in_soft().is_some());
    }
    assert!(held < 5_000, "{held}");
}

/// Place by place the quotient has the bits of two long divisions.
#[test]
fn both_divisions_agree() {
    let mantissas = [1 << 63, (1 << 63) + 1, u64::MAX, u64::MAX - 1, 0xb504_f333_f9de_6484];
    let slacks = [0, 1, 2, 5, 70, 12_345, 1 << 22];
    let all = mantissas
        .map(|mantissa| slacks.map(|slack| Soft { exponent: (slack % 9) as i32, mantissa, slack }));
    for num in all.as_flattened() {
        for den in all.as_flattened() {
            let ((a, s), (b, t)) = (num.parts(), den.parts());
            let (least, most) = ((a << 63) / (b + t), ((a + s) << 63).div_ceil(b));
            let expected = Soft::of(least, most - least, num.exponent - den.exponent - 63);
            assert_eq!(
                num.over_by_inverse(&Divisor { of: *den, inverse: inverse(den.mantissa) }),
                expected,
                "{num:?} / {den:?}"
            );
            assert_eq!(num.over(*den), expected, "{num:?} / {den:?}");
        }
    }
}

#[test]
fn roots_by_reciprocals_are_those_of_whole_numbers() {
    let some = [0, 1, 2, 3, 4, 99, 1 << 62, (1 << 63) + 1, u64::MAX - 1, u64::MAX];
    let least = 1 << 126;
    let check = |square: u128| {
        let root = square.isqrt();
        let found = super::root_by_reciprocal(square);
        assert_eq!((found.0.into(), found.1), (root, root * root == square), "{square}");
    };
    for x in some.map(u128::from) {
        let square = (x | 1 << 63) * (x | 1 << 63);
        for near in [square - 1, square, square + 1, least + x, least | x << 64, least | x << 62] {
            check(near.max(least));
        }
    }
    let mut random = Random(0x1007);
    for n in 0..100_000 {
        // A root with a lower half of few digits, or of ones.
        let (x, y) = (random.bits() | 1 << 63, random.bits());
        let root = u128::from(match n % 4 {
            0 => x,
            1 => x >> 32 << 32 | y >> (32 + n % 32),
            2 => x >> (n % 60) << (n % 60),
            _ => x | ((1 << (n % 64)) - 1),
        });
        let square = root * root;
        for near in [square - 1, square, square + 1, square + root, square + 2 * root] {
            check(near.max(least));
        }
    }
    check(u128::MAX);
}

#[test]
fn bounds_hold_where_bits_are_lost() {
    let long = Soft::of_limbs(&[1, 0, 7]).unwrap();
    assert!(long.slack == 1);
    let near = Soft::of_limbs(&[0, 0, 7]).unwrap();
    assert!(!near.is_less_than(long) && !long.is_less_than(near));
    let sum = near.plus(number(1));
    assert!(sum.slack > 0 && sum.mantissa == near.mantissa);
    assert!(number(6).is_less_than(number(7)) && !number(7).is_less_than(number(7)));
    assert!(number(1).is_less_than(near) && !near.is_less_than(number(1)));
    assert!(number(u64::MAX).is_less_than(Soft::of_limbs(&[0, 1]).unwrap()));
    // As far as is known, three thirds are one.
    let third = number(1).over(number(3));
    let one = third.plus(third).plus(third);
    assert!(!one.is_less_than(number(1)) && !number(1).is_less_than(one) && one.slack < 64);
    let (square, two) = (number(2).root().times(number(2).root()), number(2));
    assert!(!square.is_less_than(two) && !two.is_less_than(square));
}

/// Numbers that are known as roughly as may be, in the operations of a root of an equation.
#[test]
fn wide_bounds_hold() {
    let apart = 2_f64.powi(if Slack::BITS == 64 { -33 } else { -43 });
    let ends = |x: f64| [x * (1.0 - apart), x * (1.0 + apart)];
    let at = |p: f64, q: f64, a: f64| (p + q.sqrt() * a.sqrt()) / a;
    for (p, q, a) in [(1.0, 1.0, 1.0), (3.9, 0.1, 1e-9), (1e100, 7.5, 1e-100), (1e-9, 2.0, 5.0)] {
        let [p, q, a] = [p, q, a].each(ends);
        let [known_p, known_q, known_a] =
            [p, q, a].each(|[low, high]| Soft::between(low, high).unwrap());
        let sum = known_p.plus(known_q.root().times(known_a.root()));
        let root = sum.over(known_a);
        // Within what `f64` rounds.
        let (low, high) = (root.in_double(), root.above().in_double() * (1.0 + 1e-15));
        let [least, most] = [at(p[0], q[0], a[1]) * (1.0 + 1e-15), at(p[1], q[1], a[0])];
        assert!(low <= least && most <= high, "{p:?} {q:?} {a:?}");
        assert!(high / low - 1.0 < 32.0 * apart);
    }
    assert_eq!(Soft::between(1.0, 1.0 + 2_f64.powi(-29)), None);
}

/// Both by one division and place by place.
#[test]
fn leading_bits_are_divided_as_whole_numbers() {
    let limbs = [1, 3, 0x2a5c_93d1, u64::MAX / 3, 1 << 63, u64::MAX];
    let numbers = limbs.map(|low| [0, 1, 0x7b1e_4f27, u64::MAX].each(|high| [low, high]));
    for num in numbers.as_flattened() {
        let whole = u128::from(num[1]) << 64 | u128::from(num[0]);
        let zeros = whole.leading_zeros();
        let n = Soft::of_limbs(num).unwrap();
        assert_eq!(n.mantissa, ((whole << zeros) >> 64) as u64);
        assert_eq!(n.exponent, 64 - zeros as i32);
        for den in numbers.as_flattened() {
            let d = Soft::of_limbs(den).unwrap();
            let expected = (u128::from(n.mantissa) << 63) / u128::from(d.mantissa);
            let exponent = n.exponent - d.exponent - 63;
            assert_eq!(n.quotient(d), (expected as u64, exponent), "{num:?} / {den:?}");
        }
    }
    assert_eq!(Soft::ZERO.quotient(Soft::ONE).0, 0);
}

/// Of exact numbers in two words, and of numbers beside them.
#[test]
fn leading_digits_are_those_of_whole_numbers() {
    let mut random = Random(0x1ead);
    let mut known = 0;
    for n in 0..20_000 {
        let (a, b) = (random.bits() >> (11 + n % 40), random.bits() >> (11 + n % 47));
        let whole = (i128::from(a) << 20) - i128::from(b);
        let size = whole.unsigned_abs();
        let x = Double::difference(a as f64 * 1_048_576.0, b as f64);
        for error in [0.0, 1e-6 * (a as f64), 1.0, a as f64] {
            let Some(found) = x.leading(error) else { continue };
            let off = error.min(size as f64) as u128;
            let bits = |x: Soft| (x.exponent, x.mantissa);
            for near in [size, size - off, size + off] {
                let truth = bits(Soft::of_limbs(&[near as u64, (near >> 64) as u64]).unwrap());
                assert!(bits(found[0]) <= truth && truth <= bits(found[1]), "{a} {b} {error}");
            }
            known += u32::from(found[0] == found[1]);
        }
    }
    assert!(known > 5_000, "{known}");
    let near_zero = Double { high: f64::MIN_POSITIVE, low: 0.0 };
    assert_eq!([Double::ZERO, near_zero].each(|x| x.leading(0.0)), [None; 2]);
}
