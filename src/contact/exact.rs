//! A direction in exact numbers.

use core::cmp::Ordering;

use crate::arithmetic::{Soft, pick, three, turn};

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
