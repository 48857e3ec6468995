//! Vectors of three numbers.

use crate::number::Number;

pub(crate) type Vector<T> = [T; 3];

pub(crate) fn plus<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn times<T: Number>(a: Vector<T>, x: T) -> Vector<T> {
    [a[0] * x, a[1] * x, a[2] * x]
}

pub(crate) fn cross<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Within zero and `most`.
pub(crate) fn within<T: Number>(x: T, most: T) -> T {
    if x > most {
        most
    } else if x > T::ZERO {
        x
    } else {
        T::ZERO
    }
}
