//! Whether one axis separates, by the definition: project the triangle's vertices and all eight
//! corners of the box on the axis.

use crate::Each;
use septum::Axis;

use super::case::Case;
use super::lattice::{Lattice, Ring, Shapes};
use super::sample::Sample;

/// Whether the projections of triangle and box on the axis are disjoint.
pub fn separates<S: Sample>(case: &Case<S>, axis: Axis) -> bool {
    Lattice::new(case).is_disjoint_on(axis)
}

impl Lattice {
    fn is_disjoint_on(&self, axis: Axis) -> bool {
        match self {
            Self::Narrow(shapes) => shapes.disjoint_on(axis),
            Self::Wide(shapes) => shapes.disjoint_on(axis),
        }
    }
}

impl<I: Ring> Shapes<I> {
    fn disjoint_on(&self, axis: Axis) -> bool {
        let vector = self.vector(axis);
        let triangle = self.vertices.each_ref().each(|v| I::dot(&vector, v));
        let zero = I::from_bit(false);
        let corners: [I; 8] = core::array::from_fn(|corner| {
            let point = core::array::from_fn(|i| {
                if corner >> i & 1 == 0 { zero.clone() } else { self.extent[i].clone() }
            });
            I::dot(&vector, &point)
        });
        let below = |a: &[I], b: &[I]| a.iter().all(|x| b.iter().all(|y| x.minus(y).sign() < 0));
        below(&triangle, &corners) || below(&corners, &triangle)
    }

    fn vector(&self, axis: Axis) -> [I; 3] {
        let unit = |k: u8| core::array::from_fn(|i| I::from_bit(i == usize::from(k)));
        match axis {
            Axis::Face(i) => unit(i),
            Axis::Normal => I::cross(&self.edge(0), &self.edge(1)),
            Axis::Edge { axis, edge } => I::cross(&unit(axis), &self.edge(edge.into())),
        }
    }
}
