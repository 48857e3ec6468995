//! Unit normals: an oracle in integers of any size. It compares squares, and computes no root.

use crate::Each;
use std::cmp::Ordering;

use dashu_int::IBig;

use super::exact::{Parts, least_exponent, whole};
use super::sample::Sample;

pub type Points<S> = [[S; 3]; 3];

/// The normal in whole numbers, and its square.
pub fn normal_of<S: Sample>(points: &Points<S>) -> ([IBig; 3], IBig) {
    normal_of_parts(points.each(|p| p.each(S::mantissa_exponent)))
}

fn normal_of_parts(points: [[Parts; 3]; 3]) -> ([IBig; 3], IBig) {
    let unit = least_exponent(points.as_flattened());
    let [a, b, c] = points.each(|p| p.each(|x| whole(x, unit)));
    let area =
        |j: usize, k: usize| (&b[j] - &a[j]) * (&c[k] - &a[k]) - (&b[k] - &a[k]) * (&c[j] - &a[j]);
    let n = [area(1, 2), area(2, 0), area(0, 1)];
    let square = n.iter().map(|x| x * x).sum();
    (n, square)
}

/// Compares x·2^e with n / √square.
pub fn compare_with_unit(x: &IBig, e: i32, n: &IBig, square: &IBig) -> Ordering {
    let signed_square = |y: &IBig| if *y < IBig::ZERO { -(y * y) } else { y * y };
    let (left, right) = (signed_square(x) * square, signed_square(n));
    let shift = 2 * e.unsigned_abs() as usize;
    if e < 0 { left.cmp(&(right << shift)) } else { (left << shift).cmp(&right) }
}

/// Whether `x` is the number of its type nearest to n / √square.
pub fn is_nearest_to_unit<S: Sample>(x: S, n: &IBig, square: &IBig) -> bool {
    is_nearest_in_parts(x.mantissa_exponent(), [x == S::LEAST, x == S::GREATEST], n, square)
}

fn is_nearest_in_parts((m, e): Parts, is_end: [bool; 2], n: &IBig, square: &IBig) -> bool {
    let twice = IBig::from(m) * 2;
    (is_end[0] || compare_with_unit(&(&twice - 1), e - 1, n, square).is_le())
        && (is_end[1] || compare_with_unit(&(twice + 1), e - 1, n, square).is_ge())
}
