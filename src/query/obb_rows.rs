//! Three vectors side by side: a row is a component of all three. So products with another vector
//! come out for all three at once, by the operations of [`cross`](super::triangle_obb::cross) and
//! [`dot`](super::triangle_obb::dot), in their order.

use crate::arithmetic::{Float, InFloat, Number, Quad, greatest};
use crate::scalar::Scalar;
use crate::shape::Obb;

/// Three vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors<Q>([Q; 3]);

impl<F: Float, Q: Quad<Lane = F>> Vectors<Q> {
    #[inline(always)]
    pub(super) fn new([a, b, c]: &[[F; 3]; 3]) -> Self {
        let row = |i: usize| Q::of_three([a[i], b[i], c[i]]);
        Self([row(0), row(1), row(2)])
    }

    /// Of axes: the cross product of the two others, in order.
    #[inline(always)]
    pub(super) fn normals(&self) -> Self {
        let next = self.0.map(Q::turned);
        let last = next.map(Q::turned);
        let minor = |j: usize, k: usize| next[j] * last[k] - next[k] * last[j];
        Self([minor(1, 2), minor(2, 0), minor(0, 1)])
    }

    /// The dot product of each with a vector.
    #[inline(always)]
    pub(super) fn dot(&self, x: [F; 3]) -> Q {
        let Self([a, b, c]) = *self;
        a * Q::splat(x[0]) + b * Q::splat(x[1]) + c * Q::splat(x[2])
    }

    /// The determinant of three axes, given their normals.
    #[inline(always)]
    pub(super) fn determinant(&self, normals: &Self) -> Q::Lane {
        let ([a, b, c], [x, y, z]) = (self.0, normals.0);
        (a * x + b * y + c * z).to_array()[0]
    }

    /// x × each.
    #[inline(always)]
    pub(super) fn crossed_by(&self, x: [F; 3]) -> Self {
        let [a, b, c] = self.0;
        let [x, y, z] = [Q::splat(x[0]), Q::splat(x[1]), Q::splat(x[2])];
        Self([y * c - z * b, z * a - x * c, x * b - y * a])
    }

    /// The vectors one by one.
    #[inline(always)]
    pub(super) fn to_arrays(self) -> [[F; 3]; 3] {
        let Self([a, b, c]) = self;
        transposed([a.three(), b.three(), c.three()])
    }

    /// The greatest magnitude of a component.
    #[inline(always)]
    pub(super) fn largest(&self) -> Q {
        let [a, b, c] = self.0;
        a.magnitude().greatest(b.magnitude()).greatest(c.magnitude())
    }
}

#[inline(always)]
pub(super) fn transposed<F: Copy>([a, b, c]: [[F; 3]; 3]) -> [[F; 3]; 3] {
    [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]]
}

/// An oriented box in floats. Where they are whole numbers of the last place, its axes are in
/// units of one.
#[derive(Clone, Copy, Debug)]
pub(super) struct ObbInFloats<F> {
    pub(super) center: [F; 3],
    pub(super) axes: [[F; 3]; 3],
    pub(super) half: [F; 3],
}

impl<F: Float> ObbInFloats<F> {
    #[inline(always)]
    pub(super) fn new<S: Scalar + InFloat<F>>(obb: &Obb<S>) -> Self {
        let [u, v, w] = obb.axes_as_arrays();
        Self {
            center: in_floats(obb.center().to_array()),
            axes: [in_units::<S, F>(u), in_units::<S, F>(v), in_units::<S, F>(w)],
            half: in_floats(obb.half_extents().to_array()),
        }
    }
}

#[inline(always)]
pub(super) fn in_floats<S: InFloat<F>, F: Float>([x, y, z]: [S; 3]) -> [F; 3] {
    [x.in_float(), y.in_float(), z.in_float()]
}

/// A vector whose length is in units of one.
#[inline(always)]
pub(super) fn in_units<S: InFloat<F>, F: Float>(x: [S; 3]) -> [F; 3] {
    let [x, y, z] = in_floats(x);
    if S::PLACE > F::ZERO { [x * S::PLACE, y * S::PLACE, z * S::PLACE] } else { [x, y, z] }
}

/// Whether none of these numbers was rounded when it became a float.
#[inline(always)]
pub(super) fn fits<S: InFloat<Q::Lane>, Q: Quad<Lane: Float>, const K: usize>(
    rows: &[[Q::Lane; 3]; K],
) -> bool {
    let Some(limit) = S::LIMIT else { return true };
    let zero = Q::splat(Q::Lane::ZERO);
    most(rows.iter().fold(zero, |most, row| most.greatest(Q::of_three(*row).magnitude()))) < limit
}

/// The greatest of the first three.
#[inline(always)]
pub(super) fn most<Q: Quad>(row: Q) -> Q::Lane {
    let [x, y, z] = row.three();
    greatest(greatest(x, y), z)
}
