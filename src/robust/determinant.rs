//! Areas and determinants of differences, as exact sums of products.
//!
//! No difference is computed, because it might round. A difference is a list of signed coordinates,
//! and a product of differences is the sum of all products with one coordinate of each list. Only
//! the sum's sign is used.

use core::cmp::Ordering;

use super::exact_sum::ExactSum;
use super::predicate::Backend;
use crate::arithmetic::{Each, Parts, pick, three, turn};

/// A sum of up to three signed coordinates.
pub(crate) type Linear = [Parts; 3];

/// A vector of three such sums.
pub(crate) type Vector = [Linear; 3];

/// A coordinate alone.
pub(crate) fn single(a: Parts) -> Linear {
    [a, Parts::ZERO, Parts::ZERO]
}

/// a − b.
pub(crate) fn difference(a: Parts, b: Parts) -> Linear {
    [a, b.negated(), Parts::ZERO]
}

/// A point's coordinates.
pub(crate) fn singles<S: Backend>(x: [S; 3]) -> Vector {
    x.each(|x| single(x.parts()))
}

/// a − b.
#[inline(never)]
pub(crate) fn differences<S: Backend>(a: &[S; 3], b: &[S; 3]) -> Vector {
    three(|i| difference(a[i].parts(), b[i].parts()))
}

/// The vector along coordinate axis `i` of length `one`.
pub(crate) fn along_axis(i: usize, one: Parts) -> Vector {
    three(|k| single(if k == i { one } else { Parts::ZERO }))
}

const UNIT: Linear = [Parts::UNIT, Parts::ZERO, Parts::ZERO];

/// Adds a·b·c to the sum or subtracts it, times `factor` if there is one. Out of line, because rare
/// code should be small.
#[inline(never)]
fn add_product<T: ExactSum>(
    sum: &mut T,
    [a, b, c]: [&Linear; 3],
    factor: Option<Parts>,
    minus: bool,
) {
    let nonzero = |x: &&Parts| x.magnitude != 0;
    for &x in a.iter().filter(nonzero) {
        let x = if minus { x.negated() } else { x };
        for &y in b.iter().filter(nonzero) {
            for &z in c.iter().filter(nonzero) {
                match factor {
                    Some(factor) => sum.add(&[factor, x, y, z]),
                    None => sum.add(&[x, y, z]),
                }
            }
        }
    }
}

/// The sign of (a × b)·c. Out of line, as all that make a sum alone: it takes up to 1 KB.
#[inline(never)]
pub(crate) fn side<T: ExactSum>(vectors: [&Vector; 3]) -> Ordering {
    let mut sum = T::new();
    add_determinant(&mut sum, vectors, None);
    sum.sign()
}

/// The sign of component `i` of a × b.
#[inline(never)]
pub(crate) fn minor_sign<T: ExactSum>(a: &Vector, b: &Vector, i: usize) -> Ordering {
    let mut sum = T::new();
    add_minor(&mut sum, a, b, i, false);
    sum.sign()
}

/// The sign of a sum of coordinates.
#[inline(never)]
pub(crate) fn sign<T: ExactSum>(x: &Linear) -> Ordering {
    let mut sum = T::new();
    add_product(&mut sum, [x, &UNIT, &UNIT], None, false);
    sum.sign()
}

/// Adds a·b to the sum or subtracts it.
pub(crate) fn add_area<T: ExactSum>(sum: &mut T, a: &Linear, b: &Linear, minus: bool) {
    add_product(sum, [a, b, &UNIT], None, minus);
}

/// Adds component `i` of a × b to the sum or subtracts it.
pub(crate) fn add_minor<T: ExactSum>(sum: &mut T, a: &Vector, b: &Vector, i: usize, minus: bool) {
    let (_, j, k) = turn(i);
    add_area(sum, pick(a, j), pick(b, k), minus);
    add_area(sum, pick(a, k), pick(b, j), !minus);
}

/// Adds (a × b)·c to the sum, times `factor` if there is one.
pub(crate) fn add_determinant<T: ExactSum>(
    sum: &mut T,
    [a, b, c]: [&Vector; 3],
    factor: Option<Parts>,
) {
    for i in 0..3 {
        let (i, j, k) = turn(i);
        add_product(sum, [pick(a, j), pick(b, k), pick(c, i)], factor, false);
        add_product(sum, [pick(a, k), pick(b, j), pick(c, i)], factor, true);
    }
}
