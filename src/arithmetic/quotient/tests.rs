//! Quotients against their definition, and all types against each other.

use super::*;

/// The definition: within half a unit, and even if two integers are equally near.
fn check(num: i128, den: i128, shift: u32, q: i64) {
    let (n, d) = (num << shift, den);
    let (error, half) = ((n - i128::from(q) * d).abs() * 2, d.abs());
    assert!(error < half || error == half && q % 2 == 0, "{num}·2^{shift} / {den} = {q}");
}

#[test]
fn every_type_agrees_with_the_definition() {
    for num in -40_i32..=40 {
        for den in (-9_i32..=9).filter(|&d| d != 0) {
            for shift in [0, 1, 2, 4, 7, 16, 31] {
                let q = num.quotient(den, shift);
                check(num.into(), den.into(), shift, q);
                assert_eq!(q, i64::from(num).quotient(den.into(), shift));
                assert_eq!(q, i128::from(num).quotient(den.into(), shift));
                assert_eq!(q, I256::from(i128::from(num)).quotient(i128::from(den).into(), shift));
                let wide = |x: i32| I256::product(i128::from(x) << 100, 1 << 40);
                assert_eq!(q, wide(num).quotient(wide(den), shift));
            }
        }
    }
}

/// If a double rounds its operands, the guess may be the odd neighbour.
#[test]
fn ties_of_large_numbers_are_even() {
    for k in 0..2000_i64 {
        let (q, half) = ((1 << 40) - 2 - k, (1 << 21) + 2 * k + 1);
        for (num, den) in [((2 * q + 1) * half, 2 * half), (-(2 * q + 1) * half, 2 * half)] {
            check(num.into(), den.into(), 0, num.quotient(den, 0));
            check(num.into(), den.into(), 0, i128::from(num).quotient(den.into(), 0));
        }
    }
}

/// A guess uses the leading bits of both numbers, or is not made.
#[test]
fn quotients_of_numbers_beyond_a_word() {
    for den_bits in 20..100 {
        for bits in 2..(121 - den_bits).min(62) {
            for odd in [1_i128, 0x2a5c_93d1, -0x7b1e_4f27] {
                let den = (1_i128 << den_bits) + (odd << (den_bits / 2)) + 1;
                let num = (den << bits) / 3 + odd;
                if den > 0 {
                    check(num, den, 0, num.quotient(den, 0));
                    check(-num, den, 0, (-num).quotient(den, 0));
                }
            }
        }
    }
}

#[test]
fn long_division_goes_on_where_one_does_not_reach() {
    let den = (1_i64 << 61) - 1;
    for num in [den - 1, den / 3, 1, 5 * (den / 7), den] {
        for shift in [8, 16, 32] {
            let q = num.quotient(den, shift);
            check(num.into(), den.into(), shift, q);
            let wide = |x: i64| I256::product(i128::from(x) << 66, 1 << 60);
            assert_eq!(q, wide(num).quotient(wide(den), shift));
            let wide = |x: i64| i128::from(x) << 64;
            assert_eq!(q, wide(num).quotient(wide(den), shift));
        }
    }
}

#[test]
fn what_is_too_large_ends_at_the_end() {
    assert_eq!((1_i64 << 60).quotient(-1, 16), i64::MIN);
    assert_eq!((1_i128 << 120).quotient(1, 0), i64::MAX);
    let large = I256::product(1 << 120, 1 << 62);
    assert_eq!(large.quotient(I256::from(-3_i128), 64), i64::MIN);
    assert_eq!(large.quotient(large, 63), i64::MAX);
    assert_eq!(large.quotient(large, 62), 1 << 62);
}

#[test]
fn a_quotient_compares_as_a_fraction_does() {
    for num in -20_i32..=20 {
        for t in -20..=20 {
            let expected = (4 * num).cmp(&(3 * t as i32));
            assert_eq!(num.compare(3, 2, t), expected);
            assert_eq!(i128::from(num).compare(3, 2, t), expected);
            let wide = |x: i128| I256::product(x << 100, 1 << 40);
            assert_eq!(wide(num.into()).compare(wide(3), 2, t), expected);
        }
    }
}
