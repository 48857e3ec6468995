//! Numbers as mantissa and exponent. Oracles work on these, because code that is not generic over
//! the scalar is compiled only once.

use core::cmp::Ordering;

use dashu_int::IBig;

/// A number of any scalar as mantissa and exponent: exactly m·2^e.
pub type Parts = (i64, i32);

/// The least exponent among numbers that are not zero, or zero.
pub(crate) fn least_exponent<'a>(all: impl IntoIterator<Item = &'a Parts>) -> i32 {
    all.into_iter().filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0)
}

/// The number in units of 2^unit, which must be no coarser than the number's own.
pub(crate) fn whole((m, e): Parts, unit: i32) -> IBig {
    if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
}

/// Compares two sums.
pub fn compare_sums(a: &[Parts], b: &[Parts]) -> Ordering {
    let unit = least_exponent(a.iter().chain(b));
    let sum = |x: &[Parts]| x.iter().map(|&x| whole(x, unit)).sum::<IBig>();
    sum(a).cmp(&sum(b))
}
