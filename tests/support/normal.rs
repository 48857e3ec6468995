//! Unit normals: an oracle in whole numbers of any size. No root is drawn, squares
//! are compared.

use std::cmp::Ordering;

use dashu_int::IBig;

use super::scalar::Sample;

pub(crate) type Points<S> = [[S; 3]; 3];

/// The normal in whole numbers, and its square.
pub(crate) fn normal_of<S: Sample>(points: &Points<S>) -> ([IBig; 3], IBig) {
    let parts = points.map(|p| p.map(S::mantissa_exponent));
    let unit = parts.iter().flatten().filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0);
    let [a, b, c] = parts.map(|p| {
        p.map(|(m, e)| if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize })
    });
    let area =
        |j: usize, k: usize| (&b[j] - &a[j]) * (&c[k] - &a[k]) - (&b[k] - &a[k]) * (&c[j] - &a[j]);
    let n = [area(1, 2), area(2, 0), area(0, 1)];
    let square = n.iter().map(|x| x * x).sum();
    (n, square)
}

/// How x·2^e compares with n / √square.
pub(crate) fn compare_with_unit(x: &IBig, e: i32, n: &IBig, square: &IBig) -> Ordering {
    let signed_square = |y: &IBig| if *y < IBig::ZERO { -(y * y) } else { y * y };
    let (left, right) = (signed_square(x) * square, signed_square(n));
    let shift = 2 * e.unsigned_abs() as usize;
    if e < 0 { left.cmp(&(right << shift)) } else { (left << shift).cmp(&right) }
}

/// Whether `x` is the number of its type nearest to n / √square.
pub(crate) fn is_nearest_to_unit<S: Sample>(x: S, n: &IBig, square: &IBig) -> bool {
    let (m, e) = x.mantissa_exponent();
    let twice = IBig::from(m) * 2;
    (x == S::LEAST || compare_with_unit(&(&twice - 1), e - 1, n, square).is_le())
        && (x == S::GREATEST || compare_with_unit(&(twice + 1), e - 1, n, square).is_ge())
}
