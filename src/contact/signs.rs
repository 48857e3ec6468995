//! The signs of the sides of the shapes along a direction, where floats are certain.

use core::cmp::Ordering;

use super::body::dot;
use super::directions::Direction;
use super::filter::{ERROR, Filter, cross_with_products, in_range, is_product};
use crate::arithmetic::{compare, largest, pick, three};

impl Filter<'_> {
    /// How many of the two sides of the direction are rounded, as differences of points are.
    pub(super) fn rounded_sides(&self, direction: Direction) -> u8 {
        let triangles = self.are_triangles;
        direction.sides(triangles).map(|(shape, _)| u8::from(triangles[shape % 2])).iter().sum()
    }

    /// The sides that are perpendicular to the direction because they are its own, equal one of these,
    /// or are the third edge of the triangle that both belong to: bit 3·shape + k for side k.
    fn across(&self, direction: Direction) -> u8 {
        let bit = |(shape, k): (usize, usize)| 1_u8 << (3 * shape + k);
        let [one, other] = direction.sides(self.are_triangles);
        let mut across = bit(one) | bit(other);
        for (j, same) in self.axes.same.iter().enumerate() {
            let equal = same.map_or(0, |i| bit((0, i)) | bit((1, j)));
            if across & equal != 0 {
                across |= equal;
            }
        }
        for (shape, of) in self.shapes.iter().enumerate() {
            if of.is_triangle && across & 3 << (3 * shape) == 3 << (3 * shape) {
                across |= bit((shape, 2));
            }
        }
        across
    }

    /// The signs of the sides of the shapes along a direction, where floats are certain.
    ///
    /// With the products p − q in a coordinate of a, a·s is a sum of terms p·s and q·s.
    /// `filter.g` proves that it errs by at most a quarter of [`ERROR`] times the greatest of these
    /// terms. The bound is by terms, so that a side keeps its sign if it is
    /// perpendicular to the direction up to a residue. If all terms are zero, so is the sum, unless
    /// one has underflowed.
    pub(super) fn along(&self, direction: Direction) -> [[Option<Ordering>; 3]; 2] {
        let [x, y] = &self.sides(direction);
        let (a, products) = cross_with_products(x, y);
        let across = self.across(direction);
        let of = |shape: usize| {
            three(|k| {
                if across & 1 << (3 * shape + k) != 0 {
                    return Some(Ordering::Equal);
                }
                let s = pick(&self.shapes[shape % 2].sides, k);
                let along = dot(&a, s);
                let size = largest(&three(|i| products[i] * s[i]));
                if size == 0.0 && self.is_short {
                    return Some(Ordering::Equal);
                }
                let is_in_range = is_product(largest(&products)) && in_range(largest(s));
                let is_certain = is_in_range && in_range(size) && along.abs() > ERROR / 4.0 * size;
                is_certain.then(|| compare(along, 0.0))
            })
        };
        [of(0), of(1)]
    }
}
