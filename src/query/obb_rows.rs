//! Three vectors side by side: each row holds one component of all three, so that a product with
//! another vector comes out for all three at once. The operations are those of
//! [`cross3`](crate::arithmetic::cross3) and [`dot3`](crate::arithmetic::dot3), in the same order.

use crate::arithmetic::{Each, Float, InFloat, Number, Quad, three_in_float};
use crate::scalar::Scalar;
use crate::shape::Obb;

/// Three vectors, one row for each component.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vectors<Q>([Q; 3]);

impl<F: Float, Q: Quad<Lane = F>> Vectors<Q> {
    #[inline(always)]
    pub(super) fn new([a, b, c]: &[[F; 3]; 3]) -> Self {
        let row = |i: usize| Q::of_three([a[i], b[i], c[i]]);
        Self([row(0), row(1), row(2)])
    }

    /// For three axes: the cross product of the two other axes, in order.
    #[inline(always)]
    pub(super) fn normals(&self) -> Self {
        let next = self.0.each(Q::turned);
        let last = next.each(Q::turned);
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

    /// The rows.
    #[inline(always)]
    pub(super) fn rows(&self) -> &[Q; 3] {
        &self.0
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

/// An oriented box in floats. In fixed point, centre and half-extents are counted in units of the
/// last place, and axes in units of one.
#[derive(Clone, Copy, Debug)]
pub(super) struct ObbInFloats<F> {
    pub(super) center: [F; 3],
    pub(super) axes: [[F; 3]; 3],
    pub(super) half: [F; 3],
}

impl<F: Float> ObbInFloats<F> {
    #[inline(always)]
    pub(super) fn new<S: Scalar + InFloat<F>>(obb: &Obb<S>) -> Self {
        let [center, u, v, w, half] = obb.numbers();
        Self {
            center: three_in_float(center),
            axes: [in_units::<S, F>(u), in_units::<S, F>(v), in_units::<S, F>(w)],
            half: three_in_float(half),
        }
    }
}

/// A vector in units of one.
#[inline(always)]
pub(super) fn in_units<S: InFloat<F>, F: Float>(x: [S; 3]) -> [F; 3] {
    let [x, y, z] = three_in_float(x);
    if S::PLACE > F::ZERO { [x * S::PLACE, y * S::PLACE, z * S::PLACE] } else { [x, y, z] }
}

/// Whether the float can represent a vector of length one. If it cannot, this stage does not run:
/// [`Embeds::one`](crate::arithmetic::Embeds::one) fails in every number system there, and
/// `may_overlap` must not decide more here than elsewhere.
#[inline(always)]
pub(super) fn holds_one<S: InFloat<F>, F: Float>() -> bool {
    S::LIMIT.is_none_or(|limit| limit * S::PLACE > F::from(1))
}

/// Whether all these numbers became floats without rounding.
#[inline(always)]
pub(super) fn fits<S: InFloat<Q::Lane>, Q: Quad<Lane: Float>, const K: usize>(
    rows: &[[Q::Lane; 3]; K],
) -> bool {
    let Some(limit) = S::LIMIT else { return true };
    let zero = Q::splat(Q::Lane::ZERO);
    let most = rows.iter().fold(zero, |most, row| most.greatest(Q::of_three(*row).magnitude()));
    most.most() < limit
}

/// Random inputs for tests that compare the rows with the single-number kernels.
#[cfg(all(test, not(feature = "small")))]
pub(super) mod tests {
    use crate::shape::Obb;

    /// Numbers from −1 to 1, some on a coarse grid, some zero.
    pub(in crate::query) struct Numbers(pub(in crate::query) u64);

    impl Numbers {
        pub(in crate::query) fn next(&mut self) -> f32 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let x = (self.0 >> 40) as f32 / (1_u32 << 23) as f32 - 1.0;
            if self.0 >> 36 & 3 == 0 { (x * 4.0) as i32 as f32 / 4.0 } else { x }
        }

        pub(in crate::query) fn point(&mut self) -> [f32; 3] {
            [self.next(), self.next(), self.next()]
        }

        /// A box rotated about one coordinate axis, aligned with the axes, or skewed.
        pub(in crate::query) fn obb(&mut self) -> Obb<f32> {
            loop {
                let [u, v, w] = [self.point(), self.point(), self.point()];
                let axes = match self.0 >> 33 & 3 {
                    0 => [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]],
                    1 => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                    _ => [u, v, w],
                };
                let half = self.point().map(f32::abs);
                if let Ok(obb) = Obb::from_skewed_axes(self.point(), axes, half) {
                    return obb;
                }
            }
        }
    }
}
