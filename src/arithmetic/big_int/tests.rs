//! Integers of fixed length beside integers of any size.

extern crate std;

use core::iter;

use dashu_int::IBig;
use std::vec::Vec;

use super::*;

/// The number in arithmetic of any size.
pub(crate) fn any_size<const L: usize>(x: BigInt<L>) -> IBig {
    let fold = |sum: IBig, limb: &u64| (sum << 64) + IBig::from(*limb);
    let unsigned = x.0.iter().rev().fold(IBig::ZERO, fold);
    if x.is_negative() { unsigned - (IBig::ONE << (64 * L)) } else { unsigned }
}

/// Numbers whose limbs begin, end and pass carries, in all combinations.
fn all<const L: usize>() -> impl Iterator<Item = BigInt<L>> {
    const LIMBS: [u64; 6] = [0, 1, u64::MAX, 1 << 63, u64::MAX >> 1, 0x9e37_79b9_7f4a_7c15];
    (0..LIMBS.len().pow(L as u32)).map(|mut k| {
        BigInt([0; L].map(|_| {
            let limb = LIMBS[k % LIMBS.len()];
            k /= LIMBS.len();
            limb
        }))
    })
}

fn sums_agree<const L: usize>() {
    let numbers: Vec<_> = all::<L>().map(|x| (x.half().half(), any_size(x) >> 2)).collect();
    for (a, big_a) in &numbers {
        assert_eq!(any_size(*a), *big_a);
        assert_eq!((any_size(-*a), a.sign()), (-big_a, big_a.cmp(&IBig::ZERO)));
        for up in [0, 1, 63, 64, 65].into_iter().filter(|up| *up < 64 * L) {
            // What is shifted out at the top comes back as copies of the sign.
            let (shifted, lost) = (any_size(a.shifted_up(up)), 64 * L - up);
            let kept = (big_a + (IBig::ONE << (lost - 1))) & ((IBig::ONE << lost) - 1);
            assert_eq!(shifted >> up, kept - (IBig::ONE << (lost - 1)));
        }
        for (b, big_b) in &numbers {
            assert_eq!((any_size(*a + *b), any_size(*a - *b)), (big_a + big_b, big_a - big_b));
            assert_eq!((a.cmp(b), a == b), (big_a.cmp(big_b), big_a == big_b));
        }
    }
}

#[test]
fn sums_are_those_of_any_size() {
    sums_agree::<1>();
    sums_agree::<2>();
    sums_agree::<3>();
}

fn products_agree<const L: usize, const M: usize, const R: usize>() {
    for a in all::<L>() {
        for b in all::<M>() {
            assert_eq!(any_size(a.times::<M, R>(&b)), any_size(a) * any_size(b), "{a:?} {b:?}");
        }
    }
}

/// In the lengths of a [`Window`](super::super::Window), and in others.
#[test]
fn products_are_those_of_any_size() {
    products_agree::<1, 1, 2>();
    products_agree::<2, 2, 4>();
    products_agree::<4, 2, 6>();
    products_agree::<2, 3, 9>();
}

#[test]
fn multiples_are_added_at_every_shift() {
    for x in all::<2>() {
        for (factor, start) in [(1, 0), (u64::MAX, -1), (3 << 50, i128::MAX)] {
            for shift in (0..130).chain([191, 192]) {
                for is_minus in [false, true] {
                    let mut sum = BigInt::<7>::from(start);
                    sum.add_multiple(&x, factor, shift, is_minus);
                    let product = (any_size(x) * IBig::from(factor)) << shift;
                    let product = if is_minus { -product } else { product };
                    assert_eq!(any_size(sum), IBig::from(start) + product, "{x:?} {shift}");
                }
            }
        }
    }
}

#[test]
fn resized_numbers_are_equal() {
    for x in all::<2>() {
        assert_eq!(any_size(x.resized::<5>()), any_size(x));
        assert_eq!(x.resized::<5>().resized::<2>(), x);
    }
    for x in iter::successors(Some(1_i128), |x| x.checked_mul(-3)) {
        assert_eq!(any_size(BigInt::<3>::from(x)), IBig::from(x));
    }
}
