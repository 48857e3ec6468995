//! The signs of the sides of the shapes along a direction, where floats are certain.

use core::cmp::Ordering;

use super::body::{Vec64, dot};
use super::directions::Direction;
use super::filter::{Filter, ROUNDOFFS, cross_with_products};
use super::lanes::Measure;
use crate::arithmetic::{Number, REGISTERS_ARE_WIDE, largest, three};

impl Filter<'_> {
    /// How many of the two sides of a direction are rounded, as differences of points are.
    pub(super) fn rounded_sides(&self, [one, other]: [u8; 2]) -> u8 {
        let is_rounded = |n: u8| u8::from(self.ruler.are_triangles[usize::from(n >= 3)]);
        is_rounded(one) + is_rounded(other)
    }

    /// The sides that are perpendicular to the direction because they are its own, given as numbers, equal
    /// one of these, or are the third edge of the triangle that both belong to: bit 3·shape + k for side k.
    fn across(&self, [one, other]: [u8; 2]) -> u8 {
        let mut across = 1_u8 << one | 1 << other;
        for (j, same) in self.axes.same.iter().enumerate() {
            let equal = same.map_or(0, |i| 1_u8 << i | 8 << j);
            if across & equal != 0 {
                across |= equal;
            }
        }
        for (shape, of) in self.ruler.shapes.iter().enumerate() {
            if of.is_triangle && across & 3 << (3 * shape) == 3 << (3 * shape) {
                across |= 4 << (3 * shape);
            }
        }
        across
    }

    /// The signs of the sides of the shapes along a direction, where floats are certain.
    ///
    /// With the products p − q in a coordinate of a, a·s is a sum of terms p·s and q·s.
    /// `filter.g` proves that it errs by at most a quarter of [`ROUNDOFFS`] times the
    /// greatest of these terms. The bound is by terms, so that a side keeps its sign if it is
    /// perpendicular to the direction up to a residue. If all terms are zero, so is the sum, unless
    /// one has underflowed.
    pub(super) fn along(&self, direction: Direction) -> [[Option<Ordering>; 3]; 2] {
        let numbers = direction.numbers(self.ruler.are_triangles);
        let [x, y] = self.ruler.sides(numbers);
        self.signs(numbers, &cross_with_products(x, y))
    }

    /// The same, given the direction in floats and the products in its coordinates. Inlined, so that what
    /// [`settled`](super::settled::settled) has measured along the sides serves.
    #[inline(always)]
    pub(super) fn signs(
        &self,
        numbers: [u8; 2],
        (a, products): &(Vec64, Vec64),
    ) -> [[Option<Ordering>; 3]; 2] {
        let across = self.across(numbers);
        let is_in_range = largest(products).is_product();
        let of = |shape: usize| {
            let sides = &self.ruler.shapes[shape % 2].sides;
            three(|k| {
                let is_across = across >> (3 * shape + k) & 1 == 1;
                // Hosts do not branch.
                if is_across && !REGISTERS_ARE_WIDE {
                    return Some(Ordering::Equal);
                }
                let s = &sides[k];
                let along = dot(a, s);
                let size = largest(&three(|i| products[i] * s[i]));
                let is_in_range = is_in_range & largest(s).is_size() & size.is_size();
                let is_certain = is_in_range & (along.abs() > size.error(ROUNDOFFS / 4));
                let is_equal = is_across | (self.is_short & (size == 0.0));
                let sign = if is_equal { 0 } else { 2 * i8::from(along > 0.0) - 1 };
                (is_equal | is_certain).then(|| sign.cmp(&0))
            })
        };
        [of(0), of(1)]
    }
}
