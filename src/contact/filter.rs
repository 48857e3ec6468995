//! Bounds in floats on the overlap along each direction.

use core::mem::size_of;

use super::body::Rough;
use super::directions::{Axes, Direction};
use super::lanes::{Lanes, Measure};
use crate::arithmetic::{Number, largest, pick, three, turn, two};
use crate::scalar::Scalar;

/// Roundoffs in an overlap, per P·R: the greatest product in the direction, and the size.
pub(super) const ROUNDOFFS: u16 = 256;

/// Directions in floats, side by side.
pub(super) struct Measured<V> {
    /// The directions: cross products of two sides.
    pub(super) a: [V; 3],
    /// The greater of the two products in each coordinate.
    pub(super) products: [V; 3],
    /// The greatest product.
    pub(super) scale: V,
    /// The square of each direction.
    pub(super) square: V,
    /// The overlaps against the directions, and along them, in units of their lengths.
    pub(super) overlaps: [V; 2],
    /// How far an overlap may be from the truth.
    pub(super) error: V,
}

/// Bounds on the overlaps along directions, as squares of true lengths and not below zero, against
/// them and along them.
pub(super) struct Overlaps<V> {
    pub(super) least: [V; 2],
    pub(super) most: [V; 2],
    /// The directions that floats do not know, as bits: nothing is certain along them.
    pub(super) unknown: u32,
    /// Whether the shapes are certainly apart along a direction.
    pub(super) are_apart: bool,
}

/// x × y, and the greater of the two products in each coordinate, which bounds its error.
#[inline(always)]
pub(super) fn cross_with_products<V: Lanes>(x: &[V; 3], y: &[V; 3]) -> ([V; 3], [V; 3]) {
    let product = |j, k| *pick(x, j) * *pick(y, k);
    let [p, q] =
        [three(|i| product(turn(i).1, turn(i).2)), three(|i| product(turn(i).2, turn(i).1))];
    (three(|i| p[i] - q[i]), three(|i| p[i].size().most(q[i].size())))
}

/// a·v.
#[inline(always)]
fn along<V: Lanes>(a: &[V; 3], v: &[V::Lane; 3]) -> V {
    a[0] * V::same(v[0]) + a[1] * V::same(v[1]) + a[2] * V::same(v[2])
}

/// Where a shape begins and ends along each direction. `is_origin`: the first of its places is zero.
#[inline(always)]
fn ends<V: Lanes>(shape: &Rough<V::Lane>, is_origin: bool, a: &[V; 3]) -> [V; 2] {
    let zero = V::same(V::Lane::ZERO);
    let p = if is_origin { zero } else { along(a, &shape.at[0]) };
    if shape.is_triangle {
        let [q, r] = [along(a, &shape.at[1]), along(a, &shape.at[2])];
        let least = (zero - p).most(zero - q).most(zero - r);
        return [zero - least, p.most(q).most(r)];
    }
    let [u, v, w] = three(|k| along(a, &shape.sides[k]).size() * V::same(shape.half[k]));
    let reach = u + v + w;
    [p - reach, p + reach]
}

/// Two shapes in floats, relative to the origin of the second.
pub(super) struct Ruler<'a, F> {
    pub(super) shapes: &'a [Rough<F>; 2],
    pub(super) are_triangles: [bool; 2],
    /// Side k of a shape is 3·shape + k; the last one again, so that a mask suffices.
    sides: [&'a [F; 3]; 8],
    /// An upper bound of the numbers of the two shapes.
    size: F,
}

/// Such shapes, and what else is known.
pub(super) struct Filter<'a> {
    pub(super) ruler: Ruler<'a, f64>,
    /// Whether no product of two numbers underflows.
    pub(super) is_short: bool,
    pub(super) axes: Axes,
}

impl<'a, F: Measure> Ruler<'a, F> {
    #[inline(always)]
    pub(super) fn new(shapes: &'a [Rough<F>; 2]) -> Self {
        debug_assert!(shapes[1].at[0] == [F::ZERO; 3]);
        let mut size = F::ZERO;
        for shape in shapes {
            for k in 0..3 {
                let (side, half) = (largest(&shape.sides[k]), shape.half[k]);
                size = size + (largest(&shape.at[k]) + half * side);
                // A tiny side can lose to underflow, all of it in `f32`, and a large half-extent would
                // multiply the loss.
                if side > F::SIZES.1 || (side < F::SIZES.0 && half > F::ZERO) {
                    size = F::INFINITY;
                }
            }
        }
        let ([a, b, c], [u, v, w]) = (&shapes[0].sides, &shapes[1].sides);
        let sides = [a, b, c, u, v, w, w, w];
        Self { shapes, are_triangles: two(|n| shapes[n].is_triangle), sides, size }
    }

    #[inline(always)]
    pub(super) fn sides(&self, numbers: [u8; 2]) -> [&[F; 3]; 2] {
        two(|n| self.sides[usize::from(numbers[n] & 7)])
    }

    /// The directions in floats, by the numbers of their sides.
    ///
    /// # The error
    ///
    /// u is the unit roundoff; P is the greatest product of two coordinates in a = x × y, for the
    /// two sides x and y. Sides and half-extents have one rounding at most; in `f32` one of `f64`
    /// comes before, for which the bound has room. Positions relative to the origin are means of two
    /// differences. The differences may cancel, but neither exceeds `size` R, so a position errs by
    /// 3·u·R.
    ///
    /// The overlap is a sum of two terms a·p, for a position p, and of six terms h·|a·s|, for a
    /// half-extent and an axis. `filter.g` proves that it errs by at most [`ROUNDOFFS`] times
    /// u·P·R, with second orders and underflow. [`SIZES`](Measure::SIZES) and
    /// [`PRODUCTS`](Measure::PRODUCTS) keep P·R normal, and so the sides that have half-extents. In
    /// `f32` P·R is above 2^-40, and an overlap with its error above 2^-56, whose square is normal.
    ///
    /// P is not the product of the greatest coordinates. For axes parallel up to a residue in
    /// one coordinate, P is as small as a.
    ///
    /// The square of a errs by 2·√3·8·u·P·|a| and roundings. If it exceeds
    /// [`NOISE`](Measure::NOISE)·P², the relative error is less than [`SPREAD`](Measure::SPREAD):
    /// 28·2^-53 / 2^-27 = 2^-21.2, and in `f32` 28·2^-24 / 2^-11 = 2^-8.2. If |a| is at least P/4, it
    /// is less than [`LEAST_SPREAD`](Measure::LEAST_SPREAD): 28·4·2^-53 = 2^-46.2, or 2^-17.2, and the
    /// roundings.
    #[inline(always)]
    pub(super) fn measured<V: Lanes<Lane = F>>(
        &self,
        numbers: impl Fn(usize) -> [u8; 2],
    ) -> Measured<V> {
        let mut sides = [[&self.shapes[0].sides[0]; 2]; 4];
        for (n, sides) in sides.iter_mut().enumerate().take(V::COUNT) {
            *sides = self.sides(numbers(n));
        }
        let [x, y] = two(|k| three(|i| V::of(|n| sides[n % 4][k][i])));
        let (a, products) = cross_with_products(&x, &y);
        let scale = products[0].most(products[1]).most(products[2]);
        let square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        let [a0, a1] = ends(&self.shapes[0], false, &a);
        let [b0, b1] = ends(&self.shapes[1], true, &a);
        let error = V::same(F::from(ROUNDOFFS) * F::ROUNDOFF) * (scale * V::same(self.size));
        Measured { a, products, scale, square, overlaps: [a1 - b0, b1 - a0], error }
    }

    /// The directions, of those measured, that floats know, as bits: they are certainly not zero, and
    /// point there.
    #[inline(always)]
    pub(super) fn known<V: Lanes<Lane = F>>(&self, scale: V, square: V) -> u32 {
        let (low, high) = (V::same(F::PRODUCTS.0), V::same(F::PRODUCTS.1));
        let is_size = if self.size.is_size() { u32::MAX } else { 0 };
        let is_clear = (V::same(F::NOISE) * scale * scale).is_within(square);
        is_size & scale.is_above(low) & high.is_above(scale) & is_clear
    }

    /// Bounds on the overlaps along directions.
    #[inline(always)]
    pub(super) fn overlaps<V: Lanes<Lane = F>>(
        &self,
        numbers: impl Fn(usize) -> [u8; 2],
    ) -> Overlaps<V> {
        let Measured { scale, square, overlaps, error, .. } = self.measured::<V>(numbers);
        let all = (1 << V::COUNT) - 1;
        let unknown = all & !self.known(scale, square);
        let (zero, one) = (V::same(F::ZERO), V::same(F::from(1)));
        let inverse = one / square;
        // Roundings are far below the spread.
        let noisy = (scale * scale).is_above(V::same(F::from(16)) * square);
        let spread = if noisy == 0 {
            V::same(F::LEAST_SPREAD)
        } else {
            // Read side by side. Lanes that are written one by one and then read together wait.
            V::of(|n| F::SPREADS[noisy as usize % 16][n])
        };
        let least = (one - spread) * inverse;
        let most = (one + V::same(F::from(3)) * spread) * inverse;
        let bounds = two(|side| {
            let low = (overlaps[side] - error).most(zero);
            let high = overlaps[side] + error;
            (low * low * least, high * high * most)
        });
        let below = zero - error;
        let are_apart = below.is_above(overlaps[0]) | below.is_above(overlaps[1]);
        let mut most = two(|side| bounds[side].1);
        if unknown != 0 {
            let is_known = |n: usize| unknown >> n & 1 == 0;
            let known = |most: V| V::of(|n| if is_known(n) { most.lane(n) } else { F::INFINITY });
            most = two(|side| known(most[side]));
        }
        let are_apart = are_apart & !unknown != 0;
        Overlaps { least: two(|side| bounds[side].0), most, unknown, are_apart }
    }
}

impl<'a> Filter<'a> {
    pub(super) fn new<S: Scalar>(shapes: &'a [Rough; 2]) -> Self {
        let ruler = Ruler::new(shapes);
        let is_short = size_of::<S>() < size_of::<f64>();
        // Two different numbers may round to the same float.
        let axes = Axes::new(two(|n| &shapes[n].sides), ruler.are_triangles, S::IS_IN_DOUBLE);
        Self { ruler, is_short, axes }
    }

    /// The directions that are not certainly zero or equal to an earlier one, as bits.
    pub(super) fn needed(&self, all: &[Direction]) -> u16 {
        let ruler = &self.ruler;
        self.axes.needed(all, |numbers, axis| {
            let [x, y] = ruler.sides(numbers);
            let (a, products) = cross_with_products(x, y);
            a[axis].abs() > f64::SPREAD * products[axis]
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::arithmetic::{OfFour, three, two};
    use crate::contact::body::{Rough, cross, dot};
    use crate::contact::filter::Ruler;
    use crate::contact::lanes::{Lanes, Measure};
    use crate::random::Random;

    /// The square of a direction that `f32` knows is that of the sides in `f64`, within its spread: of
    /// sides as nearly parallel as it allows, and of all others.
    #[test]
    fn squares_in_f32_are_within_their_spread() {
        let mut random = Random(0x50ea);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut known = [0; 2];
        for n in 0..40_000 {
            let (x, by, off) = (three(|_| number()), number(), 2_f64.powi(-(n % 14)));
            let y = three(|i| by * x[i] + off * number());
            let rough = |side| Rough {
                is_triangle: false,
                at: [[0.0; 3]; 3],
                sides: [side; 3],
                half: [1.0; 3],
            };
            let shapes = [rough(x), rough(y)];
            let short = two(|k| shapes[k].short());
            let ruler = Ruler::new(&short);
            let found = ruler.measured::<<f32 as OfFour>::Quad>(|_| [0, 3]);
            if ruler.known(found.scale, found.square) & 1 == 0 {
                continue;
            }
            let (square, scale) = (found.square.lane(0), found.scale.lane(0));
            let is_noisy = scale * scale > 16.0 * square;
            let spread = if is_noisy { f32::SPREAD } else { f32::LEAST_SPREAD };
            let a = cross(&x, &y);
            let truth = dot(&a, &a);
            assert!((f64::from(square) - truth).abs() <= f64::from(spread) * truth, "{x:?} {y:?}");
            known[usize::from(is_noisy)] += 1;
        }
        assert!(known[0] > 8_000 && known[1] > 8_000, "{known:?}");
    }
}
