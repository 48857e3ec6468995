//! A direction as it is: exact sums of products of the numbers as given. Every term of a length
//! along it has four factors, and of a coordinate of it two.

use core::cmp::Ordering;

use super::body::{Body, side_of};
use super::directions::Direction;
use crate::arithmetic::{Parts, Positive, pick, turn};
use crate::robust::{ExactSum, Vector, add_area, add_scaled_determinant};
use crate::scalar::Scalar;

/// A direction that is not zero.
pub(super) struct Exact<'a, S> {
    bodies: &'a [Body<'a, S>; 2],
    sides: [Vector; 2],
    /// Its coordinates, as sign and size.
    pub(super) coordinates: [Option<(Ordering, Positive)>; 3],
    /// How the three sides of each shape lie to it.
    pub(super) along: [[Ordering; 3]; 2],
}

/// The size of a sum, which is not below zero; `None` of zero.
fn size<T: ExactSum>(sum: &T) -> Option<Positive> {
    Positive::of_limbs(sum.limbs())
}

impl<'a, S: Scalar> Exact<'a, S> {
    /// The direction, if it is not zero; some of the signs are known.
    pub(super) fn new(
        bodies: &'a [Body<'a, S>; 2],
        direction: Direction,
        known: &[[Option<Ordering>; 3]; 2],
    ) -> Option<Self> {
        let own = direction.sides([bodies[0].is_triangle(), bodies[1].is_triangle()]);
        let sides = own.map(|(shape, k)| bodies[shape % 2].side(k));
        let coordinates = [0, 1, 2].map(|i: usize| {
            let (_, j, k) = turn(i);
            let [x, y] = &sides;
            let of = |minus: bool| {
                let mut sum = S::Sum::new();
                add_area(&mut sum, pick(x, j), pick(y, k), minus);
                add_area(&mut sum, pick(x, k), pick(y, j), !minus);
                sum
            };
            let sum = of(false);
            let sign = sum.sign();
            let size = if sign.is_lt() { size(&of(true)) } else { size(&sum) };
            size.map(|size| (sign, size))
        });
        if coordinates.iter().all(Option::is_none) {
            return None;
        }
        let along = [0, 1].map(|shape: usize| {
            [0, 1, 2].map(|k: usize| {
                let is_across = own.contains(&(shape, k));
                // The third edge of a triangle is the sum of the other two.
                let is_across =
                    is_across || own == [(shape, 0), (shape, 1)] && bodies[shape % 2].is_triangle();
                if is_across {
                    return Ordering::Equal;
                }
                let side = || side_of::<S>(sides.each_ref(), &bodies[shape % 2].side(k));
                pick(&known[shape % 2], k).unwrap_or_else(side)
            })
        });
        Some(Self { bodies, sides, coordinates, along })
    }

    /// How far the shapes overlap along the direction, in units of its length: by how far the
    /// first must go against it, or along it. `None` if they do not.
    pub(super) fn overlap(&self, is_along: bool) -> Option<Positive> {
        let (lower, upper) = if is_along { (1, 0) } else { (0, 1) };
        let mut sum = S::Sum::new();
        // The end of the one that lies lower, less the beginning of the other, both twice.
        self.add_end(&mut sum, lower, Ordering::Greater);
        self.add_end(&mut sum, upper, Ordering::Less);
        if sum.sign().is_gt() { size(&sum).map(|size| size.scaled(-1)) } else { None }
    }

    /// Adds how far the shape reaches along the direction, twice, or takes away where it begins.
    fn add_end(&self, sum: &mut S::Sum, shape: usize, toward: Ordering) {
        let [x, y] = &self.sides;
        let (body, along) = (&self.bodies[shape % 2], &self.along[shape % 2]);
        let vertex = farthest(along, toward).iter().position(|&is| is).unwrap_or(0);
        body.add_place(sum, [x, y], vertex, toward.is_lt());
        for k in 0..3 {
            let sign = *pick(along, k);
            if sign.is_eq() || body.is_triangle() {
                continue;
            }
            for h in body.extent(k) {
                let h = if sign.is_lt() { Parts::negated(h) } else { h };
                add_scaled_determinant(sum, x, y, &body.side(k), h);
            }
        }
    }

    /// The length of the direction, and its square.
    pub(super) fn length(&self) -> Option<(Positive, Positive)> {
        let sizes = || self.coordinates.iter().flatten().map(|&(_, size)| size);
        let square = sizes().map(|x| x.times(x)).reduce(Positive::plus)?;
        // Along a coordinate axis nothing is lost.
        let length = if sizes().count() == 1 { sizes().next()? } else { square.root() };
        Some((length, square))
    }
}

/// The vertices of a triangle that lie farthest in a direction, by how its edges lie to it.
pub(super) fn farthest(along: &[Ordering; 3], toward: Ordering) -> [bool; 3] {
    [0, 1, 2].map(|k: usize| {
        let (_, _, before) = turn(k);
        // The edge from here does not go farther, and that to here not back.
        *pick(along, k) != toward && *pick(along, before) != toward.reverse()
    })
}
