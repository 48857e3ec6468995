//! The three coordinate axes by number, and vectors of any numbers.

use core::ops::{Add, Mul, Sub};

/// Coordinate axis `i` and the next two in cyclic order; `i` is at most 2. A remainder is avoided,
/// because a small core divides by calling a function, and because indices are visibly in bounds
/// this way. Kernels with unrolled loops do better with the remainder, which folds.
#[inline(always)]
pub(crate) const fn turn(i: usize) -> (usize, usize, usize) {
    match i {
        0 => (0, 1, 2),
        1 => (1, 2, 0),
        _ => (2, 0, 1),
    }
}

/// Applies `f` to each coordinate axis. Always inlined: `array::map` often is not, and then goes
/// through memory, which costs more than the computation.
#[inline(always)]
pub(crate) fn three<T>(mut f: impl FnMut(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// Applies `f` to 0 and 1, always inlined.
#[inline(always)]
pub(crate) fn two<T>(mut f: impl FnMut(usize) -> T) -> [T; 2] {
    [f(0), f(1)]
}

/// `array::map` of short arrays, always inlined: it costs less time, and tests compile sooner. Some cold
/// conversions keep `map`: on small cores its loop is less code than three copies of what it calls.
pub(crate) trait Each {
    type Item;
    type Of<U>;

    /// Applies `f` to each element.
    fn each<U>(self, f: impl FnMut(Self::Item) -> U) -> Self::Of<U>;
}

impl<T> Each for [T; 2] {
    type Item = T;
    type Of<U> = [U; 2];

    #[inline(always)]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 2] {
        let [a, b] = self;
        [f(a), f(b)]
    }
}

impl<T> Each for [T; 3] {
    type Item = T;
    type Of<U> = [U; 3];

    #[inline(always)]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 3] {
        let [a, b, c] = self;
        [f(a), f(b), f(c)]
    }
}

impl<T> Each for [T; 4] {
    type Item = T;
    type Of<U> = [U; 4];

    #[inline(always)]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 4] {
        let [a, b, c, d] = self;
        [f(a), f(b), f(c), f(d)]
    }
}

/// Component `i`, without a bounds check.
#[inline(always)]
pub(crate) fn pick<T>(x: &[T; 3], i: usize) -> &T {
    match i {
        0 => &x[0],
        1 => &x[1],
        _ => &x[2],
    }
}

/// a − b.
#[inline(always)]
pub(crate) fn minus3<T: Copy + Sub<Output = T>>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a × b.
#[inline(always)]
pub(crate) fn cross3<T>(a: &[T; 3], b: &[T; 3]) -> [T; 3]
where
    T: Copy + Mul<Output = T> + Sub<Output = T>,
{
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a·b.
#[inline(always)]
pub(crate) fn dot3<T: Copy + Mul<Output = T> + Add<Output = T>>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
