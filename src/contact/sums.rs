//! The exact numbers of a direction as sums of products of the given numbers. They serve all
//! inputs. Each term of a length along the direction has four factors, and each term of a
//! coordinate two.

use core::cmp::Ordering;

use super::body::Body;
use super::exact::{Given, Size};
use crate::arithmetic::{Each, Parts, Soft, pick, three};
use crate::robust::{self, ExactSum, Vector, add_determinant, add_minor};
use crate::scalar::Scalar;

/// A direction, by the two sides of its cross product.
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
