//! The directions along which shapes may be separated, and bounds in floats on the overlap along
//! each.

use core::cmp::Ordering;

use super::body::{Body, Rough, Vec64};
use crate::arithmetic::{self, Filtered, compare, greatest, largest, pick, three, turn};
use crate::scalar::Scalar;

/// An axis: the cross product of two sides of the shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// The normal of a face, of the first shape or of the second.
    Face { is_second: bool, k: usize },
    /// Side i of the first shape across side j of the second.
    Sides(usize, usize),
}

/// All directions, in the order that decides between equal depths: faces of the first shape, faces
/// of the second, pairs of sides. A triangle's face comes before the faces of a box.
pub(super) fn all<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> impl Iterator<Item = Direction> {
    let [first, second] = bodies.each_ref().map(Body::normals);
    let faces = move |is_second: bool| {
        let count = if is_second { second } else { first };
        (0..count).map(move |k| Direction::Face { is_second, k })
    };
    let begin = bodies[1].is_triangle() && !bodies[0].is_triangle();
    let pairs = (0..9).map(|n| Direction::Sides(n / 3, n % 3));
    faces(begin).chain(faces(!begin)).chain(pairs)
}

impl Direction {
    /// The two sides of the cross product, each as a shape and the number of its side.
    pub(super) fn sides(self, is_triangle: [bool; 2]) -> [(usize, usize); 2] {
        match self {
            Self::Face { is_second, k } => {
                let shape = usize::from(is_second);
                let (_, i, j) = if is_triangle[shape] { (0, 0, 1) } else { turn(k) };
                [(shape, i), (shape, j)]
            }
            Self::Sides(i, j) => [(0, i), (1, j)],
        }
    }
}

/// Two bounds on the overlap of two shapes along a direction, as squares of true lengths and not
/// below zero. The direction need not have length one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overlap {
    pub(super) least: f64,
    pub(super) most: f64,
}

impl Overlap {
    /// The bounds if floats do not know the overlap.
    pub(super) const UNKNOWN: Self = Self { least: 0.0, most: f64::INFINITY };
}

/// The result of the float filter for a direction.
pub(super) enum Finding {
    /// The direction is certainly zero, or equal to an earlier one.
    Nothing,
    /// The shapes are apart.
    Apart,
    /// The overlap that the first shape must undo against the direction, and along it.
    Overlaps([Overlap; 2]),
}

/// Roundoffs in an overlap, per P·R: the greatest product in the direction, and the size.
const ROUNDOFFS: u16 = 256;
const ERROR: f64 = ROUNDOFFS as f64 * (f64::EPSILON / 2.0);

/// If the square of a cross product is below this part of P², it may be off by more than
/// [`SPREAD`].
const NOISE: f64 = f64::from_bits((1023 - 54) << 52);

/// The relative error of the square of a cross product.
const SPREAD: f64 = f64::from_bits((1023 - 20) << 52);

/// A number between these may be squared, cubed, and squared again.
const RANGE: (f64, f64) = (f64::from_bits((1023 - 100) << 52), f64::from_bits((1023 + 100) << 52));

/// The least P. Axes that are parallel but for a residue have a short cross product.
const LEAST_PRODUCT: f64 = f64::from_bits((1023 - 150) << 52);

fn in_range(x: f64) -> bool {
    x > RANGE.0 && x < RANGE.1
}

pub(super) fn cross(x: &Vec64, y: &Vec64) -> Vec64 {
    arithmetic::cross::<Filtered<f64>>(x, y)
}

/// x × y, and the greater of the two products in each coordinate, which bounds its error.
fn cross_with_products(x: &Vec64, y: &Vec64) -> (Vec64, Vec64) {
    let products = three(|i| {
        let (_, j, k) = turn(i);
        [pick(x, j) * pick(y, k), pick(x, k) * pick(y, j)]
    });
    (products.map(|[p, q]| p - q), products.map(|[p, q]| greatest(p.abs(), q.abs())))
}

/// Whether a product is so great that underflow does not matter, and no more than that.
fn is_product(x: f64) -> bool {
    x > LEAST_PRODUCT && x < RANGE.1
}

pub(super) fn dot(x: &Vec64, y: &Vec64) -> f64 {
    arithmetic::dot::<Filtered<f64>>(x, y)
}

/// Where a shape begins and ends along a direction.
#[inline(always)]
fn ends(shape: &Rough, a: &Vec64) -> [f64; 2] {
    if shape.is_triangle {
        let at = three(|k| dot(a, &shape.at[k]));
        let least = -greatest(greatest(-at[0], -at[1]), -at[2]);
        return [least, greatest(greatest(at[0], at[1]), at[2])];
    }
    let reach = shape.half[0] * dot(a, &shape.sides[0]).abs()
        + shape.half[1] * dot(a, &shape.sides[1]).abs()
        + shape.half[2] * dot(a, &shape.sides[2]).abs();
    let at = dot(a, &shape.at[0]);
    [at - reach, at + reach]
}

/// Two shapes in floats, and facts about their axes that are known in advance.
pub(super) struct Filter<'a> {
    shapes: &'a [Rough; 2],
    /// An upper bound of the numbers of the two shapes.
    size: f64,
    /// Coordinate axes that have occurred, as directions that are not zero.
    seen: [bool; 3],
    /// The axis of the first box that equals each axis of the second, if there is one.
    same: [Option<usize>; 3],
}

impl<'a> Filter<'a> {
    pub(super) fn new<S: Scalar>(shapes: &'a [Rough; 2]) -> Self {
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
        let mut same = [None; 3];
        // Two different numbers may round to the same float.
        if S::IS_IN_DOUBLE && !shapes[0].is_triangle && !shapes[1].is_triangle {
            for (same, v) in same.iter_mut().zip(&shapes[1].sides) {
                let is_along = |u: &Vec64| (0..3).all(|i| u[i] == v[i]);
                let is_against = |u: &Vec64| (0..3).all(|i| u[i] == -v[i]);
                *same = shapes[0].sides.iter().position(|u| is_along(u) || is_against(u));
            }
        }
        Self { shapes, size, seen: [false; 3], same }
    }

    fn sides(&self, direction: Direction) -> [Vec64; 2] {
        let shapes = self.shapes;
        let [(a, i), (b, j)] = direction.sides([shapes[0].is_triangle, shapes[1].is_triangle]);
        [*pick(&shapes[a % 2].sides, i), *pick(&shapes[b % 2].sides, j)]
    }

    /// The signs of the sides of the shapes along a direction, where floats are certain.
    ///
    /// With the products p − q in a coordinate of a, a·s is a sum of terms p·s and q·s.
    /// `directions.g` proves that it errs by at most a quarter of [`ROUNDOFFS`] times u and the
    /// greatest of these terms. The bound is by terms, so that a side keeps its sign if it is
    /// perpendicular to the direction but for a residue.
    pub(super) fn along(&self, direction: Direction) -> [[Option<Ordering>; 3]; 2] {
        let [x, y] = &self.sides(direction);
        let (a, products) = cross_with_products(x, y);
        let of = |shape: &Rough| {
            three(|k| {
                let s = &shape.sides[k];
                let along = dot(&a, s);
                let size = largest(&three(|i| products[i] * s[i]));
                let is_in_range = is_product(largest(&products)) && in_range(largest(s));
                let is_certain = is_in_range && in_range(size) && along.abs() > ERROR / 4.0 * size;
                is_certain.then(|| compare(along, 0.0))
            })
        };
        [of(&self.shapes[0]), of(&self.shapes[1])]
    }

    /// Whether a direction of two boxes is zero, or equal to an earlier one, because of axes that
    /// the boxes share.
    fn is_shared(&self, direction: Direction) -> bool {
        match direction {
            Direction::Face { is_second: false, .. } => false,
            Direction::Face { is_second: true, k } => {
                let (_, i, j) = turn(k);
                pick(&self.same, i).is_some() && pick(&self.same, j).is_some()
            }
            // If v_j equals an axis of the first box, u_i × v_j is zero or a face normal of the
            // first box. If u_i equals an axis of the second box, it is zero or a face normal of
            // the second box.
            Direction::Sides(i, j) => pick(&self.same, j).is_some() || self.same.contains(&Some(i)),
        }
    }

    /// The result of the float filter for the direction.
    ///
    /// # The error
    ///
    /// u is the unit roundoff; P is the greatest product of two coordinates in a = x × y, for the
    /// two sides x and y. Sides and half-extents have one rounding at most. Positions relative to
    /// the origin are means of two differences. The differences may cancel, but neither exceeds
    /// `size` R, so a position errs by 3·u·R.
    ///
    /// The overlap is a sum of two terms a·p, for a position p, and of six terms h·|a·s|, for a
    /// half-extent and an axis. `directions.g` proves that it errs by at most [`ROUNDOFFS`] times
    /// u·P·R, with second orders and underflow. [`RANGE`] and [`LEAST_PRODUCT`] keep P·R normal,
    /// and so the sides that have half-extents.
    ///
    /// P is not the product of the greatest coordinates. For axes parallel but for a residue in
    /// one coordinate, P is as small as a.
    ///
    /// The square of a errs by 2·√3·8·u·P·|a| and roundings. If it exceeds [`NOISE`]·P², the
    /// relative error is less than [`SPREAD`]: 28·2^-53 / 2^-27 = 2^-21.2.
    pub(super) fn finding(&mut self, direction: Direction) -> Finding {
        if self.is_shared(direction) {
            return Finding::Nothing;
        }
        let shapes = self.shapes;
        let [x, y] = &self.sides(direction);
        // Counts the products in each coordinate that are certainly not zero, apart from underflow.
        let products = three(|i| {
            let (_, j, k) = turn(i);
            let is_product = |a: usize, b: usize| *pick(x, a) != 0.0 && *pick(y, b) != 0.0;
            u8::from(is_product(j, k)) + u8::from(is_product(k, j))
        });
        let along = match products {
            [0, 0, 0] => return Finding::Nothing,
            [n, 0, 0] => Some((0, n)),
            [0, n, 0] => Some((1, n)),
            [0, 0, n] => Some((2, n)),
            _ => None,
        };
        if let Some((axis, n)) = along {
            if self.seen[axis] {
                return Finding::Nothing;
            }
            self.seen[axis] = n == 1;
        }

        let (a, products) = cross_with_products(x, y);
        let (scale, square) = (largest(&products), dot(&a, &a));
        if !is_product(scale) || !in_range(self.size) || square < NOISE * scale * scale {
            // The direction may be zero, or point anywhere.
            return Finding::Overlaps([Overlap::UNKNOWN; 2]);
        }
        let ([a0, a1], [b0, b1]) = (ends(&shapes[0], &a), ends(&shapes[1], &a));
        let error = ERROR * (scale * self.size);
        let overlaps = [a1 - b0, b1 - a0];
        if overlaps[0] < -error || overlaps[1] < -error {
            return Finding::Apart;
        }
        // Roundings are far below the spread.
        let (least, most) = ((1.0 - SPREAD) / square, (1.0 + 3.0 * SPREAD) / square);
        let bounds = |overlap: f64| {
            let (low, high) = (greatest(overlap - error, 0.0), overlap + error);
            Overlap { least: low * low * least, most: high * high * most }
        };
        Finding::Overlaps([bounds(overlaps[0]), bounds(overlaps[1])])
    }
}
