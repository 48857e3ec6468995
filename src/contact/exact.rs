//! A direction in exact numbers.

use core::cmp::Ordering;

use super::body::Body;
use crate::arithmetic::{Each, Parts, Soft, pick, three, turn};
use crate::robust::{self, ExactSum, Vector, add_determinant, add_minor};
use crate::scalar::Scalar;

/// A number that is above zero, or none.
pub(super) type Size = Option<Soft>;

/// The exact numbers of a direction.
pub(super) trait Given {
    /// The coordinates, as sign and size; `None` for zero.
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3];
    /// The sign of a side of a shape along the direction.
    fn side(&self, shape: usize, k: usize) -> Ordering;
    /// Twice the overlap: the last vertex of shape `lower` minus the first vertex of the opposite
    /// shape, both along the direction. `along` has the signs of the sides. `None` if the overlap
    /// is not above zero.
    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size;
}

/// A direction that is not zero.
#[derive(Debug, PartialEq)]
pub(super) struct Exact {
    pub(super) coordinates: [Option<(Ordering, Soft)>; 3],
    /// The signs of the three sides of each shape along the direction.
    pub(super) along: [[Ordering; 3]; 2],
    /// The overlaps, in units of the direction's length, for a translation of the first shape
    /// against the direction and along it. `None` if not wanted or not above zero.
    pub(super) overlaps: [Size; 2],
}

impl Exact {
    /// The exact direction, if it is not zero. Some of the signs are known already. `own` are the
    /// two sides of its cross product.
    pub(super) fn new(
        given: &(impl Given + ?Sized),
        are_triangles: [bool; 2],
        own: [(usize, usize); 2],
        known: &[[Option<Ordering>; 3]; 2],
        wanted: [bool; 2],
    ) -> Option<Self> {
        let coordinates = given.coordinates();
        if coordinates.iter().all(Option::is_none) {
            return None;
        }
        let along_shape = |shape: usize| {
            // The third edge of a triangle is minus the sum of the first two.
            let is_normal = own == [(shape, 0), (shape, 1)] && are_triangles[shape % 2];
            three(|k| {
                if is_normal || own.contains(&(shape, k)) {
                    return Ordering::Equal;
                }
                pick(&known[shape % 2], k).unwrap_or_else(|| given.side(shape, k))
            })
        };
        let along = [along_shape(0), along_shape(1)];
        let overlap = |is_along: bool| {
            if !wanted[usize::from(is_along)] {
                return None;
            }
            // The last vertex of the lower shape minus the first vertex of the upper shape.
            let lower = usize::from(is_along);
            let vertex = |shape: usize| {
                let toward = if shape == lower { Ordering::Greater } else { Ordering::Less };
                farthest(&along[shape % 2], toward).iter().position(|&is| is).unwrap_or(0)
            };
            given.overlap(&along, [vertex(0), vertex(1)], lower).map(|size| size.scaled(-1))
        };
        let overlaps = [overlap(false), overlap(true)];
        Some(Self { coordinates, along, overlaps })
    }
}

/// The length of a direction, and its square; `None` for zero.
pub(super) fn length(coordinates: &[Option<(Ordering, Soft)>; 3]) -> Option<(Soft, Soft)> {
    let (mut sum, mut count, mut last): (Size, _, Size) = (None, 0, None);
    for &(_, size) in coordinates.iter().flatten() {
        let square = size.times(size);
        sum = Some(sum.map_or(square, |sum| sum.plus(square)));
        (count, last) = (count + 1, Some(size));
    }
    let square = sum?;
    // Along a coordinate axis the length is exact.
    let length = if count == 1 { last? } else { square.root() };
    Some((length, square))
}

/// The vertices of a triangle that lie farthest in a direction, from the signs of its edges along
/// it.
pub(super) fn farthest(along: &[Ordering; 3], toward: Ordering) -> [bool; 3] {
    three(|k| {
        let (_, _, before) = turn(k);
        // The edge that leaves this vertex does not lead farther, and the edge that arrives does
        // not lead back.
        *pick(along, k) != toward && *pick(along, before) != toward.reverse()
    })
}

/// A direction, by the two sides of its cross product: its exact numbers as sums of products of the
/// given numbers. They serve all inputs. Each term of a length along the direction has four factors,
/// and each term of a coordinate two.
pub(super) struct Sums<'a, S> {
    bodies: &'a [Body<'a, S>; 2],
    sides: [Vector; 2],
}

/// The size of a sum that is not below zero; `None` for zero.
fn size<T: ExactSum>(sum: &T) -> Size {
    Soft::of_limbs(sum.limbs())
}

impl<'a, S: Scalar> Sums<'a, S> {
    pub(super) fn new(bodies: &'a [Body<'a, S>; 2], own: [(usize, usize); 2]) -> Self {
        Self { bodies, sides: own.each(|(shape, k)| bodies[shape % 2].side(k)) }
    }

    /// Adds twice the shape's end along the direction, or subtracts its beginning.
    fn add_end(
        &self,
        sum: &mut S::SeptumSum,
        body: &Body<'_, S>,
        vertex: usize,
        along: &[Ordering; 3],
        is_upper: bool,
    ) {
        let [x, y] = &self.sides;
        body.add_place(sum, [x, y], vertex, is_upper);
        for k in 0..3 {
            let sign = *pick(along, k);
            if sign.is_eq() || body.is_triangle() {
                continue;
            }
            for h in body.extent(k) {
                let h = if sign.is_lt() { Parts::negated(h) } else { h };
                add_determinant(sum, [x, y, &body.side(k)], Some(h));
            }
        }
    }
}

impl<S: Scalar> Given for Sums<'_, S> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        three(|i| {
            let [x, y] = &self.sides;
            let of = |minus: bool| {
                let mut sum = S::SeptumSum::new();
                add_minor(&mut sum, x, y, i, minus);
                sum
            };
            let sum = of(false);
            let sign = sum.sign();
            let size = if sign.is_lt() { size(&of(true)) } else { size(&sum) };
            size.map(|size| (sign, size))
        })
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        let [x, y] = &self.sides;
        robust::side::<S::SeptumSum>([x, y, &self.bodies[shape % 2].side(k)])
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let mut sum = S::SeptumSum::new();
        for shape in 0..2 {
            let (body, is_upper) = (&self.bodies[shape], shape != lower);
            self.add_end(&mut sum, body, vertices[shape], &along[shape], is_upper);
        }
        if sum.sign().is_gt() { size(&sum) } else { None }
    }
}
