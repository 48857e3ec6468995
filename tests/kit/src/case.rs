//! A case: a triangle and a box, as plain numbers.

use crate::Each;
use septum::{Aabb, ShapeError, Triangle};

use super::sample::Sample;

/// The numbers of a box, in one of its forms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BoxNumbers<S> {
    /// Centre and half-extents.
    Center([S; 3], [S; 3]),
    /// Least and greatest corner.
    Corners([S; 3], [S; 3]),
}

impl<S: Copy> BoxNumbers<S> {
    /// The same box in other numbers.
    pub fn map<T>(self, f: impl Fn(S) -> T + Copy) -> BoxNumbers<T> {
        match self {
            Self::Center(c, h) => BoxNumbers::Center(c.each(f), h.each(f)),
            Self::Corners(min, max) => BoxNumbers::Corners(min.each(f), max.each(f)),
        }
    }
}

impl<S: Sample> BoxNumbers<S> {
    /// The box, if it is valid.
    pub fn shape(&self) -> Result<Aabb<S>, ShapeError> {
        match *self {
            Self::Center(c, h) => Aabb::from_center_half_extents(c, h),
            Self::Corners(min, max) => Aabb::from_min_max(min, max),
        }
    }
}

/// A triangle and a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case<S> {
    pub vertices: [[S; 3]; 3],
    pub aabb: BoxNumbers<S>,
}

impl<S: Sample> Case<S> {
    /// The triangle.
    pub fn triangle(&self) -> Triangle<S> {
        let [a, b, c] = self.vertices;
        Triangle::new(a, b, c).expect("finite vertices")
    }

    /// The box.
    pub fn aabb(&self) -> Aabb<S> {
        self.aabb.shape().expect("a valid box")
    }

    /// The two shapes.
    pub fn shapes(&self) -> (Triangle<S>, Aabb<S>) {
        (self.triangle(), self.aabb())
    }

    /// The two triples of the box.
    pub fn box_numbers(&self) -> [[S; 3]; 2] {
        match self.aabb {
            BoxNumbers::Center(a, b) | BoxNumbers::Corners(a, b) => [a, b],
        }
    }

    /// All fifteen numbers: nine for the triangle, six for the box.
    pub fn numbers(&self) -> [S; 15] {
        let [a, b, c] = self.vertices;
        let [p, q] = self.box_numbers();
        let rows = [a, b, c, p, q];
        core::array::from_fn(|i| rows[i / 3][i % 3])
    }

    /// The same case with number `i` of the fifteen replaced, if the box stays valid.
    pub fn with_number(mut self, i: usize, x: S) -> Option<Self> {
        let (row, column) = (i / 3, i % 3);
        match (row, &mut self.aabb) {
            (0..=2, _) => self.vertices[row][column] = x,
            (3, BoxNumbers::Center(c, _)) => c[column] = x,
            (_, BoxNumbers::Center(_, h)) if x >= S::ZERO => h[column] = x,
            (3, BoxNumbers::Corners(min, max)) if x <= max[column] => min[column] = x,
            (4, BoxNumbers::Corners(min, max)) if x >= min[column] => max[column] = x,
            _ => return None,
        }
        Some(self)
    }
}
