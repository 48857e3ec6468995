//! The three coordinate axes by number.

/// Coordinate axis `i` and the two that follow it in turn; there is none beyond
/// 2. No remainder: a small core divides by calling a function, and an index is
/// plainly in bounds this way. Kernels whose loops unroll do better with the
/// remainder: it folds.
#[inline(always)]
pub(crate) const fn turn(i: usize) -> (usize, usize, usize) {
    match i {
        0 => (0, 1, 2),
        1 => (1, 2, 0),
        _ => (2, 0, 1),
    }
}

/// What `f` says of each coordinate axis. Inlined always: `array::map` often is not, and what
/// goes through memory then costs more than what is computed.
#[inline(always)]
pub(crate) fn three<T>(mut f: impl FnMut(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// What `f` says of each of three, inlined always.
#[inline(always)]
pub(crate) fn each<T, U>([a, b, c]: [T; 3], mut f: impl FnMut(T) -> U) -> [U; 3] {
    [f(a), f(b), f(c)]
}

/// Component `i`, without a bound to check.
#[inline(always)]
pub(crate) fn pick<T>(x: &[T; 3], i: usize) -> &T {
    match i {
        0 => &x[0],
        1 => &x[1],
        _ => &x[2],
    }
}
