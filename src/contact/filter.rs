//! Bounds in floats on the overlap along each direction.

use core::mem::size_of;

use super::axes::Axes;
use super::body::{Rough, Vec64};
use super::directions::Direction;
use crate::arithmetic::{REGISTERS_ARE_WIDE, greatest, largest, pick, three, turn, two};
use crate::scalar::Scalar;

/// So many directions are measured at once: vectors take them side by side.
pub(super) const AT_ONCE: usize = match REGISTERS_ARE_WIDE {
    true if cfg!(target_feature = "avx") => 4,
    true => 2,
    false => 1,
};

/// Directions in floats, side by side.
pub(super) struct Measured<const N: usize> {
    /// The directions: cross products of two sides.
    pub(super) a: [[f64; N]; 3],
    /// The greater of the two products in each coordinate.
    pub(super) products: [[f64; N]; 3],
    /// The greatest product.
    pub(super) scale: [f64; N],
    /// The square of each direction.
    pub(super) square: [f64; N],
    /// The overlaps against the directions, and along them, in units of their lengths.
    pub(super) overlaps: [[f64; N]; 2],
    /// How far an overlap may be from the truth.
    pub(super) error: [f64; N],
}

/// Bounds on the overlaps along directions, as squares of true lengths and not below zero, against
/// them and along them.
pub(super) struct Overlaps {
    pub(super) least: [[f64; AT_ONCE]; 2],
    pub(super) most: [[f64; AT_ONCE]; 2],
    /// Whether the shapes are certainly apart along a direction.
    pub(super) are_apart: bool,
}

/// Roundoffs in an overlap, per P·R: the greatest product in the direction, and the size.
const ROUNDOFFS: u16 = 256;
pub(super) const ERROR: f64 = ROUNDOFFS as f64 * (f64::EPSILON / 2.0);

/// If the square of a cross product is below this part of P², it may be off by more than
/// [`SPREAD`].
const NOISE: f64 = f64::from_bits((1023 - 54) << 52);

/// The relative error of the square of a cross product.
const SPREAD: f64 = f64::from_bits((1023 - 20) << 52);

/// The same if the square is at least a sixteenth of P².
const LEAST_SPREAD: f64 = f64::from_bits((1023 - 45) << 52);

/// A number between these may be squared, cubed, and squared again.
const RANGE: (f64, f64) = (f64::from_bits((1023 - 100) << 52), f64::from_bits((1023 + 100) << 52));

/// The least P. Axes that are parallel except for a residue have a short cross product.
const LEAST_PRODUCT: f64 = f64::from_bits((1023 - 150) << 52);

pub(super) fn in_range(x: f64) -> bool {
    (x > RANGE.0) & (x < RANGE.1)
}

/// x × y, and the greater of the two products in each coordinate, which bounds its error.
#[inline]
pub(super) fn cross_with_products(x: &Vec64, y: &Vec64) -> (Vec64, Vec64) {
    let (a, products) = crosses(&x.map(|x| [x]), &y.map(|y| [y]));
    (a.map(|[a]| a), products.map(|[product]| product))
}

/// The same for vectors side by side.
#[inline(always)]
fn crosses<const N: usize>(x: &[[f64; N]; 3], y: &[[f64; N]; 3]) -> ([[f64; N]; 3], [[f64; N]; 3]) {
    let product = |j, k| lanes::<N>(|n| pick(x, j)[n] * pick(y, k)[n]);
    let [p, q] =
        [three(|i| product(turn(i).1, turn(i).2)), three(|i| product(turn(i).2, turn(i).1))];
    let a = three(|i| lanes::<N>(|n| p[i][n] - q[i][n]));
    (a, three(|i| lanes::<N>(|n| greatest(p[i][n].abs(), q[i][n].abs()))))
}

/// Whether a product is so great that underflow does not matter, and no more than that.
pub(super) fn is_product(x: f64) -> bool {
    (x > LEAST_PRODUCT) & (x < RANGE.1)
}

/// A number for each of the directions.
#[inline(always)]
fn lanes<const N: usize>(of: impl Fn(usize) -> f64) -> [f64; N] {
    let mut lanes = [0.0; N];
    for (n, lane) in lanes.iter_mut().enumerate() {
        *lane = of(n);
    }
    lanes
}

/// Where a shape begins and ends along each direction. `is_origin`: the first of its places is zero.
#[inline(always)]
fn ends<const N: usize>(shape: &Rough, is_origin: bool, a: &[[f64; N]; 3]) -> [[f64; N]; 2] {
    let along = |v: &Vec64| lanes::<N>(|n| a[0][n] * v[0] + a[1][n] * v[1] + a[2][n] * v[2]);
    let p = if is_origin { [0.0; N] } else { along(&shape.at[0]) };
    if shape.is_triangle {
        let [q, r] = [along(&shape.at[1]), along(&shape.at[2])];
        let least = lanes(|n| -greatest(greatest(-p[n], -q[n]), -r[n]));
        return [least, lanes(|n| greatest(greatest(p[n], q[n]), r[n]))];
    }
    let [u, v, w] = [along(&shape.sides[0]), along(&shape.sides[1]), along(&shape.sides[2])];
    let [i, j, k] = shape.half;
    let reach = lanes::<N>(|n| i * u[n].abs() + j * v[n].abs() + k * w[n].abs());
    [lanes(|n| p[n] - reach[n]), lanes(|n| p[n] + reach[n])]
}

/// Two shapes in floats, relative to the origin of the second.
pub(super) struct Filter<'a> {
    pub(super) shapes: &'a [Rough; 2],
    pub(super) are_triangles: [bool; 2],
    /// An upper bound of the numbers of the two shapes.
    size: f64,
    /// Whether no product of two numbers underflows.
    pub(super) is_short: bool,
    pub(super) axes: Axes,
}

impl<'a> Filter<'a> {
    pub(super) fn new<S: Scalar>(shapes: &'a [Rough; 2]) -> Self {
        debug_assert_eq!(shapes[1].at[0], [0.0; 3]);
        let mut size = 0.0;
        for shape in shapes {
            for k in 0..3 {
                let (side, half) = (largest(pick(&shape.sides, k)), *pick(&shape.half, k));
                size += largest(pick(&shape.at, k)) + half * side;
                // A tiny side can lose to underflow, and a large half-extent would multiply the
                // loss.
                if side > RANGE.1 || (side < RANGE.0 && half * side > 0.0) {
                    size = f64::INFINITY;
                }
            }
        }
        let is_short = size_of::<S>() < size_of::<f64>();
        // Two different numbers may round to the same float.
        let sides = two(|n| &shapes[n].sides);
        let are_triangles = two(|n| shapes[n].is_triangle);
        let axes = Axes::new(sides, are_triangles, S::IS_IN_DOUBLE);
        Self { shapes, are_triangles, size, is_short, axes }
    }

    pub(super) fn sides(&self, direction: Direction) -> [Vec64; 2] {
        sides_of(self.shapes, self.are_triangles, direction).map(|side| *side)
    }

    /// The directions in floats.
    ///
    /// # The error
    ///
    /// u is the unit roundoff; P is the greatest product of two coordinates in a = x × y, for the
    /// two sides x and y. Sides and half-extents have one rounding at most. Positions relative to
    /// the origin are means of two differences. The differences may cancel, but neither exceeds
    /// `size` R, so a position errs by 3·u·R.
    ///
    /// The overlap is a sum of two terms a·p, for a position p, and of six terms h·|a·s|, for a
    /// half-extent and an axis. `filter.g` proves that it errs by at most [`ROUNDOFFS`] times
    /// u·P·R, with second orders and underflow. [`RANGE`] and [`LEAST_PRODUCT`] keep P·R normal,
    /// and so the sides that have half-extents.
    ///
    /// P is not the product of the greatest coordinates. For axes parallel up to a residue in
    /// one coordinate, P is as small as a.
    ///
    /// The square of a errs by 2·√3·8·u·P·|a| and roundings. If it exceeds [`NOISE`]·P², the
    /// relative error is less than [`SPREAD`]: 28·2^-53 / 2^-27 = 2^-21.2. If |a| is at least P/4, it
    /// is less than [`LEAST_SPREAD`]: 28·4·2^-53 = 2^-46.2, and the roundings.
    #[inline(always)]
    pub(super) fn measured<const N: usize>(&self, directions: [Direction; N]) -> Measured<N> {
        let mut sides = [[&self.shapes[0].sides[0]; 2]; N];
        for (sides, direction) in sides.iter_mut().zip(directions) {
            *sides = sides_of(self.shapes, self.are_triangles, direction);
        }
        let [x, y] = two(|k| three(|i| lanes::<N>(|n| sides[n][k][i])));
        let (a, products) = crosses(&x, &y);
        let scale = lanes(|n| greatest(greatest(products[0][n], products[1][n]), products[2][n]));
        let square = lanes(|n| a[0][n] * a[0][n] + a[1][n] * a[1][n] + a[2][n] * a[2][n]);
        let [a0, a1] = ends(&self.shapes[0], false, &a);
        let [b0, b1] = ends(&self.shapes[1], true, &a);
        let overlaps = [lanes(|n| a1[n] - b0[n]), lanes(|n| b1[n] - a0[n])];
        let error = lanes(|n| ERROR * (scale[n] * self.size));
        Measured { a, products, scale, square, overlaps, error }
    }

    /// Whether floats know a direction that is measured: it is certainly not zero, and points there.
    pub(super) fn knows(&self, scale: f64, square: f64) -> bool {
        is_product(scale) & in_range(self.size) & (square >= NOISE * scale * scale)
    }

    /// Bounds on the overlaps along directions. Nothing is certain along a direction that floats do not
    /// know.
    #[inline(always)]
    pub(super) fn overlaps(&self, directions: [Direction; AT_ONCE]) -> Overlaps {
        let Measured { scale, square, overlaps, error, .. } = self.measured(directions);
        // No branches: vectors take all directions.
        let is_known = |n: usize| self.knows(scale[n], square[n]);
        let error = lanes::<AT_ONCE>(|n| if is_known(n) { error[n] } else { f64::INFINITY });
        let inverse = lanes::<AT_ONCE>(|n| 1.0 / if is_known(n) { square[n] } else { 1.0 });
        // Roundings are far below the spread.
        let is_clear = |n: usize| 16.0 * square[n] >= scale[n] * scale[n];
        let spread = lanes::<AT_ONCE>(|n| if is_clear(n) { LEAST_SPREAD } else { SPREAD });
        let least = two(|side| {
            let low = lanes::<AT_ONCE>(|n| greatest(overlaps[side][n] - error[n], 0.0));
            lanes::<AT_ONCE>(|n| low[n] * low[n] * ((1.0 - spread[n]) * inverse[n]))
        });
        let most = two(|side| {
            let high = lanes::<AT_ONCE>(|n| overlaps[side][n] + error[n]);
            lanes::<AT_ONCE>(|n| high[n] * high[n] * ((1.0 + 3.0 * spread[n]) * inverse[n]))
        });
        let is_apart = |n: usize| (overlaps[0][n] < -error[n]) | (overlaps[1][n] < -error[n]);
        Overlaps { least, most, are_apart: (0..AT_ONCE).fold(false, |all, n| all | is_apart(n)) }
    }

    /// The directions that are not certainly zero or equal to an earlier one, as bits.
    pub(super) fn needed(&mut self, all: &[Direction]) -> u16 {
        let (shapes, triangles) = (self.shapes, self.are_triangles);
        self.axes.needed(all, |direction, axis| {
            let [x, y] = sides_of(shapes, triangles, direction);
            let (a, products) = cross_with_products(x, y);
            a[axis].abs() > SPREAD * products[axis]
        })
    }
}

/// The two sides of a direction.
#[inline(always)]
fn sides_of(shapes: &[Rough; 2], triangles: [bool; 2], direction: Direction) -> [&Vec64; 2] {
    let sides = direction.sides(triangles);
    two(|n| pick(&shapes[sides[n].0 % 2].sides, sides[n].1))
}
