//! Vectors of three floats. Only sums and products, in a fixed order, so that every machine gives
//! the same bits.

pub(crate) type Vector = [f32; 3];

pub(crate) fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn times(a: Vector, x: f32) -> Vector {
    [a[0] * x, a[1] * x, a[2] * x]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The square root, by Newton's method, because `core` has none. Zero if `x` is not positive.
pub(crate) fn root(x: f32) -> f32 {
    if x <= 0.0 {
        return 0.0;
    }
    // Half the exponent is within a factor of two.
    let mut y = f32::from_bits((x.to_bits() >> 1) + (0x3f80_0000 >> 1));
    for _ in 0..4 {
        y = 0.5 * (y + x / y);
    }
    y
}
